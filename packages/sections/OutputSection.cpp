// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/OutputSection.hpp"

namespace stroma::sections {

using namespace output;

deck::Section<OutputParameters> output_section() {
  deck::Section<OutputParameters> section("Output",
                                          "What a run writes into its folder, and how often.");
  section
      .optional("Particles Every", &OutputParameters::particles_every, deck::at_least(0),
                "Load steps between two writes of particles.e; 0: the last step only.")
      .optional("Grid Every", &OutputParameters::grid_every, deck::at_least(0),
                "Load steps between two writes of grid.e; 0: the last step only.")
      .optional(
          "Checkpoint Every", &OutputParameters::checkpoint_every, deck::at_least(0),
          "Load steps between two checkpoints (checkpoint.h5, from which `stroma run --restart` "
          "goes on); 0: as Checkpoint Minutes says. One is written at the end, too, and where a "
          "run is stopped by a signal or by --time-limit.")
      .optional(
          "Checkpoint Minutes", &OutputParameters::checkpoint_minutes, deck::at_least(0.0),
          "Minutes between two checkpoints, at the end of a step; 0: as Checkpoint Every says.")
      .choice(
          "Precision", &OutputParameters::precision,
          {{"Double", Precision::Double}, {"Single", Precision::Single}},
          "Floating-point numbers in particles.e and grid.e: Double (8 bytes) or Single (4 bytes, "
          "half the space).")
      .optional("Pictures", &OutputParameters::pictures, deck::any(),
                "Draw vessels.png, von_mises.png and force.png with gnuplot at the end.")
      .optional("Report", &OutputParameters::report, deck::any(),
                "Write report.html at the end: what `stroma report DIR` makes of the folder.")
      .choice("Origin", &OutputParameters::origin,
              {{"Top", Origin::Top}, {"Bottom", Origin::Bottom}},
              "Where pictures have y = 0, the image's first row: at the Top, as image viewers show "
              "the image (y grows downwards, the face y- is at the top), or at the Bottom.");
  return section;
}

}  // namespace stroma::sections
