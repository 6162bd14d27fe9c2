// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/obstacle_clusters.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

constexpr int kNoCluster = -1, kUnnumbered = -1;

template <typename Visit>
void visit_neighbours(Cell cell, Visit&& visit) {
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      if (di != 0 || dj != 0) visit(Cell{cell.i + di, cell.j + dj});
    }
  }
}

}  // namespace

bool ObstacleClusters::inside(Cell cell) const {
  return static_cast<unsigned>(cell.i - window_.first.i) < static_cast<unsigned>(window_.size) &&
         static_cast<unsigned>(cell.j - window_.first.j) < static_cast<unsigned>(window_.size);
}

std::size_t ObstacleClusters::index(Cell cell) const {
  return static_cast<std::size_t>(cell.j - window_.first.j) * static_cast<std::size_t>(window_.size) +
         static_cast<std::size_t>(cell.i - window_.first.i);
}

// Those in the midst of others are never come upon first.
bool ObstacleClusters::edge(Cell cell) const {
  return !window_.obstacle({cell.i + 1, cell.j}) || !window_.obstacle({cell.i - 1, cell.j}) ||
         !window_.obstacle({cell.i, cell.j + 1}) || !window_.obstacle({cell.i, cell.j - 1});
}

void ObstacleClusters::gather(const Window& window, const std::vector<Overlap>& overlaps, int steps) {
  window_ = window;
  half_ = 0.5 * window.map.resolution;
  marks_.assign(static_cast<std::size_t>(window.size) * static_cast<std::size_t>(window.size), kNoCluster);
  members_.clear();
  add_overlapped(overlaps);
  std::size_t ring = 0;
  for (int step = 0; step < steps; ++step) {
    const std::size_t next = members_.size();
    add_ring(ring, step == 0);
    ring = next;
  }
  raise_overlapped(overlaps);
  number_clusters();
}

// The depths have been handed on: now what the robot may do in the overlapped cells themselves.
void ObstacleClusters::raise_overlapped(const std::vector<Overlap>& overlaps) {
  for (std::size_t k = 0; k < overlaps.size(); ++k) {
    Member& member = members_[k];
    visit_neighbours(member.cell, [&](Cell beside) {
      if (!inside(beside) || !holds(beside)) return;
      const auto from = static_cast<std::size_t>(marks_[index(beside)]);
      if (from < overlaps.size()) member.limit = std::max(member.limit, std::min(half_, overlaps[from].depth));
    });
    member.near_limit = member.limit;
  }
}

void ObstacleClusters::add(const Member& member) {
  marks_[index(member.cell)] = static_cast<int>(members_.size());
  members_.push_back(member);
}

void ObstacleClusters::add_overlapped(const std::vector<Overlap>& overlaps) {
  for (const Overlap& overlap : overlaps) {
    const double depth = std::max(overlap.depth, 0.0);
    add({overlap.cell, depth, depth, kUnnumbered});
  }
}

// The neighbours of the members from `begin` on.
void ObstacleClusters::add_ring(std::size_t begin, bool first) {
  const std::size_t end = members_.size();
  for (std::size_t m = begin; m < end; ++m) {
    const double limit = std::min(half_, members_[m].limit);
    visit_neighbours(members_[m].cell, [&](Cell cell) { reach(cell, end, limit, first ? limit : 0.0); });
  }
}

// From one of its neighbours; from the deepest where it has more of them. `ring` is where the new members begin.
void ObstacleClusters::reach(Cell cell, std::size_t ring, double limit, double near_limit) {
  if (!inside(cell)) return;
  const int known = marks_[index(cell)];
  if (known == kNoCluster) {
    if (window_.obstacle(cell) && edge(cell)) add({cell, limit, near_limit, kUnnumbered});
    return;
  }
  if (static_cast<std::size_t>(known) < ring) return;
  Member& member = members_[static_cast<std::size_t>(known)];
  member.limit = std::max(member.limit, limit);
  member.near_limit = std::max(member.near_limit, near_limit);
}

void ObstacleClusters::number_clusters() {
  int clusters = 0;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (members_[m].cluster == kUnnumbered) spread_number(m, clusters++);
  }
  std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
    if (a.cluster != b.cluster) return a.cluster < b.cluster;
    return a.cell.j != b.cell.j ? a.cell.j < b.cell.j : a.cell.i < b.cell.i;
  });
  for (std::size_t m = 0; m < members_.size(); ++m) marks_[index(members_[m].cell)] = static_cast<int>(m);
}

void ObstacleClusters::spread_number(std::size_t from, int number) {
  members_[from].cluster = number;
  open_.assign(1, from);
  while (!open_.empty()) {
    const Cell here = members_[open_.back()].cell;
    open_.pop_back();
    visit_neighbours(here, [&](Cell cell) {
      if (!inside(cell) || !holds(cell)) return;
      Member& member = members_[static_cast<std::size_t>(marks_[index(cell)])];
      if (member.cluster != kUnnumbered) return;
      member.cluster = number;
      open_.push_back(static_cast<std::size_t>(marks_[index(cell)]));
    });
  }
}

}  // namespace hidwa_local_planner
