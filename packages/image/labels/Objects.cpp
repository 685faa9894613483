// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Objects.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "stroma/base/DisjointSets.hpp"

namespace stroma::image {
namespace {

struct Offset {
  int x, y, z;
};

/// The neighbours of a voxel that come before it in storage order.
std::vector<Offset> earlier_neighbours(Connectivity connectivity) {
  if (connectivity == Connectivity::faces) return {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<Offset> offsets;
  for (int z = -1; z <= 0; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (z < 0 || y < 0 || (y == 0 && x < 0)) offsets.push_back({x, y, z});
      }
    }
  }
  return offsets;
}

}  // namespace

Objects::Objects(const base::Communicator& communicator, const voxels::LabelVolume& labels,
                 Connectivity connectivity, std::int32_t ground)
    : communicator_(communicator) {
  find_pieces(labels, connectivity, ground);
  merge_over_slabs(labels, connectivity);
  size_ = sum_over_pieces(std::move(size_));
}

void Objects::find_pieces(const voxels::LabelVolume& labels, Connectivity connectivity,
                          std::int32_t ground) {
  const std::vector<Offset> neighbours = earlier_neighbours(connectivity);
  const auto [nx, ny, nz] =
      std::array<std::int64_t, 3>{labels.size[0], labels.size[1], labels.planes};
  piece_.assign(labels.values.size(), -1);
  base::DisjointSets sets;
  std::size_t voxel = 0;
  for (std::int64_t k = 0; k < nz; ++k) {
    for (std::int64_t j = 0; j < ny; ++j) {
      for (std::int64_t i = 0; i < nx; ++i, ++voxel) {
        const std::int32_t label = labels.values[voxel];
        if (label < 0 || label == ground) continue;
        std::int32_t& piece = piece_[voxel];
        for (const Offset& d : neighbours) {
          if (i + d.x < 0 || i + d.x >= nx || j + d.y < 0 || j + d.y >= ny || k + d.z < 0) continue;
          const auto other = static_cast<std::size_t>(static_cast<std::int64_t>(voxel) + d.x +
                                                      nx * (d.y + ny * d.z));
          if (labels.values[other] != label) continue;
          if (piece < 0) {
            piece = piece_[other];
          } else if (piece != piece_[other]) {
            sets.join(piece, piece_[other]);
          }
        }
        if (piece < 0) piece = sets.add();
      }
    }
  }
  // Number the sets 0, 1, ... in the order of their first voxels, and count voxels.
  std::vector<std::int32_t> number(sets.size());
  std::int32_t pieces = 0;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const auto root = static_cast<std::size_t>(sets.root(static_cast<std::int32_t>(s)));
    number[s] = root == s ? pieces++ : number[root];
  }
  size_.assign(static_cast<std::size_t>(pieces), 0);
  for (std::int32_t& piece : piece_) {
    if (piece < 0) continue;
    piece = number[static_cast<std::size_t>(piece)];
    ++size_[static_cast<std::size_t>(piece)];
  }
  first_id_ = communicator_.sum_before(static_cast<std::int64_t>(pieces));
  id_.resize(size_.size());
  std::iota(id_.begin(), id_.end(), first_id_);
}

void Objects::merge_over_slabs(const voxels::LabelVolume& labels, Connectivity connectivity) {
  const std::int64_t nx = labels.size[0], ny = labels.size[1];
  const std::int64_t plane = nx * ny;
  const int reach = connectivity == Connectivity::faces ? 0 : 1;
  const bool busy = labels.planes > 0;
  const std::int64_t last_plane = labels.first_plane + labels.planes - 1;
  const voxels::Box below{{0, 0, labels.first_plane - 1},
                          {nx, ny, busy && labels.first_plane > 0 ? 1 : 0}};
  const voxels::Box above{{0, 0, last_plane + 1},
                          {nx, ny, busy && last_plane + 1 < labels.size[2] ? 1 : 0}};

  // Each rank sees the plane before and the plane behind its slab; pieces that touch across take
  // the smaller number, until no rank has anything to change. Only boundary planes are filled and
  // exchanged.
  voxels::Volume<std::int64_t> ids;
  ids.size = {nx, ny, 2 * communicator_.size()};
  ids.first_plane = 2 * communicator_.rank();
  ids.planes = 2;
  ids.values.assign(static_cast<std::size_t>(2 * plane), -1);
  const voxels::Slabs slabs(labels.size[2], communicator_.size());
  const auto in_ids = [&](const voxels::Box& box,
                          int side) {  // side 0: a slab's first plane, 1: its last
    voxels::Box found = box;
    if (box.count[2] > 0) found.first[2] = 2 * slabs.owner(box.first[2]) + side;
    return found;
  };
  const std::vector<std::int32_t> labels_below = voxels::extract(communicator_, labels, below);
  const std::vector<std::int32_t> labels_above = voxels::extract(communicator_, labels, above);

  const auto publish = [&] {
    for (int side = 0; side < 2 && busy; ++side) {
      const std::int64_t offset = side == 0 ? 0 : (labels.planes - 1) * plane;
      for (std::int64_t v = 0; v < plane; ++v) {
        const std::int32_t piece = piece_[static_cast<std::size_t>(offset + v)];
        ids.values[static_cast<std::size_t>(side * plane + v)] =
            piece < 0 ? -1 : id_[static_cast<std::size_t>(piece)];
      }
    }
  };
  // Takes over smaller numbers from a neighbouring plane.
  const auto adopt = [&](const std::vector<std::int64_t>& other_ids,
                         const std::vector<std::int32_t>& other_labels, std::int64_t own_plane) {
    bool changed = false;
    if (other_ids.empty()) return changed;
    for (std::int64_t j = 0; j < ny; ++j) {
      for (std::int64_t i = 0; i < nx; ++i) {
        const auto own = static_cast<std::size_t>(own_plane * plane + j * nx + i);
        if (piece_[own] < 0) continue;
        std::int64_t& id = id_[static_cast<std::size_t>(piece_[own])];
        for (std::int64_t y = std::max<std::int64_t>(j - reach, 0);
             y <= std::min(j + reach, ny - 1); ++y) {
          for (std::int64_t x = std::max<std::int64_t>(i - reach, 0);
               x <= std::min(i + reach, nx - 1); ++x) {
            const auto other = static_cast<std::size_t>(y * nx + x);
            if (other_labels[other] != labels.values[own] || other_ids[other] >= id) continue;
            id = other_ids[other];
            changed = true;
          }
        }
      }
    }
    return changed;
  };
  if (communicator_.size() == 1) return;
  for (bool changed = true; changed;) {
    publish();
    const std::vector<std::int64_t> ids_below =
        voxels::extract(communicator_, ids, in_ids(below, 1));
    const std::vector<std::int64_t> ids_above =
        voxels::extract(communicator_, ids, in_ids(above, 0));
    const bool changed_below = adopt(ids_below, labels_below, 0);
    const bool changed_above = adopt(ids_above, labels_above, labels.planes - 1);
    changed = communicator_.any(changed_below || changed_above);
  }
}

std::vector<std::int64_t> Objects::sum_over_pieces(std::vector<std::int64_t> of_pieces) const {
  // The rank that numbered an object adds up its pieces, and tells the others the sum. The volume
  // of messages is that of the pieces that reach over slabs.
  const int ranks = communicator_.size();
  const std::vector<std::int64_t> firsts = communicator_.gather(first_id_);
  const auto owner = [&](std::int64_t id) {
    return static_cast<std::size_t>(std::upper_bound(firsts.begin(), firsts.end(), id) -
                                    firsts.begin() - 1);
  };
  std::vector<std::vector<std::int64_t>> ask(static_cast<std::size_t>(ranks));  // id, number, ...
  std::vector<std::vector<std::size_t>> asked_for(static_cast<std::size_t>(ranks));  // piece
  std::vector<std::int64_t> total(of_pieces.size(), 0);
  for (std::size_t p = 0; p < of_pieces.size(); ++p) {
    const std::size_t rank = owner(id_[p]);
    if (static_cast<int>(rank) == communicator_.rank()) {
      total[static_cast<std::size_t>(id_[p] - first_id_)] += of_pieces[p];
    } else {
      ask[rank].insert(ask[rank].end(), {id_[p], of_pieces[p]});
      asked_for[rank].push_back(p);
    }
  }
  std::vector<int> send_counts, send_at, receive_counts(static_cast<std::size_t>(ranks)),
      receive_at;
  std::vector<std::int64_t> send;
  for (const auto& part : ask) {
    send_at.push_back(static_cast<int>(send.size()));
    send_counts.push_back(static_cast<int>(part.size()));
    send.insert(send.end(), part.begin(), part.end());
  }
  MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT,
               communicator_.raw());
  int received = 0;
  for (const int count : receive_counts) {
    receive_at.push_back(received);
    received += count;
  }
  std::vector<std::int64_t> questions(static_cast<std::size_t>(received));
  MPI_Alltoallv(send.data(), send_counts.data(), send_at.data(), MPI_INT64_T, questions.data(),
                receive_counts.data(), receive_at.data(), MPI_INT64_T, communicator_.raw());
  for (std::size_t q = 0; q < questions.size(); q += 2)
    total[static_cast<std::size_t>(questions[q] - first_id_)] += questions[q + 1];
  for (std::size_t q = 0; q < questions.size(); q += 2)
    questions[q + 1] = total[static_cast<std::size_t>(questions[q] - first_id_)];
  MPI_Alltoallv(questions.data(), receive_counts.data(), receive_at.data(), MPI_INT64_T,
                send.data(), send_counts.data(), send_at.data(), MPI_INT64_T, communicator_.raw());
  for (std::size_t p = 0; p < of_pieces.size(); ++p) {
    if (static_cast<int>(owner(id_[p])) == communicator_.rank())
      of_pieces[p] = total[static_cast<std::size_t>(id_[p] - first_id_)];
  }
  for (std::size_t rank = 0; rank < asked_for.size(); ++rank) {
    for (std::size_t i = 0; i < asked_for[rank].size(); ++i)
      of_pieces[asked_for[rank][i]] = send[static_cast<std::size_t>(send_at[rank]) + 2 * i + 1];
  }
  return of_pieces;
}

std::int64_t Objects::count(std::int64_t smallest) const {
  std::int64_t objects = 0;
  for (std::size_t p = 0; p < id_.size(); ++p)
    if (is_first(p) && size_[p] >= smallest) ++objects;
  return communicator_.sum(objects);
}

std::int64_t Objects::largest() const {
  const auto found = std::max_element(size_.begin(), size_.end());
  return communicator_.max(found == size_.end() ? std::int64_t{0} : *found);
}

namespace {

/// (piece) How many more neighbours of the object's voxels are empty space than label 0.
std::vector<std::int64_t> emptiness_around(const base::Communicator& communicator,
                                           const voxels::LabelVolume& labels,
                                           const Objects& objects) {
  const auto [nx, ny, nz] = labels.size;
  const std::int64_t first = std::max<std::int64_t>(labels.first_plane - 1, 0);
  const std::int64_t last = std::min(labels.first_plane + labels.planes + 1, nz);
  const std::vector<std::int32_t> around = voxels::extract(
      communicator, labels, {{0, 0, first}, {nx, ny, labels.planes > 0 ? last - first : 0}});
  std::vector<std::int64_t> emptiness(objects.pieces(), 0);
  std::size_t voxel = 0;
  for (std::int64_t k = labels.first_plane; k < labels.first_plane + labels.planes; ++k) {
    for (std::int64_t j = 0; j < ny; ++j) {
      for (std::int64_t i = 0; i < nx; ++i, ++voxel) {
        if (objects.size_at(voxel) == 0) continue;
        std::int64_t& here = emptiness[objects.piece_at(voxel)];
        for (std::int64_t z = std::max(k - 1, first); z < std::min(k + 2, last); ++z) {
          for (std::int64_t y = std::max<std::int64_t>(j - 1, 0); y < std::min(j + 2, ny); ++y) {
            for (std::int64_t x = std::max<std::int64_t>(i - 1, 0); x < std::min(i + 2, nx); ++x) {
              const std::int32_t label =
                  around[static_cast<std::size_t>(x + nx * (y + ny * (z - first)))];
              here += label < 0 ? 1 : label == 0 ? -1 : 0;
            }
          }
        }
      }
    }
  }
  return objects.sum_over_pieces(std::move(emptiness));
}

}  // namespace

std::int64_t remove_small_objects(const base::Communicator& communicator,
                                  voxels::LabelVolume& labels, std::int64_t smallest) {
  const Objects objects(communicator, labels, Connectivity::corners);
  const std::int64_t removed = objects.count() - objects.count(smallest);
  std::vector<std::int64_t> emptiness(objects.pieces(), 0);
  const bool some_empty = std::any_of(labels.values.begin(), labels.values.end(),
                                      [](std::int32_t label) { return label < 0; });
  if (removed > 0 && communicator.any(some_empty))
    emptiness = emptiness_around(communicator, labels, objects);
  for (std::size_t voxel = 0; voxel < labels.values.size(); ++voxel) {
    const std::int64_t size = objects.size_at(voxel);
    if (size > 0 && size < smallest)
      labels.values[voxel] = emptiness[objects.piece_at(voxel)] > 0 ? -1 : 0;
  }
  return removed;
}

}  // namespace stroma::image
