// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/VectorImagesSection.hpp"

namespace stroma::sections {

using namespace mechanics;

deck::Section<VectorImages> vector_images_section(const std::string& name,
                                                  const std::string& meaning,
                                                  const std::string& unread) {
  deck::Section<VectorImages> section(name, meaning);
  section.required(
      "Images", &VectorImages::images, deck::not_empty(),
      std::string("Files, relative to the deck: three, of the components x, y, z, or one whose "
                  "channels they are.") +
          unread);
  section.optional("Channels", &VectorImages::channels, deck::not_negative(),
                   "Channels of the components x, y, z, counted from 0. Without it: 0 of three "
                   "files; 0, 1, 2 of one.");
  section.optional("Dataset", &VectorImages::dataset, deck::not_empty(), "Of HDF5 files.");
  section.optional("Frame", &VectorImages::frame, deck::not_negative(), "Of time series, from 0.");
  section.optional(
      "Voxel Size [um]", &VectorImages::voxel_size, deck::positive(),
      "Sides of their voxels along x, y, z; they need not be the specimen's. Without it: "
      "the files' own.");
  section.optional(
      "Corner [um]", &VectorImages::corner, deck::any(),
      "Where the lower corner of their first voxel lies, from that of the first voxel of "
      "the specimen's whole image.");
  section.check([](const VectorImages& p, deck::Findings& findings) {
    if (p.images.size() != 1 && p.images.size() != 3)
      findings.add("Images", "found " + std::to_string(p.images.size()) +
                                 " files; admissible: three, or one that holds all components");
  });
  return section;
}

}  // namespace stroma::sections
