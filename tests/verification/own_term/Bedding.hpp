// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// An example of a term of the balance of momentum that Stroma does not have: springs that tie the
/// whole body to the ground.

#include "stroma/grid/ToDevice.hpp"
#include "stroma/mechanics/body/Body.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::example {

/// f_I = k V_I u_I  [pN], with V_I = sum_p V0 N_I(X_p) the volume of a node: an elastic bedding of
/// stiffness k per volume [pN/um^4], lumped to the nodes. For a grid that is not reset.
class Bedding : public mechanics::Term {
 public:
  Bedding(const mechanics::Body& body, double stiffness)
      : body_(body),
        stiffness_(stiffness),
        volume_("volume",
                body.halo().partition().touched_nodes(body.communicator().rank()).count()) {
    const grid::Vector at_rest(body.halo().owned_map());
    const transfer::VolumeForce one{{1.0, 0.0, 0.0}, false, -1, 0.0, 0.0};
    body.kernels().external_force(body.points(at_rest),
                                  grid::to_device("one", std::vector<transfer::VolumeForce>{one}),
                                  body.density(), {}, volume_);
  }

  bool changes_with_load() const override { return false; }

  mechanics::TermForce force(const mechanics::TrialState& state,
                             grid::Vector& force) const override {
    add_times(state.points.displacement, body_.halo().contributions());
    body_.halo().sum_to_owner(force);
    return {};
  }
  std::int64_t add_tangent(const mechanics::TrialState&,
                           const transfer::BlockRows<Device>& rows) const override {
    return add_diagonal(rows);
  }
  std::int64_t add_tangent(const mechanics::TrialState&,
                           const transfer::StencilRows<Device>& rows) const override {
    return add_diagonal(rows);
  }
  void add_tangent_times(const mechanics::TrialState&, const ConstNodeView& direction,
                         const NodeView& product) const override {
    add_times(direction, product);
  }

  /// Every node is held: no rigid motion is free.
  void visit_held(const mechanics::Pieces& pieces,
                  const mechanics::HeldVisitor& visit) const override {
    const grid::Partition& partition = body_.halo().partition();
    const grid::Box touched = partition.touched_nodes(body_.communicator().rank());
    for (std::int64_t n = 0; n < touched.count(); ++n)
      for (int c = 0; c < 3; ++c)
        if (const int piece = pieces.of_node(n); piece != mechanics::Pieces::none)
          visit({piece, {-1, partition.grid().node_position(touched.index(n)), c}, -1, 0.0});
  }

 private:
  void add_times(const ConstNodeView& u, const NodeView& sum) const {
    const auto V = volume_;
    const double k = stiffness_;
    Kokkos::parallel_for(
        "bedding", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(V.extent(0))),
        KOKKOS_LAMBDA(const int n) {
          for (int c = 0; c < 3; ++c) sum(n, c) += k * V(n, 0) * u(n, c);
        });
  }
  template <class Rows>
  std::int64_t add_diagonal(const Rows& rows) const {
    const auto V = volume_;
    const double k = stiffness_;
    Kokkos::parallel_for(
        "bedding", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(V.extent(0))),
        KOKKOS_LAMBDA(const int n) {
          for (int c = 0; c < 3; ++c) rows.add_to_diagonal(n, c, k * V(n, 0));
        });
    return 0;
  }

  const mechanics::Body& body_;
  double stiffness_;
  NodeView volume_;  // (touched node, 0) of this rank's particles [um^3]
};

}  // namespace stroma::example
