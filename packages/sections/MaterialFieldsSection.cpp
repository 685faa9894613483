// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/MaterialFieldsSection.hpp"

#include <algorithm>

#include "stroma/base/Log.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/material/VaryingMaterial.hpp"
#include "stroma/sections/Ascending.hpp"
#include "stroma/sections/FieldImage.hpp"
#include "stroma/sections/ModelNumbers.hpp"

namespace stroma::sections {

using namespace material;

deck::Section<MaterialFields> material_fields_section() {
  deck::Section<FieldParameters> field(
      "NAME", "One number of the material, by the intensity of an image; NAME is the user's.");
  field.required(
      "Parameter", &FieldParameters::parameter, deck::not_empty(),
      "The number that varies: any that the material gives. \"C1 [Pa]\"; \"C [Pa]|2\", the "
      "second of a list; \"Fibers|FAMILY|Xi [Pa]\"; \"Viscosity|Moduli|1\"; "
      "\"Active Stress|T0 [Pa]\"; \"Growth|Ratio\". What follows from it by Poisson Ratio "
      "varies with it. The material's own value then only stands where one number has "
      "to.");
  declare_field_image(field);
  field.optional("Smoothing [um]", &FieldParameters::smoothing, deck::not_negative(),
                 "Standard deviation of a Gaussian over the intensities, as "
                 "Image|Segmentation|Smoothing [um].");
  field.required("Intensities", &FieldParameters::intensities, deck::not_empty(),
                 "Intensities of the image as the file has them; ascending.");
  field.required("Values", &FieldParameters::values, deck::any(),
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
        if (p.fields[m].second.parameter == p.fields[n].second.parameter) {
          findings.add(p.fields[n].first, "gives " + p.fields[n].second.parameter + ", as \"" +
                                              p.fields[m].first + "\" does");
          break;
        }
  });
  return section;
}

void check_fields(const MaterialParameters& p, deck::Findings& findings) {
  if (!p.fields) return;
  const std::vector<VaryingNumber> numbers = numbers_that_may_vary(p);
  std::vector<std::string> names;
  for (const VaryingNumber& number : numbers) names.push_back(number.name);
  for (const auto& [name, field] : p.fields->fields) {
    const std::string where = "Fields|" + name + "|";
    const auto found = std::find(names.begin(), names.end(), field.parameter);
    if (found == names.end()) {
      findings.add(where + "Parameter",
                   "found \"" + field.parameter +
                       "\", which is no number of the material that may vary; " +
                       deck::suggestion(field.parameter, names));
      continue;
    }
    const Range& range = numbers[static_cast<std::size_t>(found - names.begin())].admissible;
    const deck::Admissible rule = admissible(range);
    for (const double value : field.values)
      if (!rule.allows(value))
        findings.add(where + "Values",
                     base::format("found %g; admissible for %s: ", value, found->c_str()) +
                         rule.describe(deck::detail::value_type<double>()));
    const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
    if (!range.has_zero && *least < 0.0 && *most > 0.0)
      findings.add(where + "Values", base::format("pass 0 between %g and %g; admissible for %s: "
                                                  "numbers of one sign",
                                                  *least, *most, found->c_str()));
  }
}

}  // namespace stroma::sections
