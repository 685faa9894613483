// SPDX-License-Identifier: BSD-3-Clause

#include "run/HomeOrder.hpp"

namespace stroma {

HomeOrder::HomeOrder(const base::Communicator& communicator,
                     const particles::Particles<grid::Device>& particles, int count)
    : communicator_(communicator),
      count_(static_cast<std::size_t>(count)),
      leave_(static_cast<std::size_t>(communicator.size())) {
  const auto home = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.home);
  for (int p = 0; p < particles.count(); ++p) {
    const int rank = particles::home_rank(home(p));
    if (rank == communicator.rank())
      stay_.push_back({p, particles::home_number(home(p))});
    else
      leave_[static_cast<std::size_t>(rank)].push_back(p);
  }
  for (const std::int64_t arrived :
       particles::exchange_values(communicator, leave_, home.data(), 1))
    arrive_.push_back(particles::home_number(arrived));
}

}  // namespace stroma
