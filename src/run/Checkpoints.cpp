// SPDX-License-Identifier: BSD-3-Clause

#include "run/Checkpoints.hpp"

#include <mpi.h>

#include <algorithm>
#include <utility>

#include "stroma/base/Log.hpp"

namespace stroma {

Checkpoints::Checkpoints(const base::Communicator& communicator, std::string path, const Deck& deck,
                         const std::vector<KnownFile>& files, std::int64_t step)
    : communicator_(communicator),
      path_(std::move(path)),
      deck_(&deck),
      files_(&files),
      step_(step),
      written_at_(MPI_Wtime()) {}

bool Checkpoints::is_due(std::int64_t step) const {
  const output::OutputParameters& when = deck_->parameters.output;
  const bool is_late =
      communicator_.any(communicator_.is_root() && when.checkpoint_minutes > 0.0 &&
                        MPI_Wtime() - written_at_ >= 60.0 * when.checkpoint_minutes);
  return is_late || output::is_due(step, when.checkpoint_every, false);
}

void Checkpoints::write(const mechanics::MovingBody& body, const RunState& state) {
  if (step_ != state.load.accepted) write_anew(body, state);
}

void Checkpoints::write_anew(const mechanics::MovingBody& body, const RunState& state) {
  const double begin = MPI_Wtime();
  write_checkpoint(communicator_, path_, *deck_, *files_, body, state);
  step_ = state.load.accepted;
  written_at_ = MPI_Wtime();
  seconds_ = std::max(seconds_, communicator_.max(written_at_ - begin));
}

std::string Checkpoints::on_disk() const {
  return step_ < 0 ? ""
                   : base::format(", checkpoint.h5 of step %lld", static_cast<long long>(step_));
}

}  // namespace stroma
