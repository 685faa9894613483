// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Communicator.hpp"

namespace stroma::base {

Communicator::Communicator(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &size_);
}

void Communicator::broadcast(std::string& text, int root) const {
  std::uint64_t length = text.size();
  broadcast(length, root);
  text.resize(length);
  broadcast(text.data(), length, root);
}

}  // namespace stroma::base
