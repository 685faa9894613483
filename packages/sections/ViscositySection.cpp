// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ViscositySection.hpp"

#include "stroma/base/Log.hpp"

namespace stroma::sections {

using namespace material;

deck::Section<ViscosityParameters> viscosity_section() {
  deck::Section<ViscosityParameters> section(
      "Viscosity",
      "The stress relaxes: S(t) = integral of G(t - s) dS_e/ds ds, G = G0 + sum g_i exp(-t/t_i), S_e "
      "the second Piola-Kirchhoff stress of matrix and fibres. Loading|Duration [s] or Times [s] "
      "gives the time.");
  section.required("Moduli", &ViscosityParameters::moduli, deck::not_negative(),
                   "g_1 to g_n, 1 to 6 of them, as shares of the elastic law.");
  section.required("Relaxation Times [s]", &ViscosityParameters::times, deck::positive(),
                   "t_1 to t_n, one each.");
  section.optional("G0", &ViscosityParameters::long_term, deck::not_negative(),
                   "What is left in the end; 1: the elastic law is the long-term one.");
  section.choice("Applies To", &ViscosityParameters::is_deviatoric,
                 {{"All", false}, {"Deviatoric", true}},
                 "All of the stress, or its deviatoric part alone: of laws whose energies of shape "
                 "and volume are apart, without Fibers of their own.");
  section.check([](const ViscosityParameters& p, deck::Findings& findings) {
    const std::size_t most = Viscosity::most_terms;
    if (p.moduli.empty() || p.moduli.size() > most)
      findings.add("Moduli", base::format("found %zu numbers; admissible: 1 to %zu of them",
                                          p.moduli.size(), most));
    if (p.times.size() != p.moduli.size())
      findings.add("Relaxation Times [s]",
                   base::format("%zu numbers for %zu Moduli; admissible: one each", p.times.size(),
                                p.moduli.size()));
  });
  return section;
}

}  // namespace stroma::sections
