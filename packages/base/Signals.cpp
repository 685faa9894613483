// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Signals.hpp"

namespace stroma::base {
namespace {

volatile std::sig_atomic_t caught = 0;
int living = 0;

extern "C" void remember(int signal) {
  if (caught == SIGINT && signal == SIGINT) {  // whoever asks twice does not want to wait
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  caught = signal;
}

}  // namespace

void let_writes_fail() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

StopRequests::StopRequests() {
  if (living++ == 0) caught = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;  // what is being written is written to its end
  sigemptyset(&action.sa_mask);
  sigaction(SIGTERM, &action, &term_before_);
  sigaction(SIGINT, &action, &int_before_);
  sigaction(SIGUSR1, &action, &usr1_before_);
}

StopRequests::~StopRequests() {
  --living;
  sigaction(SIGTERM, &term_before_, nullptr);
  sigaction(SIGINT, &int_before_, nullptr);
  sigaction(SIGUSR1, &usr1_before_, nullptr);
}

std::string StopRequests::asked(const Communicator& communicator) const {
  const int signal = communicator.max(static_cast<int>(caught));
  if (signal == 0) return "";
  if (signal == SIGUSR1) return "SIGUSR1";
  return signal == SIGINT ? "SIGINT" : "SIGTERM";
}

}  // namespace stroma::base
