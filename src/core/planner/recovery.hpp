// SPDX-License-Identifier: BSD-3-Clause
// Watches whether the robot gets on, and what is done where it does not. After each cycle, in this order:
//
// 1. Collision: a robot that stands in collision, and that no legal motion leads out of, waits for a second. A new scan
//    may take away what the last one has put under it. Then the cycle fails, so that the host clears its costmap.
// 2. Rest: autonomy that prefers standing still to every legal motion is stuck. RecoveryMotion searches for a way;
//    after half of blocked_time it drives. Where there is no way the cycle fails at once, else after all of
//    blocked_time, so that the host replans or recovers.
// 3. The last turn: at the goal's position only a turn is left. Where a critic forbids its direction (one that the
//    operator had the robot turn from, for example), the other one is longer, and standing still is cheaper for ever.
//    After half of blocked_time the critics forget. After all of it the outline cannot turn there, and RecoveryMotion
//    leads to the goal's pose by another way; with turn_when_stuck off the cycle fails.
//
// Why it is safe: it changes the outcome to failing or braking, and resets critics. It makes no command.
#pragma once

#include "core/planner/conclusion.hpp"
#include "core/planner/cycle.hpp"
#include "core/planner/recovery_motion.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class Recovery {
 public:
  /// All the memory that is large.
  void reserve() { motion_.reserve(); }
  /// A new goal.
  void reset();
  /// Nothing was chosen: the robot was stopped, or driven directly, or the input had a fault.
  void interrupt();

  /// RecoveryMotion decides what is driven.
  bool active() const { return motion_.active(); }
  /// It follows a way that it has found.
  bool follows() const { return motion_.follows(); }
  /// A way to the goal's pose is searched or followed, since the robot cannot turn where it reached the position.
  bool leads_to_goal() const { return motion_.leads_to_goal(); }
  /// That is the one back, to let out who blocks the plan.
  bool goes_back() const { return motion_.goes_back(); }
  /// It does, and has found it while it drove.
  bool drives_on() const { return motion_.drives_on(); }
  /// The candidate that gets autonomy going; -1 where there is none, or no need of one. Without `autonomous` it ends.
  int choose(bool autonomous, const RecoveryMotion::Scene& scene);

  /// What is known of a cycle once its command is chosen.
  struct Course {
    bool autonomous = false;  // nobody steers, and more is left than to turn at the goal
    bool steered = false;     // the operator command counts
    bool trapped = false;     // the robot stands in collision and no legal motion leads out
    bool yields = false;      // what moves decides: it evades, or stands for that
    bool tight = false;       // it comes near to something soon, if it follows what was chosen
    Pose2 soon;               // where it will be once a command takes effect, costmap frame
  };
  struct Review {
    Conclusion conclusion;
    bool reset_critics = false;  // what they forbid may be what gets the robot going
    bool waits = false;          // for what moves to go
  };
  /// Once per cycle that was planned: what the cycle comes to in view of those before it.
  Review review(const Cycle& cycle, const Course& course, Conclusion conclusion);

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.motion_, self.trapped_, self.unturned_, self.unturned_reset_);
  }

 private:
  void watch_collision(const Cycle& cycle, bool trapped, Conclusion& conclusion);
  bool watch_rest(const Cycle& cycle, const Course& known, Conclusion& conclusion);
  bool yields(const Course& course, double now) const;
  bool watch_last_turn(const Cycle& cycle, bool steered, Conclusion& conclusion);

  RecoveryMotion motion_;
  ConditionTimer trapped_;       // in collision, and no motion leads out
  ConditionTimer unturned_;      // the robot stands at the goal's position with another heading
  bool unturned_reset_ = false;  // the critics were reset for that
};

}  // namespace hidwa_local_planner
