// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// When a run writes its checkpoint.

#include <cstdint>
#include <string>

#include "run/Checkpoint.hpp"

namespace stroma {

/// Keeps checkpoint.h5 of one run up to date.
class Checkpoints {
 public:
  /// \param communicator  of the run
  /// \param path          of checkpoint.h5
  /// \param deck          as run; it says how often
  /// \param files         that the specimen was read from; they stay
  /// \param step          of the checkpoint that is on disk; -1: none
  Checkpoints(const base::Communicator& communicator, std::string path, const Deck& deck,
              const std::vector<KnownFile>& files, std::int64_t step);

  /// Whether the deck asks for one of an accepted step. Collective.
  bool is_due(std::int64_t step) const;
  /// Writes a checkpoint of the last accepted step unless it is on disk. Collective.
  /// \throws base::RunError
  void write(const mechanics::MovingBody& body, const RunState& state);

  /// Writes it whatever is on disk. Collective. \throws base::RunError
  void write_anew(const mechanics::MovingBody& body, const RunState& state);

  /// ", checkpoint.h5 of step 3"; empty if there is none.
  std::string on_disk() const;
  /// The longest time that one took [s].
  double seconds() const { return seconds_; }

 private:
  base::Communicator communicator_;
  std::string path_;
  const Deck* deck_;
  const std::vector<KnownFile>* files_;
  std::int64_t step_;
  double written_at_;  // MPI_Wtime() of rank 0
  double seconds_ = 0.0;
};

}  // namespace stroma
