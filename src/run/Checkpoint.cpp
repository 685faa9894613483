// SPDX-License-Identifier: BSD-3-Clause

#include "run/Checkpoint.hpp"

#include <algorithm>
#include <any>
#include <cmath>
#include <list>
#include <memory>
#include <optional>
#include <utility>

#include "run/DeckComparison.hpp"
#include "run/MovingSupports.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/particles/ById.hpp"
#include "stroma/particles/Migration.hpp"

namespace stroma {
namespace {

using output::Slab;
using output::StateArray;

constexpr std::int64_t format_version = 1;

/// What a rank owns of an array of nodal values, (z, y, x, component), and the whole of it.
struct NodeSlab {
  NodeSlab(const grid::Partition& partition, int rank)
      : shape{0, 0, 0, 3}, mine{{0, 0, 0, 0}, {0, 0, 0, 3}} {
    const grid::Box all = partition.grid().all_nodes(), own = partition.owned_nodes(rank);
    for (int d = 0; d < 3; ++d) {
      const auto axis = static_cast<std::size_t>(2 - d);
      shape[axis] = static_cast<std::uint64_t>(all.extent(d));
      mine.begin[axis] = static_cast<std::uint64_t>(own.begin[d] - all.begin[d]);
      mine.count[axis] = static_cast<std::uint64_t>(std::max<std::int64_t>(own.extent(d), 0));
    }
  }

  std::vector<std::uint64_t> shape;
  Slab mine;
};

template <class T>
constexpr StateArray::Type type_of = StateArray::Type::real;
template <>
constexpr StateArray::Type type_of<std::int64_t> = StateArray::Type::integer;
template <>
constexpr StateArray::Type type_of<std::uint8_t> = StateArray::Type::byte;

/// The arrays of a checkpoint as they are put together, with what only lives for it.
class Arrays {
 public:
  explicit Arrays(const base::Communicator& communicator) : communicator_(communicator) {}

  const std::vector<StateArray>& all() const { return arrays_; }

  /// Numbers that all ranks know.
  template <class T>
  void shared(const std::string& name, const std::string& about, std::vector<T> values,
              std::vector<std::uint64_t> shape = {}) {
    if (shape.empty()) shape = {values.size()};
    const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    Slab mine{std::vector<std::uint64_t>(shape.size(), 0), shape};
    if (!communicator_.is_root()) mine.count.assign(shape.size(), 0);
    arrays_.push_back({name, about, type_of<T>, std::move(shape), std::move(mine), kept->data()});
    keep_.emplace_back(kept);
  }
  void text(const std::string& name, const std::string& about, const std::string& value) {
    std::vector<std::uint8_t> bytes(value.begin(), value.end());
    bytes.push_back('\n');  // so that it is never empty
    shared(name, about, std::move(bytes));
  }

  /// A field of this rank's particles.
  template <class View>
  void field(const std::string& name, const std::string& about, const View& view,
             std::size_t numbers) {
    const auto count = static_cast<std::uint64_t>(view.extent(0));
    const Slab mine{{communicator_.sum_before(count), 0}, {count, numbers}};
    from_device("particles/" + name, about, view, {communicator_.sum(count), numbers}, mine);
  }
  /// The nodal values of this rank's nodes.
  void nodes(const std::string& name, const std::string& about, const grid::Vector& u,
             const grid::Partition& partition) {
    const NodeSlab slab(partition, communicator_.rank());
    from_device("grid/" + name, about, grid::node_view(u), slab.shape, slab.mine);
  }

 private:
  template <class View>
  void from_device(const std::string& name, const std::string& about, const View& view,
                   const std::vector<std::uint64_t>& shape, const Slab& mine) {
    const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
    arrays_.push_back(
        {name, about, type_of<typename View::non_const_value_type>, shape, mine, host.data()});
    keep_.emplace_back(host);
  }

  base::Communicator communicator_;
  std::vector<StateArray> arrays_;
  std::list<std::any> keep_;  // of what the arrays point to
};

/// Whether a condition holds its face where it is, at any load.
bool is_still(const mechanics::BoundaryCondition& condition) {
  const auto is_zero = [](const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return x == 0.0; });
  };
  return !condition.images && is_zero(condition.displacement.value_or(std::array<double, 3>{})) &&
         is_zero(condition.displacement_gradient.value_or(std::array<double, 9>{})) &&
         condition.strain.value_or(0.0) == 0.0 && condition.rotation.value_or(0.0) == 0.0;
}

/// The curves by which a deck drives its body, and whose they are.
std::vector<std::pair<std::string, mechanics::LoadCurve>> curves_of(const DeckParameters& p) {
  std::vector<std::pair<std::string, mechanics::LoadCurve>> curves;
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    if (!is_still(condition)) curves.emplace_back("Boundary Conditions|" + name, condition.curve);
  for (const auto& [name, force] : p.external_forces.forces)
    curves.emplace_back("External Forces|" + name, force.curve);
  for (const auto& [section, name] : curves_of_materials(p))
    curves.emplace_back(section, curve_named(p, name));
  return curves;
}

/// (row, curve)
std::vector<double> values_of_curves(const DeckParameters& p,
                                     const std::vector<output::HistoryRow>& rows) {
  const auto curves = curves_of(p);
  std::vector<double> values;
  for (const output::HistoryRow& row : rows)
    for (const auto& curve : curves)
      values.push_back(curve.second.at(row.time / p.loading.seconds()));
  return values;
}

/// Whether a step changes a field of a body's particles; what a step does not change is known from
/// the image.
bool is_state(const particles::Field& field) {
  return field.change == particles::Change::with_the_grid ||
         field.presence == particles::Presence::where_particles_carry_motion ||
         field.presence == particles::Presence::where_motion_changes_grids ||
         field.presence == particles::Presence::where_laws_remember;
}

/// Whether particles are asked for a displacement of their own.
bool is_movable(const particles::Particles<grid::Device>& particles) {
  return particles.base_displacement.extent(0) > 0;
}

void add_particles(Arrays& arrays, const base::Communicator& communicator,
                   const particles::Particles<grid::Device>& particles) {
  const bool moves = communicator.any(is_movable(particles));
  bool has_any = false;
  particles::for_each_field(
      [&](const particles::Field& field, const auto& view) {
        using T = typename std::decay_t<decltype(view)>::non_const_value_type;
        if constexpr (std::is_same_v<T, double>) {
          if (!is_state(field) || (field.change != particles::Change::none && !moves)) return;
          const std::size_t numbers = particles::numbers_anywhere(communicator, field, view);
          if (numbers == 0) return;
          has_any = true;
          arrays.field(field.name, std::string("(particle, number) [") + field.unit + "]", view,
                       numbers);
        }
      },
      particles);
  if (has_any) arrays.field("id", "(particle) [-]", particles.id, 1);
}

void add_history(Arrays& arrays, const Deck& deck, const ResultsSoFar& results) {
  std::vector<double> rows;
  for (const output::HistoryRow& row : results.rows) {
    const std::vector<double> values = output::history_values(row);
    rows.insert(rows.end(), values.begin(), values.end());
  }
  const std::uint64_t count = results.rows.size();
  arrays.shared("history/rows", "(step, column of history.csv)", rows,
                {count, rows.size() / count});
  const std::vector<double> curves = values_of_curves(deck.parameters, results.rows);
  if (!curves.empty())
    arrays.shared("history/load_curves",
                  "(step, condition that moves, then force, then drive of a material) [-]", curves,
                  {count, curves.size() / count});
  const FieldFilesEnd& files = results.files;
  arrays.shared("files/last", "step of particles.e, step of grid.e, number of grid files",
                std::vector<std::int64_t>{files.particles_step, files.grid_step, files.grid_files});
  std::vector<std::int64_t> ends;
  for (std::size_t r = 0; r < files.particles.size(); ++r)
    for (const output::FileEnd& end : {files.particles[r], files.grid[r]})
      ends.insert(ends.end(), {end.steps, end.bytes});
  arrays.shared("files/ends", "(rank, steps and bytes of particles.e, then of the last grid file)",
                ends, {files.particles.size(), 4});
}

/// A line for each file: its checksum.
std::string checksums(const std::vector<KnownFile>& files) {
  std::string text;
  for (const KnownFile& file : files) text += file.sha256 + "\n";
  return text;
}

std::string text_in(const output::StateReader& file, const std::string& name) {
  const std::vector<std::uint8_t> bytes = file.get<std::uint8_t>(name);
  std::string text(bytes.begin(), bytes.end());
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace

void write_checkpoint(const base::Communicator& communicator, const std::string& path,
                      const Deck& deck, const std::vector<KnownFile>& files,
                      const mechanics::MovingBody& body, const RunState& state) {
  const base::Stage stage("checkpoint");
  const mechanics::Motion& motion = body.motion();
  const grid::Partition& partition = body.balance().halo().partition();
  Arrays arrays(communicator);
  arrays.shared("format", "version of this format", std::vector<std::int64_t>{format_version});
  arrays.text("deck", "the body's part of the deck, XML", body_of_deck(deck));
  arrays.text("image", "SHA-256 of the image files", checksums(files));
  arrays.shared("loading/duration", "[s]; 1 where the deck has none",
                std::vector<double>{deck.parameters.loading.seconds()});
  arrays.shared(
      "loading/load",
      "load factors: accepted, next step's size, accepted before, of histories, of the base "
      "configuration [-]",
      std::vector<double>{state.load.load, state.load.size, motion.previous_load,
                          motion.history_load, motion.base_load});
  arrays.shared("loading/steps", "accepted; 1 if no step has begun since",
                std::vector<std::int64_t>{state.load.accepted, motion.has_news ? 1 : 0});
  arrays.shared(
      "solver/newton",
      "nonlinearity [-], last relative residual [-], last forcing [-], largest force [pN]",
      std::vector<double>{state.newton.nonlinearity, state.newton.last_relative,
                          state.newton.last_forcing, state.newton.largest_force});
  add_history(arrays, deck, state.results);
  arrays.shared("grid/stabilization", "of barely filled elements [-]",
                std::vector<double>{body.balance().problem().method.stabilization});
  if (motion.grid) {
    const grid::Grid& grid = *motion.grid;
    arrays.shared("grid/elements", "x, y, z",
                  std::vector<std::int64_t>{grid.elements[0], grid.elements[1], grid.elements[2]});
    arrays.shared("grid/origin", "x, y, z [um]",
                  std::vector<double>{grid.origin[0], grid.origin[1], grid.origin[2]});
    arrays.shared("grid/spacing", "x, y, z [um]",
                  std::vector<double>{grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  }
  const char* about = "(z, y, x of the node, component) since the base configuration [um]";
  arrays.nodes("displacement", about, body.displacement(), partition);
  if (body.previous_displacement() != nullptr)
    arrays.nodes("previous_displacement", about, *body.previous_displacement(), partition);
  if (const mechanics::Inertia* inertia = body.balance().inertia()) {
    arrays.nodes("velocity", "(z, y, x of the node, component) [um/s]", inertia->velocity(),
                 partition);
    arrays.nodes("acceleration", "(z, y, x of the node, component) [um/s^2]",
                 inertia->acceleration(), partition);
  }
  add_particles(arrays, communicator, body.balance().body().particles());
  output::write_state(communicator, path, arrays.all());
}

void Checkpoint::on_every_rank(const std::function<void()>& work) const {
  try {
    base::collectively(communicator_, work);
  } catch (const base::InputError& error) {
    const std::string text = error.what();
    const bool is_named = file_ && text.find(file_->path()) != std::string::npos;
    throw base::InputError(
        is_named || !file_ ? text : "cannot go on from '" + file_->path() + "': " + text);
  }
}

Checkpoint::Checkpoint(const base::Communicator& communicator, const std::string& path,
                       const Deck& deck)
    : communicator_(communicator) {
  base::collectively(communicator, [&] { file_ = std::make_unique<output::StateReader>(path); });
  on_every_rank([&] {
    const auto version = file_->value<std::int64_t>("format");
    if (version != format_version)
      throw base::InputError(base::format("its format is number %lld, this program reads %lld",
                                          static_cast<long long>(version),
                                          static_cast<long long>(format_version)));
    const auto lines = differences(text_in(*file_, "deck"), body_of_deck(deck));
    std::string text;
    for (const std::string& line : lines) text += "\n- " + line;
    if (!lines.empty())
      throw base::InputError("the deck describes another body than it holds (there):" + text +
                             "\na run that goes on may change Loading, Load Curves, Solver, "
                             "Output and Title");
    read_state(deck);
  });
}

void Checkpoint::read_state(const Deck& deck) {
  const DeckParameters& p = deck.parameters;
  const double duration = file_->value<double>("loading/duration");
  const auto loads = file_->get<double>("loading/load", {{0}, {5}});
  const auto steps = file_->get<std::int64_t>("loading/steps", {{0}, {2}});
  const auto newton = file_->get<double>("solver/newton", {{0}, {4}});
  const bool is_number = std::all_of(loads.begin(), loads.end(),
                                     [](double load) { return load >= 0.0 && load <= 1.0; });
  if (!(duration > 0.0) || !is_number || steps[0] < 0) throw base::InputError("its load is none");
  // Time is what stays: load factors are those of the deck's duration.
  const double stretch = duration == p.loading.seconds() ? 1.0 : duration / p.loading.seconds();
  state_.load = {loads[0] * stretch, loads[1] * stretch, static_cast<int>(steps[0])};
  motion_.load = loads[0] * stretch;
  motion_.previous_load = loads[2] * stretch;
  motion_.history_load = loads[3] * stretch;
  motion_.base_load = loads[4] * stretch;
  motion_.has_news = steps[1] == 1;
  state_.newton = {newton[0], newton[1], newton[2], newton[3]};

  const auto shape = file_->shape("history/rows");
  const output::HistoryNames names = history_names(p);
  const std::size_t columns = output::history_columns(names).size();
  if (shape.size() != 2 || shape[0] == 0 || shape[1] != columns)
    throw base::InputError("its history is not that of the deck");
  const auto rows = file_->get<double>("history/rows");
  for (std::size_t begin = 0; begin < rows.size(); begin += columns) {
    const auto first = rows.begin() + static_cast<std::ptrdiff_t>(begin);
    state_.results.rows.push_back(output::history_row(
        std::vector<double>(first, first + static_cast<std::ptrdiff_t>(columns)), names));
    state_.results.rows.back().load *= stretch;
  }
  require_same_past(deck, stretch);

  const auto last = file_->get<std::int64_t>("files/last", {{0}, {3}});
  FieldFilesEnd& files = state_.results.files;
  files.particles_step = last[0];
  files.grid_step = last[1];
  files.grid_files = last[2];
  const auto ends = file_->get<std::int64_t>("files/ends");
  for (std::size_t r = 0; r + 4 <= ends.size(); r += 4) {
    files.particles.push_back({ends[r], ends[r + 1]});
    files.grid.push_back({ends[r + 2], ends[r + 3]});
  }
}

/// What is past is past: where the deck's curves have other values at the steps that were accepted,
/// the body would not be in balance with what it says.
void Checkpoint::require_same_past(const Deck& deck, double stretch) const {
  const auto& rows = state_.results.rows;
  if (rows.back().load > 1.0 + 1e-12)
    throw base::InputError(base::format(
        "it is at %.6g s already; Loading|Duration [s] must not be less", rows.back().time));
  const auto curves = curves_of(deck.parameters);
  if (curves.empty()) return;
  const std::vector<double> here = values_of_curves(deck.parameters, rows),
                            there = file_->get<double>("history/load_curves");
  if (there.size() != here.size()) throw base::InputError("its history is not that of the deck");
  for (std::size_t n = 0; n < here.size(); ++n) {
    if (std::fabs(here[n] - there[n]) <= 1e-12 * std::max(1.0, std::fabs(there[n]))) continue;
    const std::string& whose = curves[n % curves.size()].first;
    throw base::InputError(base::format(
        "%s had %.6g of its full value at time %.6g, and would have had %.6g by the deck%s; what "
        "comes after %.6g may be changed",
        whose.c_str(), there[n], rows[n / curves.size()].time, here[n],
        stretch != 1.0 ? ", whose Loading|Duration [s] is another" : "", rows.back().time));
  }
}

bool Checkpoint::has_images(const std::vector<KnownFile>& files) const {
  bool are_the_same = false;
  on_every_rank([&] { are_the_same = text_in(*file_, "image") == checksums(files); });
  return are_the_same;
}

void Checkpoint::require_images(const std::vector<KnownFile>& files) const {
  if (!has_images(files))
    throw base::InputError("cannot go on from '" + file_->path() +
                           "': the image files are not those that the run had (their checksums "
                           "differ)");
}

std::unique_ptr<mechanics::MovingBody> Checkpoint::body(const Specimen& specimen,
                                                        const mechanics::Problem& problem) const {
  const base::Stage stage("restart");
  mechanics::Motion motion = motion_;
  mechanics::Problem as_it_was = problem;
  on_every_rank([&] {
    // Before the first step is there, it is still to be chosen.
    if (state_.load.accepted > 0 && file_->has("grid/stabilization"))
      as_it_was.method.stabilization = file_->value<double>("grid/stabilization");
    if (!(as_it_was.method.stabilization >= 0.0))
      throw base::InputError("its stabilization is none");
    if (!file_->has("grid/elements")) return;
    const auto elements = file_->get<std::int64_t>("grid/elements", {{0}, {3}});
    const auto origin = file_->get<double>("grid/origin", {{0}, {3}});
    const auto spacing = file_->get<double>("grid/spacing", {{0}, {3}});
    motion.grid = grid::grid_for(problem.method.shape_functions, problem.body);
    for (std::size_t d = 0; d < 3; ++d) {
      if (elements[d] < 1 || elements[d] > (std::int64_t{1} << 31))
        throw base::InputError("its grid is none");
      motion.grid->elements[d] = elements[d];
      motion.grid->origin[d] = origin[d];
      motion.grid->spacing[d] = spacing[d];
    }
  });
  auto body = std::make_unique<mechanics::MovingBody>(
      communicator_, specimen.partition, specimen.particles, as_it_was, motion,
      [&](particles::Particles<grid::Device>& particles) { restore(particles); });
  const mechanics::MomentumBalance& balance = body->balance();
  grid::Vector u(balance.owned_map()), previous(balance.owned_map());
  restore("grid/displacement", u, balance.halo().partition());
  const bool has_previous = file_->has("grid/previous_displacement");
  if (has_previous) restore("grid/previous_displacement", previous, balance.halo().partition());
  body->resume(u, has_previous ? &previous : nullptr);
  if (balance.inertia() != nullptr) {
    grid::Vector velocity(balance.owned_map()), acceleration(balance.owned_map());
    restore("grid/velocity", velocity, balance.halo().partition());
    restore("grid/acceleration", acceleration, balance.halo().partition());
    body->resume_motion(velocity, acceleration);
  }
  return body;
}

void Checkpoint::restore(particles::Particles<grid::Device>& particles) const {
  if (!file_->has("particles/id")) return;
  Slab share;
  std::vector<std::int64_t> read;
  on_every_rank([&] {
    const auto ranks = static_cast<std::uint64_t>(communicator_.size()),
               rank = static_cast<std::uint64_t>(communicator_.rank());
    const std::uint64_t count = file_->shape("particles/id").at(0), begin = count * rank / ranks,
                        end = count * (rank + 1) / ranks;
    share = {{begin, 0}, {end - begin, 1}};
    read = file_->get<std::int64_t>("particles/id", share);
  });
  const auto id = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.id);
  std::optional<particles::ById> by_id;
  const std::vector<std::int64_t> own(id.data(), id.data() + id.extent(0));
  try {
    by_id.emplace(communicator_, own, read);
  } catch (const base::InputError& error) {
    throw base::InputError("cannot go on from '" + file_->path() + "': " + error.what());
  }
  const auto count = static_cast<std::size_t>(particles.count());
  particles::for_each_field(
      [&](const particles::Field& field, auto& view) {
        using T = typename std::decay_t<decltype(view)>::non_const_value_type;
        if constexpr (std::is_same_v<T, double>) {
          const std::string name = std::string("particles/") + field.name;
          if (!is_state(field) || !file_->has(name)) return;
          std::vector<double> rows;
          std::size_t numbers = 0;
          on_every_rank([&] {
            const auto shape = file_->shape(name);
            numbers = shape.size() == 2 ? shape[1] : 0;
            const std::size_t expected = particles::numbers_of(view);
            if (numbers == 0 ||
                (std::decay_t<decltype(view)>::rank_dynamic < 2 && numbers != expected))
              throw base::InputError(name + " is of another shape than expected");
            rows = file_->get<double>(name, {{share.begin[0], 0}, {share.count[0], numbers}});
          });
          const std::vector<double> values = (*by_id)(rows, numbers);
          particles::allocate(view, field.name, count, numbers);
          const auto host = Kokkos::create_mirror_view(view);
          std::copy(values.begin(), values.end(), host.data());
          Kokkos::deep_copy(view, host);
        }
      },
      particles);
}

void Checkpoint::restore(const std::string& name, grid::Vector& u,
                         const grid::Partition& partition) const {
  on_every_rank([&] {
    const NodeSlab slab(partition, communicator_.rank());
    if (file_->shape(name) != slab.shape)
      throw base::InputError("its grid is not that of the deck");
    const std::vector<double> values = file_->get<double>(name, slab.mine);
    const grid::NodeView nodes = grid::node_view(u);
    const auto host = Kokkos::create_mirror_view(nodes);
    std::copy(values.begin(), values.end(), host.data());
    Kokkos::deep_copy(nodes, host);
  });
}

}  // namespace stroma
