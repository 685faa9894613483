// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// How near the product K v comes to the memory's bandwidth, and what assembly costs: all timed in
/// turn with a STREAM triad on the same ranks, because these machines are noisy. Prints medians.
///
///     mpirun -np RANKS benchmark_product NX NY NZ [REPETITIONS]

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "stroma/base/Session.hpp"
#include "support/Specimen.hpp"

namespace {

using namespace stroma;

double seconds(const base::Communicator& world, const std::function<void()>& work) {
  world.barrier();
  const double start = MPI_Wtime();
  work();
  world.barrier();
  return MPI_Wtime() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// a = b + s c on arrays too long for the caches; three arrays of doubles move (the store's
/// allocation, which some processors add, is not counted, as in STREAM).
class Triad {
 public:
  static constexpr std::size_t length = 20'000'000;
  static constexpr double bytes = 3.0 * 8.0 * length;

  Triad() : a_(length, 0.0), b_(length, 1.0), c_(length, 2.0) {}
  void run() {
    double* __restrict a = a_.data();
    const double* __restrict b = b_.data();
    const double* __restrict c = c_.data();
    for (std::size_t i = 0; i < length; ++i) a[i] = b[i] + 3.0 * c[i];
    check_ += a[length / 2];
  }
  double check() const { return check_; }

 private:
  std::vector<double> a_, b_, c_;
  double check_ = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
  const base::MpiSession mpi(&argc, &argv);
  const auto world = base::Communicator::world();
  const base::KokkosSession kokkos(world, {argv[0]});
  if (argc < 4) {
    if (world.is_root()) std::fprintf(stderr, "usage: benchmark_product NX NY NZ [REPETITIONS]\n");
    return 2;
  }
  test::Specimen specimen;
  specimen.elements = {std::atol(argv[1]), std::atol(argv[2]), std::atol(argv[3])};
  specimen.conditions = test::clamped(0.1);
  const int repetitions = argc > 4 ? std::atoi(argv[4]) : 15;

  const auto balance = specimen.balance(world);
  grid::Vector u(balance->owned_map()), v(balance->owned_map()), product(balance->owned_map());
  v.randomize();
  balance->supports().clear(v);
  balance->assemble_tangent(u);
  const auto matrix = balance->tangent_matrix();

  // The same tangent as a stencil.
  const auto lean = specimen.balance(world);
  lean->choose_tangent(mechanics::TangentForm::stencil);
  lean->assemble_tangent(u);
  const auto stencil = Teuchos::rcp_dynamic_cast<tangent::StencilMatrix>(lean->tangent());
  const grid::NodeField<float> x_float("x", stencil->exchange().grid());
  const grid::NodeField<float> y_float("y", stencil->exchange().grid());
  stencil->to_field(v, 0, x_float);

  Triad triad;
  triad.run();
  std::vector<double> triad_times, product_times, tangent_times, force_times;
  std::vector<double> stencil_times, float_times, stencil_tangent_times, free_times;
  for (int r = 0; r < repetitions; ++r) {
    triad_times.push_back(seconds(world, [&] { triad.run(); }));
    product_times.push_back(seconds(world, [&] { matrix->apply(v, product); }));
    stencil_times.push_back(seconds(world, [&] { stencil->apply(v, product); }));
    float_times.push_back(seconds(world, [&] {
      stencil->stencil().multiply(x_float, y_float);
      stencil->exchange().sum(y_float);
    }));
    if (r % 5 != 0) continue;
    free_times.push_back(seconds(world, [&] { balance->tangent_times(u, v, product); }));
    stencil_tangent_times.push_back(seconds(world, [&] { lean->assemble_tangent(u); }));
    tangent_times.push_back(seconds(world, [&] { balance->assemble_tangent(u); }));
    force_times.push_back(seconds(world, [&] { balance->internal_force(u, product); }));
  }

  // What a product must move: 8 + 4 bytes an entry, a row offset, and the vectors once.
  const auto entries = static_cast<double>(matrix->getGlobalNumEntries());
  const auto rows = static_cast<double>(matrix->getGlobalNumRows());
  const double bytes = 12.0 * entries + 8.0 * rows + 16.0 * rows;
  const double stream = world.size() * Triad::bytes / median(triad_times);
  const double particles =
      static_cast<double>(world.sum<std::int64_t>(balance->body().particles().count()));
  if (world.is_root()) {
    std::printf("elements %s x %s x %s, %.0f unknowns, %.0f entries, %d ranks (check %g)\n",
                argv[1], argv[2], argv[3], rows, entries, world.size(), triad.check());
    std::printf("triad           %8.2f GB/s\n", stream * 1e-9);
    std::printf("product K v     %8.2f GB/s   %.2f of the triad   %.3f ms\n",
                bytes / median(product_times) * 1e-9, bytes / median(product_times) / stream,
                median(product_times) * 1e3);
    // A stencil's product reads its blocks, and moves the vectors once.
    const double nodes = rows / 3.0;
    const double in_double = (4.0 * transfer::StencilLayout::entries + 48.0) * nodes;
    const double in_float = (4.0 * transfer::StencilLayout::entries + 24.0) * nodes;
    const auto line = [&](const char* what, double moved, double time) {
      std::printf("%-16s%8.2f GB/s   %.2f of the triad   %.3f ms\n", what, moved / time * 1e-9,
                  moved / time / stream, time * 1e3);
    };
    line("stencil, double", in_double, median(stencil_times));
    line("stencil, float", in_float, median(float_times));
    std::printf("no matrix       %8.1f ns per particle and core   %.3f ms\n",
                median(free_times) / particles * world.size() * 1e9, median(free_times) * 1e3);
    std::printf("to the stencil  %8.1f ns per particle and core\n",
                median(stencil_tangent_times) / particles * world.size() * 1e9);
    std::printf("tangent         %8.1f ns per particle and core (8 particles an element)\n",
                median(tangent_times) / particles * world.size() * 1e9);
    std::printf("internal force  %8.1f ns per particle and core\n",
                median(force_times) / particles * world.size() * 1e9);
  }
  return 0;
}
