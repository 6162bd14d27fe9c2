// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "sim/operator.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace study {

/// How fast the robot drives and turns while the stick is fully deflected.
struct FullDeflection {
  double v = 0.5;         // [m/s]
  double omega = 1.0;     // [rad/s]
  double exponent = 2.0;  // of the stick's map
};

/// Free space between a point [m] and the nearest obstacle `ahead` [s] from now, exact below `at_most` [m], else that:
/// what a person at the stick sees.
using Room = std::function<double(const Eigen::Vector2d& point, double ahead, double at_most)>;

/// A person who wants the robot to hit something. They see every obstacle exactly, and attack for seconds at
/// a time, the stick fully deflected: to the side that would bring the robot nearest to one, decided
/// anew with every message, or else from side to side several times a second. In between they let go for a
/// while, so that autonomy takes the robot to where a new attack pays. They leave for good at a given time.
class HostilePerson : public sim::Operator {
 public:
  HostilePerson(Room room, const FullDeflection& full, std::uint64_t seed,
                double leaves = std::numeric_limits<double>::infinity());  // [s]

  sim::Stick update(const sim::Observation& seen) override;

 private:
  enum class Phase { resting, aiming, flipping };

  void begin_phase(double now);
  double nearer_side(const sim::Pose& pose) const;

  Room room_;
  FullDeflection full_;
  sim::Random random_;
  double leaves_;  // [s]
  Phase phase_ = Phase::resting;
  double phase_ends_ = 0.0;  // [s]
  double flips_ = 0.0;       // [s], when it changes sides next
  double side_ = 1.0;        // left
};

/// A person who means well: where the robot's plan turns away from its heading they steer that way, by as
/// much as leaves most room. They see every obstacle exactly and the plan as it is, decide four times a
/// second, and let go once the robot faces the plan. They feel no reaction time.
class HelpfulPerson : public sim::Operator {
 public:
  HelpfulPerson(Room room, const FullDeflection& full);

  sim::Stick update(const sim::Observation& seen) override;
  void set_plan(const sim::Route& plan) override { plan_ = plan; }

 private:
  double off_plan(const sim::Pose& pose) const;
  double decide(const sim::Pose& pose) const;

  Room room_;
  FullDeflection full_;
  sim::Route plan_;       // map frame
  double decides_ = 0.0;  // [s], next
  double left_ = 0.0;     // the stick
};

}  // namespace study
}  // namespace hidwa_local_planner
