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

/// A particle as it travels.
struct Record {
  double position[3];
  double displacement[3];
  double gradient[3][3];
  double volume;
  std::int64_t id;
  std::int64_t home;
  std::int64_t material;
};

/// Host views of a rank's particles that turn into records and back.
struct HostParticles {
  explicit HostParticles(const Particles<grid::Device>& particles)
      : position(copy(particles.position)),
        displacement(copy(particles.base_displacement)),
        gradient(copy(particles.base_gradient)),
        volume(copy(particles.volume)),
        id(copy(particles.id)),
        home(copy(particles.home)),
        material(copy(particles.material)) {}

  Record record(int p) const {
    Record r;
    for (int i = 0; i < 3; ++i) {
      r.position[i] = position(p, i);
      r.displacement[i] = has_displacement() ? displacement(p, i) : 0.0;
      for (int j = 0; j < 3; ++j) r.gradient[i][j] = has_gradient() ? gradient(p, i, j) : 0.0;
    }
    r.volume = volume(p);
    r.id = id(p);
    r.home = has_home() ? home(p) : 0;
    r.material = material(p);
    return r;
  }

  void set(int p, const Record& r) const {
    for (int i = 0; i < 3; ++i) {
      position(p, i) = r.position[i];
      if (has_displacement()) displacement(p, i) = r.displacement[i];
      for (int j = 0; j < 3 && has_gradient(); ++j) gradient(p, i, j) = r.gradient[i][j];
    }
    volume(p) = r.volume;
    id(p) = r.id;
    if (has_home()) home(p) = r.home;
    material(p) = static_cast<std::uint8_t>(r.material);
  }

  void copy_to(const Particles<grid::Device>& particles) const {
    Kokkos::deep_copy(particles.position, position);
    Kokkos::deep_copy(particles.base_displacement, displacement);
    Kokkos::deep_copy(particles.base_gradient, gradient);
    Kokkos::deep_copy(particles.volume, volume);
    Kokkos::deep_copy(particles.id, id);
    Kokkos::deep_copy(particles.home, home);
    Kokkos::deep_copy(particles.material, material);
  }

  // What particles that do not move go without.
  bool has_displacement() const { return displacement.extent(0) != 0; }
  bool has_gradient() const { return gradient.extent(0) != 0; }
  bool has_home() const { return home.extent(0) != 0; }

  Particles<grid::Device>::Vector3::HostMirror position, displacement;
  Particles<grid::Device>::Tensor::HostMirror gradient;
  Kokkos::View<double*, grid::Device>::HostMirror volume;
  Kokkos::View<std::int64_t*, grid::Device>::HostMirror id, home;
  Kokkos::View<std::uint8_t*, grid::Device>::HostMirror material;

 private:
  template <class View>
  static typename View::HostMirror copy(const View& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  }
};

template <class View>
void allocate(View& view, const char* name, std::size_t count) {
  view = View(Kokkos::view_alloc(std::string(name), Kokkos::WithoutInitializing), count);
}

/// Room for particles of the same kind as the given ones.
Particles<grid::Device> allocate_like(const base::Communicator& communicator,
                                      const HostParticles& given, std::size_t count,
                                      std::size_t elements) {
  Particles<grid::Device> particles;
  allocate(particles.position, "position", count);
  allocate(particles.volume, "volume", count);
  allocate(particles.material, "material", count);
  allocate(particles.id, "id", count);
  allocate(particles.element_begin, "element_begin", elements + 1);
  if (communicator.any(given.has_displacement()))
    allocate(particles.base_displacement, "base_displacement", count);
  if (communicator.any(given.has_gradient()))
    allocate(particles.base_gradient, "base_gradient", count);
  if (communicator.any(given.has_home())) allocate(particles.home, "home", count);
  return particles;
}

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
  particles.base_displacement = decltype(particles.base_displacement)("base_displacement", count);
  particles.base_gradient = decltype(particles.base_gradient)("base_gradient", count);
  allocate(particles.home, "home", count);
  const auto home = Kokkos::create_mirror_view(particles.home);
  for (std::size_t p = 0; p < count; ++p)
    home(p) = home_of(communicator.rank(), static_cast<int>(p));
  Kokkos::deep_copy(particles.home, home);
}

grid::Grid covering_grid(const base::Communicator& communicator, const grid::Grid& body,
                         const Particles<grid::Device>& particles) {
  const auto position =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.position);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  grid::Grid grid = body;
  double elements = 1.0;
  for (int d = 0; d < 3; ++d) {
    double lowest = infinity, highest = -infinity;
    for (int p = 0; p < particles.count(); ++p) {
      lowest = std::min(lowest, position(p, d));
      highest = std::max(highest, position(p, d));
    }
    lowest = communicator.min(lowest);
    highest = communicator.max(highest);
    if (d == 2 && body.flat) continue;
    elements *= 1.0 + (highest - lowest) / body.spacing[d];
    if (!(elements < 64.0 * static_cast<double>(body.all_elements().count()) + 4096.0))
      throw base::RunError(base::format(
          "the particles are spread from %g to %g um along %c: some must have got lost", lowest,
          highest, "xyz"[d]));
    const std::int64_t first = element_along(body, d, lowest);
    grid.origin[d] = body.origin[d] + static_cast<double>(first) * body.spacing[d];
    grid.elements[d] = element_along(body, d, highest) - first + 1;
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
  const HostParticles before(particles);

  std::vector<int> stay;
  std::vector<std::vector<Record>> leave(static_cast<std::size_t>(communicator.size()));
  for (int p = 0; p < particles.count(); ++p) {
    const grid::Index3 element = element_at(grid, &before.position(p, 0));
    if (box.contains(element)) {
      stay.push_back(p);
    } else {
      leave[static_cast<std::size_t>(partition.owner_of_element(element))].push_back(
          before.record(p));
    }
  }
  const std::vector<Record> arrived = particles::exchange(communicator, leave);
  leave.clear();
  const std::size_t count = stay.size() + arrived.size();
  const auto total = communicator.sum<std::int64_t>(particles.count());
  if (communicator.sum(static_cast<std::int64_t>(count)) != total)
    throw base::RunError("particles were lost on the way between ranks");
  if (communicator.any(count > static_cast<std::size_t>(std::numeric_limits<int>::max())))
    throw base::RunError("more than 2^31 particles on one rank; run with more ranks");

  // Counting sort by element; those of one element by id.
  struct Place {
    std::int64_t id;
    int source;  // of stay, then of arrived
  };
  const auto id_of = [&](std::size_t n) {
    return n < stay.size() ? before.id(stay[n]) : arrived[n - stay.size()].id;
  };
  std::vector<int> element(count);
  std::vector<int> begin(static_cast<std::size_t>(box.count()) + 1, 0);
  for (std::size_t n = 0; n < count; ++n) {
    const double* position =
        n < stay.size() ? &before.position(stay[n], 0) : arrived[n - stay.size()].position;
    element[n] = static_cast<int>(box.local(element_at(grid, position)));
    ++begin[static_cast<std::size_t>(element[n]) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Place> order(count);
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t n = 0; n < count; ++n)
    order[static_cast<std::size_t>(next[static_cast<std::size_t>(element[n])]++)] = {
        id_of(n), static_cast<int>(n)};
  for (std::size_t e = 0; e + 1 < begin.size(); ++e)
    std::sort(order.begin() + begin[e], order.begin() + begin[e + 1],
              [](const Place& a, const Place& b) { return a.id < b.id; });

  const Particles<grid::Device> sorted =
      allocate_like(communicator, before, count, static_cast<std::size_t>(box.count()));
  const HostParticles after(sorted);
  for (std::size_t p = 0; p < count; ++p) {
    const auto n = static_cast<std::size_t>(order[p].source);
    after.set(static_cast<int>(p),
              n < stay.size() ? before.record(stay[n]) : arrived[n - stay.size()]);
  }
  after.copy_to(sorted);
  const auto element_begin = Kokkos::create_mirror_view(sorted.element_begin);
  std::copy(begin.begin(), begin.end(), element_begin.data());
  Kokkos::deep_copy(sorted.element_begin, element_begin);
  return sorted;
}

}  // namespace stroma::particles
