// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The one list of laws of fibres: what `Fibers|FAMILY|Law` may name.

#include "stroma/material/BucklingStiffening.hpp"
#include "stroma/material/ExponentialLinear.hpp"
#include "stroma/material/ExponentialPower.hpp"
#include "stroma/material/TaggedUnion.hpp"

namespace stroma::material {

using AnyFiberLaw = TaggedUnion<ExponentialPower,   //
                                ExponentialLinear,  //
                                BucklingStiffening>;

}  // namespace stroma::material
