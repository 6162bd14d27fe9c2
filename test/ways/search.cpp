// SPDX-License-Identifier: BSD-3-Clause
#include "ways/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_ways {

Search::Search(const Ground& ground, const Lattice& lattice, const Shape& shape, const Make& make)
    : ground_(ground),
      lattice_(lattice),
      make_(make),
      outlines_(turned_to(lattice, shape, make.fineness)),
      found_(lattice.size()) {
  // Longer than a cell's diagonal: each leads to another cell.
  const double length = 1.5 * lattice.step();
  for (const int turn : {-1, 1}) add_step(0.0, turn);
  for (const int turn : {0, -1, 1, -2, 2}) {
    add_step(length, turn);
    if (make.reverse) add_step(-length, turn);
  }
}

void Search::add_step(double length, int turn) {
  const double sign = make_.undo ? -1.0 : 1.0;
  Step step;
  step.turn = make_.undo ? -turn : turn;
  step.move = {sign * length, step.turn * lattice_.turn()};
  step.length = static_cast<float>(std::abs(length));
  step.cost = static_cast<float>(std::abs(length) + kCostOfTurn * std::abs(turn) * lattice_.turn());
  step.parts = turn == 0 ? std::min(2, make_.fineness) : make_.fineness * std::abs(turn);
  step.first = shifts_.size();
  steps_.push_back(step);
  for (int k = 0; k < lattice_.headings(); ++k) {
    for (int part = 1; part <= step.parts; ++part) {
      const Pose2 to = after({0.0, 0.0, lattice_.heading(k)}, step.move, static_cast<double>(part) / step.parts);
      shifts_.push_back({to.x, to.y});
    }
  }
}

bool Search::free(double x, double y, int part_of_turn) const {
  const int count = make_.fineness * lattice_.headings();
  const auto outline = static_cast<std::size_t>((part_of_turn % count + count) % count);
  return lattice_.region().has(x, y) && !ground_.overlaps(outlines_[outline], x, y);
}

bool Search::free_along(const Node& from, const Step& step) const {
  const int sign = step.turn > 0 ? 1 : step.turn < 0 ? -1 : 0;
  for (int part = step.parts; part > 0; --part) {
    const Shift& by = shift(from, step, part);
    if (!free(from.x + by.x, from.y + by.y, make_.fineness * from.heading + sign * part)) return false;
  }
  return true;
}

void Search::push(int node, double ahead) {
  const float cost = nodes_[static_cast<std::size_t>(node)].cost;
  queue_.push_back({static_cast<float>(cost + ahead), node, cost});
  std::push_heap(queue_.begin(), queue_.end());
}

int Search::next() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Entry entry = queue_.back();
    queue_.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    if (node.open && node.cost == entry.cost) return entry.node;
  }
  return -1;
}

void Search::begin_at(double x, double y, int k) {
  if (!free(x, y, make_.fineness * k)) return;
  Found& found = found_[lattice_.index(lattice_.column(x), lattice_.row(y), k)];
  if (found.node >= 0) return;
  found = {0.0F, static_cast<std::int32_t>(nodes_.size())};
  Node node;
  node.x = x;
  node.y = y;
  node.heading = static_cast<std::int16_t>(k);
  nodes_.push_back(node);
  push(found.node, 0.0);
}

// The node that a step leads to; -1 where it leads nowhere that is new, cheaper and free.
int Search::reach(const Node& from, int from_index, std::size_t step) {
  const Step& taken = steps_[step];
  const float cost = from.cost + taken.cost, length = from.length + taken.length;
  if (length > static_cast<float>(make_.longest)) return -1;
  const Shift& by = shift(from, taken, taken.parts);
  const double x = from.x + by.x, y = from.y + by.y;
  if (!lattice_.region().has(x, y)) return -1;
  const int k = lattice_.wrap(from.heading + taken.turn);
  Found& found = found_[lattice_.index(lattice_.column(x), lattice_.row(y), k)];
  if (found.cost <= cost + 1e-5F) return -1;
  if (!free_along(from, taken)) return -1;
  // A new node, not the old one changed: others were reached from that.
  if (found.node >= 0) nodes_[static_cast<std::size_t>(found.node)].open = false;
  found = {cost, static_cast<std::int32_t>(nodes_.size())};
  nodes_.push_back(
      {x, y, cost, length, from_index, static_cast<std::int16_t>(k), static_cast<std::int8_t>(step), true});
  return found.node;
}

Way Search::way_to(int node) const {
  Way way;
  const Node* at = &nodes_[static_cast<std::size_t>(node)];
  for (; at->from >= 0; at = &nodes_[static_cast<std::size_t>(at->from)])
    way.moves.push_back(steps_[static_cast<std::size_t>(at->move)].move);
  std::reverse(way.moves.begin(), way.moves.end());
  way.start = {at->x, at->y, lattice_.heading(at->heading)};
  return way;
}

double Search::cost_near(const Pose2& pose) const {
  const int column = lattice_.column(pose.x), row = lattice_.row(pose.y), k = lattice_.turned(pose.theta);
  double least = std::numeric_limits<double>::infinity();
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      for (int turn = k - 1; turn <= k + 1 && lattice_.has(i, j); ++turn)
        least = std::min(least, cost_of(i, j, lattice_.wrap(turn)));
    }
  }
  return least;
}

}  // namespace hidwa_ways
