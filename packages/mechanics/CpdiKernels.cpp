#include "mechanics/KernelsOf.hpp"
#include "shape/Cpdi.hpp"

namespace stroma::mechanics {

std::shared_ptr<const ShapeKernels> cpdi_kernels(bool flat) {
  if (flat) return std::make_shared<KernelsOf<shape::Cpdi<2>>>();
  return std::make_shared<KernelsOf<shape::Cpdi<3>>>();
}

}  // namespace stroma::mechanics
