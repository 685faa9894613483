// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/voxels/Volume.hpp"

#include <algorithm>

#include "stroma/base/Log.hpp"

namespace stroma::voxels {
namespace {

/// The part of a box that lies in the planes [first, first + count).
Box planes_within(const Box& box, std::int64_t first, std::int64_t count) {
  const std::int64_t begin = std::max(box.first[2], first);
  const std::int64_t end = std::min(box.first[2] + box.count[2], first + count);
  Box part = box;
  part.first[2] = begin;
  part.count[2] = std::max<std::int64_t>(end - begin, 0);
  return part;
}

template <class T>
std::vector<T> pack(const Volume<T>& volume, const Box& part) {
  std::vector<T> values;
  values.reserve(static_cast<std::size_t>(part.voxels()));
  for (std::int64_t k = 0; k < part.count[2]; ++k) {
    const T* plane = volume.plane(part.first[2] + k - volume.first_plane);
    for (std::int64_t j = 0; j < part.count[1]; ++j) {
      const T* row = plane + (part.first[1] + j) * volume.size[0] + part.first[0];
      values.insert(values.end(), row, row + part.count[0]);
    }
  }
  return values;
}

}  // namespace

std::string name_of_voxel(const std::array<std::int64_t, 3>& in_file) {
  return base::format("voxel (%lld, %lld, %lld)", static_cast<long long>(in_file[0]),
                      static_cast<long long>(in_file[1]), static_cast<long long>(in_file[2]));
}

std::string name_of_voxel(const IntensityVolume& volume, std::int64_t voxel) {
  const std::int64_t row = voxel / volume.size[0];
  const std::array<std::int64_t, 3>& first = volume.first_in_file;
  return name_of_voxel({first[0] + voxel % volume.size[0], first[1] + row % volume.size[1],
                        first[2] + row / volume.size[1]});
}

template <class T>
std::vector<T> extract(const base::Communicator& communicator, const Volume<T>& volume,
                       const Box& wanted) {
  Box box = wanted;
  if (box.voxels() == 0) box = Box{};

  std::array<std::int64_t, 6> request;
  std::copy(box.first.begin(), box.first.end(), request.begin());
  std::copy(box.count.begin(), box.count.end(), request.begin() + 3);
  std::vector<std::array<std::int64_t, 6>> requests(static_cast<std::size_t>(communicator.size()));
  MPI_Allgather(request.data(), 6, MPI_INT64_T, requests.data(), 6, MPI_INT64_T,
                communicator.raw());

  constexpr int tag = 4711;
  const std::int64_t box_plane = box.count[0] * box.count[1];
  std::vector<T> values(static_cast<std::size_t>(box.voxels()));
  const Slabs slabs(volume.size[2], communicator.size());
  std::vector<MPI_Request> open;

  // A rank's planes are consecutive in the answer, so they are received in place. Messages count
  // whole rows of the box as one item, so that counts fit an int.
  MPI_Datatype plane_type;
  MPI_Type_contiguous(static_cast<int>(std::max<std::int64_t>(box_plane, 1)), base::mpi_type<T>(),
                      &plane_type);
  MPI_Type_commit(&plane_type);
  for (int rank = 0; rank < communicator.size(); ++rank) {
    const Box part = planes_within(box, slabs.first(rank), slabs.count(rank));
    if (rank == communicator.rank() || part.voxels() == 0) continue;
    T* target = values.data() + (part.first[2] - box.first[2]) * box_plane;
    open.emplace_back();
    MPI_Irecv(target, static_cast<int>(part.count[2]), plane_type, rank, tag, communicator.raw(),
              &open.back());
  }

  std::vector<std::vector<T>> packed;
  packed.reserve(static_cast<std::size_t>(communicator.size()));
  std::vector<MPI_Datatype> types;
  for (int rank = 0; rank < communicator.size(); ++rank) {
    const auto& r = requests[static_cast<std::size_t>(rank)];
    const Box asked{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
    const Box part = planes_within(asked, volume.first_plane, volume.planes);
    if (part.voxels() == 0) continue;
    packed.push_back(pack(volume, part));
    if (rank == communicator.rank()) {
      std::copy(packed.back().begin(), packed.back().end(),
                values.begin() + (part.first[2] - box.first[2]) * box_plane);
      packed.pop_back();
      continue;
    }
    types.emplace_back();
    MPI_Type_contiguous(static_cast<int>(part.count[0] * part.count[1]), base::mpi_type<T>(),
                        &types.back());
    MPI_Type_commit(&types.back());
    open.emplace_back();
    MPI_Isend(packed.back().data(), static_cast<int>(part.count[2]), types.back(), rank, tag,
              communicator.raw(), &open.back());
  }
  MPI_Waitall(static_cast<int>(open.size()), open.data(), MPI_STATUSES_IGNORE);
  for (MPI_Datatype& type : types) MPI_Type_free(&type);
  MPI_Type_free(&plane_type);
  return values;
}

template std::vector<std::uint8_t> extract(const base::Communicator&, const Volume<std::uint8_t>&,
                                           const Box&);
template std::vector<std::int32_t> extract(const base::Communicator&, const Volume<std::int32_t>&,
                                           const Box&);
template std::vector<std::int64_t> extract(const base::Communicator&, const Volume<std::int64_t>&,
                                           const Box&);
template std::vector<float> extract(const base::Communicator&, const Volume<float>&, const Box&);
template std::vector<double> extract(const base::Communicator&, const Volume<double>&, const Box&);

}  // namespace stroma::voxels
