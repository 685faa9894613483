// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/BSpline.hpp"

namespace stroma::mechanics {

template class StressKernelsOf<shape::Gimp<2>, material::AnyLaw>;
template class StressKernelsOf<shape::Gimp<3>, material::AnyLaw>;

}  // namespace stroma::mechanics
