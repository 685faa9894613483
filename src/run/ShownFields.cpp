// SPDX-License-Identifier: BSD-3-Clause

#include "run/ShownFields.hpp"

#include <cstddef>
#include <type_traits>

#include "run/OwnNumbers.hpp"
#include "stroma/material/VaryingMaterial.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma {
namespace {

/// Of each law's numbers those that are shown; where it has none, 0.
std::vector<ShownValues> shown_of_laws(const material::NamedMaterials& materials,
                                       const std::vector<std::vector<int>>& which,
                                       const particles::Particles<grid::Device>& particles) {
  const std::vector<ShownNumber> numbers = shown_numbers(materials, which);
  std::vector<std::vector<double>> of_material;
  for (const auto& named : materials)
    of_material.push_back(material::numbers_of(material::law_at_rest(named.second)));
  const particles::HostParticles host = particles::on_host(particles);
  std::vector<ShownValues> shown;
  for (const ShownNumber& number : numbers) {
    const Kokkos::View<double*, grid::Device> view(number.name,
                                                   static_cast<std::size_t>(host.count()));
    const auto values = Kokkos::create_mirror_view(view);
    // (material) the column of own_numbers, or -1: its own value
    std::vector<int> column(materials.size(), -1);
    for (std::size_t m = 0; m < materials.size(); ++m)
      for (std::size_t c = 0; c < which[m].size(); ++c)
        if (which[m][c] == number.place[m]) column[m] = static_cast<int>(c);
    for (int p = 0; p < host.count(); ++p) {
      const std::size_t m = host.material(p);
      if (number.place[m] < 0)
        values(p) = 0.0;
      else if (column[m] >= 0)
        values(p) = host.own_numbers(p, column[m]);
      else
        values(p) = of_material[m][static_cast<std::size_t>(number.place[m])];
    }
    Kokkos::deep_copy(view, values);
    shown.push_back({{number.name, number.unit}, view});
  }
  return shown;
}

}  // namespace

std::vector<ShownValues> shown_fields(const base::Communicator& communicator,
                                      const material::NamedMaterials& materials,
                                      const Specimen& specimen,
                                      const mechanics::MomentumBalance& balance) {
  const particles::Particles<grid::Device>& particles = balance.body().particles();
  std::vector<ShownValues> shown = shown_of_laws(materials, specimen.own_numbers, particles);
  particles::for_each_field(
      [&](const particles::Field& field, const auto& view) {
        if constexpr (std::is_same_v<std::decay_t<decltype(view)>,
                                     Kokkos::View<double*, grid::Device>>)
          if (field.is_shown && communicator.any(view.extent(0) > 0))
            shown.push_back({{field.name, field.unit}, view});
      },
      particles);
  if (balance.inertia() != nullptr) {
    const grid::ConstNodeView velocity = balance.inertia()->particle_velocity();
    for (int c = 0; c < 3; ++c) {
      const Kokkos::View<double*, grid::Device> component("velocity", velocity.extent(0));
      Kokkos::deep_copy(component, Kokkos::subview(velocity, Kokkos::ALL, c));
      shown.push_back({{std::string("velocity_") + "xyz"[c], "um/s"}, component});
    }
  }
  return shown;
}

output::ParticleState state_of(const transfer::ParticleFields<grid::Device>& fields,
                               const std::vector<ShownValues>& shown, int first) {
  output::ParticleState state{fields.displacement.data(), fields.stress.data(),
                              fields.gradient.data(), fields.jacobian.data(), fields.energy.data()};
  for (const ShownValues& one : shown) state.fields.push_back(one.values.data() + first);
  return state;
}

}  // namespace stroma
