// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Elements that the body barely fills: which they are, and what stabilising them costs.

#include <string>

#include "stroma/mechanics/MomentumBalance.hpp"

namespace stroma::mechanics {

/// How many elements, of all ranks, are filled by less than half. Collective.
std::int64_t count_barely_filled(const MomentumBalance& balance);

/// What the user should know of them, in a sentence; empty where there are none. Collective.
std::string barely_filled_note(const MomentumBalance& balance);

/// (local element) 1: filled by less than 0.7, in a body that is stabilised by so little, or not at
/// all, that its nodes are hard to solve for. Empty where no element of any rank is filled by less
/// than half: those a little fuller matter beside such ones alone. Collective.
Kokkos::View<std::uint8_t*, grid::Device> barely_held_elements(const MomentumBalance& balance);

/// The share of the fictitious points in the work of the body's deformation, u . f_fictitious / u .
/// f [-]: to first order what they add to the body's stiffness. Of a grid that is not reset.
/// Collective.
double stabilization_share(const MomentumBalance& balance, const grid::Vector& u);
/// The same of a small displacement v from the base, v . K_fictitious v / v . K v.
double small_stabilization_share(const MomentumBalance& balance, const grid::Vector& v);

}  // namespace stroma::mechanics
