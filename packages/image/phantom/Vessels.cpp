// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Vessel networks as voxels: labels, and the grey image that a confocal microscope would make of
/// them.

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "stroma/image/labels/Smoothing.hpp"
#include "stroma/image/phantom/CounterRandom.hpp"
#include "stroma/image/phantom/Phantom.hpp"
#include "stroma/image/phantom/VesselNetwork.hpp"

namespace stroma::image {
namespace {

/// Distance to the nearest vessel's axis over the vessel's radius there, squared: below 1 inside.
/// Scaling all radii by a common factor k is then a threshold of k^2. Known up to `widest`.
constexpr double widest = 1.7;

/// Draws one segment into the field, which takes the smaller value.
void draw(const TubeSegment& s, voxels::Volume<float>& field) {
  const auto& h = field.voxel_size;
  const double reach = widest * std::max(s.radius_from, s.radius_to);
  std::array<std::int64_t, 3> first{}, last{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double low = std::min(s.from[a], s.to[a]) - reach,
                 high = std::max(s.from[a], s.to[a]) + reach;
    const std::int64_t begin = a == 2 ? field.first_plane : 0;
    const std::int64_t end = a == 2 ? field.first_plane + field.planes : field.size[a];
    first[a] = std::max(begin, static_cast<std::int64_t>(std::floor(low / h[a])));
    last[a] = std::min(end - 1, static_cast<std::int64_t>(std::floor(high / h[a])));
  }
  const std::array<double, 3> axis{s.to[0] - s.from[0], s.to[1] - s.from[1], s.to[2] - s.from[2]};
  const double inverse =
      1.0 / std::max(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2], 1e-30);
  for (std::int64_t k = first[2]; k <= last[2]; ++k) {
    const double z = (static_cast<double>(k) + 0.5) * h[2] - s.from[2];
    for (std::int64_t j = first[1]; j <= last[1]; ++j) {
      const double y = (static_cast<double>(j) + 0.5) * h[1] - s.from[1];
      float* row = field.plane(k - field.first_plane) + j * field.size[0];
      for (std::int64_t i = first[0]; i <= last[0]; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * h[0] - s.from[0];
        const double t =
            std::min(std::max((x * axis[0] + y * axis[1] + z * axis[2]) * inverse, 0.0), 1.0);
        const double dx = x - t * axis[0], dy = y - t * axis[1], dz = z - t * axis[2];
        const double r = s.radius_from + t * (s.radius_to - s.radius_from);
        row[i] = std::min(row[i], static_cast<float>((dx * dx + dy * dy + dz * dz) / (r * r)));
      }
    }
  }
}

double fraction_below(const base::Communicator& communicator, const voxels::Volume<float>& field,
                      double factor) {
  const auto bound = static_cast<float>(factor * factor);
  std::int64_t below = 0;
  for (const float value : field.values) below += value < bound ? 1 : 0;
  return static_cast<double>(communicator.sum(below)) / static_cast<double>(field.voxels());
}

/// The factor on all radii that gives the fraction, by bisection.
double factor_for(const base::Communicator& communicator, const voxels::Volume<float>& field,
                  double fraction) {
  double low = 0.0, high = widest;
  for (int i = 0; i < 32; ++i) {
    const double middle = 0.5 * (low + high);
    (fraction_below(communicator, field, middle) < fraction ? low : high) = middle;
  }
  return high;
}

[[noreturn]] void does_not_fit(const VesselParameters& p) {
  throw base::InputError(
      base::format("a vessel network of volume fraction %.4g cannot be made to 0.2 %% in a box of "
                   "%lld x %lld x %lld voxels; take a "
                   "larger box or another fraction",
                   p.fraction, static_cast<long long>(p.size[0]), static_cast<long long>(p.size[1]),
                   static_cast<long long>(p.size[2])));
}

/// The distance field of a network that can reach the fraction, and a little more, with a common
/// factor near 1. A slice or another thin box is cut from the middle of a thicker network.
voxels::Volume<float> network_field(const base::Communicator& communicator,
                                    const VesselParameters& parameters) {
  const double voxel =
      *std::max_element(parameters.voxel_size.begin(), parameters.voxel_size.end());
  std::array<double, 3> box{};
  for (std::size_t a = 0; a < 3; ++a)
    box[a] = static_cast<double>(parameters.size[a]) * parameters.voxel_size[a];
  // Microvessels: capillaries of 5 um, trunks of 18 um; but nothing thinner than 3 voxels, and
  // nothing that fills a small box.
  NetworkParameters network{};
  const double room = 0.18 * std::sqrt(box[0] * box[1]);
  network.largest_radius = std::max(std::min(9.0, room), 2.5 * voxel);
  network.smallest_radius = std::max(std::min(2.5, 0.5 * network.largest_radius), 1.5 * voxel);
  network.seed = static_cast<std::uint64_t>(parameters.seed);
  std::array<double, 3> corner{};
  for (std::size_t a = 0; a < 3; ++a) {
    network.box[a] = std::max(box[a], 4.0 * network.largest_radius);
    corner[a] = 0.5 * (network.box[a] - box[a]);
  }
  // Tubes laid at random overlap: a share of 1 - exp(-V) is covered by a volume of V.
  network.tube_volume =
      -std::log(1.0 - parameters.fraction) * network.box[0] * network.box[1] * network.box[2];
  for (int attempt = 0; attempt < 6; ++attempt) {
    voxels::Volume<float> field(communicator, parameters.size, parameters.voxel_size);
    std::fill(field.values.begin(), field.values.end(), 1e9f);
    for (TubeSegment segment : grow_network(network)) {
      for (std::size_t a = 0; a < 3; ++a) {
        segment.from[a] -= corner[a];
        segment.to[a] -= corner[a];
      }
      draw(segment, field);
    }
    if (fraction_below(communicator, field, 0.8 * widest) > parameters.fraction) return field;
    network.tube_volume *= 1.3;
  }
  does_not_fit(parameters);
}

/// The fraction that a user asked for, or none. \throws base::InputError
void require_fraction(double reached, const VesselParameters& parameters) {
  if (std::abs(reached - parameters.fraction) > 0.002) does_not_fit(parameters);
}

void check(const VesselParameters& p) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (p.size[a] < 1) throw base::InputError("a phantom's size must be at least 1 x 1 x 1 voxels");
    if (!(p.voxel_size[a] > 0.0)) throw base::InputError("a phantom's voxel size must be positive");
  }
  if (!(p.fraction > 0.0 && p.fraction < 0.6)) {
    throw base::InputError(base::format(
        "the volume fraction of vessels is %g; admissible: above 0 and below 0.6", p.fraction));
  }
}

/// What the detector counts: photons of the vessel's stain and of the background, then read noise
/// [grey levels].
constexpr double background_photons = 6.0, vessel_photons = 60.0, levels_per_photon = 3.0,
                 read_noise = 2.0;
/// Standard deviations of the point spread function in the plane and along the optical axis [um].
constexpr double blur_xy = 0.4, blur_z = 1.2;

/// Number of photons of a Poisson process with this mean, by inversion of its distribution.
int poisson(double mean, double uniform) {
  double probability = std::exp(-mean), sum = probability;
  int count = 0;
  while (uniform > sum && count < 1000) {
    ++count;
    probability *= mean / count;
    sum += probability;
  }
  return count;
}

/// The grey image of the tubes, all radii scaled by a factor.
voxels::Volume<std::uint8_t> expose(const base::Communicator& communicator,
                                    const voxels::Volume<float>& field, double factor,
                                    std::uint64_t seed) {
  voxels::Volume<float> light = field;
  const auto bound = static_cast<float>(factor * factor);
  for (float& value : light.values) value = value < bound ? 1.0f : 0.0f;
  const auto& h = field.voxel_size;
  smooth(communicator, light, {blur_xy / h[0], blur_xy / h[1], blur_z / h[2]});

  voxels::Volume<std::uint8_t> grey(communicator, field.size, field.voxel_size);
  const auto first_voxel = static_cast<std::uint64_t>(field.first_plane * field.plane_voxels());
  const std::uint64_t noise_seed = random_bits(seed, 0x6E6F697365);
  for (std::size_t i = 0; i < light.values.size(); ++i) {
    const std::uint64_t counter = 3 * (first_voxel + i);
    const double mean =
        background_photons + (vessel_photons - background_photons) * light.values[i];
    const int photons = poisson(mean, random_uniform(noise_seed, counter));
    const double normal = std::sqrt(-2.0 * std::log(random_uniform(noise_seed, counter + 1))) *
                          std::cos(6.283185307179586 * random_uniform(noise_seed, counter + 2));
    const double level = levels_per_photon * photons + read_noise * normal;
    grey.values[i] = static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
  }
  return grey;
}

/// Otsu's threshold and the fraction above it.
void measure(const base::Communicator& communicator, GreyVessels& grey) {
  Histogram histogram{-0.5, 1.0, true, std::vector<std::int64_t>(256, 0)};
  for (const std::uint8_t value : grey.volume.values) ++histogram.counts[value];
  communicator.sum_all(histogram.counts.data(), histogram.counts.size());
  grey.otsu_threshold = static_cast<int>(std::lround(otsu_threshold(histogram)));
  std::int64_t above = 0;
  for (std::size_t level = static_cast<std::size_t>(grey.otsu_threshold) + 1; level < 256; ++level)
    above += histogram.counts[level];
  grey.otsu_fraction = static_cast<double>(above) / static_cast<double>(grey.volume.voxels());
}

}  // namespace

voxels::LabelVolume make_vessels(const base::Communicator& communicator,
                                 const VesselParameters& parameters) {
  check(parameters);
  const voxels::Volume<float> field = network_field(communicator, parameters);
  const double factor = factor_for(communicator, field, parameters.fraction);
  const auto bound = static_cast<float>(factor * factor);
  voxels::LabelVolume labels(communicator, parameters.size, parameters.voxel_size);
  std::transform(field.values.begin(), field.values.end(), labels.values.begin(),
                 [&](float value) { return value < bound ? 1 : 0; });
  require_fraction(fraction_below(communicator, field, factor), parameters);
  return labels;
}

GreyVessels make_grey_vessels(const base::Communicator& communicator,
                              const VesselParameters& parameters) {
  check(parameters);
  const auto seed = static_cast<std::uint64_t>(parameters.seed);
  const voxels::Volume<float> field = network_field(communicator, parameters);
  GreyVessels best;
  double drawn = parameters.fraction;
  for (int round = 0; round < 8; ++round) {
    GreyVessels grey;
    const double factor = factor_for(communicator, field, drawn);
    grey.volume = expose(communicator, field, factor, seed);
    grey.drawn_fraction = fraction_below(communicator, field, factor);
    measure(communicator, grey);
    const double error = grey.otsu_fraction - parameters.fraction;
    const bool better =
        round == 0 || std::abs(error) < std::abs(best.otsu_fraction - parameters.fraction);
    if (better) best = std::move(grey);
    if (std::abs(error) < 2e-4) break;
    drawn = std::clamp(drawn - error, 1e-6, 0.95);
  }
  require_fraction(best.otsu_fraction, parameters);
  return best;
}

}  // namespace stroma::image
