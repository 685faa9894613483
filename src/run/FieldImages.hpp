// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What particles take from images for the numbers and directions of their materials.

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "run/Deck.hpp"
#include "run/ReadImages.hpp"
#include "run/Specimen.hpp"
#include "stroma/image/StructureTensor.hpp"
#include "stroma/particles/Seeding.hpp"

namespace stroma {

/// Intensities and directions at the particles of a rank. An image is read when it is first asked
/// for, and gone when the particles have its values. Member functions are collective; all throw
/// base::InputError, naming the deck's section, when an image cannot be had, has another size or
/// voxel size than the specimen's, or holds no number there.
class FieldImages {
 public:
  /// \param communicator  of the ranks that share the particles
  /// \param deck          it names the images
  /// \param image         the specimen's; it and the particles' voxels must stay
  /// \param particles     where they lie in it
  /// \param seen          gets the images that are read; it must stay
  FieldImages(const base::Communicator& communicator, const Deck& deck, const SpecimenImage& image,
              const particles::ParticleVoxels& particles, ReadImages& seen)
      : communicator_(communicator),
        deck_(&deck),
        image_(&image),
        particles_(&particles),
        seen_(&seen) {}

  /// (particle) the intensity of its voxel.
  /// \param where      the deck's section that asks
  /// \param smoothing  standard deviation [um]
  const std::vector<double>& intensities(const std::string& where,
                                         const material::FieldImage& image, double smoothing);
  /// (particle) the direction of fibres in its voxel.
  /// \param counts  (particle) whether its direction is wanted, and has to be there
  std::vector<image::Orientation> directions(const std::string& where,
                                             const material::DirectionsFromImage& from,
                                             const std::vector<bool>& counts);

 private:
  voxels::IntensityVolume read(const std::string& where, const material::FieldImage& image);
  std::vector<image::Orientation> by_structure_tensor(const std::string& where,
                                                      const material::DirectionsFromImage& from,
                                                      const std::vector<bool>& counts);
  std::vector<image::Orientation> by_components(const std::string& where,
                                                const material::DirectionsFromImage& from,
                                                const std::vector<bool>& counts);
  /// Refuses the first particle that counts and has no direction.
  void require_directions(const std::string& where, const std::string& what,
                          const std::vector<bool>& counts, const std::vector<bool>& has) const;
  std::string name_of_voxel(std::size_t particle) const;

  using Key = std::tuple<std::optional<std::string>, std::optional<std::string>, std::optional<int>,
                         std::optional<int>, double>;
  base::Communicator communicator_;
  const Deck* deck_;
  const SpecimenImage* image_;
  const particles::ParticleVoxels* particles_;
  std::map<Key, std::vector<double>> known_;
  ReadImages* seen_;
};

}  // namespace stroma
