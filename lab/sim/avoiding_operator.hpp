// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "sim/drive_prediction.hpp"
#include "sim/operator.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {

/// How quick and how careful the person is.
struct OperatorTraits {
  double reaction_time = 0.4;    // [s], from seeing to moving the stick
  double decision_period = 0.2;  // [s]
  double look_ahead = 5.0;       // [s], how far ahead the motion without input is judged
  double region_margin = 0.15;   // [m], kept from regions
  double release_margin = 0.05;  // [m], more margin to let go of the stick than to take it
  double stick_step = 0.05;      // finest difference of stick positions
  double stick_noise = 0.03;     // standard deviation of a stick position
};

/// A person who leaves the robot alone while what it is about to do keeps clear of the regions to avoid, and
/// else steers it round them, on the gentlest way seen that clears the region and returns to the robot's
/// plan. Decides a few times a second; each decision takes effect a reaction time later; the stick is not set
/// exactly.
class AvoidingOperator : public Operator {
 public:
  AvoidingOperator(const OperatorTraits& traits, const RobotHabits& habits, const OccupancyMap& map,
                   const std::vector<Region>& regions, std::uint64_t seed);

  void set_plan(const Route& plan) override;
  Stick update(const Observation& observation) override;

 private:
  using State = DrivePrediction::State;

  struct Decision {
    double effective;  // [s]
    double left;       // stick
  };

  struct Choice {
    double cost = std::numeric_limits<double>::infinity();
    double left = 0.0;  // stick
  };

  void reset();
  void take_effect(double now);
  void decide(const Observation& observation);
  State anticipated(const Observation& observation, double& hold_left);
  bool safe_alone(State state, double hold_left, double margin) const;
  Choice search(const State& state, std::size_t depth) const;
  double segment_cost(State& state, double omega, double duration) const;
  double end_cost(const State& state) const;
  double set_by_hand(double left);

  OperatorTraits traits_;
  RobotHabits habits_;
  DrivePrediction prediction_;
  bool anything_to_avoid_;
  Random random_;
  std::uint64_t seed_;
  Route plan_;
  std::size_t plan_position_ = 0;  // index of the plan's point nearest to the anticipated pose

  std::deque<Decision> pending_;
  double left_ = 0.0;                                                // stick
  double released_ = -std::numeric_limits<double>::infinity();       // [s]
  double last_time_ = -std::numeric_limits<double>::infinity();      // [s]
  double next_decision_ = -std::numeric_limits<double>::infinity();  // [s]
};

}  // namespace sim
}  // namespace hidwa_local_planner
