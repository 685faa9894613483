#include "output/PictureFile.hpp"

#include <filesystem>
#include <fstream>

#include "output/Gnuplot.hpp"

namespace stroma::output {

std::string draw_picture(const base::Communicator& communicator, const std::string& run_folder,
                         const std::string& name, const std::string& data,
                         const std::string& data_ending, const std::string& script) {
  std::string note;
  if (communicator.is_root()) {
    const std::string folder = run_folder + "/pictures";
    std::error_code reason;
    std::filesystem::create_directories(folder, reason);
    const auto written = [&](const std::string& file, const std::string& content) {
      std::ofstream stream(folder + "/" + file, std::ios::binary);
      stream << content;
      stream.close();
      return !stream.fail();
    };
    if (!written(name + "." + data_ending, data) || !written(name + ".gp", script)) {
      note = name + ".png was not drawn: cannot write into '" + folder + "'";
    } else {
      const std::string failure = run_gnuplot(folder, name + ".gp");
      if (!failure.empty()) {
        note = name + ".png was not drawn: " + failure + "; " + folder + "/" + name +
               ".gp draws it where gnuplot with pngcairo is at hand";
      }
    }
  }
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
