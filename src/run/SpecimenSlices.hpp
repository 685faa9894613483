// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The specimen's image for a report, read again from where the deck says that it is.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {

/// The image that the specimen was made from, in 8 bits: means over merged voxels of every n-th
/// plane. On rank 0; a text that says why there is none where it cannot be read. Collective.
nlohmann::json image_slices(const base::Communicator& communicator, const Deck& deck,
                            std::vector<output::PageArray>& arrays);

/// The materials of its voxels, as maps without fields. On rank 0; null where the image cannot be
/// read. Collective.
nlohmann::json material_slices(const base::Communicator& communicator, const Deck& deck,
                               std::vector<output::PageArray>& arrays);

}  // namespace stroma
