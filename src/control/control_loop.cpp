// SPDX-License-Identifier: BSD-3-Clause
#include "control/control_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion/late_cycles.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner::control {
namespace {

// Two plans lead the same way where they are no farther apart [m]. A robot is on neither side of what fits between
// them.
constexpr double kSameWay = 0.15;

// A global planner may end each plan some centimetres beside the one before: at another cell, or where the goal lies in
// an obstacle. A robot that has reached one of these ends stays latched at the others: so far beyond the tolerance a
// latch lasts.
bool same_goal(const Pose2& a, const Pose2& b, const Parameters& p) {
  const bool any_heading = std::isnan(a.theta) && std::isnan(b.theta);
  return distance(a, b) <= goal_margin(p) &&
         (any_heading || std::abs(wrap_angle(a.theta - b.theta)) <= p.yaw_goal_tolerance);
}

// A host may send one plan again and again: progress on it goes on.
bool same_poses(const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Pose2& p, const Pose2& q) { return p.x == q.x && p.y == q.y; });
}

constexpr double kLengthBehind = 1.0;  // of the plan's window [m]

// Length of the plan's window ahead of the robot [m]. It never limits the speed, but with the paper's method.
double length_ahead(const Parameters& p) {
  const double least = p.method == Method::paper ? 0.0 : 1.2 * p.max_vel_x * p.sim_time;
  return std::max(p.forward_prune_distance, least);
}

}  // namespace

std::string critic_fault(const std::exception& thrown) {
  return std::string("critics: one of them cannot use its parameters: ") + thrown.what();
}

std::vector<std::string> ControlLoop::configure(const Parameters& parameters, const Planner::SourceFor& sources) {
  try {
    return planner_.configure(parameters, sources);
  } catch (const std::exception& error) {
    return {critic_fault(error)};
  }
}

void ControlLoop::set_plan(std::vector<Pose2> plan, const std::string& frame, double now, double period) {
  const bool paused = goal_checker_.plan_arrives(now, period);
  goal_.pose = plan.back();
  const bool is_new = !goal_.known || frame != frame_ || !same_goal(goal_.pose, goal_.first, parameters());
  plan = with_poses_between(plan);
  situation_.plan.reserve(plan.size() + 1);  // what no window of it outgrows
  const bool chooses = autonomous_ && parameters().method == Method::hidwa;
  if (is_new || paused) {
    plan_choice_.clear();
    plan_.set_plan(std::move(plan));
  } else if (parameters().plan_in_order && same_poses(plan, plan_.plan())) {
    plan_choice_.clear();
  } else if (plan_.empty() || !chooses || leads_the_same_way(plan)) {
    plan_choice_.clear();
    plan_.replace_plan(std::move(plan));
  } else {
    plan_.reserve(plan.size());
    plan_choice_.offer(std::move(plan));
  }
  frame_ = frame;
  // The goal that the latches belong to stays the reference: a sum of small changes is a change.
  if (is_new) goal_.first = goal_.pose;
  goal_.known = true;
  if (is_new || paused) begin_goal();
}

// Nothing that a robot could go round fits between the two: half of it is inside of the robot.
bool ControlLoop::leads_the_same_way(const std::vector<Pose2>& plan) const {
  const double apart = std::min(kSameWay, planner_.footprint().inscribed_radius());
  return same_way(plan_.plan(), plan_.next_pose(), plan, apart);
}

void ControlLoop::drop_plan(double now, double period) {
  plan_.set_plan({});
  plan_choice_.clear();
  if (goal_checker_.plan_arrives(now, period)) begin_goal();
}

void ControlLoop::begin_goal() {
  planner_.reset();
  goal_checker_.reset();
  goal_.begins = true;
}

void ControlLoop::finish_goal(const Timing& timing) {
  goal_.known = false;
  fill_timing_and_last_command(timing);
  planner_.skip(situation_);
  last_command_ = {};
}

bool ControlLoop::goal_reached(const Observation& observation, bool manual) {
  if (manual || !observation.fault.empty()) return false;
  follow_progress(observation);
  return check_goal(observation);
}

// In the costmap frame. Where any heading will do it is the robot's.
Pose2 ControlLoop::goal_of(const Observation& observation) const {
  Pose2 goal = observation.from_plan.apply(goal_.pose);
  if (std::isnan(goal_.pose.theta)) goal.theta = observation.pose.theta;
  return goal;
}

void ControlLoop::follow_progress(const Observation& observation) {
  const PlanOrder in_order = order();
  plan_.advance(observation.from_plan.apply_inverse(observation.pose),
                parameters().plan_in_order ? &in_order : nullptr);
}

// Where the robot was carried or driven away from the goal, what was latched there is true no more, unless its own way
// to the goal's heading leads out and back.
bool ControlLoop::check_goal(const Observation& observation) {
  const bool latched = goal_checker_.latched();
  situation_.goal_next = !parameters().plan_in_order || plan_.leads_to_end(parameters().xy_goal_tolerance);
  const bool reached = goal_checker_.update(observation.pose, planner_.believed(*velocity_of(observation)),
                                            goal_of(observation), parameters(), situation_.goal_next);
  if (latched && !goal_checker_.latched() && !planner_.leads_to_goal()) begin_goal();
  return reached;
}

void ControlLoop::save(Bytes& state) const {
  Bytes planner;
  planner_.save(planner);
  ArchiveWriter write(state);
  archive(*this, write);
  write(planner, twist_watch_);
}

bool ControlLoop::load(const Bytes& state) {
  Bytes planner;
  ArchiveReader read(state);
  archive(*this, read);
  read(planner, twist_watch_);
  return read.complete() && planner_.load(planner);
}

// What moves the robot while it passes commands through is what was commanded, too.
void ControlLoop::watch_velocity(const Observation& observation) {
  if (observation.resumed || observation.timing.jumped_back || !observation.fault.empty()) twist_watch_.interrupt();
  if (!observation.fault.empty()) return;
  const Parameters& p = parameters();
  twist_watch_.observe({observation.timing.now,
                        observation.pose_age,
                        observation.pose,
                        *observation.velocity,
                        last_command_,
                        {std::max(p.max_vel_x, -p.min_vel_x), p.max_vel_theta}});
}

std::optional<Twist2> ControlLoop::velocity_of(const Observation& observation) const {
  if (!observation.velocity || !twist_watch_.doubts() || !observation.fault.empty()) return observation.velocity;
  return twist_watch_.from_pose();
}

Result ControlLoop::step(const Observation& observation, const OperatorIntent& wanted, const Sampling& sampling) {
  if (!observation.goalless) goal_.begins = false;  // what began before, the operator has heard
  goal_checker_.cycle(observation.timing.now);
  watch_velocity(observation);
  if (observation.timing.jumped_back) fault_brake_.clear();
  if (observation.resumed) {
    // Somebody else sent commands meanwhile: the next one starts from what the robot does, within the limits.
    resumed_ = true;
    last_command_ = planner_.limits().clamp(*observation.resumed);
  }
  Result result;
  result.intent = wanted;
  result.goalless = observation.goalless;
  OperatorIntent intent = wanted;
  if (observation.host_stops) intent.influence = Influence::stop;
  if (observation.goalless) follow_operator(intent);
  autonomous_ = intent.influence == Influence::none && intent.state == OperatorStateId::autonomy;
  steered_ = intent.influence == Influence::shared || intent.influence == Influence::direct;
  if (observation.fault.empty()) {
    decide(observation, intent, sampling, result);
  } else {
    brake(observation, intent, result);
  }
  fill_feedback(observation, result);
  remember(observation, result);
  return result;
}

// Without a goal the operator alone drives, always guarded.
void ControlLoop::follow_operator(OperatorIntent& intent) {
  const bool drives = intent.influence == Influence::shared || intent.influence == Influence::direct;
  intent.influence = drives ? Influence::direct : Influence::stop;
  intent.guarded = true;
}

void ControlLoop::brake(const Observation& observation, const OperatorIntent& intent, Result& result) {
  const Timing& timing = observation.timing;
  fill_timing_and_last_command(timing);
  planner_.skip(situation_);
  const double period = late_brake_period(timing.interval, timing.period, timing.longest_period);
  const FaultBrake::Command braking =
      fault_brake_.brake(timing.now, observation.velocity, last_command_, parameters(), planner_.limits(), period);
  result.outcome = outcome_of(braking, intent);
  result.command = braking.command;
}

void ControlLoop::decide(const Observation& observation, const OperatorIntent& intent, const Sampling& sampling,
                         Result& result) {
  fault_brake_.clear();
  if (plan_choice_.offers() && !observation.goalless) choose_plan(observation);
  take_situation(observation);
  result.decision = &planner_.plan(situation_, observation.costmap, intent, sampling);
  result.outcome = result.decision->outcome;
  if (result.outcome != Outcome::fail) result.command = result.decision->command;
}

void ControlLoop::choose_plan(const Observation& observation) {
  const PlanChoice::Context context{observation.pose, observation.from_plan,  observation.costmap,
                                    plan_.plan(),     observation.timing.now, autonomous_};
  if (plan_choice_.prefers_offer(context, parameters())) plan_.replace_plan(plan_choice_.take());
}

void ControlLoop::fill_timing_and_last_command(const Timing& timing) {
  situation_.time = timing.now;
  situation_.period = timing.period;
  situation_.longest_period = timing.longest_period;
  situation_.last_command = last_command_;
  situation_.resumed = std::exchange(resumed_, false);
}

void ControlLoop::take_situation(const Observation& observation) {
  fill_timing_and_last_command(observation.timing);
  situation_.pose = observation.pose;
  situation_.velocity = *velocity_of(observation);
  situation_.velocity_time =
      twist_watch_.doubts() ? observation.timing.now - observation.pose_age : observation.velocity_time;
  situation_.pose_age = observation.pose_age;
  situation_.moving_obstacles = observation.moving_obstacles;
  situation_.sensor_sectors = observation.sensor_sectors;
  situation_.goalless = observation.goalless;
  if (observation.goalless) return take_no_goal(observation);
  situation_.goal = goal_of(observation);
  take_plan_window(observation);
  check_goal(observation);
  situation_.goal_latched = goal_checker_.latched();
}

// Whatever goal comes next is a new one.
void ControlLoop::take_no_goal(const Observation& observation) {
  goal_.known = false;
  situation_.goal = observation.pose;
  situation_.goal_next = true;
  situation_.goal_latched = situation_.turns_back = false;
  situation_.plan.clear();
}

void ControlLoop::take_plan_window(const Observation& observation) {
  const FrameTransform& from_plan = observation.from_plan;
  const double ahead = length_ahead(parameters());
  follow_progress(observation);
  if (parameters().plan_in_order) plan_.find_turn(ahead, order(), {observation.costmap, from_plan});
  const PlanWindow::Range range = plan_.range(kLengthBehind, ahead);
  situation_.plan.clear();
  for (std::size_t i = range.begin; i < range.end; ++i) situation_.plan.push_back(from_plan.apply(plan_.plan()[i]));
  situation_.turns_back = range.turns_back;
  if (range.turns_back) situation_.plan.push_back(from_plan.apply(plan_.turn()));
}

void ControlLoop::fill_feedback(const Observation& observation, Result& result) const {
  input::CycleFeedback& feedback = result.feedback;
  if (!observation.goalless) feedback.new_goal = goal_.begins;
  feedback.command = result.command;
  const Twist2 velocity = velocity_of(observation).value_or(Twist2{});
  feedback.stands = hidwa_local_planner::stands(result.command, velocity, parameters());
  feedback.operator_command_rejected = result.decision != nullptr && !result.decision->operator_rejected_by.empty();
  feedback.goal_latched = goal_checker_.latched() && !observation.goalless;
}

void ControlLoop::remember(const Observation& observation, const Result& result) {
  last_command_ = result.command;  // zero on failure: so the host does
  stands_ = result.feedback.stands;
  if (observation.goalless) return;
  goal_.begins = false;
  if (result.outcome == Outcome::fail) plan_choice_.give_way();
  if (result.decision != nullptr && result.decision->problem_kind == Problem::stuck) plan_.give_way();
}

}  // namespace hidwa_local_planner::control
