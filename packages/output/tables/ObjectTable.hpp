// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// objects.csv: size, place, shape, stress and strain of each connected object.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/labels/NumberedObjects.hpp"
#include "stroma/output/files/ParticleVariables.hpp"
#include "stroma/output/files/RunFolder.hpp"

namespace stroma::output {

/// Where an object's voxels are.
struct ObjectLattice {
  std::array<double, 3> voxel_size, origin;  ///< [um]
};

/// The sums over the particles of objects, on one rank.
class ObjectSums {
 public:
  /// Deformed volume; volume times von Mises stress, stress and strain (xx yy zz xy yz zx).
  static constexpr std::size_t count = 14;
  using Sums = std::array<double, count>;

  /// \param object  (particle) number of its object, or 0; must outlive the sums
  explicit ObjectSums(const std::vector<std::int32_t>& object) : object_(&object) {}

  /// Adds a particle, if it belongs to an object.
  void add(std::int64_t p, const ParticleAt& particle, double volume);
  /// By number.
  const std::map<std::int32_t, Sums>& sums() const { return sums_; }

 private:
  const std::vector<std::int32_t>* object_;
  std::map<std::int32_t, Sums> sums_;
  Sums* last_ = nullptr;
  std::int32_t last_object_ = 0;
};

/// The object with the largest principal value of its mean stress; object 0: there is none.
struct MostStressed {
  std::int64_t object = 0, voxels = 0;
  std::string material;
  double stress = 0.0;  ///< [Pa]
};

/// Writes the table in pieces of 4096 objects, of which all ranks have the sums at a time.
/// Collective.
/// \param communicator  of the run
/// \param files         of the run
/// \param materials     (label) name; a label without one has an empty field
/// \param lattice       of the voxels
/// \param objects       without the numbers of voxels
/// \param sums          of this rank's particles
/// \throws base::RunError on all ranks when the file cannot be written
/// \return  on all ranks
MostStressed write_object_table(const base::Communicator& communicator, const RunFiles& files,
                                const std::map<std::int64_t, std::string>& materials,
                                const ObjectLattice& lattice, const image::NumberedObjects& objects,
                                const ObjectSums& sums);

}  // namespace stroma::output
