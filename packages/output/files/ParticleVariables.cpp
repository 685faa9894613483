// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ParticleVariables.hpp"

namespace stroma::output {

void ParticleAt::find_principal_stresses() const {
  const tensor::Tensor3 s = stress();
  const tensor::PrincipalValues values = tensor::principal_values(s);
  principal_ = values;
  has_principal_ = true;
}

tensor::Tensor3 ParticleAt::gradient() const {
  const double* h = state_->gradient + 9 * p_;
  return {{{h[0], h[1], h[2]}, {h[3], h[4], h[5]}, {h[6], h[7], h[8]}}};
}

tensor::Tensor3 ParticleAt::strain() const {
  const tensor::Tensor3 H = gradient();
  return 0.5 * tensor::left_cauchy_green_minus_identity(tensor::transpose(H));
}

std::vector<ParticleVariable> particle_variables(const std::vector<ShownField>& fields) {
  using At = ParticleAt;
  std::vector<ParticleVariable> all{
      {"displacement_x", "um", [](const At& p) { return p.displacement(0); }, true},
      {"displacement_y", "um", [](const At& p) { return p.displacement(1); }, true},
      {"displacement_z", "um", [](const At& p) { return p.displacement(2); }, true},
      {"von_mises", "Pa", [](const At& p) { return tensor::von_mises(p.stress()); }},
      {"stress_xx", "Pa", [](const At& p) { return p.stress_component(0); }},
      {"stress_yy", "Pa", [](const At& p) { return p.stress_component(1); }},
      {"stress_zz", "Pa", [](const At& p) { return p.stress_component(2); }},
      {"stress_xy", "Pa", [](const At& p) { return p.stress_component(3); }},
      {"stress_yz", "Pa", [](const At& p) { return p.stress_component(4); }},
      {"stress_zx", "Pa", [](const At& p) { return p.stress_component(5); }},
      {"strain_xx", "-", [](const At& p) { return p.strain()(0, 0); }},
      {"strain_yy", "-", [](const At& p) { return p.strain()(1, 1); }},
      {"strain_zz", "-", [](const At& p) { return p.strain()(2, 2); }},
      {"strain_xy", "-", [](const At& p) { return p.strain()(0, 1); }},
      {"strain_yz", "-", [](const At& p) { return p.strain()(1, 2); }},
      {"strain_zx", "-", [](const At& p) { return p.strain()(2, 0); }},
      {"jacobian", "-", [](const At& p) { return p.jacobian(); }},
      {"strain_energy_density", "Pa", [](const At& p) { return p.strain_energy_density(); }},
      {"principal_stress_1", "Pa", [](const At& p) { return p.principal_stress(0); }},
      {"principal_stress_2", "Pa", [](const At& p) { return p.principal_stress(1); }},
      {"principal_stress_3", "Pa", [](const At& p) { return p.principal_stress(2); }}};
  for (std::size_t n = 0; n < fields.size(); ++n)
    all.push_back({fields[n].name, fields[n].unit, [n](const At& p) { return p.field(n); }});
  return all;
}

}  // namespace stroma::output
