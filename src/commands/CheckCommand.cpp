// SPDX-License-Identifier: BSD-3-Clause

#include "commands/CheckCommand.hpp"

#include <algorithm>
#include <cmath>

#include "run/BodyNotes.hpp"
#include "run/BoundsTable.hpp"
#include "run/MemoryEstimate.hpp"
#include "run/Specimen.hpp"
#include "stiffness/ApparentStiffness.hpp"
#include "stiffness/StiffnessRun.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Segmentation.hpp"
#include "stroma/solver/IterationTraffic.hpp"
#include "stroma/solver/TrialSolve.hpp"

namespace stroma {
namespace {

using base::format;

void check_image(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
                 const voxels::LabelVolume& labels, base::Log& log) {
  const image::ImageSummary& summary = specimen.image;
  const std::array<double, 3>& spacing = specimen.body.spacing;
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
  std::size_t m = 0;
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
      const image::Widths& widths = specimen.widths[m];
      const auto& chords = widths.chords;
      if (std::isfinite(widths.tubes))
        log.line(format(
            "width       %-12s %.4g x %.4g x %.4g um from wall to wall along x, y, z on the average: "
            "%.2f x %.2f x %.2f elements; as round tubes %.4g um",
            name.c_str(), chords[0], chords[1], chords[2], chords[0] / spacing[0],
            chords[1] / spacing[1], chords[2] / spacing[2], widths.tubes));
    }
    ++m;
  }
  if (fractions.count(-1) > 0) log.line(format("fraction    empty (-1): %.6f", fractions.at(-1)));
  std::vector<double> shares;
  for (const auto& [name, material] : deck.parameters.materials.materials)
    shares.push_back(fractions.count(material.label) > 0 ? fractions.at(material.label) : 0.0);
  for (const std::string& line :
       bounds_table(deck.parameters.materials.materials, shares, specimen.extremes,
                    deck.parameters.grid.plane_strain, fractions.count(-1) > 0))
    log.line(line);
  const image::Objects objects(communicator, labels, image::Connectivity::corners);
  log.line(format("objects     %lld of labels above 0 (26-connected), the largest of %lld voxels",
                  static_cast<long long>(objects.count()),
                  static_cast<long long>(objects.largest())));
}

/// Bytes on the rank with the most.
void check_memory(const base::Communicator& communicator, const Deck& deck,
                  const Specimen& specimen, const voxels::LabelVolume& labels, base::Log& log) {
  const grid::Box nodes = specimen.partition.touched_nodes(communicator.rank());
  const grid::Box elements = specimen.partition.elements(communicator.rank());
  const MemoryEstimate estimate = estimate_memory(
      deck.parameters,
      {static_cast<double>(labels.values.size()), static_cast<double>(specimen.particles.count()),
       static_cast<double>(nodes.count()), static_cast<double>(elements.extent(2)),
       measured_numbers(deck.parameters, labels.size, specimen.body, communicator.size())});
  const auto most = [&](double bytes) { return base::readable_bytes(communicator.max(bytes)); };
  const double program = base::program_memory;
  log.line(format(
      "memory      about %s on the fullest of %d rank%s: program %s, and the most of "
      "image %s; seeding %s; particles %s, their results %s, tangent %s, vectors %s, "
      "preconditioner %s",
      most(program + estimate.bytes()).c_str(), communicator.size(),
      communicator.size() == 1 ? "" : "s", most(program).c_str(), most(estimate.image).c_str(),
      most(estimate.seeding).c_str(), most(estimate.particles).c_str(),
      most(estimate.results).c_str(), most(estimate.tangent).c_str(),
      most(estimate.vectors).c_str(), most(estimate.preconditioner).c_str()));
  if (estimate.measured > 0.0)
    log.line(
        format("            images of displacements or velocities, with the specimen's voxels: %s",
               most(estimate.measured).c_str()));
  if (deck.parameters.solver.preconditioner == solver::PreconditionerKind::direct)
    log.note("the factors of Preconditioner = Direct come on top; they grow fast with the grid");
}

/// What is solved, or the first set of load cases of a stiffness.
mechanics::Problem problem_to_check(const base::Communicator& communicator, const Deck& deck,
                                    const Specimen& specimen, base::Log& log) {
  if (!asks_for_stiffness(deck.parameters)) return problem_of(deck, specimen);
  const mechanics::UniformBoundary first =
      possible_boundaries(deck, solid_shares_of_faces(communicator, specimen), log).front().second;
  return problem_of(deck, specimen, first, mechanics::load_cases(first).front());
}

}  // namespace

void check_command(const base::Communicator& communicator, const Deck& deck, base::Log& log) {
  solver::try_lists(communicator, deck.parameters.solver);
  const SpecimenImage image = read_image(communicator, deck);
  const voxels::LabelVolume& labels = image.labels;
  const Specimen specimen = make_specimen(communicator, deck, image);
  const grid::Grid& grid = specimen.body;
  check_image(communicator, deck, specimen, labels, log);

  for (const std::string& line : describe_rig(deck.parameters)) log.line("rig         " + line);
  const mechanics::MomentumBalance balance(communicator, specimen.partition, specimen.particles,
                                           problem_to_check(communicator, deck, specimen, log));
  std::int64_t filled = 0;
  const auto flags = balance.body().filled_elements(grid::lattice_under(specimen.partition));
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
  for (const std::string& field : specimen.fields) log.line(field);
  log.line("dilatation  " + specimen.dilatation);
  for (const std::string& note : specimen.notes) log.note(note);
  log.line(format("unknowns    %lld", static_cast<long long>(balance.supports().unknowns())));
  log.line(format("pieces      %lld, connected through the grid",
                  static_cast<long long>(balance.supports().pieces().count)));
  for (const std::string& note : body_notes(deck, specimen, balance)) log.note(note);
  check_memory(communicator, deck, specimen, labels, log);
  const std::string exchange = solver::describe_traffic(communicator, specimen.partition,
                                                        deck.parameters.solver.preconditioner);
  if (!exchange.empty()) log.line(exchange);
  log.line("the deck is ready to run");
}

}  // namespace stroma
