// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ParticlesSection.hpp"

namespace stroma::sections {

using namespace particles;

deck::Section<ParticleParameters> particles_section() {
  deck::Section<ParticleParameters> section(
      "Particles", "How the image becomes particles; a particle's label is that of its voxel.");
  section.choice(
      "Layout", &ParticleParameters::layout,
      {{"Voxel Centers", Layout::voxel_centers},
       {"Gauss", Layout::gauss},
       {"Per Element", Layout::per_element}},
      "Voxel Centers: Per Voxel^3 particles in each voxel, cut where faces of elements cross it, "
      "and halved where elements would have one alone: any resolution of the grid is integrated. "
      "Gauss: the 2 x 2 x 2 Gauss points of each element. Per Element: Per Element^3 equally "
      "spaced particles in each element. These two take the label of the voxel at the particle for "
      "all that it stands for, and so lose voxels where there are more than particles; the domains "
      "of Gauss points leave gaps for shape functions that average over them, and Per Element = 1 "
      "leaves motions of nodes without resistance. In plane strain, Voxel Centers and Per Element "
      "have one particle through z: nothing varies there.");
  section.optional("Per Voxel", &ParticleParameters::per_voxel, deck::between(1, 16),
                   "Particles per voxel and direction, for Layout = Voxel Centers.");
  section.optional("Per Element", &ParticleParameters::per_element, deck::between(1, 64),
                   "Particles per element and direction, for Layout = Per Element.");
  return section;
}

}  // namespace stroma::sections
