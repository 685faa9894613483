// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Values of particles that were written in another order, on other ranks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/particles/Exchange.hpp"

namespace stroma::particles {

/// The way of rows of values, each of one particle, from the ranks that read them to those that
/// have the particles. Ids meet on a third rank, that of their share of all numbers, so that nobody
/// needs room for more than its part.
class ById {
 public:
  /// Collective.
  /// \param communicator  of the ranks that share the particles
  /// \param own           ids of this rank's particles
  /// \param read          ids of the rows that this rank has read
  /// \throws base::InputError on all ranks when the two are not the same ids
  ById(const base::Communicator& communicator, const std::vector<std::int64_t>& own,
       const std::vector<std::int64_t>& read);

  /// (row read, number) -> (own particle, number). Collective.
  template <class T>
  std::vector<T> operator()(const std::vector<T>& rows, std::size_t numbers) const {
    const auto met = exchange_values(communicator_, to_meet_, rows.data(), numbers);
    const auto home = exchange_values(communicator_, to_home_, met.data(), numbers);
    std::vector<T> values(home.size());
    for (std::size_t n = 0; n < number_.size(); ++n)
      std::copy_n(home.data() + numbers * n, numbers,
                  values.data() + numbers * static_cast<std::size_t>(number_[n]));
    return values;
  }

 private:
  base::Communicator communicator_;
  std::vector<std::vector<int>> to_meet_;  // (rank) rows that this rank has read
  std::vector<std::vector<int>> to_home_;  // (rank) rows that met their particles here
  std::vector<int> number_;                // of the particle, of each row that comes home
};

}  // namespace stroma::particles
