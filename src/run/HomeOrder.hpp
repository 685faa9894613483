// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Results in the order in which particles were seeded, wherever they have moved.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/particles/Exchange.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma {

/// The way home of what particles bear that have moved across the grid: to the ranks that seeded
/// them, in the order of seeding (particles::home_of).
class HomeOrder {
 public:
  /// \param communicator  of the ranks that share the particles
  /// \param particles     as they are now, with homes
  /// \param count         particles that this rank seeded
  HomeOrder(const base::Communicator& communicator,
            const particles::Particles<grid::Device>& particles, int count);

  /// (particle, ...) -> (seeded particle, ...). Collective.
  template <class View>
  auto operator()(const View& here) const {
    const std::size_t numbers = particles::numbers_of(here);
    const auto values = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), here);
    typename View::non_const_type at_home;
    particles::allocate(at_home, "at home", count_, numbers);
    const auto home = Kokkos::create_mirror_view(at_home);
    const auto deliver = [&](const auto* from, int number) {
      std::copy_n(from, numbers, home.data() + numbers * static_cast<std::size_t>(number));
    };
    for (const Stay& stay : stay_)
      deliver(values.data() + numbers * static_cast<std::size_t>(stay.particle), stay.number);
    const auto arrived = particles::exchange_values(communicator_, leave_, values.data(), numbers);
    for (std::size_t n = 0; n < arrive_.size(); ++n)
      deliver(arrived.data() + numbers * n, arrive_[n]);
    Kokkos::deep_copy(at_home, home);
    return at_home;
  }

 private:
  struct Stay {
    int particle, number;  // at home
  };

  base::Communicator communicator_;
  std::size_t count_;
  std::vector<Stay> stay_;               // those that are at home
  std::vector<std::vector<int>> leave_;  // (rank) those that belong there
  std::vector<int> arrive_;              // numbers at home, in the order in which they arrive
};

}  // namespace stroma
