// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/Pieces.hpp"

#include <algorithm>

#include "stroma/base/DisjointSets.hpp"

namespace stroma::mechanics {
namespace {

/// Calls visit(element, touched node) for each node that an element's particles touch.
template <class Visit>
void for_each_touched(const transfer::ElementBox& box, int width,
                      const transfer::TouchedNodes<grid::Device>::HostMirror& touched,
                      const Visit& visit) {
  for (int k = 0; k < box.elements[2]; ++k)
    for (int j = 0; j < box.elements[1]; ++j)
      for (int i = 0; i < box.elements[0]; ++i) {
        const int element = box.element(i, j, k);
        for (int a = 0; a < width * width * width; ++a)
          if (touched(element, a / 64) >> a % 64 & 1)
            visit(element, box.node(i + a % width, j + a / width % width, k + a / (width * width)));
      }
}

/// Takes up nodes that this rank owns and only the particles of other ranks touch, each as a set of
/// its own.
void add_nodes_touched_elsewhere(const grid::Halo& halo, std::vector<int>& set_of_node) {
  const int rank = halo.communicator().rank();
  const grid::Box owned = halo.partition().owned_nodes(rank);
  const grid::Box touched = halo.partition().touched_nodes(rank);
  grid::Vector is_touched(halo.owned_map());
  const grid::NodeView mine = halo.contributions();
  const auto mine_on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), mine);
  for (std::size_t n = 0; n < set_of_node.size(); ++n)
    if (set_of_node[n] != Pieces::none) mine_on_host(n, 0) = 1.0;
  Kokkos::deep_copy(mine, mine_on_host);
  halo.largest_to_owner(is_touched);
  const auto all =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), grid::node_view(is_touched));
  for (std::int64_t n = 0; n < owned.count(); ++n) {
    const auto node = static_cast<std::size_t>(touched.local(owned.index(n)));
    if (all(n, 0) > 0.0 && set_of_node[node] == Pieces::none)
      set_of_node[node] = static_cast<int>(node);
  }
}

/// Lets the labels of sets that meet at nodes of several ranks grow to the largest of them.
void agree(const grid::Halo& halo, const std::vector<int>& set_of_node,
           std::vector<std::int64_t>& label) {
  grid::Vector largest(halo.owned_map());
  bool has_grown = true;
  while (halo.communicator().any(has_grown)) {
    const grid::NodeView mine = halo.contributions();
    const auto mine_on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), mine);
    for (std::size_t n = 0; n < set_of_node.size(); ++n)
      if (set_of_node[n] != Pieces::none)
        mine_on_host(n, 0) =
            static_cast<double>(label[static_cast<std::size_t>(set_of_node[n])] + 1);
    Kokkos::deep_copy(mine, mine_on_host);
    halo.largest_to_owner(largest);
    const auto all = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), halo.gather(largest));
    has_grown = false;
    for (std::size_t n = 0; n < set_of_node.size(); ++n) {
      if (set_of_node[n] == Pieces::none) continue;
      std::int64_t& own = label[static_cast<std::size_t>(set_of_node[n])];
      const std::int64_t seen = static_cast<std::int64_t>(all(n, 0)) - 1;
      has_grown = has_grown || seen > own;
      own = std::max(own, seen);
    }
  }
}

/// Whether a node lies where the touched nodes of several ranks meet.
bool is_at_border(const grid::Partition& partition, int rank, const grid::Index3& node) {
  const grid::Box elements = partition.elements(rank);
  const grid::Box all = partition.grid().all_elements();
  for (int d = 0; d < 3; ++d) {
    const int beyond = partition.grid().beyond(d);
    if (elements.begin[d] > all.begin[d] && node[d] < elements.begin[d] + beyond) return true;
    if (elements.end[d] < all.end[d] && node[d] >= elements.end[d]) return true;
  }
  return false;
}

}  // namespace

Pieces::Pieces(const grid::Halo& halo, const transfer::ElementBox& box,
               const transfer::TouchedNodes<grid::Device>& touched) {
  const grid::Partition& partition = halo.partition();
  const int rank = halo.communicator().rank();
  const int width = partition.grid().width;
  const grid::Box nodes = partition.touched_nodes(rank);
  const auto count = static_cast<std::size_t>(nodes.count());
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), touched);

  base::DisjointSets sets(count);
  of_element_.assign(touched.extent(0), none);  // at first, one of its nodes
  of_node_.assign(count, none);
  for_each_touched(box, width, on_host, [&](int element, int node) {
    int& first = of_element_[static_cast<std::size_t>(element)];
    if (first == none) first = node;
    sets.join(first, node);
    of_node_[static_cast<std::size_t>(node)] = node;
  });

  if (halo.communicator().size() > 1) add_nodes_touched_elsewhere(halo, of_node_);

  // Sets get numbers, and as labels the largest numbers of their nodes.
  std::vector<int> set_of_root(count, none);
  std::vector<std::int64_t> label;
  for (std::size_t n = 0; n < count; ++n) {
    if (of_node_[n] == none) continue;
    int& set = set_of_root[static_cast<std::size_t>(sets.root(static_cast<int>(n)))];
    if (set == none) {
      set = static_cast<int>(label.size());
      label.push_back(0);
    }
    of_node_[n] = set;
    std::int64_t& largest = label[static_cast<std::size_t>(set)];
    largest = std::max<std::int64_t>(
        largest, halo.touched_map()->getGlobalElement(static_cast<int>(3 * n)) / 3);
  }
  if (halo.communicator().size() > 1) agree(halo, of_node_, label);

  label_ = label;
  std::sort(label_.begin(), label_.end());
  label_.erase(std::unique(label_.begin(), label_.end()), label_.end());
  is_shared_.assign(label_.size(), 0);
  std::vector<int> piece_of_set;
  for (const std::int64_t one : label) piece_of_set.push_back(find(one));
  for (int& piece : of_element_)
    if (piece != none)
      piece = piece_of_set[static_cast<std::size_t>(of_node_[static_cast<std::size_t>(piece)])];
  for (std::size_t n = 0; n < count; ++n) {
    if (of_node_[n] == none) continue;
    of_node_[n] = piece_of_set[static_cast<std::size_t>(of_node_[n])];
    if (is_at_border(partition, rank, nodes.index(static_cast<std::int64_t>(n))))
      is_shared_[static_cast<std::size_t>(of_node_[n])] = 1;
  }
}

int Pieces::find(std::int64_t label) const {
  const auto found = std::lower_bound(label_.begin(), label_.end(), label);
  return found != label_.end() && *found == label ? static_cast<int>(found - label_.begin()) : none;
}

}  // namespace stroma::mechanics
