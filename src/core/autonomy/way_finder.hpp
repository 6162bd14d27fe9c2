// SPDX-License-Identifier: BSD-3-Clause
// Finds a way for the outline through a snapshot of the local map, in portions (WaySearch).
//
// Moving obstacles count as obstacles where they are now. Where no way leads on, the search is repeated without them:
// that says whether they alone block the way.
#pragma once

#include <cstdint>
#include <vector>

#include "core/autonomy/step_back.hpp"
#include "core/cycle/cycle.hpp"
#include "core/search/way_search.hpp"

namespace hidwa_local_planner {

class WayFinder {
 public:
  /// Where the way has to lead.
  enum class Target : std::uint8_t {
    plan,  // 1.5 m to 2.5 m ahead on the plan
    goal,  // the pose of the goal
    back   // where the robot has come from
  };

  /// The memory of a search.
  void reserve();
  /// Forgets the search.
  void clear();
  /// Begins a search from `start`, costmap frame. `trail`: where the robot has come from.
  void begin(const Cycle& cycle, const Pose2& start, Target target, const StepBack& trail);
  /// Repeats a search that found no way without moving obstacles. False where none counted in it.
  bool repeat_without_movers(const Cycle& cycle, Target target, const StepBack& trail);
  /// Continues the search. Where it finds a way, writes it.
  WaySearch::State run(const Cycle& cycle, Way& way);

  bool searching() const { return search_.state() == WaySearch::State::searching; }
  /// The search under way began near to `pose`, so that what it finds holds there.
  bool began_near(const Pose2& pose) const { return distance(start(), pose) < kSamePlace; }
  const Pose2& start() const { return search_.task().start; }
  /// How near to its target a way ends [m].
  double tolerance() const { return search_.task().near_target; }
  /// Moving obstacles count in the search.
  bool with_movers() const { return with_movers_; }
  /// The search is the one that is repeated without them.
  bool without_movers() const { return without_movers_; }
  /// Where a search without success has come to.
  WaySearch::End end() { return search_.end(); }

  static constexpr double kSamePlace = 0.3;  // [m]

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.search_, self.with_movers_, self.without_movers_);
  }

 private:
  SearchTask task_;  // the next one
  WaySearch search_;
  std::vector<Pose2> way_back_;  // as a plan
  bool with_movers_ = false;
  bool without_movers_ = false;
};

}  // namespace hidwa_local_planner
