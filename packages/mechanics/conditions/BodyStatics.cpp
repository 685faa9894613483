// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/BodyStatics.hpp"

#include <algorithm>
#include <map>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/particles/Exchange.hpp"

namespace stroma::mechanics {
namespace {

using base::format;

/// The rank that owns a node.
int owner_of(const grid::Partition& partition, std::int64_t node_number) {
  int lower = 0, upper = partition.ranks();
  while (upper - lower > 1) {
    const int middle = (lower + upper) / 2;
    (partition.first_node(middle) <= node_number ? lower : upper) = middle;
  }
  return lower;
}

/// A piece of this rank with something to say of it.
struct Remark {
  std::int64_t elements = 0, label = -1;
  std::string text;
};

/// Keeps what is said of the largest piece.
void keep_larger(Remark& kept, const PieceSums& piece, const std::string& text) {
  if (piece.elements < kept.elements ||
      (piece.elements == kept.elements && piece.label <= kept.label))
    return;
  kept = {piece.elements, piece.label, text};
}

/// What is said of the largest piece of all ranks; "" if nothing is.
std::string largest_of_all(const base::Communicator& communicator, const Remark& mine) {
  const std::int64_t elements = communicator.max(mine.elements);
  const std::int64_t label = communicator.max(mine.elements == elements ? mine.label : -1);
  if (label < 0) return "";
  const int speaker =
      communicator.min(mine.label == label ? communicator.rank() : communicator.size());
  std::string text = mine.text;
  communicator.broadcast(text, speaker);
  return text;
}

}  // namespace

BodyStatics::BodyStatics(const grid::Halo& halo, const Pieces& pieces, const grid::Grid& body,
                         std::size_t loads)
    : halo_(halo), pieces_(pieces), loads_(loads), sums_(static_cast<std::size_t>(pieces.count())) {
  frame_.length = 0.0;
  for (int d = 0; d < 3; ++d) {
    frame_.centre[static_cast<std::size_t>(d)] =
        body.origin[static_cast<std::size_t>(d)] + 0.5 * body.length(d);
    frame_.length = std::max(frame_.length, 0.5 * body.length(d));
  }
  for (int piece = 0; piece < pieces.count(); ++piece) sums(piece).label = pieces.label(piece);
}

void BodyStatics::add_element(int piece, std::int64_t particles, const std::array<double, 3>& lower,
                              const std::array<double, 3>& upper) {
  PieceSums& sum = sums(piece);
  ++sum.elements;
  sum.particles += particles;
  for (std::size_t d = 0; d < 3; ++d) {
    sum.lower[d] = std::min(sum.lower[d], lower[d]);
    sum.upper[d] = std::max(sum.upper[d], upper[d]);
  }
}

void BodyStatics::add_held(const HeldComponent& held) {
  sums(held.piece).add_held(frame_, held.at, held.rate);
  if (held.turns) sums(held.piece).turned += 1.0;
  if (held.condition >= 0 && held.rate != 0.0) moved_.emplace(held.condition, held.piece);
}

void BodyStatics::add_load(int piece, const std::array<double, 3>& position,
                           const std::array<double, 3>& force) {
  sums(piece).add_load(frame_, position, force);
}

void BodyStatics::complete() {
  if (halo_.communicator().size() > 1) exchange_shared();
  for (const PieceSums& piece : sums_) verdicts_.push_back(judge(piece, frame_));
  compare();
}

/// The owner of the node that a piece is named after adds up the parts of all ranks, in their
/// order, and sends the sums back to them.
void BodyStatics::exchange_shared() {
  const base::Communicator& communicator = halo_.communicator();
  struct Part {
    int rank;
    PieceSums sums;
  };
  std::vector<std::vector<Part>> parts(static_cast<std::size_t>(communicator.size()));
  for (int piece = 0; piece < pieces_.count(); ++piece)
    if (pieces_.is_shared(piece))
      parts[static_cast<std::size_t>(owner_of(halo_.partition(), pieces_.label(piece)))].push_back(
          {communicator.rank(), sums(piece)});
  const std::vector<Part> received = particles::exchange(communicator, parts);
  std::map<std::int64_t, PieceSums> whole;
  for (const Part& part : received) {
    const auto found = whole.emplace(part.sums.label, part.sums);
    if (!found.second) found.first->second.add(part.sums);
  }
  std::vector<std::vector<PieceSums>> replies(parts.size());
  for (const Part& part : received)
    replies[static_cast<std::size_t>(part.rank)].push_back(whole.at(part.sums.label));
  for (const PieceSums& sum : particles::exchange(communicator, replies))
    sums(pieces_.find(sum.label)) = sum;
}

/// Each piece counts where the node that it is named after is owned.
void BodyStatics::compare() {
  const base::Communicator& communicator = halo_.communicator();
  PieceSums whole;
  std::vector<int> mine;
  bool mine_are_solved = false;
  for (int piece = 0; piece < pieces_.count(); ++piece) {
    if (owner_of(halo_.partition(), pieces_.label(piece)) != communicator.rank()) continue;
    mine.push_back(piece);
    whole.add(sums(piece));
    mine_are_solved = mine_are_solved || !verdict(piece).is_idle;
  }
  some_are_solved_ = communicator.any(mine_are_solved);

  Remark largest;
  std::vector<std::int64_t> free;
  for (const int piece : mine) {
    if (!is_carried(piece) && verdict(piece).has_free_motion) free.push_back(sums(piece).label);
    if (!is_carried(piece)) continue;
    ++summary_.carried;
    summary_.carried_elements += sums(piece).elements;
    summary_.carried_particles += sums(piece).particles;
    keep_larger(largest, sums(piece), describe(sums(piece)));
  }
  const std::vector<std::vector<std::int64_t>> to_all(static_cast<std::size_t>(communicator.size()),
                                                      free);
  free_pieces_ = particles::exchange(communicator, to_all);
  std::sort(free_pieces_.begin(), free_pieces_.end());

  summary_.count = communicator.sum(static_cast<std::int64_t>(mine.size()));
  summary_.elements = communicator.sum(whole.elements);
  summary_.particles = communicator.sum(whole.particles);
  summary_.carried = communicator.sum(summary_.carried);
  summary_.carried_elements = communicator.sum(summary_.carried_elements);
  summary_.carried_particles = communicator.sum(summary_.carried_particles);
  summary_.largest_carried = largest_of_all(communicator, largest);

  communicator.sum_all(whole.held.data(), whole.held.size());
  communicator.sum_all(whole.forced.data(), whole.forced.size());
  communicator.sum_all(whole.squares.data(), whole.squares.size());
  const double squares = whole.squares[0] + whole.squares[1] + whole.squares[2];
  would_strain_whole_ = is_misfit(HeldMotions(whole.held).misfit(whole.forced, squares), squares);
}

void BodyStatics::refuse_what_moves(const std::vector<std::string>& conditions,
                                    bool with_moments) const {
  refuse_gaps(conditions);
  refuse_loads(with_moments);
}

void BodyStatics::refuse_loads(bool with_moments) const {
  Remark largest;
  for (int piece = 0; piece < pieces_.count(); ++piece) {
    if (!verdict(piece).has_free_motion) continue;
    const PieceSums& one = sums_[static_cast<std::size_t>(piece)];
    const bool is_one_load = loads_ <= 1;
    const std::string resultant = free_resultant(one, frame_, with_moments, is_one_load);
    if (resultant.empty()) continue;
    const bool is_whole = summary_.count == 1;
    keep_larger(
        largest, one,
        std::string("External Forces: ") +
            (is_one_load ? "they have a resultant "
                         : "their load curves differ, and at some load they have a resultant ") +
            resultant + ", and nothing holds " +
            (is_whole ? "the body" : "the piece of the body on which they act") +
            " against that motion" +
            (is_whole ? "" : " (" + describe(one) + "; " + other_pieces() + ")") +
            "; admissible: a boundary condition that does, or forces in balance" +
            (is_whole ? "" : ", or an image without that piece"));
  }
  const std::string refusal = largest_of_all(halo_.communicator(), largest);
  if (!refusal.empty()) throw base::InputError(refusal);
}

void BodyStatics::refuse_gaps(const std::vector<std::string>& conditions) const {
  if (summary_.count < 2 || !would_strain_whole_) return;
  std::vector<int> strains(conditions.size() + 1, 0), moves(conditions.size() + 1, 0);
  for (const auto& [condition, piece] : moved_) {
    moves[static_cast<std::size_t>(condition)] = 1;
    if (verdict(piece).is_strained) strains[static_cast<std::size_t>(condition)] = 1;
  }
  halo_.communicator().sum_all(moves.data(), moves.size());
  halo_.communicator().sum_all(strains.data(), strains.size());
  for (std::size_t m = 0; m < conditions.size(); ++m) {
    if (moves[m] == 0 || strains[m] > 0) continue;
    Remark largest;
    for (const auto& [condition, piece] : moved_)
      if (static_cast<std::size_t>(condition) == m)
        keep_larger(largest, sums_[static_cast<std::size_t>(piece)],
                    describe(sums_[static_cast<std::size_t>(piece)]));
    throw base::InputError("Boundary Conditions|" + conditions[m] +
                           ": it strains nothing, for what it moves is connected with no other "
                           "condition: a piece of " +
                           "the body of " + largest_of_all(halo_.communicator(), largest) + " (" +
                           other_pieces() +
                           "); admissible: a body in one piece between its supports");
  }
}

/// How many other pieces there are beside one.
std::string BodyStatics::other_pieces() const {
  const auto others = static_cast<long long>(summary_.count - 1);
  return format("it shares no node of the grid with the %s",
                others == 1 ? "other piece" : format("%lld other pieces", others).c_str());
}

}  // namespace stroma::mechanics
