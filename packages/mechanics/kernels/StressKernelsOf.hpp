// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The kernels for one kind of shape functions and one type of law; to be included where that pair
/// is compiled.

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "stroma/grid/ToDevice.hpp"
#include "stroma/mechanics/kernels/StressKernels.hpp"
#include "stroma/transfer/InternalForce.hpp"
#include "stroma/transfer/UpdateHistory.hpp"
#include "stroma/transfer/WaveModulus.hpp"

namespace stroma::mechanics {

template <class Shape, class Law>
class StressKernelsOf : public StressKernels {
 public:
  /// \param laws     of all materials
  /// \param general  of neo-Hookean laws: kernels of the same laws in general, for what is seldom
  ///                 asked for; what a compiler takes inline depends on how much there is in a file
  explicit StressKernelsOf(const std::vector<Law>& laws,
                           std::shared_ptr<const StressKernels> general = nullptr)
      : general_(std::move(general)),
        laws_(laws),
        law_(grid::to_device("law", laws)),
        may_be_averaged_(std::all_of(laws.begin(), laws.end(), [](const Law& law) {
          return material::may_be_averaged(law);
        })) {
    for (const Law& law : laws) {
      states_ = std::max(states_, material::states_used(law));
      own_numbers_ = std::max(own_numbers_, material::numbers_taken(law));
    }
  }

  int states() const override { return states_; }
  bool may_be_averaged() const override { return may_be_averaged_; }
  int own_numbers() const override { return own_numbers_; }
  material::SmallStrainModuli moduli_of(const particles::HostParticles& particles,
                                        int p) const override {
    const Law& law = laws_[particles.material(p)];
    if constexpr (material::takes_numbers<Law>)
      if (particles.own_numbers.extent(1) != 0) {
        Law own = law;
        own.take(&particles.own_numbers(p, 0));
        return own.small_strain();
      }
    return law.small_strain();
  }
  std::int64_t internal_force(const Points& points, const NodeView& force) const override {
    return launch("internal force", points,
                  transfer::InternalForce<Shape, Law, Device>{{points}, law_, force});
  }
  std::int64_t tangent(const Points& points,
                       const transfer::BlockRows<Device>& rows) const override {
    return launch(
        "tangent", points,
        transfer::Tangent<Shape, Law, Device, transfer::BlockRows<Device>>{{points}, law_, rows});
  }
  std::int64_t tangent(const Points& points,
                       const transfer::StencilRows<Device>& rows) const override {
    if constexpr (Shape::width == 2)
      return launch("tangent", points,
                    transfer::Tangent<Shape, Law, Device, transfer::StencilRows<Device>>{
                        {points}, law_, rows});
    else
      throw std::logic_error("a stencil of 27 blocks cannot hold the tangent of wider functions");
  }
  void tangent_times(const Points& points, const ConstNodeView& direction,
                     const NodeView& product) const override {
    launch("tangent times", points,
           transfer::TangentTimes<Shape, Law, Device>{{points}, law_, direction, product});
  }
  void particle_fields(const Points& points,
                       const transfer::ParticleFields<Device>& fields) const override {
    launch("grid to particles", points,
           transfer::GridToParticles<Shape, Law, Device>{{points}, law_, fields});
  }
  void layer_fields(const Points& points, int k, int first,
                    const transfer::ParticleFields<Device>& fields) const override {
    transfer::for_each_element_of_layer<grid::ExecutionSpace>(
        "grid to particles", points.box, k,
        transfer::GridToParticles<Shape, Law, Device>{{points}, law_, fields, first});
  }
  void wave_moduli(const Points& points,
                   const Kokkos::View<const material::FiberDirection*, Device>& directions,
                   int share, const Kokkos::View<double*, Device>& least,
                   const Kokkos::View<double* [3], Device>& across) const override {
    if constexpr (std::is_same_v<Law, material::NeoHookean>)
      general_->wave_moduli(points, directions, share, least, across);
    else
      launch("wave moduli", points,
             transfer::WaveModulus<Shape, Law, Device>{
                 {points}, law_, directions, share, least, across});
  }
  void update_history(const Points& points) const override {
    if constexpr (material::states_of < Law >> 0)
      launch("update history", points, transfer::UpdateHistory<Shape, Law, Device>{{points}, law_});
  }

 private:
  template <class Kernel>
  static std::int64_t launch(const char* name, const Points& points, const Kernel& kernel) {
    return transfer::for_each_element<Shape::width, grid::ExecutionSpace>(name, points.box, kernel);
  }

  std::shared_ptr<const StressKernels> general_;
  std::vector<Law> laws_;                 // of each material, for the host
  Kokkos::View<const Law*, Device> law_;  // of each material
  bool may_be_averaged_;
  int states_ = 0, own_numbers_ = 0;
};

/// The kernels of a shape for the laws that a deck may name: those of neo-Hookean laws alone, the
/// same for all particles of a material, or of any. Those of AnyLaw are instantiated in files of
/// their own: what a compiler takes inline depends on how much there is in a file, and laws are
/// added.
template <class Shape>
std::shared_ptr<const StressKernels> stress_kernels_of(const LawList& laws) {
  using material::AnyLaw;
  using material::NeoHookean;
  const std::vector<AnyLaw>& all = laws.of_material;
  const bool are_neo_hookean = std::all_of(all.begin(), all.end(), [](const AnyLaw& law) {
    return law.is_matrix_alone() && law.own_numbers() == 0 && law.matrix().is<NeoHookean>();
  });
  if (!are_neo_hookean) return std::make_shared<StressKernelsOf<Shape, AnyLaw>>(all);
  std::vector<NeoHookean> alike;
  for (const AnyLaw& law : all) alike.push_back(law.matrix().as<NeoHookean>());
  return std::make_shared<StressKernelsOf<Shape, NeoHookean>>(
      alike, std::make_shared<StressKernelsOf<Shape, AnyLaw>>(all));
}

}  // namespace stroma::mechanics
