// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/DrivesSection.hpp"

#include "stroma/sections/Directions.hpp"

namespace stroma::sections {

using namespace material;

namespace {

constexpr const char* meaning_of_direction =
    "N in the undeformed body, any length but 0; without it that of the first family of Fibers with "
    "Distribution = Single.";
constexpr const char* meaning_of_curve =
    "The name of one of the Load Curves, its factor; without it the load factor.";

/// \param kind  in which the direction is of no use
void check_direction(const MaterialParameters& material, const std::string& section,
                     const std::optional<std::array<double, 3>>& own, bool is_used,
                     const std::string& kind, deck::Findings& findings) {
  if (!is_used && own) findings.add(section + "|Direction", "is not used with Kind = " + kind);
  if (is_used && !direction_of(material, own))
    findings.add(section + "|Direction",
                 "missing; the material has no family of Fibers in a single direction, whose it "
                 "could be");
  refuse_no_length(section + "|Direction", own, findings);
}

}  // namespace

deck::Section<ActiveStressParameters> active_stress_section() {
  using Kind = ActiveStress::Kind;
  deck::Section<ActiveStressParameters> section(
      "Active Stress", "A stress that the material makes by itself, such as cells that contract.");
  section.choice(
      "Kind", &ActiveStressParameters::kind,
      {{"Isotropic", Kind::isotropic}, {"Fiber", Kind::fiber}, {"Transverse", Kind::transverse}},
      "Kirchhoff stress, with b = F F^T and n = F N, not a unit vector. Isotropic: T0 b. Fiber: T0 n "
      "x n. Transverse: T0 (b - n x n). The second Piola-Kirchhoff stress is constant.");
  section.required("T0 [Pa]", &ActiveStressParameters::t0, deck::any(),
                   "The stress at a factor of 1; positive contracts.");
  section.optional("Direction", &ActiveStressParameters::direction, deck::any(),
                   meaning_of_direction);
  section.optional("Load Curve", &ActiveStressParameters::load_curve, deck::not_empty(),
                   meaning_of_curve);
  return section;
}

deck::Section<GrowthParameters> growth_section() {
  using Kind = Growth::Kind;
  deck::Section<GrowthParameters> section(
      "Growth",
      "Growth of the shape without stress, F = F_e F_g: matrix, fibres and viscosity see F_e.");
  section.choice(
      "Kind", &GrowthParameters::kind,
      {{"Volume", Kind::volume}, {"Fiber", Kind::fiber}, {"Area", Kind::area}},
      "F_g by the ratio g of volumes. Volume: g^(1/3) I. Fiber: I + (g - 1) N x N. Area: "
      "sqrt(g) (I - N x N) + N x N.");
  section.required("Ratio", &GrowthParameters::ratio, deck::between(1e-5, 1e5),
                   "g at a factor of 1, from 1 at 0.");
  section.optional("Direction", &GrowthParameters::direction, deck::any(), meaning_of_direction);
  section.optional("Load Curve", &GrowthParameters::load_curve, deck::not_empty(),
                   meaning_of_curve);
  return section;
}

void check_drives(const MaterialParameters& p, deck::Findings& findings) {
  if (p.active_stress)
    check_direction(p, "Active Stress", p.active_stress->direction,
                    p.active_stress->kind != ActiveStress::Kind::isotropic, "Isotropic", findings);
  if (p.growth)
    check_direction(p, "Growth", p.growth->direction, p.growth->kind != Growth::Kind::volume,
                    "Volume", findings);
}

}  // namespace stroma::sections
