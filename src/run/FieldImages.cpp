// SPDX-License-Identifier: BSD-3-Clause

#include "run/FieldImages.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Smoothing.hpp"

namespace stroma {
namespace {

using base::format;

std::string name_of(const std::array<std::int64_t, 3>& size) {
  return format("%lld x %lld x %lld voxels", static_cast<long long>(size[0]),
                static_cast<long long>(size[1]), static_cast<long long>(size[2]));
}

/// \param voxel_size  of the specimen
/// \param is_decks    the deck overrides what files say
void require_same_specimen(const std::string& where, const image::ImageSummary& found,
                           const image::ImageSummary& specimen,
                           const std::array<double, 3>& voxel_size, bool is_decks) {
  if (found.file_size != specimen.file_size)
    throw base::InputError(where + "|Image: " + found.path + " has " + name_of(found.file_size) +
                           "; admissible: those of the specimen's image, " +
                           name_of(specimen.file_size));
  for (std::size_t d = 0; d < 3 && !is_decks; ++d) {
    const double um = found.voxel_size.um[d];
    if (um > 0.0 && std::abs(um - voxel_size[d]) > 1e-3 * voxel_size[d])
      throw base::InputError(format(
          "%s|Image: the voxels of %s are %.6g um along %c, and the specimen's %.6g um; admissible: an "
          "image of the same voxels, or Image|Voxel Size [um] for both",
          where.c_str(), found.path.c_str(), um, "xyz"[d], voxel_size[d]));
  }
}

/// Whether a field names another file than the specimen's, by whatever path.
bool is_in_another_file(const material::FieldImage& field, const image::ImageParameters& specimen,
                        const deck::Document& document) {
  if (!field.file || !specimen.file) return field.file.has_value();
  std::error_code missing;  // is told when it is read
  return !std::filesystem::equivalent(document.resolve(*field.file),
                                      document.resolve(*specimen.file), missing);
}

}  // namespace

voxels::IntensityVolume FieldImages::read(const std::string& where,
                                          const material::FieldImage& image) {
  const image::ImageParameters& specimen = deck_->parameters.image;
  if (image.is_the_specimens()) return image_->intensities;
  const bool is_another = is_in_another_file(image, specimen, deck_->document);
  image::ImageParameters other;
  other.region = specimen.region;
  other.file = image.file ? image.file : specimen.file;
  other.dataset = image.dataset || is_another ? image.dataset : specimen.dataset;
  other.channel = image.channel.value_or(is_another ? 0 : specimen.channel);
  other.frame = image.frame.value_or(is_another ? 0 : specimen.frame);
  image::ImageSummary found;
  voxels::IntensityVolume volume;
  try {
    volume = image::read_volume(communicator_, other, deck_->document.folder(), found,
                                [&](const image::ImageSummary& summary) {
                                  require_same_specimen(where, summary, image_->summary,
                                                        image_->labels.voxel_size,
                                                        specimen.voxel_size.has_value());
                                });
  } catch (const base::InputError& error) {  // thrown on all ranks alike
    const std::string what = error.what();
    throw base::InputError(what.rfind(where, 0) == 0 ? what : where + ": " + what);
  }
  seen_->add(where, found);
  volume.voxel_size = image_->labels.voxel_size;
  return volume;
}

std::string FieldImages::name_of_voxel(std::size_t particle) const {
  const voxels::Box& box = particles_->box;
  const auto number = static_cast<std::int64_t>(particles_->number[particle]);
  std::array<std::int64_t, 3> in_file{number % box.count[0], number / box.count[0] % box.count[1],
                                      number / (box.count[0] * box.count[1])};
  const auto& region = deck_->parameters.image.region;
  for (std::size_t d = 0; d < 3; ++d) in_file[d] += box.first[d] + (region ? (*region)[d] : 0);
  return voxels::name_of_voxel(in_file);
}

const std::vector<double>& FieldImages::intensities(const std::string& where,
                                                    const material::FieldImage& image,
                                                    double smoothing) {
  const Key key{image.file, image.dataset, image.channel, image.frame, smoothing};
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  voxels::IntensityVolume volume = read(where, image);
  if (smoothing > 0.0) {
    std::array<double, 3> sigma;
    for (std::size_t d = 0; d < 3; ++d) sigma[d] = smoothing / volume.voxel_size[d];
    image::smooth(communicator_, volume, sigma);
  }
  std::vector<double> values = particles::at_particles(communicator_, *particles_, volume);
  base::collectively(communicator_, [&] {
    const auto bad =
        std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
    if (bad != values.end())
      throw base::InputError(where + ": the intensity of " +
                             name_of_voxel(static_cast<std::size_t>(bad - values.begin())) +
                             " is no finite number");
  });
  return known_.emplace(key, std::move(values)).first->second;
}

void FieldImages::require_directions(const std::string& where, const std::string& what,
                                     const std::vector<bool>& counts,
                                     const std::vector<bool>& has) const {
  base::collectively(communicator_, [&] {
    for (std::size_t p = 0; p < counts.size(); ++p)
      if (counts[p] && !has[p])
        throw base::InputError(where + ": there is no direction at " + name_of_voxel(p) + ": " +
                               what);
  });
}

std::vector<image::Orientation> FieldImages::by_structure_tensor(
    const std::string& where, const material::DirectionsFromImage& from,
    const std::vector<bool>& counts) {
  const voxels::IntensityVolume volume = read(where, from);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (const double value : volume.values) {
    low = std::isnan(value) ? -infinity : std::min(low, value);
    high = std::max(high, value);
  }
  low = communicator_.min(low);
  high = communicator_.max(high);
  if (!std::isfinite(high - low))
    throw base::InputError(where + ": the image holds intensities that are no finite numbers");
  std::vector<image::SymmetricTensor> tensor(particles_->number.size());
  image::structure_tensor(communicator_, volume, {*from.gradient_scale, *from.window_scale},
                          [&](int component, const voxels::Volume<float>& values) {
                            const std::vector<float> here =
                                particles::at_particles(communicator_, *particles_, values);
                            for (std::size_t p = 0; p < here.size(); ++p)
                              tensor[p][static_cast<std::size_t>(component)] = here[p];
                          });
  // what rounding makes of a constant image is less
  const double least =
      std::pow(std::max(1e-5 * (high - low), 1e-6 * std::max(std::abs(low), std::abs(high))) /
                   *from.gradient_scale,
               2);
  std::vector<bool> has(tensor.size());
  std::vector<image::Orientation> found(tensor.size());
  for (std::size_t p = 0; p < tensor.size(); ++p) {
    has[p] = tensor[p][0] + tensor[p][1] + tensor[p][2] > least;
    if (has[p] && counts[p]) found[p] = image::orientation_of(tensor[p], volume.size[2] == 1);
  }
  require_directions(where,
                     "the image is constant around it; admissible: a larger Window Scale [um]",
                     counts, has);
  return found;
}

std::vector<image::Orientation> FieldImages::by_components(
    const std::string& where, const material::DirectionsFromImage& from,
    const std::vector<bool>& counts) {
  std::vector<image::Orientation> found(particles_->number.size());
  for (std::size_t d = 0; d < 3; ++d) {
    material::FieldImage image;
    image.file = from.images[d];
    const std::vector<double>& component = intensities(where, image, 0.0);
    for (std::size_t p = 0; p < found.size(); ++p) found[p].direction[d] = component[p];
  }
  std::vector<bool> has(found.size());
  for (std::size_t p = 0; p < found.size(); ++p) {
    auto& n = found[p].direction;
    has[p] = n != std::array<double, 3>{};
    if (has[p]) n = material::normalised(n);
    found[p].coherence = 1.0;
  }
  require_directions(where, "all three components are 0", counts, has);
  return found;
}

std::vector<image::Orientation> FieldImages::directions(const std::string& where,
                                                        const material::DirectionsFromImage& from,
                                                        const std::vector<bool>& counts) {
  return from.direction_from == material::DirectionsFromImage::Kind::structure_tensor
             ? by_structure_tensor(where, from, counts)
             : by_components(where, from, counts);
}

}  // namespace stroma
