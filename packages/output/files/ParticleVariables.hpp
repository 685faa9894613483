// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What particles.e shows of each particle in each step.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "stroma/tensor/PrincipalValues.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::output {

/// A field of the particles that is shown as it is.
struct ShownField {
  std::string name, unit;
};

/// What a step changes on the particles of one rank, in the order of the ParticleSet.
struct ParticleState {
  const double* displacement = nullptr;  ///< (particle, xyz) [um]
  const double* stress = nullptr;        ///< (particle, xx yy zz xy yz zx) Cauchy [Pa]
  const double* gradient = nullptr;      ///< (particle, 3, 3) H(i, j) = dx_i/dX_j - delta_ij [-]
  const double* jacobian = nullptr;      ///< (particle) det F [-]
  const double* strain_energy_density = nullptr;  ///< (particle) W per reference volume [Pa]
  std::vector<const double*> fields = {};         ///< (shown field) (particle)
};

/// One particle of a state.
class ParticleAt {
 public:
  ParticleAt(const ParticleState& state, std::int64_t p) : state_(&state), p_(p) {}

  double displacement(int i) const { return state_->displacement[3 * p_ + i]; }
  /// xx yy zz xy yz zx.
  double stress_component(int i) const { return state_->stress[6 * p_ + i]; }
  tensor::Tensor3 stress() const {
    const double* s = state_->stress + 6 * p_;
    return {{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
  }
  /// H = F - I.
  tensor::Tensor3 gradient() const;
  /// E = (F^T F - I) / 2 = (H + H^T + H^T H) / 2.
  tensor::Tensor3 strain() const;
  /// Descending; computed once.
  double principal_stress(int i) const {
    if (!has_principal_) find_principal_stresses();
    return principal_(i);
  }
  double jacobian() const { return state_->jacobian[p_]; }
  double strain_energy_density() const { return state_->strain_energy_density[p_]; }
  double field(std::size_t n) const { return state_->fields.at(n)[p_]; }

 private:
  void find_principal_stresses() const;

  const ParticleState* state_;
  std::int64_t p_;
  mutable tensor::PrincipalValues principal_;
  mutable bool has_principal_ = false;
};

/// A column of particles.e.
struct ParticleVariable {
  std::string name;
  std::string unit;
  std::function<double(const ParticleAt&)> value;
  bool at_nodes = false;  ///< besides, a variable of the nodes
};

/// All of them: those that follow from a step's results, then the shown fields.
/// \param fields  those of ParticleState::fields, in their order
std::vector<ParticleVariable> particle_variables(const std::vector<ShownField>& fields = {});

}  // namespace stroma::output
