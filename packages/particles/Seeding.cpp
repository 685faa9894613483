#include "particles/Seeding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/Error.hpp"
#include "base/Log.hpp"

namespace stroma::particles {
namespace {

/// Points along axis d in each voxel (Voxel Centers) or element (the others).
int points_along(const ParticleParameters& parameters, const grid::Grid& grid, int d) {
  if (parameters.layout == Layout::gauss) return 2;
  if (grid.flat && d == 2) return 1;
  return parameters.layout == Layout::voxel_centers ? parameters.per_voxel : parameters.per_element;
}

/// Natural coordinates (0 to 1) of the points of one element along one axis; equal shares.
std::vector<double> points_in_element(const ParticleParameters& parameters, int count) {
  if (parameters.layout == Layout::gauss) {
    const double offset = 0.5 / std::sqrt(3.0);
    return {0.5 - offset, 0.5 + offset};
  }
  std::vector<double> points;
  for (int n = 0; n < count; ++n) points.push_back((n + 0.5) / count);
  return points;
}

template <class View>
void allocate(View& view, const char* name, std::size_t count) {
  view = View(Kokkos::view_alloc(std::string(name), Kokkos::WithoutInitializing), count);
}

}  // namespace

deck::Section<ParticleParameters> particles_section() {
  deck::Section<ParticleParameters> section(
      "Particles", "How the image becomes particles; a particle's label is that of its voxel.");
  section.choice(
      "Layout", &ParticleParameters::layout,
      {{"Voxel Centers", Layout::voxel_centers},
       {"Gauss", Layout::gauss},
       {"Per Element", Layout::per_element}},
      "Voxel Centers: Per Voxel^3 particles in each voxel; Gauss: the 2 x 2 x 2 Gauss points of "
      "each element; Per Element: Per Element^3 equally spaced particles in each element. In plane "
      "strain, Voxel Centers and Per Element have one particle through z: nothing varies there.");
  section.optional("Per Voxel", &ParticleParameters::per_voxel, deck::between(1, 16),
                   "Particles per voxel and direction, for Layout = Voxel Centers.");
  section.optional("Per Element", &ParticleParameters::per_element, deck::between(1, 64),
                   "Particles per element and direction, for Layout = Per Element.");
  return section;
}

double particle_spacing(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                        double voxel_size) {
  return (parameters.layout == Layout::voxel_centers ? voxel_size : grid.spacing[d]) /
         points_along(parameters, grid, d);
}

double domain_half_edge(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                        double voxel_size) {
  if (parameters.layout == Layout::gauss) return (0.5 - 0.5 / std::sqrt(3.0)) * grid.spacing[d];
  return 0.5 * particle_spacing(parameters, grid, d, voxel_size);
}

AxisLayout axis_layout(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                       std::int64_t begin, std::int64_t end, std::int64_t voxels,
                       double voxel_size) {
  const double h = grid.spacing[d];
  AxisLayout axis;
  const auto add = [&](double distance, double share) {  // distance from the grid's origin
    axis.position.push_back(grid.origin[d] + distance);
    axis.length.push_back(share);
    const auto voxel = static_cast<std::int64_t>(std::floor(distance / voxel_size));
    axis.voxel.push_back(std::clamp<std::int64_t>(voxel, 0, voxels - 1));
  };
  if (parameters.layout == Layout::voxel_centers) {
    const int n = points_along(parameters, grid, d);
    axis.total = voxels * n;
    const auto distance = [&](std::int64_t point) {
      return (static_cast<double>(point) + 0.5) / n * voxel_size;
    };
    const auto element = [&](std::int64_t point) {
      return static_cast<std::int64_t>(std::floor(distance(point) / h + face_tolerance));
    };
    // The guess for the first point may be off by one where points lie on faces of elements.
    auto point = static_cast<std::int64_t>(static_cast<double>(begin) * h / voxel_size * n) - 1;
    point = std::max<std::int64_t>(point, 0);
    while (point < axis.total && element(point) < begin) ++point;
    axis.first = point;
    for (std::int64_t e = begin; e < end; ++e) {
      axis.element_begin.push_back(static_cast<int>(axis.position.size()));
      for (; point < axis.total && element(point) == e; ++point)
        add(distance(point), voxel_size / n);
    }
  } else {
    const std::vector<double> points =
        points_in_element(parameters, points_along(parameters, grid, d));
    const auto n = static_cast<std::int64_t>(points.size());
    axis.total = grid.elements[d] * n;
    axis.first = begin * n;
    for (std::int64_t e = begin; e < end; ++e) {
      axis.element_begin.push_back(static_cast<int>(axis.position.size()));
      for (const double xi : points)
        add((static_cast<double>(e) + xi) * h, h / static_cast<double>(n));
    }
  }
  axis.element_begin.push_back(static_cast<int>(axis.position.size()));
  return axis;
}

std::array<std::vector<double>, 3> layer_weights(const base::Communicator& communicator,
                                                 const grid::Grid& grid,
                                                 const image::LabelVolume& labels) {
  std::array<std::vector<double>, 3> weights;
  std::array<std::vector<std::size_t>, 3> layer_of_voxel;
  for (int d = 0; d < 3; ++d) {
    weights[d].assign(static_cast<std::size_t>(grid.elements[d]), 0.0);
    for (std::int64_t v = 0; v < labels.size[d]; ++v) {
      const double centre = (static_cast<double>(v) + 0.5) * labels.voxel_size[d];
      const auto layer = static_cast<std::int64_t>(centre / grid.spacing[d] + face_tolerance);
      layer_of_voxel[d].push_back(static_cast<std::size_t>(std::min(layer, grid.elements[d] - 1)));
    }
  }
  std::size_t position = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k)
    for (std::size_t j = 0; j < layer_of_voxel[1].size(); ++j)
      for (std::size_t i = 0; i < layer_of_voxel[0].size(); ++i, ++position) {
        if (labels.values[position] < 0) continue;
        weights[0][layer_of_voxel[0][i]] += 1.0;
        weights[1][layer_of_voxel[1][j]] += 1.0;
        weights[2][layer_of_voxel[2][static_cast<std::size_t>(labels.first_plane + k)]] += 1.0;
      }
  for (auto& weight : weights) communicator.sum_all(weight.data(), weight.size());
  return weights;
}

Particles<grid::Device> seed(const base::Communicator& communicator,
                             const ParticleParameters& parameters, const grid::Partition& partition,
                             const image::LabelVolume& labels,
                             const std::map<std::int32_t, int>& material_of_label) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(communicator.rank());

  std::array<AxisLayout, 3> axis;
  image::Box voxels{};
  for (int d = 0; d < 3; ++d) {
    axis[d] = axis_layout(parameters, grid, d, elements.begin[d], elements.end[d], labels.size[d],
                          labels.voxel_size[d]);
    if (axis[d].voxel.empty()) continue;
    voxels.first[d] = axis[d].voxel.front();
    voxels.count[d] = axis[d].voxel.back() - axis[d].voxel.front() + 1;
  }
  const std::vector<std::int32_t> label_of_voxel = image::extract(communicator, labels, voxels);

  // Visits every point of the rank, element by element: f(ix, iy, iz, label).
  const auto for_each_point = [&](const grid::Index3& element, const auto& f) {
    const std::size_t e[3] = {static_cast<std::size_t>(element[0] - elements.begin[0]),
                              static_cast<std::size_t>(element[1] - elements.begin[1]),
                              static_cast<std::size_t>(element[2] - elements.begin[2])};
    for (int iz = axis[2].element_begin[e[2]]; iz < axis[2].element_begin[e[2] + 1]; ++iz)
      for (int iy = axis[1].element_begin[e[1]]; iy < axis[1].element_begin[e[1] + 1]; ++iy)
        for (int ix = axis[0].element_begin[e[0]]; ix < axis[0].element_begin[e[0] + 1]; ++ix) {
          const auto voxel = [&](int d, int point) {
            return axis[d].voxel[static_cast<std::size_t>(point)] - voxels.first[d];
          };
          const std::int64_t position =
              voxel(0, ix) + voxels.count[0] * (voxel(1, iy) + voxels.count[1] * voxel(2, iz));
          f(ix, iy, iz, label_of_voxel[static_cast<std::size_t>(position)]);
        }
  };

  std::int64_t count = 0;
  base::collectively(communicator, [&] {
    std::map<std::int32_t, std::int64_t> homeless;
    std::int32_t last = -1;
    grid::for_each_index(elements, [&](const grid::Index3& element) {
      for_each_point(element, [&](int, int, int, std::int32_t label) {
        if (label < 0) return;
        ++count;
        if (label == last) return;
        if (material_of_label.count(label) == 0) {
          ++homeless[label];
        } else {
          last = label;
        }
      });
    });
    if (!homeless.empty()) {
      std::string known;
      for (const auto& entry : material_of_label)
        known += (known.empty() ? "" : ", ") + std::to_string(entry.first);
      std::string missing;
      for (const auto& entry : homeless) {
        if (missing.size() > 60) {
          missing += ", ...";
          break;
        }
        missing += (missing.empty() ? "" : ", ") + std::to_string(entry.first);
      }
      throw base::InputError("Materials: the image holds label " + missing +
                             ", for which there is no material; labels with a material: " + known +
                             "; -1 is empty space");
    }
    if (count > std::numeric_limits<int>::max())
      throw base::InputError("more than 2^31 particles on one rank; run with more ranks");
  });

  Particles<grid::Device> particles;
  const auto n = static_cast<std::size_t>(count);
  allocate(particles.position, "position", n);
  allocate(particles.volume, "volume", n);
  allocate(particles.material, "material", n);
  allocate(particles.id, "id", n);
  allocate(particles.element_begin, "element_begin",
           static_cast<std::size_t>(elements.count() + 1));
  const auto position = Kokkos::create_mirror_view(particles.position);
  const auto volume = Kokkos::create_mirror_view(particles.volume);
  const auto material = Kokkos::create_mirror_view(particles.material);
  const auto id = Kokkos::create_mirror_view(particles.id);
  const auto element_begin = Kokkos::create_mirror_view(particles.element_begin);

  int p = 0;
  grid::for_each_index(elements, [&](const grid::Index3& element) {
    element_begin(elements.local(element)) = p;
    for_each_point(element, [&](int ix, int iy, int iz, std::int32_t label) {
      if (label < 0) return;
      const std::size_t point[3] = {static_cast<std::size_t>(ix), static_cast<std::size_t>(iy),
                                    static_cast<std::size_t>(iz)};
      double share = 1.0;
      for (int d = 0; d < 3; ++d) {
        position(p, d) = axis[d].position[point[d]];
        share *= axis[d].length[point[d]];
      }
      volume(p) = share;
      material(p) = static_cast<std::uint8_t>(material_of_label.at(label));
      id(p) = (axis[0].first + ix) +
              axis[0].total * ((axis[1].first + iy) + axis[1].total * (axis[2].first + iz));
      ++p;
    });
  });
  element_begin(elements.count()) = p;

  Kokkos::deep_copy(particles.position, position);
  Kokkos::deep_copy(particles.volume, volume);
  Kokkos::deep_copy(particles.material, material);
  Kokkos::deep_copy(particles.id, id);
  Kokkos::deep_copy(particles.element_begin, element_begin);
  return particles;
}

}  // namespace stroma::particles
