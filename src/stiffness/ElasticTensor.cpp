// SPDX-License-Identifier: BSD-3-Clause

#include "stiffness/ElasticTensor.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stroma {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

const double sqrt2 = std::sqrt(2.0);
constexpr int first_axis[6] = {0, 1, 2, 1, 0, 0}, second_axis[6] = {0, 1, 2, 2, 2, 1};

double weight(int i) { return i < 3 ? 1.0 : sqrt2; }

/// A symmetric tensor by its six numbers in Kelvin's notation, and back.
Matrix3d tensor_of(const Vector6& v) {
  Matrix3d t;
  for (int i = 0; i < 6; ++i)
    t(first_axis[i], second_axis[i]) = t(second_axis[i], first_axis[i]) = v(i) / weight(i);
  return t;
}
Vector6 numbers_of(const Matrix3d& t) {
  Vector6 v;
  for (int i = 0; i < 6; ++i) v(i) = weight(i) * t(first_axis[i], second_axis[i]);
  return v;
}

/// The matrix of a linear map of symmetric tensors.
template <class Map>
Matrix6 matrix_of(const Map& map) {
  Matrix6 m;
  for (int i = 0; i < 6; ++i) m.col(i) = numbers_of(map(tensor_of(Vector6::Unit(i))));
  return m;
}

/// Turns Kelvin's notation to the axes that are the rows of a rotation.
Matrix6 turn_to(const Matrix3d& axes) {
  return matrix_of([&](const Matrix3d& t) -> Matrix3d { return axes * t * axes.transpose(); });
}

Matrix3d cross_with(int axis) {
  Matrix3d w = Matrix3d::Zero();
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  w(c, b) = 1.0;
  w(b, c) = -1.0;
  return w;
}

Matrix3d rotation(const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

Matrix6 isotropic_part(const Matrix6& k) {
  const double three_bulk = k.topLeftCorner<3, 3>().sum() / 3.0;
  const double two_shear = (k.trace() - three_bulk) / 5.0;
  Matrix6 p = two_shear * Matrix6::Identity();
  p.topLeftCorner<3, 3>().array() += (three_bulk - two_shear) / 3.0;
  return p;
}

Matrix6 cubic_part(const Matrix6& k) {
  Matrix6 p = Matrix6::Zero();
  const Matrix3d normal = k.topLeftCorner<3, 3>();
  p.topLeftCorner<3, 3>().setConstant((normal.sum() - normal.trace()) / 6.0);
  p.diagonal().head<3>().setConstant(normal.trace() / 3.0);
  p.diagonal().tail<3>().setConstant(k.diagonal().tail<3>().mean());
  return p;
}

/// Of transverse isotropy about the third axis.
Matrix6 transverse_part(const Matrix6& k) {
  Matrix6 p = Matrix6::Zero();
  const double normal = 0.5 * (k(0, 0) + k(1, 1));
  p(0, 0) = p(1, 1) = 0.75 * normal + 0.25 * (k(0, 1) + k(5, 5));
  p(0, 1) = p(1, 0) = 0.25 * normal + 0.75 * k(0, 1) - 0.25 * k(5, 5);
  p(5, 5) = p(0, 0) - p(0, 1);
  p(0, 2) = p(2, 0) = p(1, 2) = p(2, 1) = 0.5 * (k(0, 2) + k(1, 2));
  p(2, 2) = k(2, 2);
  p(3, 3) = p(4, 4) = 0.5 * (k(3, 3) + k(4, 4));
  return p;
}

Matrix6 orthotropic_part(const Matrix6& k) {
  Matrix6 p = Matrix6::Zero();
  p.topLeftCorner<3, 3>() = k.topLeftCorner<3, 3>();
  p.diagonal().tail<3>() = k.diagonal().tail<3>();
  return p;
}

/// The orthogonal projection of a symmetric matrix in Kelvin's notation onto a symmetry whose axes
/// are the coordinates'.
Matrix6 part(const Matrix6& k, Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::isotropic:
      return isotropic_part(k);
    case Symmetry::cubic:
      return cubic_part(k);
    case Symmetry::transversely_isotropic:
      return transverse_part(k);
    default:
      return orthotropic_part(k);
  }
}

/// How far a tensor is from a symmetry, with axes that can be turned.
struct Departure {
  const Matrix6& kelvin;
  Symmetry symmetry;

  Matrix6 in(const Matrix3d& axes) const {
    const Matrix6 q = turn_to(axes);
    return q * kelvin * q.transpose();
  }
  double at(const Matrix3d& axes) const {
    const Matrix6 k = in(axes);
    return (k - part(k, symmetry)).norm();
  }

  /// Axes of a minimum near others: Newton's method, with shorter steps where it does not descend
  /// (Levenberg and Marquardt), and to the end where rounding hides the descent.
  Matrix3d minimum_near(Matrix3d axes) const {
    const double size = kelvin.squaredNorm();
    double distance = at(axes), damping = 1e-3 * size;
    constexpr int most_steps = 60;
    for (int step = 0; step < most_steps && damping < 1e6 * size; ++step) {
      const Derivatives here = derivatives(axes);
      const Matrix3d damped = here.curvature + damping * Matrix3d::Identity();
      const Matrix3d trial = rotation(-damped.ldlt().solve(here.slope)) * axes;
      const double there = at(trial);
      const bool is_better = there < distance;
      damping *= is_better ? 0.1 : 10.0;
      if (!is_better) continue;
      axes = trial;
      distance = there;
    }
    return polished(axes);
  }

 private:
  /// Of half the squared distance, by turns about the axes.
  struct Derivatives {
    Vector3d slope;
    Matrix3d curvature;
  };

  /// With r = k - part(k) and D_a = W_a k - k W_a, W_a the generator of turns about axis a:
  /// <r, D_a>, and <D_a - part(D_a), D_b> + <r, (W_a D_b - D_b W_a + W_b D_a - D_a W_b) / 2>.
  Derivatives derivatives(const Matrix3d& axes) const {
    static const std::array<Matrix6, 3> W{generator(0), generator(1), generator(2)};
    const Matrix6 k = in(axes), r = k - part(k, symmetry);
    std::array<Matrix6, 3> D;
    for (std::size_t a = 0; a < 3; ++a) D[a] = commutator(W[a], k);
    Derivatives all;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto i = static_cast<int>(a);
      all.slope(i) = r.cwiseProduct(D[a]).sum();
      const Matrix6 outside = D[a] - part(D[a], symmetry);
      for (std::size_t b = 0; b < 3; ++b)
        all.curvature(i, static_cast<int>(b)) =
            outside.cwiseProduct(D[b]).sum() +
            0.5 * r.cwiseProduct(commutator(W[a], D[b]) + commutator(W[b], D[a])).sum();
    }
    return all;
  }

  /// Full steps as long as the slope falls. About the axis of transverse isotropy there is none.
  Matrix3d polished(Matrix3d axes) const {
    Derivatives here = derivatives(axes);
    constexpr int most_steps = 5;
    for (int step = 0; step < most_steps; ++step) {
      const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(here.curvature);
      const double negligible = 1e-9 * eigen.eigenvalues().cwiseAbs().maxCoeff();
      Vector3d turn = Vector3d::Zero();
      for (int n = 0; n < 3; ++n)
        if (eigen.eigenvalues()(n) > negligible)
          turn -= eigen.eigenvectors().col(n).dot(here.slope) / eigen.eigenvalues()(n) *
                  eigen.eigenvectors().col(n);
      const Matrix3d trial = rotation(turn) * axes;
      const Derivatives there = derivatives(trial);
      if (!(there.slope.norm() < here.slope.norm())) break;
      axes = trial;
      here = there;
    }
    return axes;
  }

  static Matrix6 commutator(const Matrix6& a, const Matrix6& b) { return a * b - b * a; }
  static Matrix6 generator(int axis) {
    const Matrix3d w = cross_with(axis);
    return matrix_of([&](const Matrix3d& t) -> Matrix3d { return w * t - t * w; });
  }
};

/// Rotations that cover all, evenly enough: quaternions of Halton's points (Shoemake's map).
std::vector<Matrix3d> spread_rotations(int count) {
  const auto halton = [](int index, int base) {
    double value = 0.0, digit = 1.0 / base;
    for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
    return value;
  };
  constexpr double full_turn = 6.283185307179586;
  std::vector<Matrix3d> rotations;
  for (int n = 1; n <= count; ++n) {
    const double u = halton(n, 2), a = full_turn * halton(n, 3), b = full_turn * halton(n, 5);
    const double s = std::sqrt(1.0 - u), c = std::sqrt(u);
    rotations.push_back(
        Eigen::Quaterniond(c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b))
            .toRotationMatrix());
  }
  return rotations;
}

/// The best of many axes, the best one first.
std::vector<Matrix3d> good_starts(const Departure& departure) {
  constexpr int tried = 500;
  constexpr std::size_t kept = 24;
  std::vector<std::pair<double, Matrix3d>> starts;
  for (const Matrix3d& axes : spread_rotations(tried))
    starts.emplace_back(departure.at(axes), axes);
  std::sort(starts.begin(), starts.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Matrix3d> best;
  for (std::size_t n = 0; n < kept; ++n) best.push_back(starts[n].second);
  return best;
}

/// The 24 turns of a cube.
std::vector<Matrix3d> turns_of_cube() {
  std::vector<Matrix3d> turns;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (const double sx : {1.0, -1.0})
        for (const double sy : {1.0, -1.0}) {
          if (x == y) continue;
          Matrix3d turn;
          turn.row(0) = sx * Vector3d::Unit(x);
          turn.row(1) = sy * Vector3d::Unit(y);
          turn.row(2) = turn.row(0).cross(turn.row(1));
          turns.push_back(turn);
        }
  return turns;
}

/// Of axes that mean the same symmetry, those that are nearest to the specimen's.
Matrix3d nearest_names(const Matrix3d& axes, Symmetry symmetry) {
  if (symmetry == Symmetry::transversely_isotropic) {
    Vector3d axis = axes.row(2), first;
    int largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    if (axis(largest) < 0.0) axis = -axis;
    first = Vector3d::Unit((largest + 1) % 3);
    first = (first - first.dot(axis) * axis).normalized();
    Matrix3d named;
    named << first.transpose(), axis.cross(first).transpose(), axis.transpose();
    return named;
  }
  Matrix3d nearest = axes;
  for (const Matrix3d& turn : turns_of_cube())
    if ((turn * axes).trace() > nearest.trace() + 1e-9) nearest = turn * axes;
  return nearest;
}

}  // namespace

Matrix6 to_kelvin(const Matrix6& voigt) {
  Matrix6 k = voigt;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) k(i, j) *= weight(i) * weight(j);
  return k;
}

Matrix6 to_voigt(const Matrix6& kelvin) {
  Matrix6 c = kelvin;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) c(i, j) /= weight(i) * weight(j);
  return c;
}

std::optional<Matrix6> compliance_of(const Matrix6& stiffness) {
  const Matrix6 k = to_kelvin(stiffness);
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(0.5 * (k + k.transpose()),
                                                     Eigen::EigenvaluesOnly);
  if (!(eigen.eigenvalues()(0) > 1e-10 * eigen.eigenvalues()(5))) return std::nullopt;
  return stiffness.inverse();
}

EngineeringModuli engineering_moduli(const Matrix6& compliance) {
  EngineeringModuli moduli;
  moduli.nu.setZero();
  for (int i = 0; i < 3; ++i) {
    moduli.young(i) = 1.0 / compliance(i, i);
    moduli.shear(i) = 1.0 / compliance(3 + i, 3 + i);
    for (int j = 0; j < 3; ++j)
      if (i != j) moduli.nu(i, j) = -compliance(j, i) / compliance(i, i);
  }
  return moduli;
}

const std::vector<std::pair<std::string, Symmetry>>& symmetries() {
  static const std::vector<std::pair<std::string, Symmetry>> table{
      {"isotropic", Symmetry::isotropic},
      {"cubic", Symmetry::cubic},
      {"transversely isotropic", Symmetry::transversely_isotropic},
      {"orthotropic", Symmetry::orthotropic}};
  return table;
}

ClosestTensor closest(const Matrix6& stiffness, Symmetry symmetry) {
  const Matrix6 whole = to_kelvin(stiffness), kelvin = 0.5 * (whole + whole.transpose());
  const Departure departure{kelvin, symmetry};
  Matrix3d best = Matrix3d::Identity();
  for (const Matrix3d& turn : turns_of_cube())
    if (departure.at(turn) < departure.at(best) - 1e-12 * kelvin.norm()) best = turn;
  const double along_specimen = departure.at(best);
  if (symmetry != Symmetry::isotropic) {
    const double enough = 1e-9 * kelvin.norm();
    for (const Matrix3d& start : good_starts(departure)) {
      const Matrix3d found = departure.minimum_near(start);
      if (departure.at(found) < departure.at(best) - enough) best = found;
    }
  }
  ClosestTensor result;
  result.frame = nearest_names(best, symmetry);
  const Matrix6 q = turn_to(result.frame);
  const Matrix6 projected = part(departure.in(result.frame), symmetry);
  result.in_frame = to_voigt(projected);
  result.stiffness = to_voigt(q.transpose() * projected * q);
  result.distance = departure.at(result.frame) / kelvin.norm();
  result.along_specimen = along_specimen / kelvin.norm();
  return result;
}

double closest_along(const Matrix6& stiffness, Symmetry symmetry) {
  const Matrix6 kelvin = to_kelvin(stiffness);
  return Departure{kelvin, symmetry}.at(Matrix3d::Identity()) / kelvin.norm();
}

Matrix6 isotropic_stiffness(double bulk, double shear) {
  Matrix6 c = Matrix6::Zero();
  c.topLeftCorner<3, 3>().setConstant(bulk - 2.0 / 3.0 * shear);
  c.diagonal().head<3>().array() += 2.0 * shear;
  c.diagonal().tail<3>().setConstant(shear);
  return c;
}

double bulk_modulus(const Matrix6& isotropic) {
  return isotropic.topLeftCorner<3, 3>().sum() / 9.0;
}

Matrix6 in_frame(const Matrix6& stiffness, const Matrix3d& axes) {
  const Matrix6 q = turn_to(axes);
  return to_voigt(q * to_kelvin(stiffness) * q.transpose());
}

}  // namespace stroma
