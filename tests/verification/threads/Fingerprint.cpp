// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Prints a hash of every bit that the kernels compute on a few bodies, one line per quantity and
/// rank. ThreadsTest.cpp runs it with different numbers of threads and compares the lines.

#include <cstdint>
#include <cstdio>
#include <string>

#include "stroma/base/Session.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "support/Specimen.hpp"

namespace stroma::test {
namespace {

/// FNV-1a over the bytes of a contiguous view.
template <class View>
std::uint64_t hash_of(const View& view) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  const auto* bytes = reinterpret_cast<const unsigned char*>(host.data());
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::size_t n = 0; n < host.span() * sizeof(typename View::value_type); ++n)
    hash = (hash ^ bytes[n]) * 0x100000001b3u;
  return hash;
}

class Fingerprint {
 public:
  explicit Fingerprint(const base::Communicator& communicator) : communicator_(communicator) {}

  template <class View>
  void print(const std::string& body, const std::string& quantity, const View& view) const {
    for (const std::uint64_t hash : communicator_.gather(hash_of(view)))
      if (communicator_.is_root())
        std::printf("%s, %s: %016llx\n", body.c_str(), quantity.c_str(),
                    static_cast<unsigned long long>(hash));
  }
  void print(const std::string& body, const std::string& quantity,
             const grid::Vector& vector) const {
    print(body, quantity, grid::node_view(vector));
  }

 private:
  base::Communicator communicator_;
};

/// The tangent as a stencil, its product, the coarse operators, and a cycle of multigrid.
void take_multigrid(const Fingerprint& fingerprint, const std::string& body,
                    mechanics::MomentumBalance& balance, const grid::Vector& u,
                    const grid::Vector& v) {
  balance.choose_tangent(mechanics::TangentForm::stencil);
  balance.assemble_tangent(u);
  const auto stencil =
      Teuchos::rcp_dynamic_cast<const tangent::StencilMatrix>(balance.tangent(), true);
  fingerprint.print(body, "stencil", stencil->stencil().values());
  grid::Vector result(balance.owned_map());
  stencil->apply(v, result);
  fingerprint.print(body, "stencil times", result);
  multigrid::MultigridSettings settings;
  settings.direct_work = 1e6;  // so that these small bodies have coarser levels
  multigrid::GeometricMultigrid multigrid(stencil, balance.halo().partition().grid().spacing, {},
                                          settings);
  multigrid.compute();
  fingerprint.print(body, "coarsest stencil", multigrid.stencil(multigrid.levels() - 1).values());
  multigrid.apply(v, result);
  fingerprint.print(body, "multigrid cycle", result);
  balance.choose_tangent(mechanics::TangentForm::compressed_rows);
}

/// All that is computed from particles for nodes, and from nodes for particles, at a displacement
/// without symmetry.
void take(const base::Communicator& world, const std::string& body, const Specimen& specimen) {
  const Fingerprint fingerprint(world);
  mechanics::MovingBody moving = specimen.moving_body(world);
  for (const double size : {0.02, 0.03}) {  // the second one from a base that has moved
    moving.begin_step();
    mechanics::MomentumBalance& balance = moving.balance();
    grid::Vector u(balance.owned_map()), v(balance.owned_map()), force(balance.owned_map());
    const auto any = [](double amplitude, int seed) {
      return [=](const grid::Index3& node, int c) { return amplitude * scatter(node, c, seed); };
    };
    fill(balance.halo(), u, any(size, 1));
    fill(balance.halo(), v, any(1.0, 2));
    balance.set_load(0.5);

    fingerprint.print(body, "unbalanced force", *balance.forces(u).unbalanced);
    balance.tangent_times(u, v, force);
    fingerprint.print(body, "tangent times", force);
    balance.assemble_tangent(u);
    fingerprint.print(body, "tangent", balance.tangent_matrix()->getLocalMatrixDevice().values);
    const auto fields = balance.body().particle_fields(u);
    fingerprint.print(body, "displacement", fields.displacement);
    fingerprint.print(body, "stress", fields.stress);
    fingerprint.print(body, "J", fields.jacobian);
    fingerprint.print(body, "energy", fields.energy);
    if (specimen.reset) {
      const auto moved = balance.body().moved_particles(u);
      fingerprint.print(body, "moved position", moved.position);
      fingerprint.print(body, "moved gradient", moved.base_gradient);
      balance.body().project_displacement(u, force);
      fingerprint.print(body, "projected displacement", force);
    }
    take_multigrid(fingerprint, body, balance, u, v);
    moving.accept(size, u);
  }
}

}  // namespace
}  // namespace stroma::test

int main(int argc, char** argv) {
  using namespace stroma;
  const base::MpiSession mpi(&argc, &argv);
  const auto world = base::Communicator::world();
  const base::KokkosSession kokkos(world, {argv[0]});
  if (world.is_root()) std::printf("threads %d\n", base::threads());

  test::Specimen block;
  block.elements = {9, 7, 8};
  block.label = test::crossing_bars;
  block.conditions = test::clamped(0.1);
  test::take(world, "block", block);

  test::Specimen island = block;  // in empty space, on a grid that is reset, loaded from outside
  island.reset = true;
  island.stabilization = 1e-3;
  island.layout.layout = particles::Layout::voxel_centers;
  island.label = [](const grid::Index3& voxel) {
    return voxel[0] < 3 || voxel[2] > 13 ? -1 : test::crossing_bars(voxel);
  };
  island.density = {1000.0, 1100.0};
  test::take(world, "island", island);

  test::Specimen slice = block;
  slice.plane_strain = true;
  slice.elements = {13, 11, 1};
  test::take(world, "slice", slice);
  return 0;
}
