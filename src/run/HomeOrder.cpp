// SPDX-License-Identifier: BSD-3-Clause

#include "run/HomeOrder.hpp"

#include "stroma/particles/Exchange.hpp"

namespace stroma {
namespace {

/// The fields of one particle on their way home.
struct Letter {
  std::int64_t home;
  double displacement[3], stress[6], jacobian, energy;
};

}  // namespace

transfer::ParticleFields<grid::Device> in_home_order(
    const base::Communicator& communicator, const particles::Particles<grid::Device>& particles,
    const transfer::ParticleFields<grid::Device>& fields, int count) {
  if (!communicator.any(particles.home.extent(0) != 0)) return fields;
  const auto host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  };
  const auto home = host(particles.home);
  const auto displacement = host(fields.displacement);
  const auto stress = host(fields.stress);
  const auto jacobian = host(fields.jacobian);
  const auto energy = host(fields.energy);

  transfer::ParticleFields<grid::Device> at_home(count);
  const auto home_displacement = Kokkos::create_mirror_view(at_home.displacement);
  const auto home_stress = Kokkos::create_mirror_view(at_home.stress);
  const auto home_jacobian = Kokkos::create_mirror_view(at_home.jacobian);
  const auto home_energy = Kokkos::create_mirror_view(at_home.energy);
  const auto deliver = [&](const Letter& letter) {
    const int n = particles::home_number(letter.home);
    for (int c = 0; c < 3; ++c) home_displacement(n, c) = letter.displacement[c];
    for (int c = 0; c < 6; ++c) home_stress(n, c) = letter.stress[c];
    home_jacobian(n) = letter.jacobian;
    home_energy(n) = letter.energy;
  };

  std::vector<std::vector<Letter>> letters(static_cast<std::size_t>(communicator.size()));
  for (std::size_t p = 0; p < home.extent(0); ++p) {
    Letter letter{home(p), {}, {}, jacobian(p), energy(p)};
    for (int c = 0; c < 3; ++c) letter.displacement[c] = displacement(p, c);
    for (int c = 0; c < 6; ++c) letter.stress[c] = stress(p, c);
    const int rank = particles::home_rank(letter.home);
    if (rank == communicator.rank()) {
      deliver(letter);
    } else {
      letters[static_cast<std::size_t>(rank)].push_back(letter);
    }
  }
  for (const Letter& letter : particles::exchange(communicator, letters)) deliver(letter);
  Kokkos::deep_copy(at_home.displacement, home_displacement);
  Kokkos::deep_copy(at_home.stress, home_stress);
  Kokkos::deep_copy(at_home.jacobian, home_jacobian);
  Kokkos::deep_copy(at_home.energy, home_energy);
  return at_home;
}

}  // namespace stroma
