// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Derivatives of supports' forces by numbers of the materials' laws, by the adjoint.

#include <memory>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Simulation.hpp"
#include "stroma/mechanics/kernels/StressKernels.hpp"

namespace stroma {

/// One component of the force of a condition's support.
struct Reaction {
  std::string condition;
  std::size_t index = 0;  ///< of the condition
  int component = 0;      ///< 0, 1, 2 for x, y, z

  /// Its column of history.csv.
  std::string column() const { return condition + ".reaction_" + "xyz"[component]; }
};

/// Why the derivatives of a deck's reactions by a parameter cannot be had by the adjoint; empty if
/// they can.
std::string adjoint_obstacle(const Deck& deck, const std::string& path);

/// Writes sensitivity.csv while a run goes on: dR/dp of reactions R by parameters p, after each
/// accepted step, exact for what is discretised:
///
///     R = s . f(u, p),    K lambda = -K s at the free components,    dR/dp = (s + lambda) . df/dp,
///
/// with f the internal force, s 1 where R is taken, and K = df/du, which is symmetric. That is one
/// linear solve for each reaction, whatever the number of parameters. df/dp at a fixed displacement
/// is the central difference of f by 1e-5 of p: exact, but for rounding, where f is linear in p.
class Sensitivity {
 public:
  /// \param deck       as run; adjoint_obstacle() is empty for each path
  /// \param value      of each parameter
  /// \param path       of sensitivity.csv
  /// \throws base::InputError when a law cannot be had that close by
  Sensitivity(const base::Communicator& communicator, const Deck& deck,
              const std::vector<std::string>& paths, const std::vector<double>& values,
              std::vector<Reaction> reactions, std::string path);

  /// Adds a row. Collective. \throws base::RunError
  void operator()(const AcceptedStep& step);

  /// The column of a derivative: "top.reaction_y by Materials|vessel|Shear Modulus [Pa]".
  static std::string column(const Reaction& reaction, const std::string& path) {
    return reaction.column() + " by " + path;
  }

 private:
  /// The laws on both sides of a parameter's value, and how far apart these are.
  struct Pair {
    mechanics::LawList above, below;
    double distance = 0.0;
  };

  base::Communicator communicator_;
  std::vector<Pair> pairs_;
  std::vector<Reaction> reactions_;
  std::string path_, header_;
  bool is_begun_ = false;
};

}  // namespace stroma
