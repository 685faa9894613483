// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/GridFile.hpp"

#include <exodusII.h>

#include <algorithm>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/SpreadFiles.hpp"

namespace stroma::output {
namespace {

IndexBox intersection(const IndexBox& a, const IndexBox& b) {
  IndexBox both;
  for (std::size_t d = 0; d < 3; ++d) {
    both.begin[d] = std::max(a.begin[d], b.begin[d]);
    both.end[d] = std::min(a.end[d], b.end[d]);
  }
  return both;
}

/// The node boxes of all ranks: 6 integers a rank.
std::vector<IndexBox> boxes_of_all(const base::Communicator& communicator, const IndexBox& own) {
  std::vector<IndexBox> boxes(static_cast<std::size_t>(communicator.size()));
  for (std::size_t d = 0; d < 3; ++d) {
    const auto begins = communicator.gather(own.begin[d]);
    const auto ends = communicator.gather(own.end[d]);
    for (std::size_t r = 0; r < boxes.size(); ++r) {
      boxes[r].begin[d] = begins[r];
      boxes[r].end[d] = ends[r];
    }
  }
  return boxes;
}

/// A rank whose box touches this one's, and the nodes of this rank's box that both use.
struct Neighbour {
  int rank;
  std::vector<std::int64_t> nodes;  ///< index in this rank's box
};

/// Neighbours tell each other which nodes of their common face, edge or corner they use.
/// Collective.
std::vector<Neighbour> find_shared(const base::Communicator& communicator, const IndexBox& own,
                                   const std::vector<std::uint8_t>& used) {
  struct Exchange {
    int rank;
    IndexBox common;
    std::vector<std::uint8_t> mine, theirs;
  };
  std::vector<Exchange> exchanges;
  const std::vector<IndexBox> boxes = boxes_of_all(communicator, own);
  for (int rank = 0; rank < communicator.size(); ++rank) {
    const IndexBox common = intersection(own, boxes[static_cast<std::size_t>(rank)]);
    if (rank == communicator.rank() || common.empty()) continue;
    Exchange exchange{rank, common, {}, {}};
    common.for_each([&](std::int64_t i, std::int64_t j, std::int64_t k) {
      exchange.mine.push_back(used[static_cast<std::size_t>(own.index(i, j, k))]);
    });
    exchange.theirs.resize(exchange.mine.size());
    exchanges.push_back(std::move(exchange));
  }
  std::vector<MPI_Request> requests;
  for (Exchange& e : exchanges) {
    const int size = static_cast<int>(e.mine.size());
    MPI_Irecv(e.theirs.data(), size, MPI_UINT8_T, e.rank, 0, communicator.raw(),
              &requests.emplace_back());
    MPI_Isend(e.mine.data(), size, MPI_UINT8_T, e.rank, 0, communicator.raw(),
              &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);

  std::vector<Neighbour> neighbours;
  for (const Exchange& e : exchanges) {
    Neighbour neighbour{e.rank, {}};
    std::size_t n = 0;
    e.common.for_each([&](std::int64_t i, std::int64_t j, std::int64_t k) {
      if (e.mine[n] != 0 && e.theirs[n] != 0) neighbour.nodes.push_back(own.index(i, j, k));
      ++n;
    });
    if (!neighbour.nodes.empty()) neighbours.push_back(std::move(neighbour));
  }
  return neighbours;
}

/// Number of distinct used nodes over all ranks: a shared node counts at the lowest rank that uses
/// it.
std::int64_t count_global_nodes(const base::Communicator& communicator,
                                const std::vector<Neighbour>& neighbours, std::int64_t used_count) {
  std::vector<std::int64_t> of_lower_ranks;
  for (const Neighbour& neighbour : neighbours) {
    if (neighbour.rank > communicator.rank()) continue;
    of_lower_ranks.insert(of_lower_ranks.end(), neighbour.nodes.begin(), neighbour.nodes.end());
  }
  std::sort(of_lower_ranks.begin(), of_lower_ranks.end());
  const auto distinct =
      std::unique(of_lower_ranks.begin(), of_lower_ranks.end()) - of_lower_ranks.begin();
  return communicator.sum(used_count - static_cast<std::int64_t>(distinct));
}

std::vector<std::string> components_of(const std::vector<std::string>& vectors) {
  std::vector<std::string> names;
  for (const std::string& vector : vectors)
    for (const char* axis : {"_x", "_y", "_z"}) names.push_back(vector + axis);
  return names;
}

/// Coordinates and global numbers of the used nodes.
void put_nodes(const ExodusFile& file, const GridPart& part, const IndexBox& box,
               const std::vector<std::uint8_t>& used, std::int64_t used_count) {
  const char* axes[3] = {"x", "y", "z"};
  file.check(ex_put_coord_names(file.id(), const_cast<char**>(axes)), "the names of the axes");
  if (used_count == 0) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    UsedNodes nodes(used);
    ExodusFile::in_pieces<double>(
        used_count, [&](std::int64_t) { return coordinate(part, box.place(nodes.next()), axis); },
        [&](std::int64_t start, std::int64_t size, const double* values) {
          file.check(
              ex_put_partial_coord(file.id(), start, size, axis == 0 ? values : nullptr,
                                   axis == 1 ? values : nullptr, axis == 2 ? values : nullptr),
              "the coordinates");
        });
  }
  UsedNodes nodes(used);
  ExodusFile::in_pieces<std::int64_t>(
      used_count, [&](std::int64_t) { return node_id(part, box.place(nodes.next())); },
      [&](std::int64_t start, std::int64_t size, const std::int64_t* ids) {
        file.check(ex_put_partial_id_map(file.id(), EX_NODE_MAP, start, size, ids),
                   "the node numbers");
      });
}

/// Connectivity and global numbers of the active elements.
void put_elements(const ExodusFile& file, const GridPart& part, const IndexBox& box,
                  const std::vector<std::int64_t>& local_number) {
  std::vector<std::int64_t> connectivity, ids;
  std::int64_t start = 1;
  const auto hand_over = [&] {
    if (ids.empty()) return;
    const auto size = static_cast<std::int64_t>(ids.size());
    file.check(ex_put_partial_elem_conn(file.id(), 1, start, size, connectivity.data()),
               "the connectivity");
    file.check(ex_put_partial_id_map(file.id(), EX_ELEM_MAP, start, size, ids.data()),
               "the element numbers");
    start += size;
    connectivity.clear();
    ids.clear();
  };
  for_each_active(part, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    for (const std::int64_t node : corners(box, i, j, k)) {
      connectivity.push_back(local_number[static_cast<std::size_t>(node)]);
    }
    ids.push_back(1 + i + part.elements[0] * (j + part.elements[1] * k));
    if (static_cast<std::int64_t>(ids.size()) == ExodusFile::piece) hand_over();
  });
  hand_over();
}

}  // namespace

GridFile::GridFile(const base::Communicator& communicator, const std::string& path,
                   const GridPart& part, std::vector<std::string> vectors,
                   const Provenance& provenance, Precision precision,
                   const std::optional<FileEnd>& continued)
    : communicator_(communicator),
      path_(spread_file_name(path, communicator.size(), communicator.rank())),
      part_(part),
      vectors_(std::move(vectors)) {
  part_.active = nullptr;  // the caller's
  const IndexBox box = node_box(part);
  used_ = used_nodes(part);
  std::int64_t elements = 0;
  for_each_active(part, [&](std::int64_t, std::int64_t, std::int64_t) { ++elements; });
  std::vector<std::int64_t> local_number(used_.size(), 0);  // in this file, from 1; 0: unused
  for (std::size_t n = 0; n < used_.size(); ++n) {
    if (used_[n] != 0) local_number[n] = ++used_count_;
  }
  if (continued) {
    base::collectively(communicator_, [&] { cut_at(path_, *continued); });
    end_ = *continued;
    return;
  }

  const std::vector<Neighbour> neighbours = find_shared(communicator_, box, used_);
  ParallelPart parallel;
  parallel.ranks = communicator_.size();
  parallel.rank = communicator_.rank();
  parallel.nodes = used_count_;
  parallel.elements = elements;
  parallel.global_nodes = count_global_nodes(communicator_, neighbours, used_count_);
  parallel.global_elements = communicator_.sum(elements);
  parallel.global_block_ids = {1};
  parallel.global_block_counts = {parallel.global_elements};

  std::vector<std::uint8_t> is_shared(used_.size(), 0);
  for (const Neighbour& neighbour : neighbours) {
    ParallelPart::Shared shared{neighbour.rank, {}};
    for (const std::int64_t node : neighbour.nodes) {
      is_shared[static_cast<std::size_t>(node)] = 1;
      shared.nodes.push_back(local_number[static_cast<std::size_t>(node)]);
    }
    parallel.shared.push_back(std::move(shared));
  }
  std::int64_t element = 0;
  for_each_active(part, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    ++element;
    const auto nodes = corners(box, i, j, k);
    const bool at_border = std::any_of(nodes.begin(), nodes.end(), [&](std::int64_t node) {
      return is_shared[static_cast<std::size_t>(node)] != 0;
    });
    if (at_border) parallel.border_elements.push_back(element);
  });

  std::int64_t largest_id = 1;
  for (const std::int64_t n : part.elements) largest_id *= n + 1;
  const FileSize size{largest_id, std::max(elements, used_count_)};
  base::collectively(communicator_, [&] {
    ExodusFile file = ExodusFile::create(path_, precision, 32, size);
    const int id = file.id();
    const std::string title = provenance.title.substr(0, MAX_LINE_LENGTH);
    file.check(ex_put_init(id, title.c_str(), 3, used_count_, elements, 1, 0, 0), "the counts");
    put_parallel_part(file, parallel);
    file.put_provenance(provenance);
    put_nodes(file, part, box, used_, used_count_);
    file.check(ex_put_block(id, EX_ELEM_BLOCK, 1, "HEX8", elements, 8, 0, 0, 0), "the elements");
    file.check(ex_put_name(id, EX_ELEM_BLOCK, 1, "grid"), "the block's name");
    put_elements(file, part, box, local_number);
    if (used_count_ > 0) file.put_variable_names(EX_NODAL, components_of(vectors_));
    file.close();
    end_ = end_of(path_);
  });
}

void GridFile::write(double time, const std::vector<NodalVector>& vectors) {
  add_step(communicator_, path_, end_, time, [&](const ExodusStep& step) {
    for (int variable = 0; variable < static_cast<int>(3 * vectors_.size()); ++variable) {
      const double* values = vectors[static_cast<std::size_t>(variable / 3)].values;
      UsedNodes nodes(used_);
      ExodusFile::in_pieces<double>(
          used_count_, [&](std::int64_t) { return values[3 * nodes.next() + variable % 3]; },
          [&](std::int64_t start, std::int64_t size, const double* piece) {
            step.put_piece(ExodusStep::At::nodes, variable + 1, 1, start, size, piece);
          });
    }
  });
}

void GridFile::copy_steps(const std::string& path, int ranks) {
  const IndexBox box = node_box(part_);
  std::vector<std::int64_t> ids;
  UsedNodes nodes(used_);
  for (std::int64_t n = 0; n < used_count_; ++n)
    ids.push_back(node_id(part_, box.place(nodes.next())));
  std::optional<SpreadFiles> before;
  base::collectively(communicator_,
                     [&] { before.emplace(path, ranks, ExodusStep::At::nodes, ids); });
  for (const double time : before->times()) {
    const std::int64_t s = end_.steps + 1;
    add_step(communicator_, path_, end_, time, [&](const ExodusStep& step) {
      if (used_count_ == 0) return;
      for (int variable = 1; variable <= static_cast<int>(3 * vectors_.size()); ++variable)
        step.put_piece(ExodusStep::At::nodes, variable, 1, 1, used_count_,
                       before->values(s, variable).data());
    });
  }
}

}  // namespace stroma::output
