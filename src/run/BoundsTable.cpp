// SPDX-License-Identifier: BSD-3-Clause

#include "run/BoundsTable.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

using base::format;
using material::Bounds;

/// "576.7 Pa +10.72 %": a modulus, and its gain over that of one material.
std::string entry(double modulus, double of_one) {
  const double gain = 100.0 * (modulus / of_one - 1.0);
  return format(std::abs(gain) < 1e6 ? "%.4g Pa %+.2f %%" : "%.4g Pa %+.3g %%", modulus, gain);
}

std::string row(const char* modulus, const Bounds& bounds, const Bounds& of_one) {
  std::string line = format("            %-18s", modulus);
  for (double Bounds::*bound : {&Bounds::reuss, &Bounds::lower, &Bounds::upper, &Bounds::voigt})
    line += format("  %18s", entry(bounds.*bound, of_one.*bound).c_str());
  return line;
}

/// Shares of materials that are solids.
std::vector<double> without_pressures(const material::NamedMaterials& materials,
                                      std::vector<double> shares) {
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (material::is_pressure(materials[m].second)) shares[m] = 0.0;
  return shares;
}

}  // namespace

Mixture mixture_of(const material::NamedMaterials& materials, const std::vector<double>& shares,
                   const std::vector<material::SmallStrainModuli>& extremes) {
  const std::vector<material::SmallStrainModuli> moduli = material::moduli_of(materials);
  const bool varies = !extremes.empty();
  Mixture mixture;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!(shares[m] > 0.0)) continue;
    mixture.soft.push_back({shares[m], varies ? extremes[2 * m] : moduli[m]});
    mixture.stiff.push_back({shares[m], varies ? extremes[2 * m + 1] : moduli[m]});
    mixture.which.push_back(m);
  }
  return mixture;
}

material::MixtureBounds bounds_of(const Mixture& mixture, bool plane_strain) {
  const auto of_phases =
      plane_strain ? material::bounds_in_plane_strain : material::bounds_in_space;
  const material::MixtureBounds soft = of_phases(mixture.soft);
  material::MixtureBounds bounds = of_phases(mixture.stiff);
  for (Bounds material::MixtureBounds::*of :
       {&material::MixtureBounds::shear, &material::MixtureBounds::bulk,
        &material::MixtureBounds::young}) {
    (bounds.*of).reuss = (soft.*of).reuss;
    (bounds.*of).lower = (soft.*of).lower;
  }
  return bounds;
}

bool are_isotropic(const material::NamedMaterials& materials) {
  return std::none_of(materials.begin(), materials.end(),
                      [](const auto& named) { return named.second.fibers.has_value(); });
}

std::vector<std::string> bounds_table(const material::NamedMaterials& materials,
                                      const std::vector<double>& shares,
                                      const std::vector<material::SmallStrainModuli>& extremes,
                                      bool plane_strain, bool has_empty_space) {
  if (!are_isotropic(materials)) return {};
  const std::vector<double> of_solid = without_pressures(materials, shares);
  const Mixture mixture = mixture_of(materials, of_solid, extremes);
  if (mixture.which.empty() || (mixture.which.size() < 2 && extremes.empty())) return {};
  double total = 0.0;
  for (const double share : of_solid) total += share;
  std::string description;
  std::size_t one = mixture.which.front();  // the material that the gains refer to
  for (const std::size_t m : mixture.which) {
    description += format("%s%.4f %s", description.empty() ? "" : " + ", of_solid[m] / total,
                          materials[m].first.c_str());
    if (materials[m].second.label == 0) one = m;
  }

  const material::Phase alone_phase{1.0, material::moduli_of(materials)[one]};
  const material::MixtureBounds bounds = bounds_of(mixture, plane_strain),
                                alone = bounds_of({{alone_phase}, {alone_phase}, {}}, plane_strain);
  std::vector<std::string> lines{
      format("bounds      of small strain, %s, and gain over %s",
             plane_strain ? "in plane strain" : "in space", materials[one].first.c_str()),
      "            " + description +
          (of_solid != shares ? " of the solid; pressures and empty space not counted"
           : has_empty_space  ? " of the solid; empty space not counted"
                              : "")};
  std::string head = format("            %-18s", "");
  for (const char* name : {"Reuss", "Hashin-Shtrikman -", "Hashin-Shtrikman +", "Voigt"})
    head += format("  %18s", name);
  lines.push_back(head);
  lines.push_back(row("shear mu", bounds.shear, alone.shear));
  lines.push_back(row(plane_strain ? "plane bulk k" : "bulk K", bounds.bulk, alone.bulk));
  lines.push_back(
      row(plane_strain ? "between rollers E'" : "Young's E", bounds.young, alone.young));
  return lines;
}

}  // namespace stroma
