// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Particles and a state, for tests of the files that hold them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "stroma/output/files/ParticleFile.hpp"

namespace stroma {

/// Particles whose values all follow from their global numbers, so that each file can be judged
/// alone. The last of several ranks has none; material 2 has none anywhere; material 1 only on even
/// ranks.
struct ParticleSample {
  explicit ParticleSample(std::int64_t count, std::int64_t first_id = 1000) {
    const auto world = base::Communicator::world();
    const bool empty = world.size() > 1 && world.rank() == world.size() - 1;
    set.count = empty ? 0 : count;
    for (std::int64_t p = 0; p < set.count; ++p) {
      const std::int64_t global = first_id + world.rank() * count + p;
      const double g = static_cast<double>(global % 1000);
      id.push_back(global);
      material.push_back((world.rank() % 2 == 0 && p % 3 == 1) ? 1 : 0);
      volume.push_back(1.0 + g);
      for (int i = 0; i < 3; ++i) position.push_back(g + 0.25 * i);
      for (int i = 0; i < 3; ++i) displacement.push_back(1e-3 * g + i);
      for (int i = 0; i < 6; ++i) stress.push_back(stress_of(global, i));
      for (int i = 0; i < 9; ++i) gradient.push_back(gradient_of(global, i / 3, i % 3));
      jacobian.push_back(1.0 + 1e-4 * g);
      energy.push_back(1.0 / 3.0 + g);
    }
    set.position = position.data();
    set.volume = volume.data();
    set.id = id.data();
    set.material = material.data();
    state = {displacement.data(), stress.data(), gradient.data(), jacobian.data(), energy.data()};
  }
  /// The state seven particles at a time, as if it were computed on the way.
  output::StatePieces in_pieces() const {
    return [this](const auto& use) {
      for (std::int64_t first = 0; first < set.count; first += 7)
        use(first, std::min<std::int64_t>(7, set.count - first),
            {state.displacement + 3 * first, state.stress + 6 * first, state.gradient + 9 * first,
             state.jacobian + first, state.strain_energy_density + first});
    };
  }

  static double stress_of(std::int64_t global, int i) {
    return std::sin(0.1 * static_cast<double>(global % 1000) + i) * 500.0;
  }

  /// H(i, j)
  static double gradient_of(std::int64_t global, int i, int j) {
    return std::cos(0.3 * static_cast<double>(global % 1000) + 3.0 * i + j);
  }

  std::vector<std::int64_t> id;
  std::vector<std::uint8_t> material;
  std::vector<double> position, volume, displacement, stress, gradient, jacobian, energy;
  output::ParticleSet set;
  output::ParticleState state;
};

}  // namespace stroma
