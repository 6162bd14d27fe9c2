// SPDX-License-Identifier: BSD-3-Clause
// Passive safety: whether the robot comes to rest before anything that moves can touch it.
//
// 1. Once a cycle the moving obstacles are left out that no command of the cycle can meet before rest.
// 2. A command's manoeuvre is rolled out in time (brake_manoeuvre.hpp): pending motion, the command, braking to rest.
//    At no pose until rest may the outline touch where an obstacle may be at that time (ReachableSet: both discs).
// 3. Both discs are larger by the robot's drift, by which a real base may be elsewhere at that time, and by half a step
//    times the obstacle's fastest and the robot's own speed: so what lies between two poses is covered, too.
// 4. What is too far away at one time need not be looked at again until both could have met.
// 5. Where a set is around the robot already when it begins to drive, the robot may leave: the distance from the
//    outline to where the obstacle is expected grows at every step (Departures), and no place of the outline that it
//    may reach until rest moves outwards but very slowly (advances_near()). So the robot never moves into what it
//    leaves. It creeps, and leaves only what has stood there for a while: who walks past is soon gone.
// 6. Where somebody may stand unseen (HiddenPlaces) is such a set, too. It may be touched by a place of the outline
//    that moves outwards no faster than blind_speed: the robot comes through a doorway, and is overtaken.
//
// can_rest() takes long steps with a short step's allowance, and the likely pending motions; confirm() takes short
// steps, all pending motions, and commands to brake at all times. A robot that stays at rest has nothing to be asked.
//
// Why it is right: an obstacle that keeps its bounds and was estimated within moving_obstacle_deviations is in its set
// at every time. Only commands that confirm() passes are sent, so the manoeuvre of the last one stays free of
// everything that was known then: where nothing passes, carrying out its braking is still safe.
// test/unit/core/movers_test.cpp does the same slowly.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/motion/command_results.hpp"
#include "core/motion/cycle_start.hpp"
#include "core/movers/advance.hpp"
#include "core/movers/departures.hpp"
#include "core/movers/manoeuvre_bounds.hpp"
#include "core/movers/reachable_set.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

class MoverCheck {
 public:
  MoverCheck();
  /// A new goal, or another cause to begin afresh.
  void forget() { departures_.forget(); }
  /// Once per cycle. `footprint` and `start` outlive the questions.
  void prepare(const Parameters& parameters, const Footprint& footprint, const MovingObstacleEstimates& movers,
               const CycleStart& start);
  /// Likewise, for somebody who may come out of each of these places (HiddenPlaces) [m]. A place of the
  /// outline that moves outwards no faster than blind_speed may be touched.
  void prepare_hidden(const Parameters& parameters, const Footprint& footprint, const std::vector<Point>& places,
                      const CycleStart& start);
  /// From the robot's centre, where such a place still counts: for prepare_hidden() and the critic Occlusion [m].
  static double reach_of_hidden(const Parameters& parameters, const Footprint& footprint, const CycleStart& start);
  /// No command of this cycle can meet anything that moves before rest.
  bool none_near() const { return near_.empty(); }

  /// Whether nothing can touch the robot before it rests, after a first command [m/s, rad/s].
  bool can_rest(const Twist2& command) { return known_free(command, coarse_); }
  /// Likewise without gaps: for the candidate that is chosen.
  bool confirm(const Twist2& command) { return known_free(command, fine_); }

  /// Somebody stands at the robot, whether it may leave him yet or not.
  bool leaving() const { return departures_.any(); }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.departures_);
  }

 private:
  struct Near {
    ReachableSet set;
    bool leaves = false;         // the robot may leave it
    double closing_speed = 0.0;  // how fast the speed disc and the robot's outline may close up [m/s]
    double closing_acc = 0.0;    // likewise the acceleration disc
  };
  // How far a manoeuvre was looked at.
  struct Progress {
    std::vector<double> clear_until;  // [near] not touched before [s]
    TurnedPose pose;                  // the last one
    double time = -1.0;               // then; negative before the first [s]
    VelocityRange velocities;         // of all of the manoeuvre
  };
  struct PendingEnd {
    std::optional<ManoeuvreRoller> roller;
    bool free = false;
    Progress progress;
  };
  // What the coarse or the fine check has found in this cycle.
  struct CheckPass {
    bool fine = false;
    double step = 0.0;  // the longest [s]
    std::array<PendingEnd, PendingMotionSet::kMost> pending_ends;
    CommandResults results;
  };
  void begin(const Footprint& footprint, const CycleStart& start, double creep);
  bool in_reach(const ReachableSet& set) const;
  void add_near(const ReachableSet& set, bool leaves);
  bool around(const ReachableSet& set) const;
  bool known_free(const Twist2& command, CheckPass& pass) {
    return pass.results.free(command, [&] { return rests_untouched(command, pass); });
  }
  bool rests_untouched(const Twist2& command, CheckPass& pass);
  bool pending_free(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end);
  bool rolls_free(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, double elsewhere, PendingEnd& pending_end);
  static double allowance(const ManoeuvreRoller& roller);
  bool free_at(const ManoeuvreRoller& roller, double elsewhere, Progress& progress) const;
  bool free_at(const TurnedPose& at, double time, const ManoeuvreRoller& roller, double elsewhere,
               Progress& progress) const;
  bool clear(const Near& near, const TurnedPose& at, double time, double grown, double& clear_until) const;
  bool leads_away(const Near& near, const TurnedPose& from, const TurnedPose& to, double time, double step) const;
  bool meets(const Near& near, const TurnedPose& at, double time, double grown, double speed,
             const VelocityRange& velocities) const;

  const Footprint* footprint_ = nullptr;
  const CycleStart* start_ = nullptr;
  double radius_ = 0.0;  // circumscribed [m]
  double creep_ = -1.0;  // a place that moves outwards no faster may be touched [m/s]; negative: none may
  ManoeuvreBounds most_;
  std::vector<Near> near_;
  Departures departures_;
  CheckPass coarse_, fine_;
  Progress progress_;  // of the manoeuvre that is looked at
};

}  // namespace hidwa_local_planner
