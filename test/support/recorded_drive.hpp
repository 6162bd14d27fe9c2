// SPDX-License-Identifier: BSD-3-Clause
// A drive over a random field with a person who does anything at all, each cycle recorded as the plugin records it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "control/control_loop.hpp"
#include "control/pause.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"
#include "record/cycle_recorder.hpp"
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
    record::DecisionRecord decision;
    std::vector<std::uint8_t> costs;  // of the local map; empty where input was missing
  };

  RecordedDrive(std::uint64_t seed, OperatorMode mode) : random_(seed), goals_(seed + 47), loop_(critics::built_in()) {
    randomise_robot(random_, parameters_);
    randomise_search(random_, parameters_);
    randomise_costs(random_, parameters_);
    parameters_.mode = mode;
    parameters_.delta = 0.4;
    parameters_.blocked_time = parameters_.stall_time = 0.2;
    parameters_.stop_button = 3;
    if (random_.chance(0.5)) parameters_.enable_button = 5;
    parameters_.authority = random_.chance(0.3) ? 0.5 : 1.0;
    configure();
    loop_.set_footprint(random_convex_outline(random_));
    field_.assign(static_cast<std::size_t>(kField) * kField, cost::kFree);
    for (int k = 0; k < 150; ++k) {
      const int i = random_.integer(0, kField - 4), j = random_.integer(0, kField - 4);
      for (int c = 0; c < 9; ++c) field_[static_cast<std::size_t>((j + c / 3) * kField + i + c % 3)] = cost::kLethal;
    }
    pose_ = {12.0, 12.0, random_.uniform(-3.0, 3.0)};
    if (random_.chance(0.3)) wall_in();
    from_plan_.origin = {random_.uniform(-3.0, 3.0), random_.uniform(-3.0, 3.0), random_.uniform(-3.0, 3.0)};
    replan();
  }

  std::vector<Cycle> run(int cycles) {
    std::vector<Cycle> all;
    for (int k = 0; k < cycles; ++k) all.push_back(cycle());
    return all;
  }

  const Parameters& parameters() const { return parameters_; }
  /// As dynamic_reconfigure does.
  void reconfigure(const Parameters& parameters) {
    parameters_ = parameters;
    configure();
    recorder_.demand_key();
  }

 private:
  void configure() {
    loop_.configure(parameters_);
    machine_.configure(parameters_);
  }

  // A room of 1.5 m around the robot: a command to go straight on is rejected soon.
  void wall_in() {
    for (int k = -12; k <= 12; ++k) {
      for (const auto& [i, j] : {std::pair{k, -12}, {k, 12}, {-12, k}, {12, k}}) {
        field_[static_cast<std::size_t>((192 + j) * kField + 192 + i)] = cost::kLethal;
      }
    }
  }

  // Everything stands still now and then, time jumps back, and somebody says stop or not.
  void pass_time() {
    const double before = time_;
    time_ += kPeriod;
    if (random_.chance(0.02)) time_ += random_.uniform(0.1, 0.8);
    if (random_.chance(0.003)) time_ -= 2.0;
    timing_ = {time_, kPeriod, random_.chance(0.1) ? 1.5 * kPeriod : kPeriod, time_ - before, time_ < before};
    if (random_.chance(0.9)) machine_.heartbeat(time_ - 0.02);
    if (random_.chance(0.05)) machine_.stop(random_.chance(0.05));
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
    machine_.receive(stick);
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

  /// A straight way from behind the robot to the goal; the host asks for one now and then.
  void replan() {
    const double heading = std::atan2(goal_.y - pose_.y, goal_.x - pose_.x);
    const int poses = static_cast<int>(distance(pose_, goal_) / 0.05);
    std::vector<Pose2> plan;
    for (int k = -3; k < poses; ++k) {
      plan.push_back(from_plan_.apply_inverse(
          {pose_.x + 0.05 * k * std::cos(heading), pose_.y + 0.05 * k * std::sin(heading), heading}));
    }
    plan.push_back(from_plan_.apply_inverse(goal_));
    loop_.set_plan(plan, "map", time_, kPeriod);
  }

  void aim() {
    const bool arrived = distance(pose_, goal_) < 0.3 && random_.chance(0.05);
    if (arrived) goal_ = {random_.uniform(5.0, 20.0), random_.uniform(5.0, 20.0), random_.uniform(-3.0, 3.0)};
    if ((arrived || random_.chance(0.05)) && !goalless_) replan();
  }

  control::Observation observe() {
    control::Observation seen;
    seen.timing = timing_;
    // Odometry shows the command before the last.
    seen.velocity = {before_last_.v + random_.uniform(-0.02, 0.02), before_last_.omega + random_.uniform(-0.02, 0.02)};
    seen.pose = pose_;
    seen.pose_age = random_.chance(0.2) ? 0.02 : 0.0;
    seen.from_plan = from_plan_;
    seen.host_stops = random_.chance(0.01);
    if (is_pause(timing_.interval, kPeriod) || timing_.jumped_back) seen.resumed = seen.velocity;
    if (random_.chance(0.02)) {
      seen.fault = "no odometry";
      if (random_.chance(0.5)) seen.velocity.reset();
      return seen;
    }
    look();
    seen.costmap = local_.grid();
    if (parameters_.mode == OperatorMode::switching) seen.sensor_sectors = {{{0.1, 0.0, 0.0}, 4.7, 10.0}};
    return seen;
  }

  Cycle cycle() {
    pass_time();
    touch();
    aim();
    if (goals_.chance(goalless_ ? 0.05 : 0.005)) goalless_ = !goalless_;  // the goal comes and goes
    control::Observation seen = observe();
    seen.goalless = goalless_;
    machine_.set_goalless(goalless_);
    Sampling sampling = random_.chance(0.1) ? Sampling{3, 5} : Sampling{};
    if (random_.chance(0.3)) sampling.report = Report::legality;
    if (random_.chance(0.5) && !goalless_) loop_.goal_reached(seen, machine_.manual());  // the host asks
    if (loop_.goal_begins()) machine_.new_goal();
    recorder_.operator_state().clear();
    ArchiveWriter write(recorder_.operator_state());
    machine_.save(write);
    recorder_.begin(loop_, seen, sampling);
    const control::Result result = loop_.step(seen, machine_.update(seen.timing.now), sampling);
    machine_.debrief(seen.timing.now, result.feedback);
    Cycle cycle{
        recorder_.finish(result, loop_.planner()), result.intent, record::decision_record(result, loop_.planner()), {}};
    if (seen.fault.empty()) cycle.costs = local_.costs;
    move(result.command);
    return cycle;
  }

  void move(const Twist2& command) {
    before_last_ = last_;
    last_ = command;
    pose_.theta = wrap_angle(pose_.theta + command.omega * kPeriod);
    pose_.x += command.v * kPeriod * std::cos(pose_.theta);
    pose_.y += command.v * kPeriod * std::sin(pose_.theta);
    from_plan_.origin.x += random_.uniform(-1e-3, 1e-3);  // localisation corrects itself
  }

  Random random_, goals_;
  Parameters parameters_;
  input::OperatorStateMachine machine_;
  control::ControlLoop loop_;
  record::CycleRecorder recorder_;
  std::vector<std::uint8_t> field_;
  Scene local_;
  Pose2 pose_, goal_{15.0, 15.0, 0.0};
  FrameTransform from_plan_;
  Twist2 last_, before_last_;
  control::Timing timing_;
  double time_ = 10.0, deflection_ = 0.0;
  bool silent_ = false, goalless_ = false;
};

}  // namespace hidwa_local_planner::test
