// SPDX-License-Identifier: BSD-3-Clause

#include "run/BoundsTable.hpp"

#include <cstddef>

#include "stroma/base/Log.hpp"
#include "stroma/material/Bounds.hpp"

namespace stroma {
namespace {

using base::format;
using material::Bounds;

/// "576.7 Pa +10.72 %": a modulus, and its gain over that of one material.
std::string entry(double modulus, double of_one) {
  return format("%.4g Pa %+.2f %%", modulus, 100.0 * (modulus / of_one - 1.0));
}

/// The lower bounds of a mixture of the softest and the upper ones of one of the stiffest: both grow
/// with the moduli.
material::MixtureBounds between(const material::MixtureBounds& soft,
                                const material::MixtureBounds& stiff) {
  material::MixtureBounds bounds = stiff;
  for (Bounds material::MixtureBounds::*of :
       {&material::MixtureBounds::shear, &material::MixtureBounds::bulk,
        &material::MixtureBounds::young}) {
    (bounds.*of).reuss = (soft.*of).reuss;
    (bounds.*of).lower = (soft.*of).lower;
  }
  return bounds;
}

std::string row(const char* modulus, const Bounds& bounds, const Bounds& of_one) {
  std::string line = format("            %-18s", modulus);
  for (double Bounds::*bound : {&Bounds::reuss, &Bounds::lower, &Bounds::upper, &Bounds::voigt})
    line += format("  %18s", entry(bounds.*bound, of_one.*bound).c_str());
  return line;
}

}  // namespace

std::vector<std::string> bounds_table(const material::NamedMaterials& materials,
                                      const std::vector<double>& shares,
                                      const std::vector<material::SmallStrainModuli>& extremes,
                                      bool plane_strain, bool has_empty_space) {
  for (const auto& named : materials)
    if (named.second.fibers) return {};  // bounds are those of isotropic materials
  const std::vector<material::SmallStrainModuli> moduli = material::moduli_of(materials);
  std::vector<material::Phase> soft, stiff;
  std::string mixture;
  double total = 0.0;
  for (const double share : shares) total += share;
  std::size_t one = materials.size();  // the material that the gains refer to
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (!(shares[m] > 0.0)) continue;
    const bool varies = !extremes.empty();
    soft.push_back({shares[m], varies ? extremes[2 * m] : moduli[m]});
    stiff.push_back({shares[m], varies ? extremes[2 * m + 1] : moduli[m]});
    mixture += format("%s%.4f %s", mixture.empty() ? "" : " + ", shares[m] / total,
                      materials[m].first.c_str());
    if (one == materials.size() || materials[m].second.label == 0) one = m;
  }
  if (soft.size() < 2 && extremes.empty()) return {};

  const auto bounds_of =
      plane_strain ? material::bounds_in_plane_strain : material::bounds_in_space;
  const material::MixtureBounds bounds = between(bounds_of(soft), bounds_of(stiff)),
                                alone = bounds_of({{1.0, moduli[one]}});
  std::vector<std::string> lines{
      format("bounds      of small strain, %s, and gain over %s",
             plane_strain ? "in plane strain" : "in space", materials[one].first.c_str()),
      "            " + mixture + (has_empty_space ? " of the solid; empty space not counted" : "")};
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
