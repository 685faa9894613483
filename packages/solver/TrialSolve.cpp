// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/TrialSolve.hpp"

#include <iostream>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/ForeignError.hpp"
#include "stroma/solver/NewtonSolver.hpp"

namespace stroma::solver {
namespace {

constexpr int edge = 4;  // elements

/// Eight particles in each element, at the centres of its octants.
particles::Particles<grid::Device> block_particles() {
  using Particles = particles::Particles<grid::Device>;
  const int elements = edge * edge * edge, count = 8 * elements;
  Particles block;
  block.position = Particles::Vector3("position", static_cast<std::size_t>(count));
  block.volume = decltype(block.volume)("volume", count);
  block.material = decltype(block.material)("material", count);
  block.id = decltype(block.id)("id", count);
  block.element_begin = decltype(block.element_begin)("element_begin", elements + 1);
  const auto position = Kokkos::create_mirror_view(block.position);
  const auto id = Kokkos::create_mirror_view(block.id);
  const auto begin = Kokkos::create_mirror_view(block.element_begin);
  for (int p = 0; p < count; ++p) {
    const int element = p / 8, octant = p % 8;
    const int index[3] = {element % edge, element / edge % edge, element / (edge * edge)};
    for (int d = 0; d < 3; ++d) position(p, d) = index[d] + 0.25 + 0.5 * (octant >> d & 1);
    id(p) = p;
    begin(element + 1) = p + 1;
  }
  Kokkos::deep_copy(block.position, position);
  Kokkos::deep_copy(block.id, id);
  Kokkos::deep_copy(block.element_begin, begin);
  Kokkos::deep_copy(block.volume, 0.125);
  return block;
}

/// A block between grips that stretch it by a thousandth, solved by one rank alone.
void solve_block(const SolverParameters& parameters) {
  const auto alone = base::Communicator::self();
  grid::Grid grid;
  grid.elements = {edge, edge, edge};
  const std::vector<double> even(edge, 1.0);
  const auto partition = grid::Partition::balanced(grid, 1, {even, even, even});
  mechanics::BoundaryCondition bottom;
  bottom.face = mechanics::Face::y_lower;
  bottom.components = "xyz";
  mechanics::BoundaryCondition top = bottom;
  top.face = mechanics::Face::y_upper;
  top.strain = 1e-3;
  mechanics::MomentumBalance balance(alone, partition, block_particles(), {{1.0, 2.0}},
                                     {{"bottom", bottom}, {"top", top}});
  NewtonSolver newton(parameters, balance);
  grid::Vector u(balance.owned_map());
  newton.predict(u, balance.supports().change(1.0, u));
  balance.set_load(1.0);
  balance.supports().impose(1.0, u);
  newton.solve(u);
}

/// What libraries print is held back while it lives.
class Silence {
 public:
  Silence() : out_(std::cout.rdbuf(sink_.rdbuf())), error_(std::cerr.rdbuf(sink_.rdbuf())) {}
  ~Silence() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  std::string text() const { return sink_.str(); }

 private:
  std::ostringstream sink_;
  std::streambuf* out_;
  std::streambuf* error_;
};

/// \throws base::InputError when the block cannot be solved with a list of the deck
void try_list(const std::string& name, const SolverParameters& parameters) {
  const std::string where = "Solver|" + name + ": ";
  const Silence silence;
  try {
    solve_block(parameters);
  } catch (const base::StepRejected& rejected) {
    throw base::InputError(
        where + "with it, not even a uniform block of 64 elements is solved: " + rejected.what());
  } catch (...) {
    std::string words = base::words_of_current_exception();
    if (words == "NOX Error") words = base::last_words(silence.text());  // it has printed why
    throw base::InputError(where + name + " refuses it: " + words);
  }
}

}  // namespace

void try_lists(const base::Communicator& communicator, const SolverParameters& parameters) {
  using List = Teuchos::RCP<Teuchos::ParameterList> SolverParameters::*;
  const std::pair<const char*, List> lists[] = {{"NOX", &SolverParameters::nox},
                                                {"Belos", &SolverParameters::belos},
                                                {"Ifpack2", &SolverParameters::ifpack2},
                                                {"MueLu", &SolverParameters::muelu}};
  base::collectively(communicator, [&] {
    for (const auto& [name, list] : lists) {
      if (parameters.*list == Teuchos::null) continue;
      SolverParameters with_one;
      with_one.preconditioner = parameters.preconditioner;
      with_one.*list = Teuchos::parameterList(*(parameters.*list));
      // Several levels even of a small block, so that smoothers are made.
      if (list == &SolverParameters::muelu) with_one.muelu->set("coarse: max size", 30);
      try_list(name, with_one);
    }
  });
}

}  // namespace stroma::solver
