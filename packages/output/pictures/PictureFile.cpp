// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/PictureFile.hpp"

#include <filesystem>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"

namespace stroma::output {

namespace {

/// A picture is whole if it ends as PNG files do; gnuplot does not tell when a disk is full.
bool is_whole_png(const std::string& path) {
  static const std::string end{"\0\0\0\0IEND\xae\x42\x60\x82", 12};
  std::ifstream file(path, std::ios::binary);
  std::string last(end.size(), '\0');
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  file.read(last.data(), static_cast<std::streamsize>(last.size()));
  return file.good() && last == end;
}

}  // namespace

std::string draw_picture(const base::Communicator& communicator, const std::string& run_folder,
                         const std::string& name, const std::string& data,
                         const std::string& data_ending, const std::string& script) {
  std::string note;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    const std::string folder = run_folder + "/pictures";
    const std::string picture = run_folder + "/" + name + ".png";
    std::error_code reason;
    std::filesystem::create_directories(folder, reason);
    write_file(folder + "/" + name + "." + data_ending, data);
    write_file(folder + "/" + name + ".gp", script);
    const std::string failure = run_gnuplot(folder, name + ".gp");
    if (!failure.empty()) {
      note = name + ".png was not drawn: " + failure + "; " + folder + "/" + name +
             ".gp draws it where gnuplot with pngcairo is at hand";
    } else if (std::filesystem::exists(picture, reason) && !is_whole_png(picture)) {
      throw base::RunError("cannot write '" + picture + "': the picture is cut short");
    }
  });
  communicator.broadcast(note);
  return note;
}

ForceUnit force_unit(double largest) {
  if (largest >= 1e6) return {"µN", 1e6};
  if (largest >= 1e3) return {"nN", 1e3};
  return {"pN", 1.0};
}

const char* line_colour(std::size_t n) {
  static const char* const colours[] = {"#31688e", "#b2182b", "#35b779",
                                        "#e69f00", "#440154", "#4d4d4d"};
  return colours[n % 6];
}

}  // namespace stroma::output
