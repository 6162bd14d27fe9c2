// SPDX-License-Identifier: BSD-3-Clause
// Searches a way for the robot's outline through a snapshot of the map: hybrid A* (Dolgov et al. 2010, "Path Planning
// for Autonomous Vehicles in Unknown Semi-structured Environments") over (x, y, heading).
//
// 1. A pose is left by moves: turns on the spot, straight on, and arcs, backwards too where the robot can. Poses are
//    exact. Of all that lie in one bin the quickest is kept. Bins and moves are coarse in the open, a cell and six
//    degrees where the outline decides, and an eighth of a cell and a degree where the robot all but touches something.
//    Where that finds nothing all is searched once more, with half a cell and four degrees.
// 2. A move is free if every pose on it is: from a pose the robot goes on by its clearance (no point of it moves
//    farther), and asks again. It needs a sixteenth of a cell of clearance. A robot that begins with less needs 80 % of
//    the most that it has had so far.
// 3. The quickest comes first: its time so far, and 1.6 times what the distance to the target takes at full speed
//    (TargetDistance), which finds a way sooner that may take up to 1.6 times as long. Time counts more where the
//    clearance is small, and at a change between forwards, backwards and turning.
// 4. It ends where the robot's centre is near the target, with the heading that is asked for, if one is; where nothing
//    is left; or where there is no memory left.
//
// The work is done in portions, a fixed number of poses each, so that no cycle takes long. All memory is kept from
// search to search. Why it is safe: it moves nothing. Every motion along the way found is checked as any candidate is,
// on the map of then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/search/bin_table.hpp"
#include "core/search/move_set.hpp"
#include "core/search/search_task.hpp"
#include "core/search/target_distance.hpp"
#include "core/search/way.hpp"
#include "core/util/rotation.hpp"

namespace hidwa_local_planner {

class WaySearch {
 public:
  WaySearch() = default;
  WaySearch(const WaySearch&) = delete;
  WaySearch& operator=(const WaySearch&) = delete;

  enum class State : std::uint8_t {
    idle,  // not begun, or forgotten
    searching,
    found,
    no_way,    // everything was looked at
    cut_short  // the memory was not enough
  };

  /// Takes the memory that a search may need, and has the system provide it: else the first one does within a cycle.
  void reserve();
  /// Forgets the search.
  void clear() { state_ = State::idle; }
  /// Takes a copy of the task.
  void begin(const SearchTask& task);
  /// Goes on, from at most `poses` poses.
  State run(int poses);
  State state() const { return state_; }
  /// How closely it looks, or looked at last; for tests.
  Pass pass() const { return pass_; }
  const SearchTask& task() const { return task_; }
  /// Where it was found: the way, smoothed, from the start to the target.
  void write(Way& way) const;

  /// Where it was not: how far the robot comes, and what is nearest to it there.
  struct End {
    Pose2 pose;            // the nearest to the target
    Point obstacle{0, 0};  // centre of the cell, costmap frame [m]
    double gap = 0.0;      // between it and the outline [m]
    bool obstacle_known = false;
    bool unknown = false;  // the cell is an unknown one
  };
  End end();

  /// A search under way is written as its task and the number of poses so far, and repeated when it is read.
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    if constexpr (std::is_const_v<Self>) {
      const bool searching = self.state_ == State::searching;
      io(searching);
      if (searching) io(self.task_, self.poses_);
    } else {
      bool searching = false;
      io(searching);
      SearchTask task;
      std::int64_t poses = 0;
      if (searching) io(task, poses);
      if (!io.failed()) self.repeat(searching, task, poses);
    }
  }

 private:
  struct Node {
    double x = 0.0, y = 0.0;   // [m]
    float time = 0.0F;         // since the start, weighted [s]
    float clearance = 0.0F;    // up to a cell [m]
    float needed = 0.0F;       // by the moves from here [m]
    std::int32_t parent = -1;  // node
    std::int16_t heading = 0;  // in kHeadingStep from the start's
    std::uint8_t move = 0;     // kind of the move that led here
    bool left = false;         // its moves were made
  };
  struct Queued {
    float bound = 0.0F;  // of the time by way of the node [s]
    std::uint32_t node = 0;
    bool operator<(const Queued& other) const {  // std heaps keep the largest on top
      return bound != other.bound ? bound > other.bound : node > other.node;
    }
  };

  void repeat(bool searching, const SearchTask& task, std::int64_t poses);
  void prepare();
  void begin_pass(Pass pass);
  void add_start();
  void leave(std::uint32_t from);
  void try_move(std::uint32_t from, const Move& move);
  struct Clearance {
    double least = 0.0;   // on the way of a move; 0 where it is less than needed [m]
    double at_end = 0.0;  // [m]
  };
  Clearance clearance_along(const Node& from, const Move& move) const;
  double tightness(const Move& move, double clearance) const;
  float needed_from(double clearance, double needed) const;
  double clearance_at(const Pose2& position, const Rotation& heading) const;
  double gap_to(const Pose2& pose, const Point& centre) const;
  Fineness fineness(const Node& node) const;
  std::uint64_t bin_of(const Node& node) const;
  void push(const Node& node);
  double bound(const Node& node);
  double turn_left(const Node& node) const;
  Rotation rotation(int heading) const;
  double heading_of(int heading) const;
  double time_between(const Node& a, const Node& b) const;

  SearchTask task_;
  std::int64_t poses_ = 0;  // that were left
  Pass pass_ = Pass::coarse;
  Footprint footprint_;
  CollisionChecker checker_;
  TargetDistance to_target_;
  MoveSets moves_;
  std::vector<Rotation> rotations_;  // of each heading
  std::vector<Node> nodes_;
  std::vector<Queued> queue_;
  BinTable bins_;
  State state_ = State::idle;
  Node end_;                 // of the way that was found; until then the nearest to the target, of both passes
  double least_left_ = 0.0;  // of all that were left: distance to the target [m]
  Polygon placed_;           // the outline at end()
};

}  // namespace hidwa_local_planner
