#include "CheckCommand.hpp"

#include <algorithm>
#include <cmath>

#include "BoundsTable.hpp"
#include "MeanWidth.hpp"
#include "Specimen.hpp"
#include "base/Error.hpp"
#include "grid/ShapeGrid.hpp"
#include "image/Objects.hpp"
#include "image/Segmentation.hpp"
#include "mechanics/BarelyFilled.hpp"
#include "solver/IterationTraffic.hpp"
#include "solver/TrialSolve.hpp"

namespace stroma {
namespace {

using base::format;

void check_image(const base::Communicator& communicator, const Deck& deck,
                 const image::ImageSummary& summary, const image::LabelVolume& labels,
                 const std::array<double, 3>& spacing, base::Log& log) {
  log.line(format("image       %s: %s, %s", summary.path.empty() ? "phantom" : summary.path.c_str(),
                  summary.format.c_str(), summary.type.name().c_str()));
  log.line(format("size        %lld x %lld x %lld voxels", static_cast<long long>(labels.size[0]),
                  static_cast<long long>(labels.size[1]), static_cast<long long>(labels.size[2])));
  log.line(format("voxel       %.8g x %.8g x %.8g um, from: %s", labels.voxel_size[0],
                  labels.voxel_size[1], labels.voxel_size[2], summary.voxel_size.source().c_str()));
  log.line(format("box         %.8g x %.8g x %.8g um",
                  static_cast<double>(labels.size[0]) * labels.voxel_size[0],
                  static_cast<double>(labels.size[1]) * labels.voxel_size[1],
                  static_cast<double>(labels.size[2]) * labels.voxel_size[2]));
  for (const std::string& note : summary.notes) log.note(note);

  const auto fractions = image::volume_fractions(communicator, labels);
  for (const auto& [name, material] : deck.parameters.materials.materials) {
    const auto found = fractions.find(material.label);
    const double fraction = found == fractions.end() ? 0.0 : found->second;
    const auto planes = image::plane_fractions(communicator, labels, material.label);
    std::string line =
        format("fraction    %-12s label %d: %.6f", name.c_str(), material.label, fraction);
    if (planes.size() > 1) {
      const auto [least, most] = std::minmax_element(planes.begin(), planes.end());
      line += format(", per slice %.4f to %.4f", *least, *most);
    }
    log.line(line);
    if (planes.size() > 1 && material.label > 0) {
      std::string list = "            per slice:";
      for (std::size_t k = 0; k < planes.size(); ++k) {
        if (k > 0 && k % 10 == 0) list += "\n                      ";
        list += format(" %.4f", planes[k]);
      }
      log.line(list);
    }
    if (material.label > 0 && fraction > 0.0) {
      const double width = mean_width(communicator, labels, material.label);
      if (std::isfinite(width))
        log.line(format("width       %-12s %.4g um on the average: %.2f x %.2f x %.2f elements",
                        name.c_str(), width, width / spacing[0], width / spacing[1],
                        width / spacing[2]));
    }
  }
  if (fractions.count(-1) > 0) log.line(format("fraction    empty (-1): %.6f", fractions.at(-1)));
  std::vector<double> shares;
  for (const auto& [name, material] : deck.parameters.materials.materials)
    shares.push_back(fractions.count(material.label) > 0 ? fractions.at(material.label) : 0.0);
  for (const std::string& line :
       bounds_table(deck.parameters.materials.materials, shares, deck.parameters.grid.plane_strain,
                    fractions.count(-1) > 0))
    log.line(line);
  const image::Objects objects(communicator, labels, image::Connectivity::corners);
  log.line(format("objects     %lld (26-connected), the largest of %lld voxels",
                  static_cast<long long>(objects.count()),
                  static_cast<long long>(objects.largest())));
}

/// Bytes on the rank with the most, by what docs/performance.md lists.
void check_memory(const base::Communicator& communicator, const Deck& deck,
                  const Specimen& specimen, base::Log& log) {
  const auto particles = static_cast<double>(specimen.particles.count());
  const auto nodes =
      static_cast<double>(specimen.partition.touched_nodes(communicator.rank()).count());
  const double state = (deck.parameters.grid.reset ? 2.0 * 145.0 + 41.0 : 41.0) * particles;
  // Results are evaluated a layer of elements at a time; with reset they must go home all together.
  const auto layers =
      static_cast<double>(specimen.partition.elements(communicator.rank()).extent(2));
  const double results =
      deck.parameters.grid.reset ? 2.0 * 88.0 * particles : 88.0 * particles / layers;
  const auto kind = deck.parameters.solver.preconditioner;
  const grid::Grid& grid = specimen.partition.grid();
  const bool is_geometric = kind == solver::PreconditionerKind::geometric_multigrid;
  const bool is_stencil = is_geometric && grid.width == 2;
  const double stencil = 504.0 * nodes;
  const double blocks = std::pow(2.0 * grid.width - 1.0, grid.flat ? 2.0 : 3.0);  // of a row
  const double matrix = is_stencil ? stencil + 48.0 * nodes : (9.0 * 12.0 + 2.0) * blocks * nodes;
  const double vectors = 20.0 * 24.0 * nodes;
  double hierarchy = 0.0;
  if (is_geometric) hierarchy = stencil / 7.0 + 8.0 / 7.0 * 72.0 * nodes;
  if (is_geometric && !is_stencil) hierarchy += stencil + 48.0 * nodes + 6.0 * 24.0 * nodes;
  if (kind == solver::PreconditionerKind::multigrid) hierarchy = 1.6 * matrix;
  const double total = state + results + matrix + vectors + hierarchy;
  const double gib = 1.0 / (1024.0 * 1024.0 * 1024.0);
  const double most = communicator.max(total);
  log.line(format(
      "memory      about %.2f GiB on the fullest of %d rank%s: particles %.2f, their results "
      "%.2f, tangent %.2f, vectors %.2f, preconditioner %.2f",
      most * gib, communicator.size(), communicator.size() == 1 ? "" : "s",
      communicator.max(state) * gib, communicator.max(results) * gib,
      communicator.max(matrix) * gib, communicator.max(vectors) * gib,
      communicator.max(hierarchy) * gib));
  if (kind == solver::PreconditionerKind::direct)
    log.note("the factors of Preconditioner = Direct come on top; they grow fast with the grid");
}

}  // namespace

void check_command(const base::Communicator& communicator, const Deck& deck, base::Log& log) {
  solver::try_lists(communicator, deck.parameters.solver);
  image::ImageSummary summary;
  const image::LabelVolume labels = read_labels(communicator, deck, summary);
  const Specimen specimen = make_specimen(communicator, deck, labels, summary);
  const grid::Grid& grid = specimen.body;
  check_image(communicator, deck, summary, labels, grid.spacing, log);

  const mechanics::MomentumBalance balance(communicator, specimen.partition, specimen.particles,
                                           problem_of(deck, specimen));
  std::int64_t filled = 0;
  const auto flags = balance.filled_elements(grid::lattice_under(specimen.partition));
  for (std::size_t e = 0; e < flags.extent(0); ++e) filled += flags(e);
  filled = communicator.sum(filled);
  log.line(format(
      "elements    %lld x %lld x %lld of %.8g x %.8g x %.8g um, %lld of %lld with particles",
      static_cast<long long>(grid.elements[0]), static_cast<long long>(grid.elements[1]),
      static_cast<long long>(grid.elements[2]), grid.spacing[0], grid.spacing[1], grid.spacing[2],
      static_cast<long long>(filled), static_cast<long long>(grid.all_elements().count())));
  log.line(format("particles   %lld, %.4g per element with particles",
                  static_cast<long long>(specimen.particle_count),
                  static_cast<double>(specimen.particle_count) / static_cast<double>(filled)));
  log.line(format("unknowns    %lld", static_cast<long long>(balance.supports().unknowns())));
  log.line(format("pieces      %lld, connected through the grid",
                  static_cast<long long>(balance.supports().pieces().count)));
  for (const std::string& note : balance.supports().notes()) log.note(note);
  const std::string barely_filled = mechanics::barely_filled_note(balance);
  if (!barely_filled.empty()) log.note(barely_filled);
  check_memory(communicator, deck, specimen, log);
  const std::string exchange = solver::describe_traffic(communicator, specimen.partition,
                                                        deck.parameters.solver.preconditioner);
  if (!exchange.empty()) log.line(exchange);
  log.line("the deck is ready to run");
}

}  // namespace stroma
