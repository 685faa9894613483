// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/report/ReportPage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "stroma/base/Log.hpp"
#include "stroma/output/report/Embedded.hpp"
#include "stroma/output/report/Packed.hpp"

namespace stroma::output {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string for_html(const std::string& text) {
  return replaced(replaced(text, "&", "&amp;"), "<", "&lt;");
}

/// The range of a field over all steps: all of it, and what but 0.5 % of the cells of a step at each
/// end lie in, by a sample of the cells where they are many.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  double shown_low = low, shown_high = high;
};

Range range_of(const FieldMap& field) {
  constexpr std::size_t most = 100'000;
  Range range;
  for (const std::vector<float>& values : field.values) {
    const std::size_t stride = 1 + values.size() / most;
    std::vector<float> sample;
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      if (!std::isfinite(values[cell])) continue;
      range.low = std::min(range.low, static_cast<double>(values[cell]));
      range.high = std::max(range.high, static_cast<double>(values[cell]));
      if (cell % stride == 0) sample.push_back(values[cell]);
    }
    if (sample.empty()) continue;
    const auto at_share = [&](double share) {
      const auto place = sample.begin() + static_cast<std::ptrdiff_t>(
                                              share * static_cast<double>(sample.size() - 1));
      std::nth_element(sample.begin(), place, sample.end());
      return static_cast<double>(*place);
    };
    range.shown_low = std::min(range.shown_low, at_share(0.005));
    range.shown_high = std::max(range.shown_high, at_share(0.995));
  }
  return range;
}

}  // namespace

std::string report_page(const std::string& title, const nlohmann::json& data,
                        const std::vector<PageArray>& arrays) {
  using Replace = nlohmann::json::error_handler_t;
  // "</script>" in a text would end the element: within JSON's texts, < may be written otherwise.
  const std::string json = replaced(data.dump(-1, ' ', false, Replace::replace), "<", "\\u003c");
  const std::string_view page = embedded::page();
  std::string text;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t begin = page.find("{{", at), end = page.find("}}", begin);
    text += page.substr(at, begin - at);
    if (begin == std::string_view::npos) break;
    const std::string_view place = page.substr(begin + 2, end - begin - 2);
    if (place == "title") text += for_html(title);
    if (place == "style") text += embedded::style();
    if (place == "script") text += embedded::script();
    if (place == "charts") text += embedded::charts();
    if (place == "licence") text += for_html(std::string(embedded::charts_licence()));
    if (place == "data") text += json;
    if (place == "arrays")
      for (const auto& [name, values] : arrays)
        text.append("<script type=\"text/plain\" id=\"")
            .append(name)
            .append("\">")
            .append(values)
            .append("</script>\n");
    at = end + 2;
  }
  return text;
}

nlohmann::json describe(const ParticleMaps& maps, const std::vector<double>& loads,
                        const std::vector<double>& step_numbers, const std::vector<double>& times,
                        std::vector<PageArray>& arrays) {
  nlohmann::json steps = nlohmann::json::array(), fields = nlohmann::json::array();
  for (const std::size_t s : maps.steps)
    steps.push_back({{"step", step_numbers[s]}, {"load", loads[s]}, {"time", times[s]}});
  for (std::size_t f = 0; f < maps.fields.size(); ++f) {
    const FieldMap& field = maps.fields[f];
    if (field.values.empty()) continue;
    const Range range = range_of(field);
    fields.push_back({{"name", field.name},
                      {"unit", field.unit},
                      {"low", range.low},
                      {"high", range.high},
                      {"shown_low", range.shown_low},
                      {"shown_high", range.shown_high}});
    for (std::size_t s = 0; s < field.values.size(); ++s)
      arrays.emplace_back(base::format("map-%zu-%zu", f, s),
                          packed(quantised(field.values[s], range.low, range.high)));
  }
  arrays.emplace_back("map-material", packed(maps.material));
  const MapLattice& lattice = maps.lattice;
  return {{"origin", lattice.origin},
          {"cell", lattice.cell},
          {"count", lattice.count},
          {"merged", lattice.merged},
          {"materials", maps.materials},
          {"steps", steps},
          {"steps_in_file", maps.steps_in_file},
          {"fields", fields}};
}

nlohmann::json table_excerpt(const std::string& text, std::size_t most, bool evenly) {
  std::istringstream lines(text);
  std::string header;
  std::getline(lines, header);
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  const std::size_t kept = std::min(most, rows.size());
  std::string excerpt = header + "\n";
  for (std::size_t n = 0; n < kept; ++n)
    excerpt += rows[evenly && rows.size() > most ? n * (rows.size() - 1) / (most - 1) : n] + "\n";
  return {{"text", excerpt}, {"rows", kept}, {"of", rows.size()}};
}

}  // namespace stroma::output
