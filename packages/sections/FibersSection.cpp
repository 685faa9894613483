// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/FibersSection.hpp"

#include <utility>

#include "stroma/base/Log.hpp"
#include "stroma/sections/Directions.hpp"
#include "stroma/sections/FieldImage.hpp"
#include "stroma/sections/ModelNumbers.hpp"

namespace stroma::sections {

using namespace material;

namespace {

/// Finds what a choice asks for and is not given, and what is given that only another uses.
class Asking {
 public:
  Asking(std::string by, bool is_chosen, deck::Findings& findings)
      : by_(std::move(by)), is_chosen_(is_chosen), findings_(findings) {}

  void may_have(const char* name, bool is_given) const {
    if (is_given && !is_chosen_) findings_.add(name, "is used with " + by_ + " only");
  }
  void must_have(const char* name, bool is_given) const {
    may_have(name, is_given);
    if (!is_given && is_chosen_) findings_.add(name, "missing; " + by_ + " asks for it");
  }

 private:
  std::string by_;
  bool is_chosen_;
  deck::Findings& findings_;
};

/// What a distribution asks for, and what it leaves unused.
void check_distribution(const FiberParameters& p, deck::Findings& findings) {
  const bool is_axial = p.distribution == Distribution::axial;
  const bool has_axis = p.distribution == Distribution::single || is_axial;
  if (p.direction && p.direction_from)
    findings.add("Direction", "beside Direction From; admissible: one of the two");
  else
    Asking("Distribution = Single or Axial", has_axis, findings)
        .must_have("Direction", p.direction || p.direction_from);
  Asking("Distribution = Ellipsoidal", p.distribution == Distribution::ellipsoidal, findings)
      .must_have("Axes", p.axes.has_value());
  Asking("Distribution = Axial", is_axial, findings)
      .must_have("Concentration", p.concentration.has_value());
  if (p.distribution == Distribution::single && p.quadrature)
    findings.add("Quadrature", "is not used with Distribution = Single");
  refuse_no_length("Direction", p.direction, findings);
}

/// What directions from images ask for, and what they leave unused.
void check_images(const FiberParameters& p, deck::Findings& findings) {
  using Kind = DirectionsFromImage::Kind;
  const bool is_tensor = p.direction_from == Kind::structure_tensor;
  const bool is_images = p.direction_from == Kind::images;
  const Asking tensor("Direction From = Structure Tensor", is_tensor, findings);
  tensor.may_have("Image", p.file.has_value());
  tensor.may_have("Dataset", p.dataset.has_value());
  tensor.may_have("Channel", p.channel.has_value());
  tensor.may_have("Frame", p.frame.has_value());
  tensor.must_have("Gradient Scale [um]", p.gradient_scale.has_value());
  tensor.must_have("Window Scale [um]", p.window_scale.has_value());
  tensor.may_have("Coherence Weight", p.weigh_by_coherence);
  if (is_tensor && p.gradient_scale && p.window_scale && *p.window_scale < *p.gradient_scale)
    findings.add("Window Scale [um]",
                 base::format("found %g; admissible: at least the Gradient Scale, %g",
                              *p.window_scale, *p.gradient_scale));
  if (is_images && p.images.size() != 3)
    findings.add("Images",
                 base::format("found %zu files; admissible: three, of the components along "
                              "x, y, z",
                              p.images.size()));
  Asking("Direction From = Images", is_images, findings).may_have("Images", !p.images.empty());
}

}  // namespace

deck::Section<FibersParameters> fibers_section() {
  const auto known = all_of(fiber_models());
  deck::Section<FiberParameters> family("FAMILY", "One family of fibres; its name is the user's.");
  family.choice("Law", &FiberParameters::law, choices_among(known),
                "Energy of the fibres, by I_n = N.C.N, the square of their stretch l: " +
                    meanings_of(known) + ".");
  for (const SharedNumber& number : shared_numbers(known))
    family.optional(number.name, &FiberParameters::numbers, admissible(number.admissible),
                    "Of " + number.models + ". " + number.meaning);
  family.choice(
      "Distribution", &FiberParameters::distribution,
      {{"Single", Distribution::single},
       {"Spherical", Distribution::spherical},
       {"Ellipsoidal", Distribution::ellipsoidal},
       {"Axial", Distribution::axial}},
      "Where the fibres point in the undeformed body. Single: along Direction. Spherical: "
      "everywhere alike. Ellipsoidal: with weight (sum (N_i/a_i)^2)^(-1/2), a the Axes. "
      "Axial: with weight exp(2 b (N.A)^2), A along Direction, b the Concentration. "
      "Energies are means over the directions; FEBio's distributions integrate over the "
      "sphere, which is 4 pi times the mean where their weight is 1.");
  family.optional("Direction", &FiberParameters::direction, deck::any(),
                  "x, y, z of Single and Axial; any length but 0.");
  family.choice(
      "Direction From", deck::inherited<FiberParameters>(&FiberParameters::direction_from),
      {{"Structure Tensor", DirectionsFromImage::Kind::structure_tensor},
       {"Images", DirectionsFromImage::Kind::images}},
      "In place of Direction, of each particle its own. Structure Tensor: the direction in "
      "which an image varies least. Images: the voxel's, by three images.");
  declare_field_image(family);
  family.optional("Gradient Scale [um]",
                  deck::inherited<FiberParameters>(&FiberParameters::gradient_scale),
                  deck::positive(),
                  "Standard deviation of the Gaussian whose derivatives give the image's gradient: "
                  "about the radius of a fibre, and no less than a voxel or so.");
  family.optional("Window Scale [um]",
                  deck::inherited<FiberParameters>(&FiberParameters::window_scale),
                  deck::positive(),
                  "Of the Gaussian over which products of gradients are averaged: the size of a "
                  "region of one direction, a few fibres wide.");
  family.optional(
      "Coherence Weight", deck::inherited<FiberParameters>(&FiberParameters::weigh_by_coherence),
      deck::any(),
      "Whether a particle's fibres count by the coherence of their direction, (l2 - l3) "
      "/ (l2 + l3), l1 >= l2 >= l3 the eigenvalues of the structure tensor.");
  family.optional("Images", deck::inherited<FiberParameters>(&FiberParameters::images), deck::any(),
                  "Three files of the components of the direction along x, y, z, of the specimen's "
                  "voxels; any length but 0, either sense.");
  family.optional("Axes", &FiberParameters::axes, deck::positive(),
                  "a_x, a_y, a_z of Ellipsoidal.");
  family.optional("Concentration", &FiberParameters::concentration, deck::any(),
                  "b of Axial; 0: spherical, negative: around the plane across Direction.");
  family.optional(
      "Quadrature", &FiberParameters::quadrature, deck::between(2, 64),
      "Rings of directions from pole to equator, n: about 3 n^2 directions. The error "
      "of the stress falls as n^-2; absent: 16, good to 1e-3 at 20 % strain for Spherical, to 4e-3 for Axial of concentration 60, to some 1e-2 for sharper peaks.");
  family.check([](const FiberParameters& p, deck::Findings& findings) {
    if (p.law)
      check_numbers(fiber_models()[static_cast<std::size_t>(*p.law)], "Law", p.numbers, {},
                    findings);
  });
  family.check(check_distribution);
  family.check(check_images);

  deck::Section<FibersParameters> section(
      "Fibers",
      "Families of fibres embedded in the material, one sublist each, named by the user.");
  section.named_sections(family, &FibersParameters::families);
  section.check([](const FibersParameters& p, deck::Findings& findings) {
    const std::size_t most = AnyLaw::most_families;
    if (p.families.size() > most)
      findings.add(p.families[most].first,
                   base::format("family %zu; admissible: at most %zu", most + 1, most));
  });
  return section;
}

}  // namespace stroma::sections
