// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How quantities are distributed over volumes whose parts are spread over the ranks.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// To which of several groups portions of a volume belong.
struct Groups {
  static constexpr std::uint16_t none = 0xffff;

  std::vector<std::uint16_t> of;  ///< (portion) its group, or none
  std::size_t count = 0;          ///< the same on all ranks
};

/// What there is to say of a quantity in one group; zeros of a group without any portion.
struct Distribution {
  static constexpr std::size_t bin_count = 64;

  double volume = 0.0;
  double mean = 0.0;  ///< by volume
  double minimum = 0.0, maximum = 0.0;
  std::vector<double> percentiles;       ///< (share asked for)
  std::array<double, bin_count> bins{};  ///< volumes, in equal steps from minimum to maximum
};

/// The distribution of a quantity over each group, by volume. No rank sees the portions of another.
/// The same on all ranks, and for any number of them but for the rounding of sums. Collective.
///
/// The percentile of a share q is a value that occurs: the smallest v such that the portions up to
/// v have at least the volume q V, less 1e-10 V, so that rounding decides nothing. It is looked for
/// among the values that are near it by their bin's bin, with bisection over the doubles in their
/// order: at most 64 sums over the ranks, for all groups together. A value that lies by less than
/// 1e-9 of a bin below the next bin is counted there, for the same reason.
///
/// \param communicator  of the ranks that share the groups
/// \param groups        of this rank's portions
/// \param volume        (portion)
/// \param values        (portion) the quantity; finite
/// \param shares        of the volume, in (0, 1), for percentiles
std::vector<Distribution> distributions(const base::Communicator& communicator,
                                        const Groups& groups, const std::vector<double>& volume,
                                        const std::vector<double>& values,
                                        const std::vector<double>& shares);

}  // namespace stroma::output
