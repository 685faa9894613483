// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What each label of the image is made of.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/material/AnyLaw.hpp"
#include "stroma/material/MaterialFields.hpp"

namespace stroma::material {

/// A family of fibres: the deck's list `Fibers|FAMILY`.
struct FiberParameters : DirectionsFromImage {
  std::optional<int> law;                 ///< place in the list of laws of fibres
  std::map<std::string, double> numbers;  ///< the law's, by their names in the deck
  Distribution distribution = Distribution::single;
  std::optional<std::array<double, 3>> direction;  ///< of single and axial; any length but 0
  double share = 1.0;                              ///< of the fibres; set by particles, not decks
  std::optional<std::array<double, 3>> axes;       ///< of ellipsoidal, > 0
  std::optional<double> concentration;             ///< b of axial
  std::optional<int> quadrature;                   ///< rings from pole to equator; absent: 16
};

struct FibersParameters {
  std::vector<std::pair<std::string, FiberParameters>> families;  ///< by the user's names
};

/// Relaxation of a material's stress: the deck's list `Viscosity`.
struct ViscosityParameters {
  double long_term = 1.0;      ///< G0 [-]
  std::vector<double> moduli;  ///< g_i [-], >= 0
  std::vector<double> times;   ///< t_i [s], one each, > 0
  bool is_deviatoric = false;
};

/// A stress that the material makes by itself: the deck's list `Active Stress`.
struct ActiveStressParameters {
  ActiveStress::Kind kind = ActiveStress::Kind::isotropic;
  double t0 = 0.0;                                 ///< [Pa]
  std::optional<std::array<double, 3>> direction;  ///< absent: that of the first single family
  std::optional<std::string> load_curve;           ///< the deck's name of it
};

/// The deck's list `Growth`.
struct GrowthParameters {
  Growth::Kind kind = Growth::Kind::volume;
  double ratio = 1.0;                              ///< g at full load [-], > 0
  std::optional<std::array<double, 3>> direction;  ///< absent: that of the first single family
  std::optional<std::string> load_curve;           ///< the deck's name of it
};

struct MaterialParameters {
  int label = 0;
  int model = 0;  ///< place in the list of laws
  /// The model's numbers by their names in the deck, as far as it gives them. Of "Poisson Ratio"
  /// and the modulus that it stands for there is one.
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<double>> lists;  ///< its lists of numbers, likewise
  VolumetricEnergy volumetric_energy = VolumetricEnergy::logarithmic;
  std::optional<std::string> load_curve;  ///< of a Pressure; absent: the load factor
  std::optional<double> density;          ///< rho [kg/m^3], > 0; where forces per mass act
  std::optional<FibersParameters> fibers;
  std::optional<ViscosityParameters> viscosity;
  std::optional<ActiveStressParameters> active_stress;
  std::optional<GrowthParameters> growth;
  std::optional<MaterialFields> fields;
};

/// Materials as the user named and ordered them. A material's place in the list is its index.
using NamedMaterials = std::vector<std::pair<std::string, MaterialParameters>>;

struct MaterialsParameters {
  NamedMaterials materials;
};

/// How materials resist a change of volume.
struct Compressibility {
  double largest_poisson_ratio;  ///< of small strain
  bool may_be_averaged = true;   ///< all laws have an energy of volume that does not relax
};

/// Of at least one material.
Compressibility compressibility(const NamedMaterials& materials);

/// Whether a material is a Pressure.
bool is_pressure(const MaterialParameters& material);
/// Whether it is Neo-Hookean, without fibres, viscosity, drives or numbers that vary.
bool is_neo_hookean_alone(const MaterialParameters& material);

/// The law of each material, by index, and the directions of fibres that they point to.
struct MaterialLaws {
  std::vector<AnyLaw> laws;
  std::vector<FiberDirections> directions;
};
MaterialLaws laws_of(const NamedMaterials& materials);

/// Of small strain, of each material, fibres included.
std::vector<SmallStrainModuli> moduli_of(const NamedMaterials& materials);

/// The direction of a family that has one; of one whose particles have theirs, what stands for them.
std::optional<std::array<double, 3>> direction_in(const FiberParameters& family);

/// The direction of a drive: its own, or that of the material's first family with a single one.
std::optional<std::array<double, 3>> direction_of(const MaterialParameters& material,
                                                  const std::optional<std::array<double, 3>>& own);

/// Without the directions of distributions of fibres: enough for all but stress.
AnyLaw law_at_rest(const MaterialParameters& material);

/// Numbers of history that particles need.
int states_of_materials(const NamedMaterials& materials);

/// Numbers of their own that particles need, at most.
int numbers_of_particles(const NamedMaterials& materials);

/// Whether anything of a material differs from particle to particle.
bool vary(const NamedMaterials& materials);
/// Whether fields or directions follow from the specimen's own image, as the deck reads it.
bool read_the_specimens_image(const NamedMaterials& materials);

/// The index of the material of each label.
std::map<std::int32_t, int> material_of_label(const NamedMaterials& materials);

}  // namespace stroma::material
