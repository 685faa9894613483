// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/ReadVolume.hpp"

#include <cmath>
#include <filesystem>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Segmentation.hpp"

namespace stroma::image {
namespace {

/// Replaces the file's voxel size by the deck's.
void override_voxel_size(const ImageParameters& parameters, ImageSummary& summary) {
  if (!parameters.voxel_size) return;
  static const char* const axis_names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const double deck = (*parameters.voxel_size)[static_cast<std::size_t>(axis)];
    const double file = summary.voxel_size.um[static_cast<std::size_t>(axis)];
    if (file > 0.0 && std::abs(deck - file) > 1e-6 * file) {
      summary.notes.push_back(base::format(
          "voxel size along %s: %.9g um from the deck is used, not %.9g um from the file (%s)",
          axis_names[axis], deck, file,
          summary.voxel_size.found_in[static_cast<std::size_t>(axis)].c_str()));
    }
    summary.voxel_size.set(axis, deck, "deck");
  }
}

/// The deck's region, or all of an image of this size.
voxels::Box region_of(const ImageParameters& parameters, const std::string& path,
                      const std::array<std::int64_t, 3>& size) {
  if (!parameters.region) return {{0, 0, 0}, size};
  voxels::Box region;
  const std::array<int, 6>& r = *parameters.region;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    region.first[axis] = r[axis];
    region.count[axis] = r[axis + 3];
    const bool inside =
        r[axis] >= 0 && r[axis + 3] >= 1 && region.first[axis] + region.count[axis] <= size[axis];
    if (!inside) {
      throw base::InputError(base::format(
          "%s: Image|Region takes the voxels %d to %lld along %c; admissible: within 0 to %lld",
          path.c_str(), r[axis],
          static_cast<long long>(region.first[axis] + region.count[axis] - 1), "xyz"[axis],
          static_cast<long long>(size[axis] - 1)));
    }
  }
  return region;
}

/// Rank 0 reads plane after plane and sends each to the rank that holds it.
void read_on_root(const base::Communicator& communicator, ImageSource& source,
                  const voxels::Box& region, voxels::IntensityVolume& volume) {
  constexpr int tag = 4712;
  const voxels::Slabs slabs(volume.size[2], communicator.size());
  voxels::Box plane = region;
  plane.count[2] = 1;
  // The file is read as a whole before anything is sent, so that a broken one leaves nobody
  // waiting.
  std::vector<double> values(
      static_cast<std::size_t>(communicator.is_root() ? volume.plane_voxels() : 0));
  base::collectively(communicator, [&] {
    if (communicator.is_root()) source.read(plane, values.data());
  });
  const int count = static_cast<int>(volume.plane_voxels());
  for (std::int64_t k = 0; k < volume.size[2]; ++k) {
    const int owner = slabs.owner(k);
    if (communicator.is_root()) {
      plane.first[2] = region.first[2] + k;
      source.read(plane, values.data());
      if (owner == 0) {
        std::copy(values.begin(), values.end(), volume.plane(k - volume.first_plane));
      } else {
        MPI_Send(values.data(), count, MPI_DOUBLE, owner, tag, communicator.raw());
      }
    } else if (owner == communicator.rank()) {
      MPI_Recv(volume.plane(k - volume.first_plane), count, MPI_DOUBLE, 0, tag, communicator.raw(),
               MPI_STATUS_IGNORE);
    }
  }
}

/// The part of a volume within a region, dealt to the ranks anew.
voxels::LabelVolume cut(const base::Communicator& communicator, const voxels::LabelVolume& whole,
                        const voxels::Box& region) {
  voxels::LabelVolume part(communicator, region.count, whole.voxel_size);
  voxels::Box mine = region;
  mine.first[2] += part.first_plane;
  mine.count[2] = part.planes;
  part.values = voxels::extract(communicator, whole, mine);
  return part;
}

voxels::LabelVolume phantom_labels(const base::Communicator& communicator,
                                   const ImageParameters& parameters, ImageSummary& summary,
                                   const BeforeReading& before_reading) {
  const PhantomParameters& phantom = *parameters.phantom;
  summary.path = "phantom";
  summary.format = "phantom";
  summary.type = {ValueType::Kind::signed_integer, 4};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    summary.file_size[axis] = phantom.size[axis];
    summary.voxel_size.set(static_cast<int>(axis), phantom.voxel_size[axis], "deck");
  }
  const voxels::Box region = region_of(parameters, summary.path, summary.file_size);
  summary.size = region.count;
  if (before_reading) before_reading(summary);
  voxels::LabelVolume labels = make_phantom(communicator, phantom);
  return parameters.region ? cut(communicator, labels, region) : labels;
}

}  // namespace

voxels::IntensityVolume read_volume(const base::Communicator& communicator,
                                    const ImageParameters& parameters, const std::string& folder,
                                    ImageSummary& summary, const BeforeReading& before_reading) {
  if (!parameters.file) throw base::InputError("Image|File: missing");
  const std::filesystem::path name = *parameters.file;
  ImageRequest request;
  request.path = name.is_absolute() || folder.empty()
                     ? name.string()
                     : (std::filesystem::path(folder) / name).string();
  request.dataset = parameters.dataset.value_or("");
  request.channel = parameters.channel;
  request.frame = parameters.frame;

  const std::unique_ptr<ImageSource> source = open_image(communicator, request);
  summary = source->summary();
  summary.files.insert(summary.files.begin(), request.path);
  if (summary.channels > 1) {
    summary.notes.push_back(base::format("the file holds %lld channels; channel %lld is read",
                                         static_cast<long long>(summary.channels),
                                         static_cast<long long>(summary.channel)));
  }
  if (summary.frames > 1) {
    summary.notes.push_back(base::format(
        "the file is a time series of %lld frames; frame %lld is read (Image|Frame)",
        static_cast<long long>(summary.frames), static_cast<long long>(summary.frame)));
  }
  override_voxel_size(parameters, summary);
  const voxels::Box region = region_of(parameters, request.path, summary.file_size);
  summary.size = region.count;
  if (before_reading) before_reading(summary);

  voxels::IntensityVolume volume;
  base::collectively(communicator, [&] {
    volume = voxels::IntensityVolume(communicator, region.count, summary.voxel_size.um);
    volume.first_in_file = region.first;
    if (!source->readable_in_parts() || volume.planes == 0) return;
    voxels::Box slab = region;
    slab.first[2] += volume.first_plane;
    slab.count[2] = volume.planes;
    source->read(slab, volume.values.data());
  });
  if (!source->readable_in_parts()) read_on_root(communicator, *source, region, volume);
  return volume;
}

void require_voxel_size(const ImageSummary& summary) {
  if (summary.voxel_size.complete()) return;
  std::string axes, notes;
  for (int axis = 0; axis < 3; ++axis) {
    if (!summary.voxel_size.known(axis))
      axes += std::string(axes.empty() ? "" : ", ") + "xyz"[axis];
  }
  for (const std::string& note : summary.notes) {
    if (note.find("not used") != std::string::npos) notes += " (" + note + ")";
  }
  throw base::InputError(summary.path + ": the size of a voxel along " + axes +
                         " is not in the file; set Image|Voxel Size [um] (x, y, z)" + notes);
}

voxels::LabelVolume read_labels(const base::Communicator& communicator,
                                const ImageParameters& parameters, const std::string& folder,
                                ImageSummary* wanted_summary, const BeforeReading& before_reading,
                                voxels::IntensityVolume* intensities) {
  ImageSummary summary;
  voxels::LabelVolume labels;
  if (parameters.phantom) {
    labels = phantom_labels(communicator, parameters, summary, before_reading);
    const int smallest = parameters.segmentation.smallest_object;
    if (smallest > 1) {
      const auto removed =
          static_cast<long long>(remove_small_objects(communicator, labels, smallest));
      summary.notes.push_back(
          base::format("objects of fewer than %d voxels removed: %lld", smallest, removed));
    }
  } else {
    voxels::IntensityVolume volume =
        read_volume(communicator, parameters, folder, summary, [&](const ImageSummary& found) {
          require_voxel_size(found);
          if (before_reading) before_reading(found);
        });
    if (intensities) *intensities = volume;
    try {
      labels = segment(communicator, std::move(volume), parameters.segmentation, summary);
    } catch (const base::InputError& error) {  // thrown on all ranks alike
      throw base::InputError(summary.path + ": " + error.what());
    }
  }
  if (wanted_summary) *wanted_summary = summary;
  return labels;
}

}  // namespace stroma::image
