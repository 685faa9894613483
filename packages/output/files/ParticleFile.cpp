// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ParticleFile.hpp"

#include <exodusII.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/SpreadFiles.hpp"

namespace stroma::output {
namespace {

std::vector<std::string> names(const std::vector<ParticleVariable>& variables, bool at_nodes) {
  std::vector<std::string> names;
  for (const ParticleVariable& variable : variables)
    if (!at_nodes || variable.at_nodes) names.push_back(variable.name);
  return names;
}

/// Calls use(members) for the particles of one material among those from `first` to `end`, in
/// pieces and in order.
template <class Use>
void for_members(const ParticleSet& particles, std::size_t material, std::int64_t first,
                 std::int64_t end, const Use& use) {
  std::vector<std::int64_t> members;
  for (std::int64_t p = first; p < end; ++p) {
    if (particles.material[p] != material) continue;
    members.push_back(p);
    if (static_cast<std::int64_t>(members.size()) == ExodusFile::piece) {
      use(members);
      members.clear();
    }
  }
  if (!members.empty()) use(members);
}

/// Calls use(start, members) for all particles of one material, in pieces and in order; start
/// counts the block's elements from 1.
template <class Use>
void in_pieces_of_block(const ParticleSet& particles, std::size_t material, const Use& use) {
  std::int64_t start = 1;
  for_members(particles, material, 0, particles.count, [&](std::vector<std::int64_t>& members) {
    const auto size = static_cast<std::int64_t>(members.size());
    use(start, members);
    start += size;
  });
}

void put_nodes(const ExodusFile& file, const ParticleSet& particles) {
  const char* axes[3] = {"x", "y", "z"};
  file.check(ex_put_coord_names(file.id(), const_cast<char**>(axes)), "the names of the axes");
  for (int axis = 0; axis < 3; ++axis) {
    ExodusFile::in_pieces<double>(
        particles.count, [&](std::int64_t p) { return particles.position[3 * p + axis]; },
        [&](std::int64_t start, std::int64_t size, const double* values) {
          file.check(
              ex_put_partial_coord(file.id(), start, size, axis == 0 ? values : nullptr,
                                   axis == 1 ? values : nullptr, axis == 2 ? values : nullptr),
              "the coordinates");
        });
  }
  ExodusFile::in_pieces<std::int64_t>(
      particles.count, [&](std::int64_t p) { return particles.id[p] + 1; },
      [&](std::int64_t start, std::int64_t size, const std::int64_t* ids) {
        file.check(ex_put_partial_id_map(file.id(), EX_NODE_MAP, start, size, ids),
                   "the node numbers");
      });
}

void put_elements(const ExodusFile& file, const ParticleSet& particles, std::size_t material) {
  const int id = file.id();
  const auto block = static_cast<ex_entity_id>(material + 1);
  std::vector<double> attribute;
  in_pieces_of_block(particles, material, [&](std::int64_t start, const auto& members) {
    std::vector<std::int64_t> nodes = members;
    for (std::int64_t& node : nodes) ++node;
    const auto size = static_cast<std::int64_t>(members.size());
    file.check(ex_put_partial_elem_conn(id, block, start, size, nodes.data()), "the connectivity");

    attribute.clear();
    for (const std::int64_t p : members) attribute.push_back(radius_of(particles.volume[p]));
    file.check(ex_put_partial_one_attr(id, EX_ELEM_BLOCK, block, start, size, 1, attribute.data()),
               "the radii");
    attribute.clear();
    for (const std::int64_t p : members) attribute.push_back(particles.volume[p]);
    file.check(ex_put_partial_one_attr(id, EX_ELEM_BLOCK, block, start, size, 2, attribute.data()),
               "the volumes");
  });
}

std::size_t longest(const std::vector<std::string>& names) {
  std::size_t length = 0;
  for (const std::string& name : names) length = std::max(length, name.size());
  return length;
}

}  // namespace

ParticleFile::ParticleFile(const base::Communicator& communicator, const std::string& path,
                           const ParticleSet& particles, const std::vector<std::string>& materials,
                           const std::vector<std::string>& global_variables,
                           const Provenance& provenance, Precision precision,
                           const std::vector<ShownField>& fields,
                           const std::optional<FileEnd>& continued)
    : communicator_(communicator),
      path_(spread_file_name(path, communicator.size(), communicator.rank())),
      materials_(materials.size()),
      globals_(global_variables.size()),
      variables_(particle_variables(fields)),
      count_(particles.count) {
  if (continued) {
    base::collectively(communicator_, [&] { cut_at(path_, *continued); });
    end_ = *continued;
    return;
  }
  ParallelPart part;
  part.ranks = communicator_.size();
  part.rank = communicator_.rank();
  part.nodes = part.elements = particles.count;
  part.global_nodes = part.global_elements = communicator_.sum(particles.count);

  std::vector<std::int64_t> counts(materials_ + 1, 0);  // the last: of no material
  for (std::int64_t p = 0; p < particles.count; ++p) {
    ++counts[std::min<std::size_t>(particles.material[p], materials_)];
  }
  part.global_block_counts.assign(counts.begin(), counts.end() - 1);
  communicator_.sum_all(part.global_block_counts.data(), materials_);
  for (std::size_t m = 0; m < materials_; ++m) {
    part.global_block_ids.push_back(static_cast<std::int64_t>(m + 1));
  }

  const std::int64_t* const ids = particles.id;
  const std::int64_t largest_id =
      particles.count == 0 ? 0 : 1 + *std::max_element(ids, ids + particles.count);
  const FileSize size{communicator_.max(largest_id), particles.count};
  base::collectively(communicator_, [&] {
    if (counts.back() > 0) throw base::RunError("a particle for '" + path_ + "' has no material");
    ExodusFile file = ExodusFile::create(
        path_, precision, std::max(longest(materials), longest(global_variables)), size);
    const int id = file.id();
    const std::string title = provenance.title.substr(0, MAX_LINE_LENGTH);
    file.check(ex_put_init(id, title.c_str(), 3, particles.count, particles.count,
                           static_cast<std::int64_t>(materials_), 0, 0),
               "the counts");
    put_parallel_part(file, part);
    file.put_provenance(provenance);
    put_nodes(file, particles);

    const char* attributes[2] = {"radius", "volume"};
    std::int64_t before = 0;  // elements of the blocks before this one
    for (std::size_t m = 0; m < materials_; ++m) {
      const auto block = static_cast<ex_entity_id>(m + 1);
      file.check(ex_put_block(id, EX_ELEM_BLOCK, block, "SPHERE", counts[m], 1, 0, 0, 2),
                 "a block");
      file.check(ex_put_name(id, EX_ELEM_BLOCK, block, materials[m].c_str()), "a material's name");
      in_pieces_of_block(particles, m, [&](std::int64_t start, std::vector<std::int64_t>& members) {
        for (std::int64_t& p : members) p = particles.id[p] + 1;
        file.check(ex_put_partial_id_map(id, EX_ELEM_MAP, before + start,
                                         static_cast<std::int64_t>(members.size()), members.data()),
                   "the element numbers");
      });
      if (counts[m] > 0) {
        file.check(ex_put_attr_names(id, EX_ELEM_BLOCK, block, const_cast<char**>(attributes)),
                   "the names of the attributes");
        put_elements(file, particles, m);
      }
      before += counts[m];
    }
    file.put_variable_names(EX_GLOBAL, global_variables);
    if (count_ > 0) file.put_variable_names(EX_NODAL, names(variables_, true));
    file.put_variable_names(EX_ELEM_BLOCK, names(variables_, false));
    std::vector<int> exists;  // (block, variable): room is made for them now
    for (std::size_t m = 0; m < materials_; ++m)
      exists.insert(exists.end(), variables_.size(), counts[m] > 0 ? 1 : 0);
    file.check(ex_put_truth_table(id, EX_ELEM_BLOCK, static_cast<int>(materials_),
                                  static_cast<int>(variables_.size()), exists.data()),
               "which variables exist");
    file.close();
    end_ = end_of(path_);
  });
}

double radius_of(double volume) {
  constexpr double pi = 3.14159265358979323846;
  return std::cbrt(0.75 / pi * volume);
}

StatePieces in_one_piece(std::int64_t count, const ParticleState& state) {
  return [count, state](const auto& use) { use(0, count, state); };
}

void ParticleFile::write(double time, const ParticleSet& particles, const StatePieces& states,
                         const std::vector<double>& globals) {
  base::collectively(communicator_, [&] {
    if (particles.count != count_ || globals.size() != globals_) {
      throw base::RunError(base::format(
          "'%s' was made for %lld particles and %zu global variables, a step brings %lld and %zu",
          path_.c_str(), static_cast<long long>(count_), globals_,
          static_cast<long long>(particles.count), globals.size()));
    }
  });
  add_step(communicator_, path_, end_, time, [&](const ExodusStep& step) {
    step.put_globals(globals);
    std::vector<std::int64_t> start(materials_, 1);  // next element of each block
    std::vector<double> buffer;
    const auto columns = static_cast<std::int64_t>(variables_.size());
    states([&](std::int64_t first, std::int64_t count, const ParticleState& state) {
      int at_nodes = 0;
      for (const ParticleVariable& variable : variables_) {
        if (!variable.at_nodes) continue;
        ++at_nodes;
        ExodusFile::in_pieces<double>(
            count,
            [&](std::int64_t p) {
              return variable.value({state, p});
            },
            [&](std::int64_t begin, std::int64_t size, const double* values) {
              step.put_piece(ExodusStep::At::nodes, at_nodes, 1, first + begin, size, values);
            });
      }
      for (std::size_t m = 0; m < materials_; ++m) {
        for_members(particles, m, first, first + count, [&](const auto& members) {
          const auto size = static_cast<std::int64_t>(members.size());
          buffer.resize(static_cast<std::size_t>(size * columns));
          for (std::int64_t n = 0; n < size; ++n) {
            const ParticleAt particle(state, members[static_cast<std::size_t>(n)] - first);
            double* value = buffer.data() + n;
            for (const ParticleVariable& variable : variables_) {
              *value = variable.value(particle);
              value += size;
            }
          }
          for (std::int64_t v = 0; v < columns; ++v)
            step.put_piece(ExodusStep::At::elements, static_cast<int>(v) + 1,
                           static_cast<std::int64_t>(m + 1), start[m], size,
                           buffer.data() + v * size);
          start[m] += size;
        });
      }
    });
  });
}

void ParticleFile::copy_steps(const std::string& path, int ranks, const ParticleSet& particles) {
  std::vector<std::int64_t> ids(particles.id, particles.id + particles.count);
  for (std::int64_t& id : ids) ++id;
  std::optional<SpreadFiles> before;
  base::collectively(communicator_,
                     [&] { before.emplace(path, ranks, ExodusStep::At::elements, ids); });
  for (const double time : before->times()) {
    const std::int64_t s = end_.steps + 1;
    add_step(communicator_, path_, end_, time, [&](const ExodusStep& step) {
      step.put_globals(before->globals(s));
      int at_nodes = 0;
      for (std::size_t v = 0; v < variables_.size(); ++v) {
        const std::vector<double> values = before->values(s, static_cast<int>(v) + 1);
        if (variables_[v].at_nodes && count_ > 0)
          step.put_piece(ExodusStep::At::nodes, ++at_nodes, 1, 1, count_, values.data());
        for (std::size_t m = 0; m < materials_; ++m)
          in_pieces_of_block(particles, m, [&](std::int64_t start, const auto& members) {
            std::vector<double> piece;
            for (const std::int64_t p : members)
              piece.push_back(values[static_cast<std::size_t>(p)]);
            step.put_piece(ExodusStep::At::elements, static_cast<int>(v) + 1,
                           static_cast<std::int64_t>(m + 1), start,
                           static_cast<std::int64_t>(piece.size()), piece.data());
          });
      }
    });
  }
}

}  // namespace stroma::output
