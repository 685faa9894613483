// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/particles/Migration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/particles/Exchange.hpp"
#include "stroma/particles/Seeding.hpp"

namespace stroma::particles {
namespace {

/// Element of a position; the tolerance is that of seeding, so that both sort alike.
std::int64_t element_along(const grid::Grid& grid, int d, double position) {
  return static_cast<std::int64_t>(
      std::floor((position - grid.origin[d]) / grid.spacing[d] + face_tolerance));
}

/// The element at a position in a grid that covers it, whatever rounding says at the upper faces.
grid::Index3 element_at(const grid::Grid& grid, const double position[3]) {
  grid::Index3 element;
  for (int d = 0; d < 3; ++d)
    element[d] =
        std::clamp<std::int64_t>(element_along(grid, d, position[d]), 0, grid.elements[d] - 1);
  return element;
}

}  // namespace

void make_movable(const base::Communicator& communicator, Particles<grid::Device>& particles) {
  const auto count = static_cast<std::size_t>(particles.count());
  for_each_field(
      [&](const Field& field, auto& view) {
        if (field.presence != Presence::where_particles_move) return;
        allocate(view, field.name, count);
        Kokkos::deep_copy(view, 0);
      },
      particles);
  const auto home = Kokkos::create_mirror_view(particles.home);
  for (std::size_t p = 0; p < count; ++p)
    home(p) = home_of(communicator.rank(), static_cast<int>(p));
  Kokkos::deep_copy(particles.home, home);
}

ParticleExtent extent_of(const base::Communicator& communicator,
                         const Particles<grid::Device>& particles,
                         const std::array<double, 3>& half_edge) {
  const auto position =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.position);
  const auto gradient =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.base_gradient);
  const bool has_gradient = gradient.extent(0) != 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ParticleExtent extent;
  for (int d = 0; d < 3; ++d) {
    double lowest = infinity, highest = -infinity;
    for (int p = 0; p < particles.count(); ++p) {
      double reach = 0.0;
      for (int e = 0; e < 3; ++e) {
        const double F = (d == e ? 1.0 : 0.0) + (has_gradient ? gradient(p, d, e) : 0.0);
        reach += std::abs(F) * half_edge[static_cast<std::size_t>(e)];
      }
      lowest = std::min(lowest, position(p, d) - reach);
      highest = std::max(highest, position(p, d) + reach);
    }
    extent.lowest[d] = communicator.min(lowest);
    extent.highest[d] = communicator.max(highest);
  }
  return extent;
}

void require_together(const ParticleExtent& extent, const grid::Grid& body) {
  double elements = 1.0;
  for (int d = 0; d < (body.flat ? 2 : 3); ++d) {
    const double lowest = extent.lowest[d], highest = extent.highest[d];
    elements *= 1.0 + (highest - lowest) / body.spacing[d];
    if (!(elements < 64.0 * static_cast<double>(body.all_elements().count()) + 4096.0))
      throw base::RunError(base::format(
          "the particles are spread from %g to %g um along %c: some must have got lost", lowest,
          highest, "xyz"[d]));
  }
}

grid::Grid covering_grid(const ParticleExtent& extent, const grid::Grid& body,
                         const FixedEnds& fixed) {
  require_together(extent, body);
  grid::Grid grid = body;
  for (int d = 0; d < (body.flat ? 2 : 3); ++d) {
    const double lowest = extent.lowest[d], highest = extent.highest[d];
    const auto& [is_lower_fixed, is_upper_fixed] = fixed[static_cast<std::size_t>(d)];
    const std::int64_t first = is_lower_fixed ? 0 : element_along(body, d, lowest);
    const std::int64_t last =
        is_upper_fixed ? body.elements[d] - 1 : element_along(body, d, highest);
    grid.origin[d] = body.origin[d] + static_cast<double>(first) * body.spacing[d];
    grid.elements[d] = last - first + 1;
    if (grid.centered && grid.elements[d] == 1) grid.elements[d] = 2;
  }
  return grid;
}

grid::Partition balanced_partition(const base::Communicator& communicator, const grid::Grid& grid,
                                   const Particles<grid::Device>& particles) {
  const auto position =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.position);
  std::array<std::vector<double>, 3> weights;
  for (int d = 0; d < 3; ++d) weights[d].assign(static_cast<std::size_t>(grid.elements[d]), 0.0);
  for (int p = 0; p < particles.count(); ++p) {
    const grid::Index3 element = element_at(grid, &position(p, 0));
    for (int d = 0; d < 3; ++d) weights[d][static_cast<std::size_t>(element[d])] += 1.0;
  }
  for (auto& weight : weights) communicator.sum_all(weight.data(), weight.size());
  try {
    return grid::Partition::balanced(grid, communicator.size(), weights);
  } catch (const base::InputError& error) {
    throw base::RunError(error.what());
  }
}

Particles<grid::Device> migrate(const base::Communicator& communicator,
                                const grid::Partition& partition,
                                const Particles<grid::Device>& particles) {
  const grid::Grid& grid = partition.grid();
  const grid::Box box = partition.elements(communicator.rank());
  const HostParticles before = on_host(particles);

  std::vector<int> stay;
  std::vector<std::vector<int>> leave(static_cast<std::size_t>(communicator.size()));
  for (int p = 0; p < particles.count(); ++p) {
    const grid::Index3 element = element_at(grid, &before.position(p, 0));
    if (box.contains(element))
      stay.push_back(p);
    else
      leave[static_cast<std::size_t>(partition.owner_of_element(element))].push_back(p);
  }
  const std::vector<double> position =
      exchange_values(communicator, leave, before.position.data(), 3);
  const std::vector<std::int64_t> id = exchange_values(communicator, leave, before.id.data(), 1);
  const std::size_t count = stay.size() + id.size();
  const auto total = communicator.sum<std::int64_t>(particles.count());
  if (communicator.sum(static_cast<std::int64_t>(count)) != total)
    throw base::RunError("particles were lost on the way between ranks");
  if (communicator.any(count > static_cast<std::size_t>(std::numeric_limits<int>::max())))
    throw base::RunError("more than 2^31 particles on one rank; run with more ranks");

  // Counting sort by element; those of one element by id.
  struct Place {
    std::int64_t id;
    std::size_t source;  // of stay, then of those that arrive
  };
  std::vector<int> element(count);
  std::vector<int> begin(static_cast<std::size_t>(box.count()) + 1, 0);
  for (std::size_t n = 0; n < count; ++n) {
    const double* x =
        n < stay.size() ? &before.position(stay[n], 0) : &position[3 * (n - stay.size())];
    element[n] = static_cast<int>(box.local(element_at(grid, x)));
    ++begin[static_cast<std::size_t>(element[n]) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Place> order(count);
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t n = 0; n < count; ++n)
    order[static_cast<std::size_t>(next[static_cast<std::size_t>(element[n])]++)] = {
        n < stay.size() ? before.id(stay[n]) : id[n - stay.size()], n};
  for (std::size_t e = 0; e + 1 < begin.size(); ++e)
    std::sort(order.begin() + begin[e], order.begin() + begin[e + 1],
              [](const Place& a, const Place& b) { return a.id < b.id; });

  // A field at a time: nobody needs room for whole particles on their way.
  Particles<grid::Device> sorted;
  for_each_field(
      [&](const Field& field, const auto& given, auto& view) {
        const std::size_t numbers = numbers_anywhere(communicator, field, given);
        if (numbers == 0) return;
        const auto arrived = exchange_values(communicator, leave, given.data(), numbers);
        allocate(view, field.name, count, numbers);
        const auto host = Kokkos::create_mirror_view(view);
        for (std::size_t p = 0; p < count; ++p) {
          const std::size_t n = order[p].source;
          const auto* const from = n < stay.size()
                                       ? given.data() + numbers * static_cast<std::size_t>(stay[n])
                                       : arrived.data() + numbers * (n - stay.size());
          std::copy_n(from, numbers, host.data() + numbers * p);
        }
        Kokkos::deep_copy(view, host);
      },
      before, sorted);
  allocate(sorted.element_begin, "element_begin", begin.size());
  const auto element_begin = Kokkos::create_mirror_view(sorted.element_begin);
  std::copy(begin.begin(), begin.end(), element_begin.data());
  Kokkos::deep_copy(sorted.element_begin, element_begin);
  return sorted;
}

}  // namespace stroma::particles
