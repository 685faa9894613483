// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The fields of particles that particles.e shows.

#include <type_traits>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/output/files/ParticleVariables.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma {

/// A field to be shown, with its values on this rank.
struct ShownValues {
  output::ShownField field;
  Kokkos::View<const double*, grid::Device> values;  ///< (particle)
};

/// Those that the list of fields has shown (particles::Field) and that the particles of some rank
/// have; the same on all ranks. Collective.
inline std::vector<ShownValues> shown_fields(const base::Communicator& communicator,
                                             const particles::Particles<grid::Device>& particles) {
  std::vector<ShownValues> shown;
  particles::for_each_field(
      [&](const particles::Field& field, const auto& view) {
        if constexpr (std::is_same_v<std::decay_t<decltype(view)>,
                                     Kokkos::View<double*, grid::Device>>)
          if (field.is_shown && communicator.any(view.extent(0) > 0))
            shown.push_back({{field.name, field.unit}, view});
      },
      particles);
  return shown;
}

}  // namespace stroma
