// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/Cpdi.hpp"

namespace stroma::mechanics {

template class StressKernelsOf<shape::Cpdi<2>, material::AnyLaw>;
template class StressKernelsOf<shape::Cpdi<3>, material::AnyLaw>;

}  // namespace stroma::mechanics
