// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// particles.e: the particles and their stress, as an Exodus file that ParaView opens.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "stroma/output/files/ExodusStep.hpp"
#include "stroma/output/files/ParticleVariables.hpp"

namespace stroma::output {

/// The particles of one rank: views of the caller's arrays, nothing is owned.
struct ParticleSet {
  std::int64_t count = 0;                  ///< may be 0; the pointers may then be null
  const double* position = nullptr;        ///< (particle, xyz) reference position [um]
  const double* volume = nullptr;          ///< (particle) reference volume [um^3]
  const std::int64_t* id = nullptr;        ///< (particle) global number, from 0
  const std::uint8_t* material = nullptr;  ///< (particle) index into the list of materials
};

/// Of a ball of some volume [um].
double radius_of(double volume);

/// Hands out the states of all particles of a rank in pieces: calls use(first, count, state) for
/// consecutive ranges that together are the whole set; state's pointers begin at the particle
/// `first`. So nobody has to keep the state of all particles at once. Does not communicate.
using StatePieces =
    std::function<void(const std::function<void(std::int64_t first, std::int64_t count,
                                                const ParticleState& state)>& use)>;

/// The one piece that is everything.
StatePieces in_one_piece(std::int64_t count, const ParticleState& state);

/// Writes particles.e, or under N > 1 ranks the spread files particles.e.N.r.
///
/// Every particle is one node and one element of type SPHERE. A material is an element block that
/// bears its name (id: index + 1) and exists on every rank, even where it is empty. The number maps
/// hold the particles' global numbers + 1. Element attributes: `radius` of a ball of the particle's
/// volume [um], and `volume`, the reference volume [um^3]. Coordinates of an Exodus file cannot
/// change in time, so the nodes stand at the reference positions and `displacement_x/y/z` exists
/// twice: as a nodal variable, by which ParaView ("Apply Displacements", on by default) shows the
/// particle at its current position, and as an element variable like the others
/// (ParticleVariables.cpp). Global variables: a row of history.csv. The time of a step is that of
/// its row.
///
/// Nothing is kept but one buffer of bounded size, and the file is closed between steps, so that a
/// running one can be looked at. What a killed run leaves: see ExodusFile.
class ParticleFile {
 public:
  /// Creates the file(s) with everything that does not change, or continues those that are there,
  /// and cuts off what comes behind. Collective.
  /// \param communicator      of the ranks that share the particles
  /// \param path              of the file, without the ending of a spread one
  /// \param particles         this rank's
  /// \param materials         names of all materials, also of those without particles
  /// \param global_variables  names of the global variables: history_columns()
  /// \param provenance        title, version and deck, kept in the file
  /// \param precision         of the numbers in it
  /// \param fields            those of the states, in their order; the same on all ranks
  /// \param continued         where this rank's file, written by an equal one, is to be continued
  /// \throws RunError on all ranks, naming the file and what could not be written
  ParticleFile(const base::Communicator& communicator, const std::string& path,
               const ParticleSet& particles, const std::vector<std::string>& materials,
               const std::vector<std::string>& global_variables, const Provenance& provenance,
               Precision precision = Precision::Double, const std::vector<ShownField>& fields = {},
               const std::optional<FileEnd>& continued = {});

  /// Adds one step. Collective.
  /// \param particles  the same particles, in the same order, as at construction
  /// \param states     in pieces of any size
  /// \param time       of the step, later than that of the step before
  /// \param globals    one value for each global variable: history_values()
  /// \throws RunError on all ranks, naming the file and what could not be written
  void write(double time, const ParticleSet& particles, const StatePieces& states,
             const std::vector<double>& globals);

  /// Adds the steps that another number of ranks wrote, of the same particles and variables, to a
  /// file that has none. Collective.
  /// \param path       of those files, without the ending of a spread one
  /// \param ranks      that wrote them
  /// \param particles  as at construction
  /// \throws RunError on all ranks, when they cannot be read or this one cannot be written
  void copy_steps(const std::string& path, int ranks, const ParticleSet& particles);

  /// Steps written so far.
  int steps() const { return static_cast<int>(end_.steps); }
  /// Where this rank's file ends.
  const FileEnd& end() const { return end_; }

 private:
  base::Communicator communicator_;
  std::string path_;  ///< of this rank's own file
  std::size_t materials_;
  std::size_t globals_;
  std::vector<ParticleVariable> variables_;
  std::int64_t count_;
  FileEnd end_;
};

}  // namespace stroma::output
