// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/Bounds.hpp"

#include <algorithm>

namespace stroma::material {
namespace {

/// One modulus of each phase, with the phase's volume fraction.
struct Weighted {
  double fraction, modulus;
};

/// The m with 1/(m + shift) = sum f_i / (m_i + shift); shift = 0: Reuss; it tends to Voigt as the
/// shift grows. With x_i = m_i - m_1 the sum keeps its digits where all m_i are alike:
/// m = m_1 + (sum f_i x_i / (m_i + shift)) / (sum f_i / (m_i + shift)).
double shifted_mean(const std::vector<Weighted>& phases, double shift) {
  const double first = phases.front().modulus;
  double numerator = 0.0, denominator = 0.0;
  for (const Weighted& phase : phases) {
    const double weight = phase.fraction / (phase.modulus + shift);
    numerator += weight * (phase.modulus - first);
    denominator += weight;
  }
  return first + numerator / denominator;
}

double voigt_mean(const std::vector<Weighted>& phases) {
  const double first = phases.front().modulus;
  double sum = 0.0;
  for (const Weighted& phase : phases) sum += phase.fraction * (phase.modulus - first);
  return first + sum;
}

bool is_less(const Weighted& a, const Weighted& b) { return a.modulus < b.modulus; }

/// What the space's dimension decides: the shifts of Hashin and Shtrikman's bounds, by the moduli
/// of the softest or stiffest phase, and the modulus of a bar.
struct Dimension {
  double (*bulk_shift)(double shear);
  double (*shear_shift)(double bulk, double shear);
  double (*young)(double bulk, double shear);
};

const Dimension space{
    [](double mu) { return 4.0 / 3.0 * mu; },
    [](double K, double mu) { return mu / 6.0 * (9.0 * K + 8.0 * mu) / (K + 2.0 * mu); },
    [](double K, double mu) { return 9.0 * K * mu / (3.0 * K + mu); }};

const Dimension plane{[](double mu) { return mu; },
                      [](double k, double mu) { return k * mu / (k + 2.0 * mu); },
                      [](double k, double mu) { return 4.0 * k * mu / (k + mu); }};

MixtureBounds bounds_of(const std::vector<Weighted>& bulk, const std::vector<Weighted>& shear,
                        const Dimension& dimension) {
  const auto [soft_bulk, stiff_bulk] = std::minmax_element(bulk.begin(), bulk.end(), is_less);
  const auto [soft_shear, stiff_shear] = std::minmax_element(shear.begin(), shear.end(), is_less);
  const double k[2] = {soft_bulk->modulus, stiff_bulk->modulus};
  const double mu[2] = {soft_shear->modulus, stiff_shear->modulus};
  MixtureBounds bounds;
  bounds.bulk = {shifted_mean(bulk, 0.0), shifted_mean(bulk, dimension.bulk_shift(mu[0])),
                 shifted_mean(bulk, dimension.bulk_shift(mu[1])), voigt_mean(bulk)};
  bounds.shear = {shifted_mean(shear, 0.0), shifted_mean(shear, dimension.shear_shift(k[0], mu[0])),
                  shifted_mean(shear, dimension.shear_shift(k[1], mu[1])), voigt_mean(shear)};
  for (double Bounds::*bound : {&Bounds::reuss, &Bounds::lower, &Bounds::upper, &Bounds::voigt})
    bounds.young.*bound = dimension.young(bounds.bulk.*bound, bounds.shear.*bound);
  return bounds;
}

/// A modulus of the phases that have a share.
template <class Modulus>
std::vector<Weighted> weighted(const std::vector<Phase>& phases, Modulus modulus) {
  double total = 0.0;
  for (const Phase& phase : phases) total += phase.share;
  std::vector<Weighted> result;
  for (const Phase& phase : phases)
    if (phase.share > 0.0) result.push_back({phase.share / total, modulus(phase.moduli)});
  return result;
}

double shear_modulus_of(const SmallStrainModuli& moduli) { return moduli.shear; }

}  // namespace

MixtureBounds bounds_in_space(const std::vector<Phase>& phases) {
  return bounds_of(weighted(phases, [](const SmallStrainModuli& moduli) { return moduli.bulk; }),
                   weighted(phases, shear_modulus_of), space);
}

MixtureBounds bounds_in_plane_strain(const std::vector<Phase>& phases) {
  return bounds_of(
      weighted(phases,
               [](const SmallStrainModuli& moduli) { return moduli.bulk + moduli.shear / 3.0; }),
      weighted(phases, shear_modulus_of), plane);
}

}  // namespace stroma::material
