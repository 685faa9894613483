// SPDX-License-Identifier: BSD-3-Clause

#include "study/ForceDeparture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stroma {
namespace {

bool has_end(const ForceRecord& record) {
  return !record.force.empty() && record.force.back() != 0.0;
}

}  // namespace

double force_at(const ForceRecord& record, double load) {
  const auto after = std::lower_bound(record.load.begin(), record.load.end(), load);
  if (after == record.load.end()) return record.force.back();
  const auto i = static_cast<std::size_t>(after - record.load.begin());
  if (i == 0 || record.load[i] == load) return record.force[i];
  const double part = (load - record.load[i - 1]) / (record.load[i] - record.load[i - 1]);
  return record.force[i - 1] + part * (record.force[i] - record.force[i - 1]);
}

std::optional<double> secant_departure(const ForceRecord& record) {
  const bool has_between = std::any_of(record.load.begin(), record.load.end(),
                                       [](double load) { return load > 0.0 && load < 1.0; });
  if (!has_end(record) || !has_between) return std::nullopt;
  const double end = record.force.back();
  double largest = 0.0;
  for (std::size_t s = 0; s < record.load.size(); ++s)
    largest = std::max(largest, std::abs(record.force[s] - record.load[s] * end));
  return largest / std::abs(end);
}

std::optional<double> force_departure_rms(const ForceRecord& record, const ForceRecord& reference) {
  if (!has_end(reference)) return std::nullopt;
  double sum = 0.0;
  int steps = 0;
  for (std::size_t s = 0; s < record.load.size(); ++s) {
    if (record.load[s] <= 0.0) continue;
    const double difference = record.force[s] - force_at(reference, record.load[s]);
    sum += difference * difference;
    ++steps;
  }
  if (steps == 0) return std::nullopt;
  return std::sqrt(sum / steps) / std::abs(reference.force.back());
}

std::optional<double> force_departure_end(const ForceRecord& record, const ForceRecord& reference) {
  if (!has_end(reference) || record.force.empty()) return std::nullopt;
  return (record.force.back() - reference.force.back()) / reference.force.back();
}

}  // namespace stroma
