// SPDX-License-Identifier: BSD-3-Clause
// Follows a way that a search has found.
//
// 1. The remaining time of a candidate is that of the pose where the robot ends if it follows the candidate for some
//    tenths of a second and then brakes. The legal candidate with the least remaining time is taken.
// 2. Where the cheapest candidate gains nearly as much, that one is taken. If it does for a second, and nothing is near
//    the robot, the way has done its work: it ends.
// 3. The way ends, too, where the robot has come to its end. It stalls where the remaining time stops falling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/cycle/cycle.hpp"
#include "core/evaluation/evaluation.hpp"
#include "core/search/move_set.hpp"
#include "core/search/way.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class WayFollower {
 public:
  /// How far the robot has come on the way.
  struct Progress {
    std::uint32_t part = 0;                                  // of the way, that the robot is on
    double since = 0.0;                                      // when the remaining time last fell, or the way began [s]
    double least = std::numeric_limits<double>::infinity();  // smallest remaining time until now [s]
    double least_left = std::numeric_limits<double>::infinity();  // likewise, from the nearest pose of the way [s]
    double room = -1.0;     // clearance along the way when it was found; negative: not measured yet [m]
    bool narrower = false;  // now it is much less
    bool blocked = false;   // now there is none
    ConditionTimer agrees;  // the cheapest candidate leads on as well
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.part, self.since, self.least, self.least_left, self.room, self.narrower, self.blocked, self.agrees);
    }
  };
  /// What a cycle proposes.
  struct Step {
    int candidate = -1;
    bool ended = false;    // there is nothing left to follow
    bool stalled = false;  // the robot should search anew
    Progress progress;     // to be remembered
  };

  /// Where a search writes the way that is followed next.
  Way& way() { return way_; }
  const Way& way() const { return way_; }
  /// There is no way.
  void clear();
  /// The robot is at the beginning of the way. `while_driving`: it was found while the robot drove.
  void begin(double now, bool while_driving);
  /// The robot will soon be near an obstacle: then the way goes on although the cheapest candidate agrees.
  void note_tight(bool tight) { tight_ = tight; }

  /// Where all candidates are checked and scored. `may_agree`: the cheapest candidate counts.
  Step propose(const Cycle& cycle, Evaluation& evaluated, bool may_agree) const;
  void commit(const Step& step) { progress_ = step.progress; }

  bool found_while_driving() const { return while_driving_; }
  /// No cycle has followed it yet, and it leads somewhere.
  bool begins() const;
  bool narrower() const { return progress_.narrower; }
  /// `other`, found from `start`, is to replace it: it takes at most kSimilarTime longer. If it drives in the opposite
  /// direction, it must be shorter by kSimilarTime.
  bool gives_way_to(const Way& other, const Pose2& start) const;
  /// Another way takes the place of this one.
  void replace(Way& other, double now);
  /// The clearance of now is good enough.
  void accept_room() { progress_.room = -1.0; }
  /// The way begins where the robot is, and leads to where the plan leads, within `near` [m].
  bool still_leads(const Cycle& cycle, double near) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.way_, self.while_driving_, self.tight_, self.progress_);
  }

 private:
  struct PoseOnWay {
    Way::Projection here;  // nearest to the robot
    std::size_t end;       // the parts before it count
    double room;           // around the way [m]
  };
  PoseOnWay pose_on_way(const Cycle& cycle, const CollisionChecker& collision) const;
  bool gets_on(const Way::Projection& here, double now, Progress& progress) const;
  void measure_room(const PoseOnWay& at, Progress& progress) const;
  double left_after(const Cycle& cycle, const PoseOnWay& at, const Tile& tile, std::size_t c) const;

  Way way_;
  bool while_driving_ = false;
  bool tight_ = false;
  Progress progress_;
};

}  // namespace hidwa_local_planner
