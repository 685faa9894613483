// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ImageSection.hpp"

#include <algorithm>

#include "stroma/sections/Directions.hpp"

namespace stroma::sections {

using namespace image;

namespace {

using deck::any;
using deck::at_least;
using deck::not_empty;
using deck::not_negative;
using deck::or_one_of;
using deck::positive;
using deck::strictly_between;

deck::Section<SegmentationParameters> segmentation_section() {
  using Method = SegmentationParameters::Method;
  deck::Section<SegmentationParameters> section("Segmentation", "How intensities become labels.");
  section
      .choice(
          "Method", &SegmentationParameters::method,
          {{"Threshold", Method::threshold}, {"Otsu", Method::otsu}, {"Labels", Method::labels}},
          "Threshold: label 1 where the intensity exceeds Threshold, else 0. Otsu: the same, with "
          "the threshold that parts the histogram best (one bin per level for integers, 256 equal "
          "bins for floats). Labels: the values are labels; -1 is empty space.")
      .optional("Threshold", &SegmentationParameters::threshold, any(),
                "Label 1 where the intensity exceeds it. Required with Method = Threshold, and "
                "only then.")
      .optional("Smoothing [um]", &SegmentationParameters::smoothing, not_negative(),
                "Standard deviation of the Gaussian that smooths the intensities first; 0: none. "
                "Truncated at 4 standard deviations; the image continues beyond its faces as its "
                "mirror image. Along a direction in which it exceeds twice the image, the mean is "
                "taken.")
      .optional("Empty Labels", &SegmentationParameters::empty_labels,
                or_one_of(not_negative(), {"Dark", "Bright"}),
                "What becomes empty space, that is, label -1: with Method = Labels a list of "
                "labels; with a threshold the word Dark (what would be label 0) or Bright (what "
                "would be label 1).")
      .optional("Smallest Object", &SegmentationParameters::smallest_object, not_negative(),
                "Voxels. Connected objects (one label above 0, 26 neighbours) of fewer voxels "
                "become background: empty space where they touch more of it than of label 0, "
                "else label 0. Empty Labels come first. 0: keep all.");
  section.check([](const SegmentationParameters& s, deck::Findings& findings) {
    if (s.method == Method::threshold && !s.threshold)
      findings.add("Threshold", "missing; required with Method = Threshold; admissible: a number");
    if (s.method != Method::threshold && s.threshold)
      findings.add("Threshold", "needs Method = Threshold; leave one of them out");
    if (s.method == Method::labels && s.smoothing > 0.0)
      findings.add("Smoothing [um]",
                   "labels cannot be smoothed; admissible with Method = Labels: 0");
    if (!s.empty_labels) return;
    const std::string* word = std::get_if<std::string>(&*s.empty_labels);
    if (s.method == Method::labels && word != nullptr)
      findings.add("Empty Labels",
                   "found \"" + *word + "\"; admissible with Method = Labels: a list of labels");
    if (s.method != Method::labels && word == nullptr)
      findings.add("Empty Labels",
                   "found a list; admissible with Method = Threshold or Otsu: Dark or Bright");
    if (word != nullptr && *word == "Bright" && s.smallest_object > 1)
      findings.add("Smallest Object",
                   "objects have labels above 0, and Empty Labels = Bright leaves none; leave one "
                   "of them out");
  });
  return section;
}

deck::Section<ShapeParameters> shape_section() {
  using Kind = ShapeParameters::Kind;
  deck::Section<ShapeParameters> section("Shape",
                                         "A shape. A voxel belongs to it when its centre lies "
                                         "inside. Coordinates start at the specimen's corner.");
  section
      .required_choice("Kind", &ShapeParameters::kind,
                       {{"Ball", Kind::ball}, {"Cylinder", Kind::cylinder}, {"Box", Kind::box}},
                       "What it is.")
      .optional("Label", &ShapeParameters::label, at_least(-1),
                "The label of its voxels; -1: empty space.")
      .required("Center [um]", &ShapeParameters::center, any(), "Its centre: x, y, z.")
      .optional("Radius [um]", &ShapeParameters::radius, positive(),
                "Of a ball or a cylinder (required there).")
      .optional("Axis", &ShapeParameters::axis, any(),
                "Direction of a cylinder's axis: x, y, z, of any length (required there).")
      .optional("Length [um]", &ShapeParameters::length, positive(),
                "Of a cylinder, half to each side of its centre; absent: a cylinder without end.")
      .optional("Size [um]", &ShapeParameters::size, positive(),
                "Sides of a box along x, y, z (required there).");
  section.check([](const ShapeParameters& s, deck::Findings& findings) {
    const bool round = s.kind != Kind::box;
    if (round && !s.radius)
      findings.add("Radius [um]", "missing; required for a ball and a cylinder");
    if (!round && s.radius) findings.add("Radius [um]", "a box has none; it has Size [um]");
    if (s.kind == Kind::cylinder && !s.axis)
      findings.add("Axis", "missing; required for a cylinder");
    if (s.kind != Kind::cylinder && s.axis) findings.add("Axis", "only a cylinder has one");
    if (s.kind != Kind::cylinder && s.length)
      findings.add("Length [um]", "only a cylinder has one");
    refuse_no_length("Axis", s.axis, findings);
    if (!round && !s.size) findings.add("Size [um]", "missing; required for a box");
    if (round && s.size)
      findings.add("Size [um]", "only a box has one; a ball and a cylinder have Radius [um]");
  });
  return section;
}

deck::Section<ShapeList> shape_list_section() {
  deck::Section<ShapeList> section(
      "Shapes", "The shapes, each under a name of yours; later ones overwrite earlier ones.");
  section.named_sections(shape_section(), &ShapeList::shapes);
  return section;
}

deck::Section<PhantomParameters> phantom_section() {
  using Kind = PhantomParameters::Kind;
  deck::Section<PhantomParameters> section("Phantom", "A specimen without an image file.");
  section
      .required_choice(
          "Kind", &PhantomParameters::kind,
          {{"Uniform", Kind::uniform}, {"Vessels", Kind::vessels}, {"Shapes", Kind::shapes}},
          "Uniform: label 0 everywhere. Vessels: a microvessel network of label 1 in label 0. "
          "Shapes: balls, cylinders and boxes in label 0.")
      .required("Size", &PhantomParameters::size, at_least(1), "Voxels along x, y, z.")
      .required("Voxel Size [um]", &PhantomParameters::voxel_size, positive(),
                "Sides of a voxel along x, y, z.")
      .optional("Volume Fraction", &PhantomParameters::fraction, strictly_between(0.0, 0.6),
                "Kind = Vessels: the fraction of the volume that the vessels fill; absent: 0.194.")
      .optional("Seed", &PhantomParameters::seed, not_negative(),
                "Kind = Vessels: another seed gives another network; absent: 1.")
      .section(shape_list_section(), &PhantomParameters::shapes);
  section.check([](const PhantomParameters& p, deck::Findings& findings) {
    if (p.kind != Kind::vessels && p.fraction)
      findings.add("Volume Fraction", "needs Kind = Vessels");
    if (p.kind != Kind::vessels && p.seed) findings.add("Seed", "needs Kind = Vessels");
    if (p.kind == Kind::shapes && !p.shapes)
      findings.add("Shapes", "missing; required with Kind = Shapes");
    if (p.kind != Kind::shapes && p.shapes) findings.add("Shapes", "needs Kind = Shapes");
    if (static_cast<double>(p.size[0]) * static_cast<double>(p.size[1]) *
            static_cast<double>(p.size[2]) >
        1e12)
      findings.add("Size", "more than 10^12 voxels");
  });
  return section;
}

}  // namespace

deck::Section<ImageParameters> image_section() {
  deck::Section<ImageParameters> section("Image", "The specimen: an image file, or a phantom.");
  section
      .optional("File", &ImageParameters::file, not_empty(),
                "The image, relative to the deck: TIFF (also stacks of ImageJ, OME, MetaMorph, "
                "Zeiss LSM), Bio-Rad PIC, "
                "NRRD, MetaImage, NIfTI "
                "or HDF5; or a folder of OME-Zarr (0.1 to 0.4), of which the finest level is read. "
                "Either File or the sublist Phantom.")
      .optional("Dataset", &ImageParameters::dataset, not_empty(),
                "The dataset of an HDF5 file. Its axes are those that the attribute axistags or "
                "DIMENSION_LABELS states, else [y][x], [z][y][x], [c][z][y][x] or "
                "[t][c][z][y][x]. Needed when the file holds several, but for files of Imaris and "
                "BigDataViewer, where Channel and Frame choose it.")
      .optional("Channel", &ImageParameters::channel, not_negative(),
                "The channel to read, counted from 0.")
      .optional("Frame", &ImageParameters::frame, not_negative(),
                "The frame of a time series to read, counted from 0.")
      .optional("Voxel Size [um]", &ImageParameters::voxel_size, positive(),
                "Sides of a voxel along x, y, z. Absent: the file's own. Required where the file "
                "does not state it; overrides the file's.")
      .optional(
          "Region", &ImageParameters::region, not_negative(),
          "First voxel x, y, z, then number of voxels along x, y, z. Absent: the whole image.")
      .section(segmentation_section(), &ImageParameters::segmentation)
      .section(phantom_section(), &ImageParameters::phantom);
  section.check([](const ImageParameters& p, deck::Findings& findings) {
    if (p.file && p.phantom)
      findings.add("Phantom", "beside File; admissible: File or Phantom, not both");
    if (!p.file && !p.phantom)
      findings.add("File", "missing; admissible: File, or the sublist Phantom");
    if (p.phantom) {
      const SegmentationParameters& s = p.segmentation;
      if (p.dataset) findings.add("Dataset", "a phantom has none; it goes with File");
      if (p.channel != 0) findings.add("Channel", "a phantom has none; it goes with File");
      if (p.frame != 0) findings.add("Frame", "a phantom has none; it goes with File");
      if (p.voxel_size)
        findings.add("Voxel Size [um]", "a phantom has its own, in the sublist Phantom");
      if (s.threshold || s.smoothing > 0.0 || s.empty_labels)
        findings.add("Segmentation", "a phantom is made of labels; admissible: Smallest Object");
    }
    if (p.region &&
        std::any_of(p.region->begin() + 3, p.region->end(), [](auto n) { return n < 1; }))
      findings.add("Region",
                   "the last three entries are numbers of voxels; admissible: at least 1 each");
  });
  return section;
}

}  // namespace stroma::sections
