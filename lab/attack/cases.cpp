// SPDX-License-Identifier: BSD-3-Clause
#include "cases.hpp"

#include <algorithm>
#include <utility>

#include "braking.hpp"

namespace hidwa_attack {
namespace {

using hidwa_local_planner::Guard;
using hidwa_local_planner::LinearPolicy;
using hidwa_local_planner::OperatorMode;

constexpr std::uint64_t kOutsideEvery = 20;
constexpr std::uint64_t kGoallessEvery = 3;

bool starts_free(const Condition& condition) {
  Spec spec;
  Random random(1);
  condition.make(spec, random);
  return spec.start == Start::free;
}

std::vector<const Condition*> conditions_of(bool promised) {
  std::vector<const Condition*> conditions;
  for (const Condition& condition : all_conditions()) {
    if (condition.promised == promised && starts_free(condition)) conditions.push_back(&condition);
  }
  return conditions;
}

// How the person steers, and how well the messages come through.
void give_device(Spec& s, Random& r) {
  if (r.chance(0.4)) return;
  s.link = r.of({Link::prompt, Link::late, Link::frozen, Link::silent, Link::nonsense});
  s.parameters.mode = r.of({OperatorMode::joystick, OperatorMode::switching});
  s.parameters.guard = Guard::nearest;
  s.parameters.linear = r.of({LinearPolicy::v_max, LinearPolicy::axis, LinearPolicy::axis});
  if (r.chance(0.2)) s.limits_change = true;
}

// How far a robot drives and how long it takes from the last cycle that did not know of somebody until it rests: who
// appears nearer cannot be allowed for.
void keep_out_of_reach(Spec& s) {
  const Parameters& p = s.parameters;
  const double dec_x = braking_x(p), dec_theta = braking_theta(p);
  const double waits = p.control_latency + 1e-3 * s.period * (2.0 + s.late_most);
  const double v = p.max_vel_x, omega = p.max_vel_theta;
  const double way = v * waits + 0.5 * v * v / dec_x;
  const double turn = outermost(shape_of(s.outline)) * (omega * waits + 0.5 * omega * omega / dec_theta);
  s.bounds.appear = way + turn + s.bounds.speed * (waits + std::max(v / dec_x, omega / dec_theta));
}

void add(Spec& s, bool condition_has_speed, Random& r) {
  if (!condition_has_speed) s.parameters.max_vel_x = r.of({0.5, 1.0, 1.5, 2.0, 2.0});
  if (s.parameters.max_vel_x > 1.0 && s.resolution < 0.05) s.resolution = 0.05;
  s.relentless = r.chance(0.8);
  give_device(s, r);
  if (s.walkers == 0 && r.chance(0.3)) s.walkers = r.whole(1, 6);
  if (s.walkers > 0) keep_out_of_reach(s);
}

// Without a goal all the time, or one that comes and goes.
void take_goal(Spec& s, Random& r) {
  s.parameters.linear = LinearPolicy::axis;
  s.goalless = r.of({0.5, 1.0});
}

}  // namespace

Case case_of(const Condition& condition, std::uint64_t seed) {
  Spec spec = spec_of(condition, seed);
  const char* place = name_of(spec.place);
  return {&condition, place, std::move(spec), seed};
}

Case mixed_case(std::uint64_t attack_seed, std::uint64_t number, const std::vector<Ground>& grounds) {
  static const std::vector<const Condition*> within = conditions_of(true), beyond = conditions_of(false);
  const bool promised = number % kOutsideEvery != kOutsideEvery - 1;
  const std::vector<const Condition*>& conditions = promised ? within : beyond;
  const std::uint64_t turn = promised ? number - number / kOutsideEvery : number / kOutsideEvery;
  Case drive = case_of(*conditions[turn % conditions.size()], Random(attack_seed * 1000003ULL + number).bits() >> 20);
  Random random(drive.seed ^ 0xdeadbeefULL);
  const bool has_speed = drive.spec.parameters.max_vel_x > 1.0;
  add(drive.spec, has_speed, random);
  if (number % kGoallessEvery == kGoallessEvery - 1) take_goal(drive.spec, random);
  if (!grounds.empty() && random.chance(0.5)) {
    const Ground& ground = grounds[static_cast<std::size_t>(random.whole(0, static_cast<int>(grounds.size()) - 1))];
    drive.spec.ground = ground.world;
    drive.spec.resolution = ground.world->resolution();
    drive.place = ground.name;
  }
  return drive;
}

const char* name_of(Link link) {
  switch (link) {
    case Link::prompt:
      return "prompt";
    case Link::late:
      return "late";
    case Link::frozen:
      return "frozen";
    case Link::silent:
      return "silent";
    case Link::nonsense:
      return "nonsense";
  }
  return "";
}

}  // namespace hidwa_attack
