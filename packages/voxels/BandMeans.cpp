// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/voxels/BandMeans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stroma::voxels {
namespace {

/// Faces of boxes that lie so near to those of voxels [voxels] lie on them.
constexpr double face_tolerance = 1e-9;
/// Volumes that differ by less than this, of themselves, are equal.
constexpr double tie = 1e-9;

/// Whether enough of a voxel is filled for it to have a value.
bool is_filled(double volume) { return volume >= 0.5 - face_tolerance; }

struct Range {
  std::int64_t begin, end;
};

/// The voxels that a box touches along an axis, of those within reach.
Range touched(const FilledBox& box, std::size_t axis, const Box& reach) {
  const double low = std::floor(box.low[axis] + face_tolerance);
  const double high = std::ceil(box.high[axis] - face_tolerance);
  const auto first = static_cast<double>(reach.first[axis]);
  const auto last = static_cast<double>(reach.first[axis] + reach.count[axis]);
  return {static_cast<std::int64_t>(std::clamp(low, first, last)),
          static_cast<std::int64_t>(std::clamp(high, first, last))};
}

/// What a box and a voxel share along an axis [voxels].
double shared(const FilledBox& box, std::size_t axis, std::int64_t voxel) {
  const auto begin = static_cast<double>(voxel);
  return std::max(0.0, std::min(box.high[axis], begin + 1.0) - std::max(box.low[axis], begin));
}

/// The value of the largest box so far, and what it fills.
struct Largest {
  double value, volume;
};

void take_larger(Largest& so_far, const Largest& other) {
  const bool is_equal = std::abs(other.volume - so_far.volume) <= tie * so_far.volume;
  if (is_equal ? other.value < so_far.value : other.volume > so_far.volume) so_far = other;
}

std::size_t numbers_of(Rule rule) { return rule == Rule::mean ? 1 : 2; }

/// Calls use(voxel of the part, voxel of an owner's planes).
template <class Use>
void for_voxels(const Box& part, const std::array<std::int64_t, 3>& size, const Use& use) {
  std::size_t in_part = 0;
  for (std::int64_t k = 0; k < part.count[2]; ++k)
    for (std::int64_t j = 0; j < part.count[1]; ++j) {
      const std::int64_t row = (k * size[1] + part.first[1] + j) * size[0] + part.first[0];
      for (std::int64_t i = 0; i < part.count[0]; ++i)
        use(in_part++, static_cast<std::size_t>(row + i));
    }
}

}  // namespace

BandMeans::BandMeans(const base::Communicator& communicator,
                     const std::array<std::int64_t, 3>& size, std::int64_t first_plane,
                     std::int64_t planes, const Box& reach, std::vector<Rule> rules)
    : communicator_(communicator),
      size_{size[0], size[1], planes},
      reach_(reach),
      rules_(std::move(rules)) {
  reach_.first[2] = first_plane;
  reach_.count[2] = planes;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::int64_t end = std::min(reach.first[axis] + reach.count[axis], size[axis]);
    reach_.first[axis] = std::clamp<std::int64_t>(reach.first[axis], 0, size[axis]);
    reach_.count[axis] = std::max<std::int64_t>(end - reach_.first[axis], 0);
  }
  const auto all = [&](std::int64_t number) { return communicator_.gather(number); };
  const auto x = all(reach_.first[0]), y = all(reach_.first[1]);
  const auto nx = all(reach_.count[0]), ny = all(reach_.count[1]);
  for (std::size_t r = 0; r < x.size(); ++r)
    reach_of_.push_back({{x[r], y[r], first_plane}, {nx[r], ny[r], planes}});

  const auto voxels = static_cast<std::size_t>(reach_.voxels());
  volume_.assign(voxels, 0.0);
  for (const Rule rule : rules_) sums_.emplace_back(voxels * numbers_of(rule), 0.0);
}

bool BandMeans::is_reached_by(const FilledBox& box) const {
  for (const std::size_t axis : {2u, 1u, 0u}) {
    const Range range = touched(box, axis, reach_);
    if (range.begin >= range.end) return false;
  }
  return true;
}

void BandMeans::add(const FilledBox& box, const double* values) {
  const Range x = touched(box, 0, reach_), y = touched(box, 1, reach_), z = touched(box, 2, reach_);
  for (std::int64_t k = z.begin; k < z.end; ++k)
    for (std::int64_t j = y.begin; j < y.end; ++j) {
      const double yz = box.filling * shared(box, 1, j) * shared(box, 2, k);
      const std::int64_t row =
          ((k - reach_.first[2]) * reach_.count[1] + j - reach_.first[1]) * reach_.count[0] -
          reach_.first[0];
      for (std::int64_t i = x.begin; i < x.end; ++i) {
        const auto voxel = static_cast<std::size_t>(row + i);
        const double volume = yz * shared(box, 0, i);
        volume_[voxel] += volume;
        for (std::size_t v = 0; v < rules_.size(); ++v) {
          double* const sum = sums_[v].data() + voxel * numbers_of(rules_[v]);
          if (rules_[v] == Rule::mean) {
            *sum += volume * values[v];
          } else {
            Largest largest{sum[0], sum[1]};
            take_larger(largest, {values[v], volume});
            sum[0] = largest.value;
            sum[1] = largest.volume;
          }
        }
      }
    }
}

/// Calls take(part, sums) on the owners of planes of the band for what each rank in turn has of
/// them; the part's planes are counted from the owner's first. Collective.
template <class Take>
void BandMeans::for_owners(const Sums& sums, std::size_t numbers, const Take& take) const {
  constexpr int tag = 4713;
  const Slabs slabs(size_[2], communicator_.size());
  const auto part_of = [&](int holder, int owner) {
    Box part = reach_of_[static_cast<std::size_t>(holder)];
    part.first[2] = slabs.first(owner);  // within the band
    part.count[2] = slabs.count(owner);
    return part;
  };
  // A message counts whole planes, so that counts fit an int.
  std::vector<MPI_Datatype> types;
  const auto plane_type = [&](const Box& part) {
    types.emplace_back();
    MPI_Type_contiguous(static_cast<int>(part.count[0] * part.count[1] * numbers), MPI_DOUBLE,
                        &types.back());
    MPI_Type_commit(&types.back());
    return types.back();
  };
  const auto begin_of = [&](const Box& part) {
    return sums.data() + part.first[2] * part.count[0] * part.count[1] * numbers;
  };
  std::vector<MPI_Request> open;
  for (int owner = 0; owner < communicator_.size(); ++owner) {
    const Box part = part_of(communicator_.rank(), owner);
    if (owner == communicator_.rank() || part.voxels() == 0) continue;
    open.emplace_back();
    MPI_Isend(begin_of(part), static_cast<int>(part.count[2]), plane_type(part), owner, tag,
              communicator_.raw(), &open.back());
  }
  std::vector<double> arrived;
  for (int holder = 0; holder < communicator_.size(); ++holder) {
    const Box part = part_of(holder, communicator_.rank());
    if (part.voxels() == 0) continue;
    if (holder == communicator_.rank()) {
      take(part, begin_of(part));
      continue;
    }
    arrived.resize(static_cast<std::size_t>(part.voxels()) * numbers);
    MPI_Recv(arrived.data(), static_cast<int>(part.count[2]), plane_type(part), holder, tag,
             communicator_.raw(), MPI_STATUS_IGNORE);
    take(part, arrived.data());
  }
  MPI_Waitall(static_cast<int>(open.size()), open.data(), MPI_STATUSES_IGNORE);
  for (MPI_Datatype& type : types) MPI_Type_free(&type);
}

std::vector<Volume<float>> BandMeans::values() {
  std::vector<double> volume(Volume<double>(communicator_, size_, {}).values);
  for_owners(volume_, 1, [&](const Box& part, const double* sums) {
    for_voxels(part, size_, [&](std::size_t n, std::size_t voxel) { volume[voxel] += sums[n]; });
  });
  std::vector<Volume<float>> values;
  for (std::size_t v = 0; v < rules_.size(); ++v) {
    values.push_back(rules_[v] == Rule::mean ? means(sums_[v], volume) : largest(sums_[v], volume));
    sums_[v] = {};
  }
  return values;
}

Volume<float> BandMeans::means(const Sums& sums, const std::vector<double>& volume) const {
  std::vector<double> sum(volume.size(), 0.0);
  for_owners(sums, 1, [&](const Box& part, const double* of_holder) {
    for_voxels(part, size_, [&](std::size_t n, std::size_t voxel) { sum[voxel] += of_holder[n]; });
  });
  Volume<float> means(communicator_, size_, {});
  for (std::size_t n = 0; n < sum.size(); ++n)
    means.values[n] = is_filled(volume[n]) ? static_cast<float>(sum[n] / volume[n])
                                           : std::numeric_limits<float>::quiet_NaN();
  return means;
}

Volume<float> BandMeans::largest(const Sums& sums, const std::vector<double>& volume) const {
  std::vector<Largest> largest(volume.size(), Largest{-1.0, 0.0});
  for_owners(sums, 2, [&](const Box& part, const double* of_holder) {
    for_voxels(part, size_, [&](std::size_t n, std::size_t voxel) {
      take_larger(largest[voxel], {of_holder[2 * n], of_holder[2 * n + 1]});
    });
  });
  Volume<float> values(communicator_, size_, {});
  for (std::size_t n = 0; n < largest.size(); ++n)
    values.values[n] = is_filled(volume[n]) ? static_cast<float>(largest[n].value) : -1.0f;
  return values;
}

}  // namespace stroma::voxels
