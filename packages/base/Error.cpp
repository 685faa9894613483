// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Error.hpp"

#include "stroma/base/Memory.hpp"

namespace stroma::base {
namespace {

enum class Kind : int { none = 0, input = 1, run = 2, step = 3 };

}  // namespace

void collectively(const Communicator& communicator, const std::function<void()>& work) {
  Kind kind = Kind::none;
  std::string message;
  try {
    work();
  } catch (const InputError& error) {
    kind = Kind::input;
    message = error.what();
  } catch (const StepRejected& error) {
    kind = Kind::step;
    message = error.what();
  } catch (const std::exception& error) {
    kind = Kind::run;
    message = is_out_of_memory(error)
                  ? "out of memory on rank " + std::to_string(communicator.rank())
                  : error.what();
  }
  const int nobody = communicator.size();
  const int first = communicator.min(kind == Kind::none ? nobody : communicator.rank());
  if (first == nobody) return;

  int shared_kind = static_cast<int>(kind);
  communicator.broadcast(shared_kind, first);
  communicator.broadcast(message, first);
  switch (static_cast<Kind>(shared_kind)) {
    case Kind::input:
      throw InputError(message);
    case Kind::step:
      throw StepRejected(message);
    default:
      throw RunError(message);
  }
}

}  // namespace stroma::base
