// SPDX-License-Identifier: BSD-3-Clause

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_TpetraOperator.hpp>

#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

/// The six rigid body motions at this rank's nodes: what the near-null space of elasticity is.
grid::RCP<grid::MultiVector> rigid_body_modes(const mechanics::MomentumBalance& balance) {
  const grid::Partition& partition = balance.halo().partition();
  const grid::Box owned = partition.owned_nodes(balance.halo().communicator().rank());
  const auto modes = Teuchos::rcp(new grid::MultiVector(balance.owned_map(), 6));
  const auto value = modes->getLocalViewHost(Tpetra::Access::OverwriteAll);
  const grid::Grid& grid = partition.grid();
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    const auto n = static_cast<std::size_t>(3 * owned.local(node));
    std::array<double, 3> r = grid.node_position(node);
    for (int d = 0; d < 3; ++d) r[d] -= grid.origin[d] + 0.5 * grid.length(d);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t m = 0; m < 6; ++m) value(n + c, m) = m == c ? 1.0 : 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {  // e_axis x r
      const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
      value(n + next, 3 + axis) = -r[last];
      value(n + last, 3 + axis) = r[next];
    }
  });
  return modes;
}

/// Smoothed aggregation on the assembled tangent.
class MueLuPreconditioner : public Preconditioner {
 public:
  MueLuPreconditioner(const SolverParameters& parameters, const mechanics::MomentumBalance& balance)
      : modes_(rigid_body_modes(balance)) {
    list_.set("verbosity", "none");
    // With threads, the other kernels of MueLu form aggregates in the order in which threads
    // arrive.
    list_.set("use kokkos refactor", false);
    list_.set("number of equations", 3);
    list_.set("multigrid algorithm", "sa");
    list_.set("coarse: max size", 1000);
    list_.set("max levels", 10);
    // Chebyshev smoothing is the same on any number of ranks, and made of products alone. Beyond
    // the largest eigenvalue its polynomial grows and the cycle turns indefinite, and power
    // iterations come from below: more of them than MueLu's 10, which were too few on this
    // operator, and a margin.
    list_.set("sa: eigenvalue estimate num iterations", 20);
    list_.set("smoother: type", "CHEBYSHEV");
    auto& smoother = list_.sublist("smoother: params");
    smoother.set("chebyshev: degree", 2);
    smoother.set("chebyshev: ratio eigenvalue", 10.0);
    smoother.set("chebyshev: boost factor", 1.3);
    if (balance.halo().communicator().size() > 1) {
      // Not MueLu's default for the coarsest grid, Amesos2's KLU2: see DirectPreconditioner.cpp.
      // With few aggregates left, a polynomial of high degree solves it well enough.
      list_.set("coarse: max size", 100);
      list_.set("coarse: type", "CHEBYSHEV");
      auto& coarse = list_.sublist("coarse: params");
      coarse.set("chebyshev: degree", 20);
      coarse.set("chebyshev: ratio eigenvalue", 100.0);
      coarse.set("chebyshev: eigenvalue max iterations", 30);
      coarse.set("chebyshev: boost factor", 1.3);
    }
    if (parameters.muelu != Teuchos::null) lay_over(*parameters.muelu);
  }

  void compute(const grid::RCP<const Operator>& tangent) override {
    Teuchos::ParameterList list(list_);
    list.sublist("user data").set("Nullspace", modes_);
    hierarchy_ = MueLu::CreateTpetraPreconditioner(grid::RCP<Operator>(as_matrix(tangent)), list);
  }
  grid::RCP<const Operator> apply_inverse() const override { return hierarchy_; }

 private:
  /// The deck's list over Stroma's own. Smoothers that it replaces take their parameters with them:
  /// others would refuse these, or MueLu the mixture of "smoother: type" and "smoother: pre type".
  void lay_over(const Teuchos::ParameterList& given) {
    const auto replaces = [&](const std::string& type) {
      return given.isType<std::string>(type) && given.get<std::string>(type) != "CHEBYSHEV";
    };
    const auto has = [&](const char* name) { return given.isParameter(name); };
    const bool two_types = has("smoother: pre type") || has("smoother: post type");
    const bool two_lists = has("smoother: pre params") || has("smoother: post params");
    if (two_types || two_lists || replaces("smoother: type"))
      list_.remove("smoother: params", false);
    if (two_types) list_.remove("smoother: type", false);
    if (replaces("coarse: type")) list_.remove("coarse: params", false);
    list_.setParameters(given);
  }

  Teuchos::ParameterList list_;
  grid::RCP<grid::MultiVector> modes_;
  grid::RCP<const Operator> hierarchy_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_muelu(const SolverParameters& parameters,
                                           const mechanics::MomentumBalance& balance) {
  return std::make_unique<MueLuPreconditioner>(parameters, balance);
}

}  // namespace stroma::solver
