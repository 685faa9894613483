// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// particles.e, read back piece by piece.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace stroma::output {

/// Some particles of one material, in the order of the file.
struct ParticlePiece {
  std::size_t material = 0;
  std::size_t count = 0;
  std::array<std::vector<double>, 3> position;  ///< (axis) (particle), in the undeformed body [um]
  std::vector<double> volume;                   ///< (particle), of the undeformed body [um^3]
  std::vector<std::vector<double>> values;      ///< (variable asked for) (particle)
};

/// The particles of a run, of one file or of a spread set, which is never in memory as a whole. For
/// one rank.
class ParticleReader {
 public:
  /// \param path  of particles.e; where there is no such file, of the newest set PATH.N.r that is whole
  /// \throws base::RunError  there is none, or it cannot be read
  explicit ParticleReader(const std::string& path);

  const std::vector<std::string>& materials() const { return materials_; }
  /// Of the particles.
  const std::vector<std::string>& variables() const { return variables_; }
  /// Steps in the file.
  std::size_t steps() const { return steps_; }
  /// (step in the file) A global variable, a column of history.csv. \throws base::RunError no such variable
  std::vector<double> global(const std::string& name) const;

  /// Calls use(piece) for all particles.
  /// \param step   in the file, from 0
  /// \param names  of the variables wanted; with none, the step is of no meaning
  /// \param use    is given each piece, in the order of the files
  /// \throws base::RunError
  void for_pieces(std::size_t step, const std::vector<std::string>& names,
                  const std::function<void(const ParticlePiece&)>& use) const;

 private:
  struct File {
    std::string path;
    std::shared_ptr<const int> id;    ///< of netCDF; closed with the last copy
    std::vector<std::size_t> blocks;  ///< (material) particles
  };

  std::vector<File> files_;
  std::vector<std::string> materials_, variables_, globals_;
  std::size_t steps_ = 0;
};

}  // namespace stroma::output
