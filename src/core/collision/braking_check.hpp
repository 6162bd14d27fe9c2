// SPDX-License-Identifier: BSD-3-Clause
// Whether the robot can still come to rest in free space after the first command towards a sample.
//
// 1. Where nothing lies within reach of any brake manoeuvre, every command can brake.
// 2. Otherwise the manoeuvre is rolled out (brake_manoeuvre.hpp): the pending motion, the command for a period and as
//    much longer as the next command may be late, braking to rest. The pending motion is the same for all commands and
//    rolled out once (PendingEnd).
// 3. At every pose the robot must keep the manoeuvre's growth as its clearance: a real base may be so far from where it
//    is rolled out. It need not keep more than it has now: a robot that stands beside a wall may drive along it. Where
//    it has less now, confirm_braking() rolls out the other ends of what a base may do, too (kLags).
// 4. A clearance that is left over is used up along the way before the map is looked at again.
// 5. For a robot that stands in collision, the manoeuvre must go no deeper either (EscapeRule).
//
// can_brake() looks at poses at most half a cell apart, at the likely pending motions, and at commands to brake that
// come as early or as late as they may. confirm_braking() leaves no gap: poses a sixteenth of a cell apart or nearer
// with half of that as more clearance, all pending motions, and commands to brake at times in between.
//
// Why it is right: however the base reaches its commands, the robot is never farther from a rolled-out pose than the
// growth (the head of brake_manoeuvre.hpp derives it), and no point of it moves farther than the spacing from one pose
// to the next. A clearance of both all along is a free way to rest. Only commands that confirm_braking() passes are
// sent, so in the next cycle the robot can still brake as it was checked in this one, whatever else is rejected there.
#pragma once

#include <array>
#include <optional>

#include "core/collision/check_setup.hpp"
#include "core/collision/clearance_lookup.hpp"
#include "core/motion/brake_manoeuvre.hpp"
#include "core/motion/command_results.hpp"
#include "core/motion/cycle_start.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

class BrakingCheck {
 public:
  /// How far the robot's centre gets at most in any manoeuvre of a command up to `fastest` [m/s], without the growth
  /// [m].
  static double reach_of_manoeuvres(const CycleStart& start, double fastest);

  /// Once per evaluation; the arguments outlive the questions.
  void prepare(const Parameters& parameters, const CheckSetup& setup, ClearanceLookup& clearances, double radius,
               double resolution);

  /// Every command can.
  bool all_can_brake() const { return all_clear_ && !setup_->escaping(); }
  bool can_brake(const Twist2& sample);
  bool confirm_braking(const Twist2& sample);
  /// The first command towards a sample [m/s, rad/s].
  Twist2 command_for(const Twist2& sample) const;

 private:
  // Where a pending motion leads to, looked at once per cycle.
  struct PendingEnd {
    std::optional<ManoeuvreRoller> roller;
    bool free = false;
    double clearance = 0.0;  // that is left there [m]
  };
  // Likewise, for a robot in collision.
  struct EscapeEnd {
    std::optional<ManoeuvreRoller> roller;
    bool deeper = false;
    EscapeRule::Descent descent;
  };
  // Results of the coarse or of the fine check.
  struct CheckPass {
    bool fine = false;
    double depth_spacing = 0.0;  // of poses that are looked at for depth in collision, in cells at least
    std::array<PendingEnd, PendingMotionSet::kMost> pending_ends;
    std::array<EscapeEnd, PendingMotionSet::kMost> escape_ends;
    void forget();
  };

  bool nothing_in_reach() const;
  bool brakes_freely(const Twist2& command, CheckPass& pass);
  bool stops_freely(const Twist2& command, CheckPass& pass);
  bool free_all_along(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end, double& growth);
  void roll_pending(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end);
  template <typename RollPart>
  bool free_along(const CheckPass& pass, double way, double& clearance, ManoeuvreRoller& roller, RollPart&& part);
  bool goes_deeper(const Twist2& command, CheckPass& pass) const;
  bool goes_deeper(const BrakeManoeuvre& manoeuvre, double spacing, EscapeEnd& pending_end) const;
  ManoeuvreRoller roller_at(const Pose2& start, double spacing) const;

  const CycleStart* start_ = nullptr;
  const CheckSetup* setup_ = nullptr;
  ClearanceLookup* clearances_ = nullptr;
  bool commands_the_sample_ = false;  // the sample itself is sent
  double radius_ = 0.0;               // [m]
  double resolution_ = 0.05;          // [m]
  double clearance_now_ = 0.0;        // no more is asked for: what the robot has now [m]
  bool all_clear_ = false;            // no manoeuvre can hit anything
  CheckPass coarse_, fine_;
  CommandResults coarse_results_;
};

}  // namespace hidwa_local_planner
