// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyComparison.hpp"

namespace stroma {
namespace {

using Records = std::vector<std::optional<ForceRecord>>;

/// A figure of a member and its reference, where both have a record.
template <class Figure>
std::optional<double> of_pair(const Pairing& pairing, const std::vector<Member>& members,
                              const Records& records, std::size_t member, Figure figure) {
  const auto reference = reference_of(pairing, members, member);
  if (!reference || !records[member] || !records[*reference]) return std::nullopt;
  return figure(*records[member], *records[*reference]);
}

}  // namespace

std::optional<std::size_t> reference_of(const Pairing& pairing, const std::vector<Member>& members,
                                        std::size_t member) {
  std::vector<std::string> wanted = members[member].labels;
  if (wanted[pairing.variation] == pairing.label) return std::nullopt;
  wanted[pairing.variation] = pairing.label;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (members[m].labels == wanted) return m;
  return std::nullopt;
}

ComparisonTable compare(const Study& study, const std::vector<Member>& members,
                        const Records& records) {
  ComparisonTable table;
  if (study.gain) table.columns.emplace_back("gain");
  if (study.compare)
    table.columns.insert(table.columns.end(), {"force_departure_rms", "force_departure_end"});
  table.columns.emplace_back("secant_departure");
  for (std::size_t m = 0; m < members.size(); ++m) {
    std::vector<std::optional<double>>& row = table.rows.emplace_back();
    if (study.gain) row.push_back(of_pair(*study.gain, members, records, m, force_departure_end));
    if (study.compare) {
      row.push_back(of_pair(*study.compare, members, records, m, force_departure_rms));
      row.push_back(of_pair(*study.compare, members, records, m, force_departure_end));
    }
    row.push_back(records[m] ? secant_departure(*records[m]) : std::nullopt);
  }
  return table;
}

}  // namespace stroma
