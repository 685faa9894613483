// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How far a run's force departs from another run's, and from a straight line.

#include <optional>
#include <vector>

namespace stroma {

/// The force of one support over the steps of a run that reached full load.
struct ForceRecord {
  std::vector<double> load;   ///< load factors, growing from 0 to 1 [-]
  std::vector<double> force;  ///< along the support's displacement [pN]
};

/// The record's force at a load factor in [0, 1], linear between steps [pN].
double force_at(const ForceRecord& record, double load);

/// max over the steps of |f(s) - s f(1)| / |f(1)|: the largest departure of the force from the
/// straight line between (0, 0) and its end, relative to its end [-]. Undefined where f(1) = 0.
std::optional<double> secant_departure(const ForceRecord& record);

/// sqrt(mean over the record's steps of (f(s) - g(s))^2) / |g(1)|, g the reference's force at the
/// same load factors, linear between its steps; the unloaded step does not count [-]. Undefined
/// where g(1) = 0, or there is no step.
std::optional<double> force_departure_rms(const ForceRecord& record, const ForceRecord& reference);

/// f(1) / g(1) - 1 [-]. Undefined where g(1) = 0.
std::optional<double> force_departure_end(const ForceRecord& record, const ForceRecord& reference);

}  // namespace stroma
