// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// history.csv: one row of figures per accepted load step.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {

/// The state of one material in the current configuration, over all ranks.
struct MaterialSummary {
  double volume = 0;          ///< current volume, sum of J V0 [um^3]
  double von_mises_mean = 0;  ///< mean von Mises stress, weighted by current volume [Pa]
  double von_mises_max = 0;   ///< largest von Mises stress [Pa]
};

/// One accepted load step. The same on every rank.
struct HistoryRow {
  std::int64_t step = 0;  ///< 0: unloaded
  double load = 0;        ///< load factor, 0 to 1 [-]
  double time = 0;        ///< [s]; without a duration the load factor
  std::int64_t newton_iterations = 0;
  std::int64_t linear_iterations = 0;  ///< summed over the step's Newton iterations
  double residual = 0;                 ///< ||residual|| / largest ||reaction|| so far [-]
  double wall_seconds = 0;             ///< since the run began [s]
  double strain_energy = 0;            ///< of the whole body [aJ]
  /// Of a body with inertia.
  struct Motion {
    double kinetic_energy = 0;  ///< [aJ]
    double external_work = 0;   ///< of supports and loads on the body, since the begin [aJ]
    double damping_work = 0;    ///< what damping has taken since then [aJ]
    double external_power = 0, damping_power = 0;  ///< of both at this step [aJ/s]
  };
  std::optional<Motion> motion;
  std::vector<std::array<double, 3>> reactions;  ///< (boundary condition) force on the body [pN]
  std::vector<double> torques;  ///< (condition that turns) on the body, about its axis [aJ]
  std::vector<MaterialSummary> materials;  ///< (material)
  std::vector<double> pressures;           ///< (material that presses) by its load curve [Pa]
};

/// What the columns are named after.
struct HistoryNames {
  std::vector<std::string> conditions;
  std::vector<std::string> turning;  ///< those of the conditions whose faces turn
  std::vector<std::string> materials;
  bool has_inertia = false;
  std::vector<std::string> pressing = {};  ///< those of the materials that are pressures
};

/// Names and order of the columns, as in docs: step, load, time, ..., those of a body with inertia, then NAME.reaction_x/y/z of each
/// boundary condition, NAME.torque of each that turns, then NAME.volume, NAME.von_mises_mean, NAME.von_mises_max of each material, and NAME.pressure of each
/// that is a pressure.
std::vector<std::string> history_columns(const HistoryNames& names);

/// The row as numbers, in the order of history_columns.
std::vector<double> history_values(const HistoryRow& row);

/// The row of such numbers.
HistoryRow history_row(const std::vector<double>& values, const HistoryNames& names);

/// Writes history.csv from rank 0: a header, then a row per step, on disk before append() returns,
/// so that a killed run keeps every completed step. Floating-point numbers have 17 significant
/// digits, which read back to the same bits. A name with a comma or a quote is quoted as in RFC
/// 4180.
class History {
 public:
  /// Writes the file anew, all at once: the header, and the rows of a run that goes on. Collective.
  /// \param communicator  of the run
  /// \param path          of the file
  /// \param names         of its columns
  /// \param rows          the first ones of the file
  /// \throws RunError on all ranks when the file cannot be written
  History(const base::Communicator& communicator, std::string path, HistoryNames names,
          const std::vector<HistoryRow>& rows = {});

  /// Adds one row. Collective.
  /// \throws RunError on all ranks when the row did not reach the file (disk full), or does not
  ///         have as many reactions, torques, materials and pressures as the header
  void append(const HistoryRow& row);

 private:
  base::Communicator communicator_;
  std::string path_;
  HistoryNames names_;
};

}  // namespace stroma::output
