// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Stiffness tensors as 6 x 6 matrices: compliance, moduli, and the closest tensor of more symmetry.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace stroma {

/// Voigt's notation: rows and columns xx, yy, zz, yz, xz, xy; stress = C strain, shears of strain
/// are engineering ones (gamma_yz = 2 eps_yz).
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Kelvin's and Mandel's notation of a stiffness, C_ij w_i w_j with w = (1, 1, 1, sqrt 2, sqrt 2,
/// sqrt 2), and back. Its norm, eigenvalues and products are those of the tensor.
Matrix6 to_kelvin(const Matrix6& voigt);
Matrix6 to_voigt(const Matrix6& kelvin);

/// The inverse; nothing where some strain costs next to no energy: the least eigenvalue of the
/// tensor is below 1e-10 of its largest.
std::optional<Matrix6> compliance_of(const Matrix6& stiffness);

/// Moduli along the axes of a compliance: E_i = 1 / S_ii, G_yz = 1 / S_44 ..., and
/// nu_ij = -S_ji / S_ii, the contraction along j by the extension along i where stress acts along i.
struct EngineeringModuli {
  Eigen::Vector3d young;  ///< E_x, E_y, E_z [Pa]
  Eigen::Matrix3d nu;     ///< (i, j); 0 on the diagonal
  Eigen::Vector3d shear;  ///< G_yz, G_xz, G_xy [Pa]
};
EngineeringModuli engineering_moduli(const Matrix6& compliance);

enum class Symmetry { isotropic, cubic, transversely_isotropic, orthotropic };
const std::vector<std::pair<std::string, Symmetry>>& symmetries();

/// The tensor of a symmetry that is closest to a stiffness by the Euclidean norm
/// |A|^2 = A_ijkl A_ijkl.
struct ClosestTensor {
  Matrix6 stiffness;      ///< along the specimen's axes [Pa]
  Matrix6 in_frame;       ///< along the axes of its symmetry [Pa]
  double distance;        ///< |C - closest| / |C|
  double along_specimen;  ///< the same with the specimen's axes, or the best of them for the axis
  /// Rows: the axes of symmetry, right-handed; the third is that of transverse isotropy.
  Eigen::Matrix3d frame;
};

/// The symmetric part of a stiffness is projected onto the tensors of a symmetry whose axes are
/// turned until they are closest; the specimen's axes stay where no others are closer by 1e-9.
///
/// Projections: M. Moakher and A. N. Norris, J. Elasticity 85 (2006) 215. Axes: Newton's method
/// on the squared distance, from many starts.
ClosestTensor closest(const Matrix6& stiffness, Symmetry symmetry);
/// The distance of a symmetric stiffness from those whose axes are the coordinates'; the third is
/// that of transverse isotropy.
double closest_along(const Matrix6& stiffness, Symmetry symmetry);

/// The stiffness of an isotropic material [Pa].
Matrix6 isotropic_stiffness(double bulk, double shear);
/// Moduli of an isotropic stiffness [Pa].
double bulk_modulus(const Matrix6& isotropic);
inline double shear_modulus(const Matrix6& isotropic) { return isotropic(5, 5); }

/// The same stiffness by its components along other axes, the rows of a rotation.
Matrix6 in_frame(const Matrix6& stiffness, const Eigen::Matrix3d& axes);

}  // namespace stroma
