// SPDX-License-Identifier: BSD-3-Clause
#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hidwa_local_planner {
namespace drive {
namespace {

// The person gives input now; in HOLD it has ended.
bool steers(OperatorStateId state) {
  return state == OperatorStateId::shared || state == OperatorStateId::manual || state == OperatorStateId::stopped ||
         state == OperatorStateId::blocked;
}

PeopleResult people_result(const sim::PeopleWatch& watch) {
  PeopleResult people;
  people.contacts_moving = watch.touches_moving();
  people.contacts_at_rest = watch.touches_at_rest();
  people.encounters = watch.encounters();
  people.closest = watch.closest();
  people.personal_space = watch.personal_space();
  people.standing = watch.standing();
  people.touches = watch.touches();
  return people;
}

}  // namespace

void Recorder::add(const Cycle& cycle, const Twist2& sent, double period, double spent) {
  const Decision& decision = cycle.decision;
  if (decision.outcome == Outcome::fail) ++result_.failures;
  if (decision.outcome == Outcome::brake) ++result_.brakes;
  add_command(sent);
  add_steering(cycle, period);
  gentleness_.add(cycle.intent.state == OperatorStateId::autonomy, sent.omega, period);
  const sim::Pose& pose = cycle.world.pose();
  add_clearance(pose);
  result_.planning_time += spent;
  if (!setup_.keep_samples) return;
  result_.samples.push_back(
      {cycle.time, pose, sent, cycle.intent.u_h, cycle.intent.state, decision.outcome, decision.problem});
}

void Recorder::add_command(const Twist2& sent) {
  if (result_.cycles++ > 0) {
    v_changes_ += std::abs(sent.v - last_.v);
    omega_changes_ += std::abs(sent.omega - last_.omega);
  }
  last_ = sent;
}

void Recorder::add_clearance(const sim::Pose& pose) {
  const double clearance = setup_.ground->clearance(setup_.footprint, pose, kFarClearance);
  result_.clearance = std::min(result_.clearance, clearance);
  clearances_ += clearance;
}

void Recorder::add_steering(const Cycle& cycle, double period) {
  const bool now = steers(cycle.intent.state);
  if (now && !steering_) ++result_.interventions;
  steering_ = now;
  if (!now) return;
  ++steered_;
  agreements_ += cycle.decision.agreement;
  result_.operator_active += period;
}

DriveResult Recorder::finish(const sim::World& world, Ending ending) {
  result_.ending = ending;
  result_.arrived = ending == Ending::arrived;
  result_.duration = world.time();
  result_.length = world.distance();
  result_.contacts = world.contacts();
  result_.people = people_result(world.watch());
  result_.regions_crossed = world.regions().crossed();
  result_.gentleness = gentleness_.result();
  if (result_.cycles > 0) result_.mean_clearance = clearances_ / static_cast<double>(result_.cycles);
  if (result_.cycles > 1) {
    const auto changes = static_cast<double>(result_.cycles - 1);
    result_.v_change = v_changes_ / changes;
    result_.omega_change = omega_changes_ / changes;
  }
  if (steered_ > 0) result_.agreement = agreements_ / static_cast<double>(steered_);
  return std::move(result_);
}

const char* to_string(Ending ending) {
  switch (ending) {
    case Ending::arrived:
      return "arrived";
    case Ending::given_up:
      return "given up";
    case Ending::no_plan:
      return "no plan";
    case Ending::out_of_time:
      return "out of time";
    case Ending::contact:
      return "contact";
  }
  return "unknown";
}

}  // namespace drive
}  // namespace hidwa_local_planner
