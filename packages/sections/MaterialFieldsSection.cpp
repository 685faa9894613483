// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/MaterialFieldsSection.hpp"

#include "stroma/base/Log.hpp"
#include "stroma/sections/Ascending.hpp"

namespace stroma::sections {

using namespace material;

deck::Section<MaterialFields> material_fields_section() {
  deck::Section<FieldParameters> field(
      "NAME", "One number of the material, by the intensity of the image; NAME is the user's.");
  field.required_choice(
      "Parameter", &FieldParameters::number,
      {{name_of(VaryingNumber::shear_modulus), VaryingNumber::shear_modulus}},
      "The number that varies. Shear Modulus [Pa]: of each particle; its other moduli are in "
      "proportion, so that Poisson's ratio is the material's. The material's own Shear Modulus [Pa] "
      "then only stands for it where one number has to: beside Bulk Modulus [Pa], and in bounds.");
  field.required("Intensities", &FieldParameters::intensities, deck::not_empty(),
                 "Intensities of the image as the file has them, before smoothing; ascending.");
  field.required("Values", &FieldParameters::values, deck::positive(),
                 "The number at each of these intensities: linear between two, and constant beyond "
                 "the first and the last. A particle takes the intensity of its voxel.");
  field.check([](const FieldParameters& p, deck::Findings& findings) {
    if (p.values.size() != p.intensities.size())
      findings.add("Values", base::format("%zu numbers for %zu Intensities; admissible: one each",
                                          p.values.size(), p.intensities.size()));
    refuse_descending("Intensities", p.intensities, findings);
  });

  deck::Section<MaterialFields> section(
      "Fields", "Numbers that vary within the material, one sublist each, named by the user.");
  section.named_sections(field, &MaterialFields::fields);
  section.check([](const MaterialFields& p, deck::Findings& findings) {
    for (std::size_t n = 1; n < p.fields.size(); ++n)
      for (std::size_t m = 0; m < n; ++m)
        if (p.fields[m].second.number == p.fields[n].second.number) {
          findings.add(p.fields[n].first, std::string("gives ") +
                                              name_of(p.fields[n].second.number) + ", as \"" +
                                              p.fields[m].first + "\" does");
          break;
        }
  });
  return section;
}

}  // namespace stroma::sections
