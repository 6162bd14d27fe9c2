// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "random.hpp"
#include "spec.hpp"
#include "walkers.hpp"
#include "world.hpp"

namespace hidwa_attack {

using hidwa_local_planner::OperatorIntent;

/// Somebody who wants a collision. Every few seconds they go about it in another way.
class Person {
 public:
  /// `walkers` are obstacles too. Somebody relentless hardly ever leaves the robot alone.
  Person(const World& world, const Walkers& walkers, Steering steering, bool relentless, std::uint64_t seed)
      : world_(world), walkers_(walkers), steering_(steering), relentless_(relentless), random_(seed) {}

  /// What they want at `now` [ms], from a robot at this pose with these limits.
  OperatorIntent want(int now, const Pose2& robot, const Parameters& limits);

 private:
  enum class Way {
    nearest,      // at full speed at the nearest obstacle
    chosen,       // at one that was in sight
    beside,       // so that it is hit by a side or just missed
    slalom,       // at full speed, another turn every few tenths of a second
    at_random,    // another wish each cycle
    frozen,       // full deflection
    alternating,  // the same, to the other side each cycle
    none,         // autonomy alone
    stop
  };
  void change_mind(int now, const Pose2& robot, const Parameters& limits);
  Twist2 steer(int now, const Pose2& robot, const Parameters& limits);
  Twist2 aim(const Pose2& robot, const Spot& target, double beside, const Parameters& limits) const;
  Twist2 wind(int now, const Parameters& limits);
  Twist2 any(const Parameters& limits);
  Twist2 full(const Parameters& limits);
  Spot nearest(const Pose2& robot) const;
  Spot ahead(const Pose2& robot);

  const World& world_;
  const Walkers& walkers_;
  Steering steering_;
  bool relentless_;
  Random random_;
  Way way_ = Way::none;
  bool manual_ = false;  // control is taken, else shared
  bool turns_first_ = false;
  int until_ = 0;        // [ms]
  int winds_until_ = 0;  // [ms]
  double beside_ = 0.0;  // how far from the target, left positive [m]
  double gain_ = 3.0;    // turn by bearing [1/s]
  Spot target_;
  Twist2 held_;  // [m/s, rad/s]
};

}  // namespace hidwa_attack
