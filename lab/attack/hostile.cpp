// SPDX-License-Identifier: BSD-3-Clause
#include "hostile.hpp"

#include <algorithm>

#include "braking.hpp"
#include "conditions.hpp"

namespace hidwa_attack {
namespace {

using hidwa_local_planner::Guard;
using hidwa_local_planner::LinearPolicy;
using hidwa_local_planner::OperatorMode;

constexpr int kSeconds = 20;  // of a drive [s]
constexpr std::uint64_t kOutsideEvery = 20;
constexpr std::uint64_t kGoallessEvery = 3;

// What only a study does.
const std::vector<Condition>& study_only() {
  static const std::vector<Condition> conditions{
      {"out_slip", false, "the base slips by up to 10 %", [](Spec& s, Random&) { s.slip = 0.1; }},
      {"out_flicker", false,
       "a fifth of the free cells beside lethal ones flicker: the robot stands in what is not there",
       [](Spec& s, Random&) { s.flicker = 0.2; }},
      {"out_walkers_fast", false, "people of twice the speed and acceleration",
       [](Spec& s, Random&) {
         s.walkers = 4;
         s.bounds.speed *= 2.0;
         s.bounds.acc *= 2.0;
       }},
      {"out_walkers_untold", false, "people of whom the planner knows nothing",
       [](Spec& s, Random&) {
         s.walkers = 4;
         s.walkers_told = false;
       }},
      {"out_walkers_doubtful", false, "errors thrice as large as told",
       [](Spec& s, Random&) {
         s.walkers = 4;
         s.bounds.told_errors = 1.0 / 3.0;
       }},
  };
  return conditions;
}

bool starts_free(const Condition& condition) {
  Spec spec;
  Random random(1);
  condition.make(spec, random);
  return spec.start == Start::free;
}

std::vector<Condition> conditions_of(bool promised) {
  std::vector<Condition> conditions;
  for (const Condition& condition : all_conditions()) {
    if (condition.promised == promised && starts_free(condition)) conditions.push_back(condition);
  }
  if (!promised) conditions.insert(conditions.end(), study_only().begin(), study_only().end());
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

HostileDrive hostile_drive(std::uint64_t study_seed, std::uint64_t index, const std::vector<Ground>& grounds) {
  static const std::vector<Condition> within = conditions_of(true), beyond = conditions_of(false);
  HostileDrive drive;
  drive.promised = index % kOutsideEvery != kOutsideEvery - 1;
  const std::vector<Condition>& conditions = drive.promised ? within : beyond;
  const std::uint64_t turn = drive.promised ? index - index / kOutsideEvery : index / kOutsideEvery;
  const Condition& condition = conditions[turn % conditions.size()];
  drive.condition = condition.name;
  drive.seed = Random(study_seed * 1000003ULL + index).bits() >> 20;
  drive.spec = spec_of(condition, drive.seed, kSeconds);
  Random random(drive.seed ^ 0xdeadbeefULL);
  const bool has_speed = drive.spec.parameters.max_vel_x > 1.0;
  add(drive.spec, has_speed, random);
  if (index % kGoallessEvery == kGoallessEvery - 1) take_goal(drive.spec, random);
  drive.place = name_of(drive.spec.place);
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
