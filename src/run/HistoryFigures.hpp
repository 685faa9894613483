// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What history.csv tells of the stress in the body.

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/body/Body.hpp"
#include "stroma/output/files/History.hpp"

namespace stroma {

/// The row with its figures of energy and materials: the elastic energy, and of each material its
/// deformed volume, and the mean, by that volume, and the largest von Mises stress of its
/// particles. Collective.
/// \param row           all else
/// \param communicator  of the ranks that share the body
/// \param body          whose particles these are
/// \param u             displacement of the nodes [um]
output::HistoryRow with_figures(output::HistoryRow row, const base::Communicator& communicator,
                                const mechanics::Body& body, const grid::Vector& u);

}  // namespace stroma
