// SPDX-License-Identifier: BSD-3-Clause
// What autonomy remembers from cycle to cycle, and how a cycle changes it.
//
// A cycle asks the behaviours for proposals (Arbiter). That changes nothing that they remember; Evasion writes scratch
// data of the cycle. Then commit() is called once. It tells the behaviours what was driven, and judges whether the
// robot gets on:
//
// 1. Collision: a robot that stands in collision, and that no legal motion leads out of, waits for a second. A new scan
//    may take away what the last one has put under it. Then the cycle fails, so that the host clears its costmap.
// 2. Rest: autonomy that prefers standing still to every legal motion is stuck. Recovery searches for a way; after half
//    of stall_time it drives. Where there is no way the cycle fails at once, else after all of stall_time, so that
//    the host replans or recovers.
// 3. The last turn: at the goal's position only a turn is left. Where a critic forbids its direction (one that the
//    operator had the robot turn from, for example), the other one is longer, and standing still is cheaper for ever.
//    After half of stall_time the critics forget. After all of it the outline cannot turn there, and Recovery leads
//    to the goal's pose by another way; with method: paper the cycle fails.
//
// Why it is safe: commit() changes the outcome to failing or braking, and resets critics. It makes no command.
#pragma once

#include "core/autonomy/escape_turn.hpp"
#include "core/autonomy/evasion.hpp"
#include "core/autonomy/recovery.hpp"
#include "core/autonomy/stall_watch.hpp"
#include "core/cycle/conclusion.hpp"

namespace hidwa_local_planner {

class Autonomy {
 public:
  /// Allocates the large buffers, so that no cycle has to.
  void reserve() { recovery_.reserve(); }
  /// A new goal.
  void reset();
  /// Nothing was chosen: the robot was stopped, or driven directly, or the input had a fault.
  void interrupt();

  const EscapeTurn& escape() const { return escape_; }
  const Recovery& recovery() const { return recovery_; }
  Evasion& evasion() { return evasion_; }
  /// Escape or recovery may decide what is driven: all candidates must be checked.
  bool active() const { return escape_.active() || recovery_.active(); }
  /// Nobody steers, and more is left than to turn at the goal.
  bool drives(const Cycle& cycle, const Steering& steering) const;

  /// What the behaviours proposed in a cycle.
  struct Steps {
    bool asked = false;    // escape and recovery were asked
    bool escapes = false;  // the robot stands in collision, and follows no way
    EscapeTurn::Step escape;
    Recovery::Step recovery;
    Evasion::Step evasion;
  };
  /// What is driven in a cycle.
  struct Driven {
    Steps steps;
    Conclusion conclusion;
    bool trapped = false;  // the robot stands in collision and no legal motion leads out
    bool yields = false;   // moving obstacles decide: it evades, or stands for them
    bool tight = false;    // it will soon be near an obstacle
    Pose2 soon;            // where it is when the next command takes effect, costmap frame
  };
  struct Verdict {
    Conclusion conclusion;
    bool reset_critics = false;  // what they forbid may be what gets the robot going
    bool waits = false;          // for moving obstacles
  };
  /// Once a cycle with scored candidates.
  Verdict commit(const Cycle& cycle, const Steering& steering, const Driven& driven);
  /// A cycle without: there is nothing to evade.
  void end_evasion() { evasion_.commit({}); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.stall_, self.escape_, self.recovery_, self.trapped_, self.unturned_, self.unturned_reset_, self.evasion_);
  }

 private:
  void forget();
  void remember(const Cycle& cycle, const Steps& steps);
  void judge_collision(const Cycle& cycle, bool trapped, Conclusion& conclusion);
  bool observe(const Cycle& cycle, bool autonomous, const Driven& driven, const Conclusion& conclusion);
  void judge_rest(const Cycle& cycle, const Driven& driven, Conclusion& conclusion) const;
  bool judge_last_turn(const Cycle& cycle, bool steered, Conclusion& conclusion);
  bool yields(const Driven& driven, double now) const;

  StallWatch stall_;
  EscapeTurn escape_;
  Recovery recovery_;
  Evasion evasion_;
  ConditionTimer trapped_;       // in collision, and no motion leads out
  ConditionTimer unturned_;      // the robot stands at the goal's position with another heading
  bool unturned_reset_ = false;  // the critics were reset for that
};

}  // namespace hidwa_local_planner
