// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The one list of matrix laws: what a deck's `Model` may name.

#include "stroma/material/ArrudaBoyce.hpp"
#include "stroma/material/CoupledNeoHookean.hpp"
#include "stroma/material/HolmesMow.hpp"
#include "stroma/material/HolzapfelGasserOgden.hpp"
#include "stroma/material/MooneyRivlin.hpp"
#include "stroma/material/NeoHookean.hpp"
#include "stroma/material/Ogden.hpp"
#include "stroma/material/OneOf.hpp"
#include "stroma/material/Pressure.hpp"
#include "stroma/material/VerondaWestmann.hpp"
#include "stroma/material/Yeoh.hpp"

namespace stroma::material {

/// The first is the deck's default.
using AnyMatrix = OneOf<NeoHookean,            //
                        CoupledNeoHookean,     //
                        MooneyRivlin,          //
                        Ogden,                 //
                        Yeoh,                  //
                        VerondaWestmann,       //
                        HolmesMow,             //
                        ArrudaBoyce,           //
                        HolzapfelGasserOgden,  //
                        Pressure>;

}  // namespace stroma::material
