// SPDX-License-Identifier: BSD-3-Clause

#include "stiffness/StiffnessRun.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "run/BoundsTable.hpp"
#include "run/KnownFiles.hpp"
#include "run/ReportFile.hpp"
#include "run/RunFacts.hpp"
#include "run/RunLog.hpp"
#include "run/RunSummary.hpp"
#include "stiffness/StiffnessFiles.hpp"
#include "stiffness/StiffnessReport.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/output/files/DeckFile.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/solver/TrialSolve.hpp"

namespace stroma {
namespace {

double volume_of(const grid::Grid& box) { return box.length(0) * box.length(1) * box.length(2); }

/// Volume of each material [um^3]. Collective.
std::vector<double> volumes_of_materials(const base::Communicator& communicator, const Deck& deck,
                                         const Specimen& specimen) {
  const auto host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  };
  const auto volume = host(specimen.particles.volume);
  const auto material = host(specimen.particles.material);
  std::vector<double> volumes(deck.parameters.materials.materials.size(), 0.0);
  for (std::size_t p = 0; p < volume.extent(0); ++p) volumes[material(p)] += volume(p);
  communicator.sum_all(volumes.data(), volumes.size());
  return volumes;
}

/// Bounds of the box, of which a share is empty: a phase without stiffness.
std::optional<material::MixtureBounds> bounds_of_box(const Deck& deck, const Specimen& specimen,
                                                     const std::vector<double>& volumes,
                                                     double empty_volume) {
  const material::NamedMaterials& materials = deck.parameters.materials.materials;
  if (!are_isotropic(materials)) return std::nullopt;
  Mixture mixture = mixture_of(materials, volumes, specimen.extremes);
  const bool has_empty_space = empty_volume > 0.0;
  if (has_empty_space) mixture.stiff.push_back({empty_volume, {0.0, 0.0}});
  material::MixtureBounds bounds = bounds_of(mixture, false);
  if (has_empty_space)
    for (material::Bounds* of : {&bounds.shear, &bounds.bulk, &bounds.young})
      of->reuss = of->lower = 0.0;
  return bounds;
}

void refuse_steps(const RunOptions& options) {
  const std::string why = ": Rig|Kind = Stiffness has no load steps; admissible: without it";
  if (options.is_restart) throw base::InputError("--restart" + why);
  if (options.time_limit) throw base::InputError("--time-limit" + why);
}

}  // namespace

mechanics::NamedBoundaries possible_boundaries(const Deck& deck,
                                               const std::array<double, 6>& face_shares,
                                               base::Log& log) {
  mechanics::NamedBoundaries wanted = mechanics::wanted_boundaries(*deck.parameters.rig);
  if (are_solid(face_shares)) return wanted;
  const auto is_traction = [](const auto& named) {
    return named.second == mechanics::UniformBoundary::traction;
  };
  const auto traction = std::find_if(wanted.begin(), wanted.end(), is_traction);
  if (deck.parameters.rig->boundary && traction != wanted.end())
    throw base::InputError(
        "Rig|Boundary: empty space cuts the surface of the specimen's box, where no traction can "
        "act; admissible with it: Uniform Displacement, Mixed");
  if (traction != wanted.end()) wanted.erase(traction);
  log.note(base::format(
      "empty space cuts the surface (a face is solid to %.4g %%): there is no uniform traction, and "
      "the mean strain of mixed conditions is taken as that of the load case",
      100.0 * *std::min_element(face_shares.begin(), face_shares.end())));
  return wanted;
}

namespace {

/// Each material's share of the box.
std::vector<std::pair<std::string, double>> shares_of(const material::NamedMaterials& materials,
                                                      const std::vector<double>& volumes,
                                                      double box) {
  std::vector<std::pair<std::string, double>> shares;
  for (std::size_t m = 0; m < volumes.size(); ++m)
    shares.emplace_back(materials[m].first, volumes[m] / box);
  return shares;
}

/// What is wrong with results whose residuals are not small against the forces; else empty.
std::string unbalanced(const StiffnessResults& results) {
  constexpr double bearable = 1e-3;
  for (const auto& one : results.all)
    if (!(one.found.largest_residual <= bearable * one.found.largest_force))
      return base::format(
          "Rig|Boundary = %s: rounding alone leaves residuals of %.3g of the forces on the surface; "
          "a lower modulus of what is stiffest, or Solver|Preconditioner = Direct, leave less",
          one.name.c_str(), one.found.largest_residual / one.found.largest_force);
  return "";
}

/// From deck to results in the folder.
void find_stiffness(const base::Communicator& communicator, const Deck& deck,
                    const output::RunFolder& folder, base::Log& log) {
  RunLog say(communicator, deck, log);
  folder.refuse_foreign_files(input_files(deck));
  solver::try_lists(communicator, deck.parameters.solver);
  const Specimen specimen = [&] {
    const SpecimenImage image = read_image(communicator, deck);
    return make_specimen(communicator, deck, image);
  }();
  const std::vector<double> volumes = volumes_of_materials(communicator, deck, specimen);
  double solid = 0.0;
  for (const double volume : volumes) solid += volume;
  const double box = volume_of(specimen.body), negligible = 1e-9 * box;
  StiffnessResults results{
      deck.parameters.title,
      specimen.body.lengths(),
      solid / box,
      shares_of(deck.parameters.materials.materials, volumes, box),
      solid_shares_of_faces(communicator, specimen),
      bounds_of_box(deck, specimen, volumes, box - solid > negligible ? box - solid : 0.0),
      {},
      {}};
  const mechanics::NamedBoundaries wanted = possible_boundaries(deck, results.face_shares, log);
  folder.refuse_inputs(specimen.files);  // data beside a header, slices
  const std::vector<KnownFile> files = known_files(communicator, specimen.files);
  bool is_begun = false;
  const auto begin = [&](const mechanics::MomentumBalance& balance) {
    if (is_begun) return;
    is_begun = true;
    folder.remove_old_results(log);
    base::collectively(communicator, [&] { log.open_file(folder.log(), false); });
    say.describe(specimen, balance);
    output::write_deck(communicator, folder.deck(), *as_run(deck),
                       run_facts(communicator, folder.taken(), files));
    results.voigt = voigt_stiffness(balance.body());
  };
  std::string failure;
  for (const auto& [name, boundary] : wanted) {
    try {
      results.all.emplace_back(name,
                               apparent_stiffness(communicator, deck, specimen, boundary, begin));
    } catch (const base::RunError& error) {
      if (results.all.empty()) throw;
      failure = "Rig|Boundary = " + name + ": " + error.what();
      break;
    }
    log.line(base::format("solved     %s: %lld iterations, %.1f s", name.c_str(),
                          static_cast<long long>(results.all.back().found.iterations()),
                          say.seconds()));
  }
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    output::write_file(folder.file("stiffness.csv"), stiffness_table(results));
    output::write_file(folder.file("stiffness.json"), stiffness_json(results));
  });
  folder.finish();
  for (const std::string& line : stiffness_lines(results)) log.line(line);
  const std::string by_rounding = unbalanced(results);
  failure += (failure.empty() || by_rounding.empty() ? "" : "; ") + by_rounding;
  if (!failure.empty())
    throw base::RunError(failure + "; stiffness.csv and stiffness.json hold what was solved");
  print_costs(log, communicator, deck, specimen.partition);
  log.line(base::format("%.1f s on %s; results in %s", say.seconds(),
                        base::ranks_and_threads(communicator).c_str(), folder.folder().c_str()));
}

}  // namespace

void run_stiffness(const base::Communicator& communicator, const Deck& deck,
                   const RunOptions& options, base::Log& log) {
  refuse_steps(options);
  const output::RunFolder folder(communicator, options.folder, run_files(deck));
  find_stiffness(communicator, deck, folder, log);
  if (deck.parameters.output.report)
    report_at_end(log, [&] { stiffness_report(communicator, folder.folder(), log); });
  folder.finish("log.txt");
}

bool holds_stiffness(const std::string& folder) {
  const output::RunFiles files(folder);
  return std::filesystem::exists(files.file("stiffness.json")) &&
         !std::filesystem::exists(files.history());
}

void refuse_stiffness_folder(const std::string& folder, const std::string& command) {
  if (holds_stiffness(folder))
    throw base::InputError(
        "'" + folder + "' holds a stiffness (Rig|Kind = Stiffness), which has no load steps to " +
        command + "; its results are in stiffness.csv and stiffness.json");
}

}  // namespace stroma
