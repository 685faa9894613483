// SPDX-License-Identifier: BSD-3-Clause

#include "commands/PhantomCommand.hpp"

#include <cmath>
#include <filesystem>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/WriteTiff.hpp"
#include "stroma/image/phantom/Phantom.hpp"

namespace stroma {
namespace {

/// What can be said before any work. \throws base::InputError
void check(const PhantomOptions& options) {
  if (options.output.empty())
    throw base::InputError("stroma phantom: name the file to write with -o FILE");
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending != ".tif" && ending != ".tiff")
    throw base::InputError(options.output +
                           ": a phantom is written as TIFF; admissible: a name that " +
                           "ends in .tif or .tiff");
  std::error_code reason;
  const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, reason))
    throw base::InputError(options.output + ": there is no folder " + folder.string());
  const auto found = std::filesystem::symlink_status(options.output, reason);
  if (!std::filesystem::status_known(found))  // a name that is too long, say
    throw base::InputError(options.output + ": " + reason.message());
  if (std::filesystem::exists(found) &&
      (std::filesystem::is_symlink(found) || !image::is_written_by_stroma(options.output)))
    throw base::InputError(options.output +
                           ": exists, and is no phantom that Stroma wrote; remove it, or choose "
                           "another name");
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (options.size[axis] < 1)
      throw base::InputError("--size: admissible: three numbers of voxels, each at least 1");
    if (!(options.voxel_size[axis] > 0.0) || !std::isfinite(options.voxel_size[axis]))
      throw base::InputError("--voxel: admissible: three lengths in um, each above 0");
    voxels *= static_cast<double>(options.size[axis]);
  }
  if (voxels > 1e12) throw base::InputError("--size: more than 10^12 voxels");
  if (options.seed < 0) throw base::InputError("--seed: admissible: an integer of at least 0");
}

}  // namespace

int phantom_command(const base::Communicator& communicator, const PhantomOptions& options,
                    base::Log& log) {
  base::collectively(communicator, [&] { check(options); });
  image::VesselParameters parameters;
  parameters.size = options.size;
  parameters.voxel_size = options.voxel_size;
  parameters.fraction = options.fraction;
  parameters.seed = options.seed;
  const image::GreyVessels grey = image::make_grey_vessels(communicator, parameters);
  image::write_tiff(communicator, options.output, grey.volume);
  log.line(base::format("%s: %lld x %lld x %lld voxels of %g x %g x %g um, 8 bit",
                        options.output.c_str(), static_cast<long long>(options.size[0]),
                        static_cast<long long>(options.size[1]),
                        static_cast<long long>(options.size[2]), options.voxel_size[0],
                        options.voxel_size[1], options.voxel_size[2]));
  log.line(
      base::format("volume fraction of the vessels %.5f (asked for: %.5f), above Otsu's threshold "
                   "%d; of the tubes before blur and noise %.5f",
                   grey.otsu_fraction, options.fraction, grey.otsu_threshold, grey.drawn_fraction));
  return 0;
}

}  // namespace stroma
