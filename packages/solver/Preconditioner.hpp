// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Preconditioners for the tangent: Tpetra operators that approximate its inverse.

#include <memory>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

using grid::Operator;

/// Makes an operator M^-1 from a tangent, again and again as its values change.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;

  /// Adapts to the tangent's present values. Collective.
  /// \param tangent  a tangent::Matrix, or a tangent::StencilMatrix for those that take it
  /// \throws base::StepRejected when the tangent is singular to the method
  virtual void compute(const grid::RCP<const Operator>& tangent) = 0;
  /// Whether compute() costs so much that one made for an earlier tangent is better kept while it
  /// works.
  virtual bool worth_keeping() const { return true; }
  /// The operator; valid after compute().
  virtual grid::RCP<const Operator> apply_inverse() const = 0;
};

/// Whether the tangent is kept as a stencil, in single precision, for a preconditioner on a grid;
/// else as compressed rows.
bool takes_stencil(PreconditionerKind kind, const grid::Grid& grid);
/// Stores the tangent of a balance as the preconditioner of the parameters takes it.
void choose_tangent(const SolverParameters& parameters, mechanics::MomentumBalance& balance);

/// The preconditioner that the deck chose. MueLu gets its rigid body modes from the grid of
/// `balance`.
std::unique_ptr<Preconditioner> make_preconditioner(const SolverParameters& parameters,
                                                    const mechanics::MomentumBalance& balance);

// One per package of Trilinos, each in its own file: their headers are heavy.
std::unique_ptr<Preconditioner> make_ifpack2(const SolverParameters& parameters);
std::unique_ptr<Preconditioner> make_muelu(const SolverParameters& parameters,
                                           const mechanics::MomentumBalance& balance);
std::unique_ptr<Preconditioner> make_direct();
/// For shape functions that are wider than hats: the geometric multigrid of the hats under them.
std::unique_ptr<Preconditioner> make_hats_multigrid(const mechanics::MomentumBalance& balance);
/// These two take the tangent as a stencil.
std::unique_ptr<Preconditioner> make_geometric_multigrid(const mechanics::MomentumBalance& balance);
std::unique_ptr<Preconditioner> make_block_jacobi();

/// The tangent as the compressed matrix that most packages of Trilinos want.
grid::RCP<tangent::Matrix> as_matrix(const grid::RCP<const Operator>& tangent);

}  // namespace stroma::solver
