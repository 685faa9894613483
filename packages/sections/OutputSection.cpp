// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/OutputSection.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "stroma/output/files/ParticleVariables.hpp"

namespace stroma::sections {

using namespace output;

namespace {

std::vector<std::string> quantities() {
  std::vector<std::string> names;
  for (const ParticleVariable& variable : particle_variables()) names.push_back(variable.name);
  names.emplace_back("label");
  return names;
}

deck::Section<ImageStacksParameters> image_stacks_section() {
  using image::Compression;
  deck::Section<ImageStacksParameters> section(
      "Image Stacks",
      "Results as images: means over the voxels of the specimen's image, a channel for each "
      "quantity. Where this sublist is left out, none is written.");
  section
      .optional("Quantities", &ImageStacksParameters::quantities, deck::one_of(quantities()),
                "Variables of particles.e, and label, the label of the material that fills most of "
                "a voxel.")
      .choice("Frame", &ImageStacksParameters::frame,
              {{"Undeformed", StackFrame::undeformed},
               {"Deformed", StackFrame::deformed},
               {"Both", StackFrame::both}},
              "At the voxels of the image, or of its Region (image_undeformed), where voxels of "
              "the same size are once the body has moved (image_deformed), or both.")
      .choice(
          "Format", &ImageStacksParameters::format,
          {{"OME-TIFF", image::StackFormat::ome_tiff}, {"OME-Zarr", image::StackFormat::ome_zarr}},
          "One file that is an OME-TIFF and a hyperstack of ImageJ, or a folder that is an "
          "OME-Zarr 0.4.")
      .choice("Compression", &ImageStacksParameters::compression,
              {{"None", Compression::none},
               {"Zlib", Compression::zlib},
               {"Zstd", Compression::zstd},
               {"Blosc", Compression::blosc}},
              "Of strips or chunks, without loss. ImageJ by itself reads None and Zlib; Blosc is "
              "for OME-Zarr alone.")
      .optional("Every", &ImageStacksParameters::every, deck::at_least(0),
                "Load steps between two stacks, whose names then hold the number of their step; 0: "
                "of the last step only.")
      .check([](const ImageStacksParameters& stacks, deck::Findings& findings) {
        const std::vector<std::string>& all = stacks.quantities;
        if (all.empty()) findings.add("Quantities", "is empty; admissible: one or more");
        for (std::size_t n = 0; n < all.size(); ++n)
          if (std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n), all[n]) > 0)
            findings.add("Quantities", "\"" + all[n] + "\" stands there twice");
        if (stacks.compression == Compression::blosc &&
            stacks.format == image::StackFormat::ome_tiff)
          findings.add("Compression",
                       "\"Blosc\" is for Format = OME-Zarr; admissible with OME-TIFF: "
                       "\"None\", \"Zlib\", \"Zstd\"");
      });
  return section;
}

}  // namespace

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
      .optional("VTKHDF", &OutputParameters::vtkhdf, deck::any(),
                "Write the steps of particles.e and grid.e as VTKHDF, too: one file a step for all "
                "ranks, particles-s0003.hdf, and their list, particles.hdf.series, for ParaView.")
      .section(image_stacks_section(), &OutputParameters::image_stacks)
      .optional(
          "Tables", &OutputParameters::tables, deck::any(),
          "Write materials.csv, histograms.csv, wall_distance.csv and objects.csv at the end: how "
          "stress and strain of the last step are distributed over each material, with the "
          "distance to walls, and over connected objects.")
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
