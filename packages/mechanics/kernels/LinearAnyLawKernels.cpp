// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/kernels/StressKernelsOf.hpp"
#include "stroma/shape/Linear.hpp"

namespace stroma::mechanics {

template class StressKernelsOf<shape::Linear, material::AnyLaw>;

}  // namespace stroma::mechanics
