// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/tables/Distributions.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace stroma::output {
namespace {

/// A number in the order of the doubles.
std::int64_t rank_of(double value) {
  std::int64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

double double_of(std::int64_t rank) {
  const std::int64_t bits = rank >= 0 ? rank : std::numeric_limits<std::int64_t>::min() - rank;
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// Between two numbers, rounded down, without overflow.
std::int64_t middle_of(std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(
                   (static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low)) / 2);
}

/// The smallest of all ranks', for each number.
void minimum_of_all(const base::Communicator& communicator, std::vector<double>& values) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MIN,
                communicator.raw());
}

/// A quantity of the portions of this rank.
struct Portions {
  const Groups& groups;
  const std::vector<double>&volume, &value;

  /// Calls use(group, value, volume) for those that belong to a group.
  template <class Use>
  void operator()(const Use& use) const {
    for (std::size_t p = 0; p < groups.of.size(); ++p)
      if (groups.of[p] != Groups::none) use(std::size_t{groups.of[p]}, value[p], volume[p]);
  }
};

std::vector<Distribution> sums_and_ends(const base::Communicator& communicator,
                                        const Portions& portions) {
  std::vector<double> sums(2 * portions.groups.count, 0.0);
  std::vector<double> ends(sums.size(), HUGE_VAL);  // minimum and -maximum
  portions([&](std::size_t g, double value, double volume) {
    sums[2 * g] += volume;
    sums[2 * g + 1] += value * volume;
    ends[2 * g] = std::min(ends[2 * g], value);
    ends[2 * g + 1] = std::min(ends[2 * g + 1], -value);
  });
  communicator.sum_all(sums.data(), sums.size());
  minimum_of_all(communicator, ends);
  std::vector<Distribution> found(portions.groups.count);
  for (std::size_t g = 0; g < found.size(); ++g) {
    if (!(sums[2 * g] > 0.0)) continue;
    found[g].volume = sums[2 * g];
    found[g].mean = sums[2 * g + 1] / sums[2 * g];
    found[g].minimum = ends[2 * g];
    found[g].maximum = -ends[2 * g + 1];
  }
  return found;
}

/// Equal parts of the bins of each group, and the volume in each.
class Buckets {
 public:
  Buckets(const base::Communicator& communicator, const Portions& portions,
          const std::vector<Distribution>& of)
      : of_(&of),
        of_bin_(std::clamp<std::size_t>(16384 / of.size(), 1, 64)),
        volume_(of.size() * count(), 0.0) {
    portions([&](std::size_t g, double value, double volume) { volume_[at(g, value)] += volume; });
    communicator.sum_all(volume_.data(), volume_.size());
  }

  std::size_t size() const { return volume_.size(); }
  /// The bucket of a value of a group.
  std::size_t at(std::size_t group, double value) const {
    const Distribution& of = (*of_)[group];
    const double range = of.maximum - of.minimum;
    if (!(range > 0.0)) return group * count();
    const auto parts = static_cast<double>(of_bin_);
    const double place = (value - of.minimum) / range * Distribution::bin_count * parts;
    return group * count() + std::min(static_cast<std::size_t>(place + 1e-9 * parts), count() - 1);
  }
  std::array<double, Distribution::bin_count> bins(std::size_t group) const {
    std::array<double, Distribution::bin_count> bins{};
    for (std::size_t b = 0; b < count(); ++b) bins[b / of_bin_] += volume_[group * count() + b];
    return bins;
  }
  /// The bucket of a group in which a volume is reached, and the volume before it.
  std::pair<std::size_t, double> reaching(std::size_t group, double wanted) const {
    std::size_t bucket = group * count();
    const std::size_t last = bucket + count() - 1;
    double before = 0.0;
    for (; bucket < last && before + volume_[bucket] < wanted; ++bucket) before += volume_[bucket];
    return {bucket, before};
  }

 private:
  std::size_t count() const { return Distribution::bin_count * of_bin_; }

  const std::vector<Distribution>* of_;
  std::size_t of_bin_;
  std::vector<double> volume_;
};

struct Candidate {
  double value, volume_up_to;
};

/// A percentile, which is known to be in some bucket.
struct Search {
  std::size_t bucket;
  double wanted;           // volume within the bucket
  std::int64_t low, high;  // it is in (low, high]

  bool is_open() const { return low + 1 != high; }
};

/// (bucket that is searched, ...) what this rank has in it, ascending; empty for the others.
std::vector<std::vector<Candidate>> candidates_of(const Portions& portions, const Buckets& buckets,
                                                  const std::vector<Search>& searches) {
  std::vector<char> is_searched(buckets.size(), 0);
  for (const Search& search : searches) is_searched[search.bucket] = 1;
  std::vector<std::vector<Candidate>> candidates(buckets.size());
  portions([&](std::size_t g, double value, double volume) {
    const std::size_t bucket = buckets.at(g, value);
    if (is_searched[bucket] != 0) candidates[bucket].push_back({value, volume});
  });
  for (std::vector<Candidate>& some : candidates) {
    std::sort(some.begin(), some.end(),
              [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
    double volume = 0.0;
    for (Candidate& one : some) one.volume_up_to = volume += one.volume_up_to;
  }
  return candidates;
}

double volume_up_to(const std::vector<Candidate>& some, double value) {
  const auto behind =
      std::upper_bound(some.begin(), some.end(), value,
                       [](double v, const Candidate& one) { return v < one.value; });
  return behind == some.begin() ? 0.0 : (behind - 1)->volume_up_to;
}

/// Bisects all searches at once.
void finish(const base::Communicator& communicator,
            const std::vector<std::vector<Candidate>>& candidates, std::vector<Search>& searches) {
  std::vector<double> ends;  // minimum and -maximum
  for (const Search& search : searches) {
    const std::vector<Candidate>& some = candidates[search.bucket];
    ends.push_back(some.empty() ? HUGE_VAL : some.front().value);
    ends.push_back(some.empty() ? HUGE_VAL : -some.back().value);
  }
  minimum_of_all(communicator, ends);
  for (std::size_t s = 0; s < searches.size(); ++s) {
    const bool is_empty = ends[2 * s] == HUGE_VAL;  // as is its group
    searches[s].low = rank_of(is_empty ? 0.0 : ends[2 * s]) - 1;
    searches[s].high = rank_of(is_empty ? 0.0 : -ends[2 * s + 1]);
  }
  std::vector<double> volume(searches.size());
  const auto is_open = [](const Search& search) { return search.is_open(); };
  while (std::any_of(searches.begin(), searches.end(), is_open)) {
    for (std::size_t s = 0; s < searches.size(); ++s)
      volume[s] = volume_up_to(candidates[searches[s].bucket],
                               double_of(middle_of(searches[s].low, searches[s].high)));
    communicator.sum_all(volume.data(), volume.size());
    for (std::size_t s = 0; s < searches.size(); ++s) {
      Search& search = searches[s];
      if (!search.is_open()) continue;
      (volume[s] >= search.wanted ? search.high : search.low) = middle_of(search.low, search.high);
    }
  }
}

}  // namespace

std::vector<Distribution> distributions(const base::Communicator& communicator,
                                        const Groups& groups, const std::vector<double>& volume,
                                        const std::vector<double>& values,
                                        const std::vector<double>& shares) {
  if (groups.count == 0) return {};
  const Portions portions{groups, volume, values};
  std::vector<Distribution> found = sums_and_ends(communicator, portions);
  const Buckets buckets(communicator, portions, found);
  std::vector<Search> searches;
  for (std::size_t g = 0; g < found.size(); ++g) {
    found[g].bins = buckets.bins(g);
    for (const double share : shares) {
      const double wanted = (share - 1e-10) * found[g].volume;
      const auto [bucket, before] = buckets.reaching(g, wanted);
      searches.push_back({bucket, wanted - before, 0, 0});
    }
  }
  finish(communicator, candidates_of(portions, buckets, searches), searches);
  for (std::size_t s = 0; s < searches.size(); ++s)
    found[s / shares.size()].percentiles.push_back(double_of(searches[s].high));
  return found;
}

}  // namespace stroma::output
