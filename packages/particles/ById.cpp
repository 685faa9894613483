// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/particles/ById.hpp"

#include <numeric>

#include "stroma/base/Error.hpp"

namespace stroma::particles {
namespace {

/// (rank) the entries of a list that meet there.
std::vector<std::vector<int>> meeting_places(const std::vector<std::int64_t>& ids,
                                             std::int64_t ids_of_a_rank, int ranks) {
  std::vector<std::vector<int>> places(static_cast<std::size_t>(ranks));
  for (std::size_t n = 0; n < ids.size(); ++n)
    places[static_cast<std::size_t>(ids[n] / ids_of_a_rank)].push_back(static_cast<int>(n));
  return places;
}

/// The order in which ids ascend.
std::vector<std::size_t> ascending(const std::vector<std::int64_t>& ids) {
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  return order;
}

std::int64_t largest(const std::vector<std::int64_t>& ids) {
  return ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
}

bool is_negative(std::int64_t id) { return id < 0; }

}  // namespace

ById::ById(const base::Communicator& communicator, const std::vector<std::int64_t>& own,
           const std::vector<std::int64_t>& read)
    : communicator_(communicator), to_home_(static_cast<std::size_t>(communicator.size())) {
  const auto refuse_unless = [&](bool are_the_same) {
    if (communicator.any(!are_the_same))
      throw base::InputError("its particles are not those of the deck");
  };
  refuse_unless(std::none_of(read.begin(), read.end(), is_negative));
  const std::int64_t share =
      communicator.max(std::max(largest(own), largest(read))) / communicator.size() + 1;
  const auto own_meet = meeting_places(own, share, communicator.size());
  to_meet_ = meeting_places(read, share, communicator.size());
  std::vector<std::int64_t> homes(own.size());
  for (std::size_t p = 0; p < own.size(); ++p)
    homes[p] = home_of(communicator.rank(), static_cast<int>(p));

  const auto own_id = exchange_values(communicator, own_meet, own.data(), 1);
  const auto own_home = exchange_values(communicator, own_meet, homes.data(), 1);
  const auto row_id = exchange_values(communicator, to_meet_, read.data(), 1);
  const auto own_order = ascending(own_id), row_order = ascending(row_id);
  bool are_the_same = own_id.size() == row_id.size();
  for (std::size_t n = 0; are_the_same && n < own_order.size(); ++n)
    are_the_same = own_id[own_order[n]] == row_id[row_order[n]];
  refuse_unless(are_the_same);

  std::vector<std::int64_t> home(row_id.size());  // (row that has come here)
  for (std::size_t n = 0; n < own_order.size(); ++n) home[row_order[n]] = own_home[own_order[n]];
  for (std::size_t row = 0; row < home.size(); ++row)
    to_home_[static_cast<std::size_t>(home_rank(home[row]))].push_back(static_cast<int>(row));
  for (const std::int64_t arrived : exchange_values(communicator, to_home_, home.data(), 1))
    number_.push_back(home_number(arrived));
}

}  // namespace stroma::particles
