// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// All ranks of a test.

#include "stroma/base/Communicator.hpp"

namespace stroma {

inline base::Communicator world() { return base::Communicator::world(); }

}  // namespace stroma
