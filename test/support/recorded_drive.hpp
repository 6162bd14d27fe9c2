// SPDX-License-Identifier: BSD-3-Clause
// A drive over a random field with a person who does anything at all, each cycle recorded as the plugin records it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/control/fault_brake.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "hidwa_local_planner/record/cycle_recorder.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner::test {

class RecordedDrive {
 public:
  static constexpr int kField = 400, kWindow = 60;  // [cells]
  static constexpr double kPeriod = 0.05;           // [s]

  struct Cycle {
    Bytes record;
    OperatorIntent intent;
    record::Verdict verdict;
    std::vector<std::uint8_t> costs;  // of the local map; empty where input was missing
  };

  RecordedDrive(std::uint64_t seed, OperatorMode mode) : random_(seed) {
    randomise_robot(random_, parameters_);
    randomise_search(random_, parameters_);
    randomise_costs(random_, parameters_);
    parameters_.velocity_reference_tolerance_x = 0.03;  // so little that what was commanded before counts
    parameters_.velocity_reference_tolerance_theta = 0.03;
    parameters_.mode = mode;
    parameters_.delta = 0.4;
    parameters_.blocked_time = 0.2;
    parameters_.stop_button = 3;
    if (random_.chance(0.5)) parameters_.enable_button = 5;
    parameters_.authority = random_.chance(0.3) ? 0.5 : 1.0;
    outline_ = random_convex_outline(random_);
    planner_.configure(parameters_);
    planner_.set_footprint(outline_);
    person_.configure(parameters_);
    field_.assign(static_cast<std::size_t>(kField) * kField, cost::kFree);
    for (int k = 0; k < 150; ++k) {
      const int i = random_.integer(0, kField - 4), j = random_.integer(0, kField - 4);
      for (int c = 0; c < 9; ++c) field_[static_cast<std::size_t>((j + c / 3) * kField + i + c % 3)] = cost::kLethal;
    }
    pose_ = {12.0, 12.0, random_.uniform(-3.0, 3.0)};
    if (random_.chance(0.3)) wall_in();
  }

  std::vector<Cycle> run(int cycles) {
    std::vector<Cycle> all;
    for (int k = 0; k < cycles; ++k) all.push_back(cycle());
    return all;
  }

  const Parameters& parameters() const { return parameters_; }
  /// As dynamic_reconfigure does; the operator's part may come a cycle earlier.
  void reconfigure(const Parameters& parameters) {
    parameters_ = parameters;
    planner_.configure(parameters_);
    person_.configure(parameters_);
    recorder_.demand_key();
  }

 private:
  // A room of 1.5 m around the robot: who wants to go straight on is refused soon.
  void wall_in() {
    for (int k = -12; k <= 12; ++k) {
      for (const auto& [i, j] : {std::pair{k, -12}, {k, 12}, {-12, k}, {12, k}}) {
        field_[static_cast<std::size_t>((192 + j) * kField + 192 + i)] = cost::kLethal;
      }
    }
  }

  // Everything stands still now and then, and somebody says stop or not.
  void pass_time() {
    time_ += kPeriod;
    if (random_.chance(0.02)) time_ += random_.uniform(0.2, 0.8);
    if (random_.chance(0.9)) person_.listens(time_ - 0.02);
    if (random_.chance(0.05)) person_.stop(random_.chance(0.05));
  }

  // Whatever a stick may do: rest, be held, jump, fall silent, press buttons.
  void touch() {
    if (random_.chance(0.03)) deflection_ = random_.chance(0.5) ? 0.0 : random_.uniform(-1.0, 1.0);
    if (random_.chance(0.02)) silent_ = !silent_;
    if (silent_) return;
    input::StickMessage stick;
    stick.axes = {static_cast<float>(deflection_), static_cast<float>(0.5 * deflection_), 0.0F, 0.0F};
    stick.buttons.assign(12, 0);
    const auto press = [&](int button, double probability) {
      if (button >= 0 && random_.chance(probability)) stick.buttons[static_cast<std::size_t>(button)] = 1;
    };
    press(parameters_.toggle_button, 0.05);
    press(parameters_.stop_button, 0.01);
    press(parameters_.enable_button, deflection_ < 0.5 ? 1.0 : 0.0);
    stick.received = time_ - 0.01;
    stick.sender = random_.chance(0.997) ? "/joy" : "/other";
    person_.receive(stick);
  }

  void look() {
    // Rolls with the robot, by whole cells.
    const int i0 = static_cast<int>(std::floor(pose_.x / kSceneResolution)) - kWindow / 2;
    const int j0 = static_cast<int>(std::floor(pose_.y / kSceneResolution)) - kWindow / 2;
    if (!local_.costs.empty() && local_.origin_x == i0 * kSceneResolution && local_.origin_y == j0 * kSceneResolution) {
      return;  // nothing moves but the robot
    }
    local_.size_x = local_.size_y = kWindow;
    local_.resolution = kSceneResolution;
    local_.origin_x = i0 * kSceneResolution;
    local_.origin_y = j0 * kSceneResolution;
    local_.costs.assign(static_cast<std::size_t>(kWindow) * kWindow, cost::kFree);
    for (int j = 0; j < kWindow; ++j) {
      for (int i = 0; i < kWindow; ++i) {
        const int x = i + i0, y = j + j0;
        const bool inside = x >= 0 && y >= 0 && x < kField && y < kField;
        local_.costs[static_cast<std::size_t>(j * kWindow + i)] =
            inside ? field_[static_cast<std::size_t>(y * kField + x)] : cost::kUnknown;
      }
    }
    inflate(local_, 0.2, 0.5, 5.0);
  }

  Situation situation() {
    Situation s;
    s.pose = pose_;
    // Odometry shows the command before the last.
    s.velocity = {before_last_.v + random_.uniform(-0.02, 0.02), before_last_.omega + random_.uniform(-0.02, 0.02)};
    s.last_command = last_;
    s.goal = goal_;
    const double heading = std::atan2(goal_.y - pose_.y, goal_.x - pose_.x);
    for (int k = -3; k < 35; ++k) {
      s.plan.push_back({pose_.x + 0.05 * k * std::cos(heading), pose_.y + 0.05 * k * std::sin(heading), heading});
    }
    s.goal_latched = distance(pose_, goal_) < 0.3;
    s.period = kPeriod;
    s.time = time_;
    return s;
  }

  Cycle cycle() {
    pass_time();
    const Twist2 last = last_;
    touch();
    if (distance(pose_, goal_) < 0.3 && random_.chance(0.05)) {
      goal_ = {random_.uniform(5.0, 20.0), random_.uniform(5.0, 20.0), random_.uniform(-3.0, 3.0)};
      planner_.reset();
      person_.new_goal();
    }
    Cycle cycle;
    Bytes before;
    ArchiveWriter write(before);
    person_.save(write);
    cycle.intent = person_.update(time_);
    if (recorder_.begin(time_)) {
      recorder_.setup({"1.2.3", to_lines(parameters_), "", "", outline_});
    }
    recorder_.operator_state() = before;
    recorder_.intent(cycle.intent);
    if (random_.chance(0.02)) {
      brake(cycle);
    } else {
      plan(cycle);
    }
    cycle.record = recorder_.finish(cycle.verdict);
    before_last_ = last;
    debrief();
    return cycle;
  }

  void plan(Cycle& cycle) {
    brake_.clear();
    look();
    const Situation s = situation();
    Sampling sampling = random_.chance(0.1) ? Sampling{3, 5} : Sampling{};
    sampling.check_all = random_.chance(0.3);
    recorder_.plans(planner_, s, local_.grid(), sampling);
    const Decision& decision = planner_.plan(s, local_.grid(), cycle.intent, sampling);
    cycle.verdict = record::verdict_of(decision, planner_.totals());
    cycle.costs = local_.costs;
    last_ = cycle.verdict.command;
    refused_ = !decision.operator_refused_by.empty();
    pose_.theta = wrap_angle(pose_.theta + last_.omega * kPeriod);
    pose_.x += last_.v * kPeriod * std::cos(pose_.theta);
    pose_.y += last_.v * kPeriod * std::sin(pose_.theta);
  }

  void brake(Cycle& cycle) {
    record::BrakeInput input{{}, std::nullopt, last_, kPeriod, "no odometry"};
    if (random_.chance(0.5)) input.velocity = last_;
    recorder_.brakes(brake_, input);
    const FaultBrake::Answer answer = brake_.answer(time_, input.velocity, last_, parameters_, kPeriod);
    cycle.verdict = record::verdict_of(outcome_of(answer, cycle.intent), answer.command);
    last_ = cycle.verdict.command;
    refused_ = false;
  }

  void debrief() {
    input::CycleFeedback feedback;
    feedback.command = last_;
    feedback.velocity = last_;
    feedback.at_rest = last_ == Twist2{};
    feedback.own_command_refused = refused_;
    feedback.goal_latched = distance(pose_, goal_) < 0.3;
    person_.debrief(time_, feedback);
  }

  Random random_;
  Parameters parameters_;
  Polygon outline_;
  Planner planner_{critics::built_in()};
  input::OperatorStateMachine person_;
  FaultBrake brake_;
  record::CycleRecorder recorder_;
  std::vector<std::uint8_t> field_;
  Scene local_;
  Pose2 pose_, goal_{15.0, 15.0, 0.0};
  Twist2 last_, before_last_;
  double time_ = 10.0, deflection_ = 0.0;
  bool silent_ = false, refused_ = false;
};

}  // namespace hidwa_local_planner::test
