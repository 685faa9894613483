// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// checkpoint.h5: a run as it is after a step, for one that goes on from there on any number of
/// ranks. Its datasets are listed in docs/file_formats.md.

#include <functional>
#include <memory>
#include <string>

#include "run/Deck.hpp"
#include "run/Results.hpp"
#include "run/Specimen.hpp"
#include "stroma/mechanics/MovingBody.hpp"
#include "stroma/output/files/StateFile.hpp"
#include "stroma/solver/NewtonSolver.hpp"
#include "stroma/solver/StepControl.hpp"

namespace stroma {

/// All of a run but its body.
struct RunState {
  solver::LoadProgress load;
  solver::NewtonMemory newton;
  ResultsSoFar results;
};

/// Writes a checkpoint, in place of the one before. Collective.
/// \throws base::RunError on all ranks when it cannot be written; the one before is still there
void write_checkpoint(const base::Communicator& communicator, const std::string& path,
                      const Deck& deck, const std::vector<KnownFile>& files,
                      const mechanics::MovingBody& body, const RunState& state);

/// A checkpoint that a run goes on from. Every member function is collective; what is damaged in the
/// file is a base::InputError on all ranks.
class Checkpoint {
 public:
  /// Opens it and compares it with the deck.
  /// \throws base::InputError when it cannot be read, or belongs to a deck whose body is another,
  ///         or whose load curves were others in the steps that it has behind it
  Checkpoint(const base::Communicator& communicator, const std::string& path, const Deck& deck);

  /// Whether image files are those that the run had, by their checksums.
  bool has_images(const std::vector<KnownFile>& files) const;
  /// \throws base::InputError when they are not
  void require_images(const std::vector<KnownFile>& files) const;

  /// All of the run but its body. Load factors are those of the deck's duration.
  const RunState& state() const { return state_; }

  /// The body as it was.
  /// \throws base::InputError  see mechanics::MovingBody
  std::unique_ptr<mechanics::MovingBody> body(const Specimen& specimen,
                                              const mechanics::Problem& problem) const;

 private:
  void read_state(const Deck& deck);
  void require_same_past(const Deck& deck, double stretch) const;
  void restore(particles::Particles<grid::Device>& particles) const;
  void restore(const std::string& name, grid::Vector& u, const grid::Partition& partition) const;
  void on_every_rank(const std::function<void()>& work) const;

  base::Communicator communicator_;
  std::unique_ptr<output::StateReader> file_;
  RunState state_;
  mechanics::Motion motion_;  ///< but for the grid
};

}  // namespace stroma
