#include "mechanics/KernelsOf.hpp"
#include "shape/Linear.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> linear_kernels() {
  return std::make_shared<KernelsOf<shape::Linear>>();
}

}  // namespace stroma::mechanics
