// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/stacks/StackWriter.hpp"

namespace stroma::image {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::int64_t chunk_edge = 256;  ///< along x and y
constexpr std::size_t most_levels = 8;

void write_file(const std::string& path, const void* bytes, std::size_t count) {
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  bool is_written = file != nullptr && std::fwrite(bytes, 1, count, file) == count;
  int reason = errno;
  if (file != nullptr && std::fclose(file) != 0 && is_written) {
    is_written = false;
    reason = errno;
  }
  if (!is_written) throw base::RunError(path + ": cannot be written: " + std::strerror(reason));
}

void write_json(const std::string& path, const Json& json) {
  const std::string text = json.dump(2) + "\n";
  write_file(path, text.data(), text.size());
}

Json compressor(Compression compression) {
  switch (compression) {
    case Compression::zlib:
      return {{"id", "zlib"}, {"level", 1}};
    case Compression::zstd:
      return {{"id", "zstd"}, {"level", 1}};
    case Compression::blosc:
      return {{"id", "blosc"}, {"cname", "lz4"}, {"clevel", 5}, {"shuffle", 1}, {"blocksize", 0}};
    default:
      return nullptr;
  }
}

/// Half the voxels along x and y: of each four, or of those that there are, the mean of what is not
/// empty; of labels the first. Not collective.
voxels::Volume<float> halved(const voxels::Volume<float>& fine, bool is_label) {
  voxels::Volume<float> coarse = fine;
  coarse.size[0] = (fine.size[0] + 1) / 2;
  coarse.size[1] = (fine.size[1] + 1) / 2;
  coarse.values.assign(static_cast<std::size_t>(coarse.planes * coarse.plane_voxels()),
                       std::numeric_limits<float>::quiet_NaN());
  float* value = coarse.values.data();
  for (std::int64_t k = 0; k < fine.planes; ++k)
    for (std::int64_t j = 0; j < fine.size[1]; j += 2)
      for (std::int64_t i = 0; i < fine.size[0]; i += 2, ++value) {
        double sum = 0.0;
        int count = 0;
        for (std::int64_t y = j; y < std::min(j + 2, fine.size[1]); ++y)
          for (std::int64_t x = i; x < std::min(i + 2, fine.size[0]); ++x) {
            const float one = fine.plane(k)[y * fine.size[0] + x];
            if (std::isnan(one) || (is_label && count > 0)) continue;
            sum += static_cast<double>(one);
            ++count;
          }
        if (count > 0) *value = static_cast<float>(sum / count);
      }
  return coarse;
}

class ZarrStack : public StackWriter {
 public:
  ZarrStack(const base::Communicator& communicator, const std::string& path,
            const StackHeader& header, Compression compression)
      : communicator_(communicator),
        path_(path),
        draft_(path + ".new"),
        header_(header),
        compression_(compression),
        planes_(planes_of_band(header)),
        least_(header.channels.size(), std::numeric_limits<float>::infinity()),
        largest_(header.channels.size(), -std::numeric_limits<float>::infinity()) {
    std::array<std::int64_t, 3> size = header.size;
    levels_.push_back(size);
    while (std::max(size[0], size[1]) > chunk_edge && levels_.size() < most_levels) {
      size = {(size[0] + 1) / 2, (size[1] + 1) / 2, size[2]};
      levels_.push_back(size);
    }
    base::collectively(communicator_, [&] {
      if (communicator_.is_root()) begin();
    });
  }
  ~ZarrStack() override {
    std::error_code ignored;
    if (communicator_.is_root()) fs::remove_all(draft_, ignored);  // unless it has its name
  }

  void write(std::int64_t first_plane,
             const std::vector<voxels::Volume<float>>& channels) override {
    std::exception_ptr failure;  // told when all ranks have given their values to each other
    for (std::size_t c = 0; c < channels.size(); ++c) {
      for (const float value : channels[c].values) {
        if (std::isnan(value)) continue;
        least_[c] = std::min(least_[c], value);
        largest_[c] = std::max(largest_[c], value);
      }
      voxels::Volume<float> level = channels[c];
      for (std::size_t n = 0; n < levels_.size(); ++n) {
        if (n > 0) level = halved(level, header_.channels[c].is_label);
        write_level(n, c, first_plane / planes_, level, failure);
      }
    }
    base::collectively(communicator_, [&] {
      if (failure) std::rethrow_exception(failure);
    });
  }

  void finish() override {
    for (std::size_t c = 0; c < least_.size(); ++c) {
      least_[c] = communicator_.min(least_[c]);
      largest_[c] = communicator_.max(largest_[c]);
    }
    base::collectively(communicator_, [&] {
      if (!communicator_.is_root()) return;
      write_json(draft_ + "/.zattrs", attributes());
      std::error_code failure;
      fs::remove_all(path_, failure);
      if (!failure) fs::rename(draft_, path_, failure);
      if (failure) throw base::RunError(path_ + ": cannot be written: " + failure.message());
    });
  }

 private:
  std::array<std::int64_t, 3> chunk(std::size_t level) const {
    const std::array<std::int64_t, 3>& size = levels_[level];
    return {std::min(chunk_edge, size[0]), std::min(chunk_edge, size[1]),
            std::min(planes_, size[2])};
  }

  void begin() const {
    std::error_code failure;
    fs::remove_all(draft_, failure);
    if (!failure) fs::create_directories(draft_, failure);
    if (failure) throw base::RunError(draft_ + ": cannot be made: " + failure.message());
    write_json(draft_ + "/.zgroup", {{"zarr_format", 2}});
    for (std::size_t n = 0; n < levels_.size(); ++n) {
      const std::string level = draft_ + "/" + std::to_string(n);
      fs::create_directories(level, failure);
      const auto [nx, ny, nz] = levels_[n];
      const auto [cx, cy, cz] = chunk(n);
      write_json(level + "/.zarray", {{"zarr_format", 2},
                                      {"shape", {header_.channels.size(), nz, ny, nx}},
                                      {"chunks", {1, cz, cy, cx}},
                                      {"dtype", "<f4"},
                                      {"compressor", compressor(compression_)},
                                      {"fill_value", "NaN"},
                                      {"order", "C"},
                                      {"filters", nullptr},
                                      {"dimension_separator", "/"}});
    }
  }

  /// The chunks of one level, channel and band: the ranks take turns.
  void write_level(std::size_t n, std::size_t channel, std::int64_t band,
                   const voxels::Volume<float>& planes, std::exception_ptr& failure) const {
    const auto [cx, cy, cz] = chunk(n);
    const std::int64_t across = (planes.size[0] + cx - 1) / cx;
    const std::int64_t chunks = across * ((planes.size[1] + cy - 1) / cy);
    for (std::int64_t first = 0; first < chunks; first += communicator_.size()) {
      const std::int64_t own = first + (communicator_.rank() + static_cast<std::int64_t>(channel)) %
                                           communicator_.size();
      const std::int64_t x = own % across, y = own / across;
      voxels::Box box;
      if (own < chunks)
        box = {{x * cx, y * cy, 0},
               {std::min(cx, planes.size[0] - x * cx), std::min(cy, planes.size[1] - y * cy),
                planes.size[2]}};
      const std::vector<float> values = voxels::extract(communicator_, planes, box);
      if (own >= chunks || failure) continue;
      try {
        const fs::path folder = fs::path(draft_) / std::to_string(n) / std::to_string(channel) /
                                std::to_string(band) / std::to_string(y);
        fs::create_directories(folder);
        write_chunk((folder / std::to_string(x)).string(), whole_chunk(values, box, {cx, cy, cz}));
      } catch (const fs::filesystem_error& error) {
        failure = std::make_exception_ptr(
            base::RunError(path_ + ": cannot be written: " + error.code().message()));
      } catch (...) {
        failure = std::current_exception();
      }
    }
  }

  /// Chunks have one size: what lies beyond the image is empty.
  static std::vector<float> whole_chunk(const std::vector<float>& values, const voxels::Box& box,
                                        const std::array<std::int64_t, 3>& size) {
    if (box.count == size) return values;
    std::vector<float> whole(static_cast<std::size_t>(size[0] * size[1] * size[2]),
                             std::numeric_limits<float>::quiet_NaN());
    for (std::int64_t k = 0; k < box.count[2]; ++k)
      for (std::int64_t j = 0; j < box.count[1]; ++j)
        std::copy_n(values.data() + (k * box.count[1] + j) * box.count[0], box.count[0],
                    whole.data() + (k * size[1] + j) * size[0]);
    return whole;
  }

  void write_chunk(const std::string& path, const std::vector<float>& values) const {
    const Bytes packed = pack(reinterpret_cast<const unsigned char*>(values.data()),
                              values.size() * sizeof(float), compression_, sizeof(float));
    write_file(path, packed.data(), packed.size());
  }

  Json attributes() const {
    Json axes = {{{"name", "c"}, {"type", "channel"}}};
    for (const char* axis : {"z", "y", "x"})
      axes.push_back({{"name", axis}, {"type", "space"}, {"unit", "micrometer"}});
    Json datasets = Json::array();
    for (std::size_t n = 0; n < levels_.size(); ++n) {
      const double step = std::ldexp(1.0, static_cast<int>(n));  // of level 0, along x and y
      const auto& h = header_.voxel_size;
      const auto& corner = header_.origin;
      const double middle = 0.5 * (step - 1.0);  // of the voxels that one of this level stands for
      datasets.push_back(
          {{"path", std::to_string(n)},
           {"coordinateTransformations",
            {{{"type", "scale"}, {"scale", {1.0, h[2], step * h[1], step * h[0]}}},
             {{"type", "translation"},
              {"translation",
               {0.0, corner[2], corner[1] + middle * h[1], corner[0] + middle * h[0]}}}}}});
    }
    Json channels = Json::array();
    for (std::size_t c = 0; c < header_.channels.size(); ++c) {
      const double low = std::isfinite(least_[c]) ? static_cast<double>(least_[c]) : 0.0;
      const double high = std::isfinite(largest_[c]) ? static_cast<double>(largest_[c]) : 0.0;
      channels.push_back(
          {{"label", header_.channels[c].name},
           {"color", "FFFFFF"},
           {"active", c == 0},
           {"window", {{"min", low}, {"max", high}, {"start", low}, {"end", high}}}});
    }
    return {{"multiscales",
             {{{"version", "0.4"},
               {"name", header_.name},
               {"axes", axes},
               {"datasets", datasets},
               {"type", "mean"},
               {"metadata", {{"creator", header_.creator}}}}}},
            {"omero", {{"name", header_.name}, {"channels", channels}}}};
  }

  base::Communicator communicator_;
  std::string path_, draft_;
  StackHeader header_;
  Compression compression_;
  std::int64_t planes_;  // of a band, and of a chunk
  std::vector<std::array<std::int64_t, 3>> levels_;
  std::vector<float> least_, largest_;  // (channel)
};

}  // namespace

std::unique_ptr<StackWriter> zarr_stack(const base::Communicator& communicator,
                                        const std::string& path, const StackHeader& header,
                                        Compression compression) {
  return std::make_unique<ZarrStack>(communicator, path, header, compression);
}

}  // namespace stroma::image
