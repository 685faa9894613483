// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/tables/GroupedParticles.hpp"

#include <algorithm>

#include "stroma/tensor/PrincipalBatch.hpp"

namespace stroma::output {
namespace {

const std::vector<double> shares{0.05, 0.25, 0.5, 0.75, 0.95};

using Look = std::function<void(std::int64_t, const ParticleAt&, double)>;

/// Consecutive quantities of this rank's particles.
struct Values {
  std::size_t first;
  std::vector<std::vector<double>> of;  // (quantity - first, particle)
  std::vector<double> volume;           // (particle) deformed, J V0 [um^3]

  bool has(std::size_t quantity) const { return quantity >= first && quantity < first + of.size(); }
  void set(std::size_t quantity, std::size_t particle, double value) {
    if (has(quantity)) of[quantity - first][particle] = value;
  }
  /// Of consecutive particles.
  template <class TensorOf>
  void set_principal(std::size_t largest, std::int64_t begin, std::int64_t number,
                     const TensorOf& tensor_of) {
    if (!has(largest) && !has(largest + 1) && !has(largest + 2)) return;
    for (std::int64_t at = 0; at < number; at += tensor::SymmetricBatch::size) {
      const auto count =
          static_cast<int>(std::min<std::int64_t>(tensor::SymmetricBatch::size, number - at));
      tensor::SymmetricBatch batch;
      for (int n = 0; n < count; ++n) batch.set(n, tensor_of(at + n));
      tensor::find_principal_values(batch);
      for (std::size_t i = 0; i < 3; ++i)
        for (int n = 0; n < count; ++n)
          set(largest + i, static_cast<std::size_t>(begin + at + n), batch.entry[i][n]);
    }
  }
};

Values evaluate(const ParticleSet& set, const StatePieces& states, std::size_t first,
                std::size_t quantities, const Look& look) {
  const auto count = static_cast<std::size_t>(set.count);
  Values values{first, {}, std::vector<double>(count)};
  values.of.assign(quantities, std::vector<double>(count));
  states([&](std::int64_t begin, std::int64_t number, const ParticleState& state) {
    for (std::int64_t n = 0; n < number; ++n) {
      const ParticleAt particle(state, n);
      const auto p = static_cast<std::size_t>(begin + n);
      values.volume[p] = particle.jacobian() * set.volume[p];
      values.set(jacobian, p, particle.jacobian());
      if (values.has(von_mises)) values.set(von_mises, p, tensor::von_mises(particle.stress()));
      if (look) look(begin + n, particle, values.volume[p]);
    }
    values.set_principal(principal_stress_1, begin, number,
                         [&](std::int64_t n) { return ParticleAt(state, n).stress(); });
    values.set_principal(principal_strain_1, begin, number,
                         [&](std::int64_t n) { return ParticleAt(state, n).strain(); });
  });
  return values;
}

}  // namespace

const std::vector<TableQuantity>& table_quantities() {
  static const std::vector<TableQuantity> quantities{
      {"von_mises", "Pa"},          {"principal_stress_1", "Pa"},
      {"principal_stress_2", "Pa"}, {"principal_stress_3", "Pa"},
      {"principal_strain_1", "1"},  {"principal_strain_2", "1"},
      {"principal_strain_3", "1"},  {"jacobian", "1"}};
  return quantities;
}

void find_distributions(const base::Communicator& communicator, const ParticleSet& set,
                        const StatePieces& states, const std::vector<GroupedParticles*>& all,
                        std::size_t at_once, const Look& look) {
  const std::size_t count = table_quantities().size();
  for (GroupedParticles* particles : all) particles->found.resize(count);
  for (std::size_t first = 0; first < count; first += at_once) {
    const Values values =
        evaluate(set, states, first, std::min(at_once, count - first), first == 0 ? look : Look());
    for (GroupedParticles* particles : all)
      for (const Quantity quantity : particles->quantities)
        if (values.has(quantity))
          particles->found[quantity] = distributions(communicator, particles->groups, values.volume,
                                                     values.of[quantity - first], shares);
  }
}

}  // namespace stroma::output
