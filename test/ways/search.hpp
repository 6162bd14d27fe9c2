// SPDX-License-Identifier: BSD-3-Clause
// The exhaustive search over (x, y, heading), with the robot's outline: hybrid A* (Dolgov et al. 2008) carried on until
// nothing is left to look at.
//
// 1. A node is a pose that a robot reaches exactly. Each cell of the lattice keeps the cheapest pose found in it.
// 2. From a node lead: turns on the spot by one heading, short lines, and arcs by one and two headings; backwards too,
//    where the robot can.
// 3. A move counts where the outline overlaps no lethal cell, at its end and in steps on its way.
// 4. The cheapest node is expanded first. The cost is the length [m], and a little for turning.
//
// A way that it finds is a way: its poses are those of the moves, not of the cells. That there is none it cannot say
// for certain, since a cell keeps one pose of many; see proof.hpp.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ways/lattice.hpp"
#include "ways/way.hpp"

namespace hidwa_ways {

/// Of equally long ways the one with less turning is the shorter one [m/rad].
constexpr double kCostOfTurn = 0.05;

class Search {
 public:
  struct Make {
    bool reverse = false;  // the robot drives backwards too
    bool undo = false;     // moves are taken back: from where it is led to, not where it leads
    double longest = 3.0;  // of a way [m]
    int fineness = 1;      // the outline is looked at so many times a heading of a turn
  };
  /// `ground` must outlive it. `shape` with its margin.
  Search(const Ground& ground, const Lattice& lattice, const Shape& shape, const Make& make);

  /// Where it begins; not where the outline overlaps something.
  void begin_at(double x, double y, int k);
  /// Expands the cheapest node until `done` says so of it, or nothing is left. `ahead` [m] estimates the cost that is
  /// left, and decides the order alone.
  template <typename Done, typename Ahead>
  int run(Done&& done, Ahead&& ahead) {
    for (int node = next(); node >= 0; node = next()) {
      if (done(nodes_[static_cast<std::size_t>(node)])) return node;
      expand(node, ahead);
    }
    return -1;
  }

  struct Node {
    double x = 0.0, y = 0.0;           // [m]
    float cost = 0.0F, length = 0.0F;  // [m]
    std::int32_t from = -1;            // the node it was reached from
    std::int16_t heading = 0;          // of the lattice
    std::int8_t move = -1;             // by which it was reached
    bool open = true;
  };
  /// The way that led to a node.
  Way way_to(int node) const;
  /// The least cost of what was found at a pose, in its cell and those beside it [m]; infinite where nothing was.
  double cost_near(const Pose2& pose) const;
  /// The same in its own cell alone, of a search that begins anywhere on the same lattice.
  double cost_at(const Node& node) const {
    return cost_of(lattice_.column(node.x), lattice_.row(node.y), node.heading);
  }

 private:
  struct Step {
    Move move;
    int turn = 0;                      // headings
    float length = 0.0F, cost = 0.0F;  // [m]
    int parts = 1;                     // in which it is looked at
    std::size_t first = 0;             // of its shifts
  };
  // What was found in a cell.
  struct Found {
    float cost = std::numeric_limits<float>::infinity();  // [m]
    std::int32_t node = -1;
  };
  struct Shift {
    double x = 0.0, y = 0.0;  // [m]
  };
  struct Entry {
    float key = 0.0F;
    std::int32_t node = 0;
    float cost = 0.0F;  // of the node when it was put there
    bool operator<(const Entry& other) const { return key != other.key ? key > other.key : node > other.node; }
  };

  double cost_of(int column, int row, int k) const {
    return static_cast<double>(found_[lattice_.index(column, row, k)].cost);
  }
  void add_step(double length, int turn);
  void push(int node, double ahead);
  int next();
  bool free(double x, double y, int part_of_turn) const;
  bool free_along(const Node& from, const Step& step) const;
  // Where a part of a step leads, counted from 1.
  const Shift& shift(const Node& from, const Step& step, int part) const {
    return shifts_[step.first + static_cast<std::size_t>(from.heading * step.parts + part - 1)];
  }
  int reach(const Node& from, int from_index, std::size_t step);
  template <typename Ahead>
  void expand(int index, Ahead&& ahead) {
    nodes_[static_cast<std::size_t>(index)].open = false;
    for (std::size_t s = 0; s < steps_.size(); ++s) {
      const Node from = nodes_[static_cast<std::size_t>(index)];
      const int reached = reach(from, index, s);
      if (reached >= 0) push(reached, ahead(nodes_[static_cast<std::size_t>(reached)]));
    }
  }

  const Ground& ground_;
  Lattice lattice_;
  Make make_;
  std::vector<Turned> outlines_;  // `fineness` of each heading
  std::vector<Step> steps_;
  std::vector<Shift> shifts_;  // of each step, at each heading, to the end of each part
  std::vector<Node> nodes_;
  std::vector<Found> found_;  // in each cell
  std::vector<Entry> queue_;  // a heap
};

}  // namespace hidwa_ways
