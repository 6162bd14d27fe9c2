// SPDX-License-Identifier: BSD-3-Clause
#include "conditions.hpp"

#include <cmath>

namespace hidwa_attack {
namespace {

using hidwa_local_planner::Admissibility;
using hidwa_local_planner::Generator;
using hidwa_local_planner::LinearPolicy;
using hidwa_local_planner::Method;

void rate(Spec& s, int hertz) { s.period = 1000 / hertz; }
void latency(Spec& s, int milliseconds) {
  s.latency = milliseconds;
  s.parameters.control_latency = 1e-3 * milliseconds;
}
void unequal(Spec& s, Random& r) {
  s.parameters.acc_lim_x = r.in(0.8, 3.0);
  s.parameters.decel_lim_x = -r.in(0.8, 3.0);
  s.parameters.acc_lim_theta = r.in(1.5, 5.0);
  s.parameters.decel_lim_theta = -r.in(1.5, 5.0);
}
void late(Spec& s, bool catches_up) {
  s.late_share = 0.2;
  s.late_most = 2.0;
  s.catches_up = catches_up;
}
void fast(Spec& s, double speed) {
  s.parameters.max_vel_x = speed;
  if (speed > 1.0 && s.resolution < 0.05) s.resolution = 0.05;
}
void backwards(Spec& s, Random& r) { s.parameters.min_vel_x = -s.parameters.max_vel_x * r.of({0.4, 1.0}); }

// Robot and host of a usual kind; every condition begins with it.
Spec usual(Random& r) {
  Spec s;
  Parameters& p = s.parameters;
  s.outline = r.of({Outline::octagon, Outline::long_rectangle, Outline::off_centre, Outline::circle});
  s.place =
      r.of({Place::posts, Place::posts, Place::walls, Place::walls, Place::corridor, Place::dead_ends, Place::clutter});
  s.resolution = r.of({0.025, 0.05, 0.05, 0.05, 0.1});
  p.max_vel_x = r.of({0.5, 0.5, 1.0});
  p.max_vel_theta = r.of({1.0, 1.0, 2.0});
  p.footprint_padding = r.of({0.0, 0.0, 0.02});
  p.sim_time = r.of({1.85, 1.85, 0.8});
  p.vx_samples = 10;
  p.vth_samples = 15;
  p.cycle_budget = -1.0;
  // The stick says what the person wants, to the full and backwards too.
  p.linear = LinearPolicy::axis;
  p.exponent = 1.0;
  p.stop_pull = 0.0;
  return s;
}

// Commands that use up less than a period's limits, beside obstacles: then it matters how they are reached.
void half_steps(Spec& s, Random& r) {
  s.parameters.generator = r.of({Generator::standard, Generator::dwa, Generator::dwa});
  s.place = r.of({s.place, Place::corridor, Place::walls, Place::posts});
  s.parameters.max_vel_theta = 2.0;
  s.parameters.vth_samples = r.of({15, 25});
}

void latency_varies(Spec& s, Random& r) {
  latency(s, r.of({100, 100, 300}));
  s.latency_varies = true;
  s.reaching = r.of({Reaching::evenly, Reaching::either});
}

// A base at either end of what it may do, whose ends sweep far, and the braking check alone to decide.
void either(Spec& s, Random& r, int hertz) {
  s.outline = r.of({Outline::long_rectangle, Outline::off_centre});
  s.reaching = Reaching::either;
  rate(s, hertz);
  s.parameters.sim_time = r.of({0.1, 0.2, 0.3, 0.4});
  fast(s, r.of({0.5, 1.0, 2.0}));
  half_steps(s, r);
  if (r.chance(0.3)) backwards(s, r);
}

// Everything that is promised, at random.
void anything(Spec& s, Random& r) {
  if (r.chance(0.5)) rate(s, r.of({5, 10, 20, 40}));
  if (r.chance(0.3)) fast(s, 2.0);
  if (r.chance(0.4)) unequal(s, r);
  if (r.chance(0.4)) backwards(s, r);
  latency(s, r.of({0, 100, 100, 300, 700}));
  if (r.chance(0.2)) s.latency = r.whole(0, s.latency);
  s.reaching = r.of({Reaching::evenly, Reaching::at_limit, Reaching::anyhow, Reaching::anyhow});
  if (r.chance(0.4)) late(s, r.chance(0.3));
  s.odometry = r.of(
      {Odometry::exact, Odometry::noisy, Odometry::outliers, Odometry::outliers, Odometry::delayed, Odometry::silent});
  if (r.chance(0.4)) s.pose_age = 50;
  if (r.chance(0.3)) s.parameters.method = Method::paper;
  if (r.chance(0.3)) s.parameters.generator = Generator::dwa;
  if (r.chance(0.2)) s.parameters.sim_time = 0.2;
  if (r.chance(0.2)) s.limits_change = true;
}

// Outlines.
std::vector<Condition> outlines() {
  return {
      {"octagon", true, "octagon of 0.30 m", [](Spec& s, Random&) { s.outline = Outline::octagon; }},
      {"long_rectangle", true, "0.9 m x 0.4 m", [](Spec& s, Random&) { s.outline = Outline::long_rectangle; }},
      {"off_centre", true, "0.65 m x 0.40 m, centre near one end",
       [](Spec& s, Random&) { s.outline = Outline::off_centre; }},
      {"circle", true, "circle of 0.25 m", [](Spec& s, Random&) { s.outline = Outline::circle; }},
  };
}

// Rates, speeds, limits, latencies.
std::vector<Condition> rates() {
  return {
      {"rate_5", true, "5 Hz", [](Spec& s, Random&) { rate(s, 5); }},
      {"rate_10", true, "10 Hz", [](Spec& s, Random&) { rate(s, 10); }},
      {"rate_40", true, "40 Hz", [](Spec& s, Random&) { rate(s, 40); }},
      {"speed_1", true, "1 m/s, 2 rad/s",
       [](Spec& s, Random&) {
         fast(s, 1.0);
         s.parameters.max_vel_theta = 2.0;
       }},
      {"speed_2", true, "2 m/s", [](Spec& s, Random&) { fast(s, 2.0); }},
      {"reverse", true, "min_vel_x negative", backwards},
      {"unequal_limits", true, "acceleration and deceleration differ",
       [](Spec& s, Random& r) {
         unequal(s, r);
         backwards(s, r);
       }},
      {"latency_0", true, "no latency", [](Spec& s, Random&) { latency(s, 0); }},
      {"latency_300", true, "0.3 s", [](Spec& s, Random&) { latency(s, 300); }},
      {"latency_700", true, "0.7 s", [](Spec& s, Random&) { latency(s, 700); }},
      {"latency_less", true, "less than told",
       [](Spec& s, Random& r) {
         latency(s, 300);
         s.latency = r.whole(0, 300);
       }},
      {"latency_less_40hz", true, "less than told, 0.5 s at 40 Hz",
       [](Spec& s, Random& r) {
         latency(s, 500);
         rate(s, 40);
         s.latency = r.whole(0, 500);
       }},
  };
}

// How commands are reached.
std::vector<Condition> reaching() {
  return {
      {"at_limit", true, "the base ramps at its limits", [](Spec& s, Random&) { s.reaching = Reaching::at_limit; }},
      {"at_limit_5hz_2ms", true, "at its limits, 5 Hz and 2 m/s",
       [](Spec& s, Random& r) {
         s.reaching = Reaching::at_limit;
         rate(s, 5);
         fast(s, 2.0);
         half_steps(s, r);
       }},
      {"at_limit_10hz", true, "at its limits, 10 Hz",
       [](Spec& s, Random& r) {
         s.reaching = Reaching::at_limit;
         rate(s, 10);
         fast(s, r.of({0.5, 1.0, 2.0}));
         half_steps(s, r);
       }},
      {"at_limit_unequal", true, "at its limits, which differ, also backwards",
       [](Spec& s, Random& r) {
         s.reaching = Reaching::at_limit;
         rate(s, r.of({5, 10}));
         unequal(s, r);
         backwards(s, r);
         half_steps(s, r);
       }},
      {"anyhow_5hz_2ms", true, "each command and axis its own way, 5 Hz and 2 m/s",
       [](Spec& s, Random& r) {
         s.reaching = Reaching::anyhow;
         rate(s, 5);
         fast(s, 2.0);
         half_steps(s, r);
       }},
      {"anyhow", true, "at its limits, evenly or between, each command and axis anew",
       [](Spec& s, Random& r) {
         s.reaching = Reaching::anyhow;
         rate(s, r.of({5, 10, 20}));
         fast(s, r.of({0.5, 1.0, 2.0}));
         half_steps(s, r);
       }},
      {"either_5hz", true, "at its limits or evenly, each command and axis anew, 5 Hz, short sim_time",
       [](Spec& s, Random& r) { either(s, r, 5); }},
      {"either_10hz", true, "the same, 10 Hz", [](Spec& s, Random& r) { either(s, r, 10); }},
      {"either_stray", true, "the same, starts with cells under the outline",
       [](Spec& s, Random& r) {
         either(s, r, r.of({5, 10, 20}));
         s.start = r.of({Start::stray, Start::grazing});
       }},
  };
}

// Late cycles.
std::vector<Condition> lateness() {
  return {
      {"late", true, "20 % of the cycles up to two periods late", [](Spec& s, Random&) { late(s, false); }},
      {"late_10hz", true, "the same at 10 Hz",
       [](Spec& s, Random&) {
         late(s, false);
         rate(s, 10);
       }},
      {"late_again", true, "a cycle is two periods late whenever the last such is about to be forgotten",
       [](Spec& s, Random& r) {
         s.late_again = true;
         s.late_most = 2.0;
         rate(s, r.of({5, 10}));
         fast(s, r.of({0.5, 1.0, 2.0}));
         s.parameters.sim_time = r.of({0.2, 0.4, 1.85});
       }},
      {"clock_set_back", true, "the clock is set back by up to 20 s again and again, latency 0.1 to 0.5 s",
       [](Spec& s, Random& r) {
         s.clock_set = true;
         latency(s, r.of({100, 300, 500}));
         s.parameters.sim_time = r.of({0.2, 0.8, 1.85});
       }},
      {"late_catching_up", true, "the same, and the host catches up as ros::Rate does",
       [](Spec& s, Random&) { late(s, true); }},
  };
}

// Odometry and pose.
std::vector<Condition> sensing() {
  return {
      {"odometry_noisy", true, "5 % off", [](Spec& s, Random&) { s.odometry = Odometry::noisy; }},
      {"odometry_outliers", true, "1 % up to 10 m/s and 20 rad/s",
       [](Spec& s, Random&) { s.odometry = Odometry::outliers; }},
      {"odometry_slips", true, "2 % zero, of the other sign, or a part of the true one, up to two in a row",
       [](Spec& s, Random& r) {
         s.odometry = Odometry::slips;
         s.parameters.sim_time = r.of({0.2, 0.8, 1.85});
       }},
      {"odometry_delayed", true, "late by the latency",
       [](Spec& s, Random& r) {
         latency(s, r.of({100, 300}));
         s.odometry = Odometry::delayed;
       }},
      {"odometry_silent", true, "0.3 to 1.5 s of silence", [](Spec& s, Random&) { s.odometry = Odometry::silent; }},
      {"odometry_flickers", true, "silent for one to three cycles again and again, latency 0.2 to 0.5 s",
       [](Spec& s, Random& r) {
         latency(s, r.of({200, 300, 500}));
         s.odometry = Odometry::flickers;
         s.parameters.sim_time = r.of({0.2, 0.8, 1.85});
       }},
      {"pose_50ms", true, "the pose is 50 ms old", [](Spec& s, Random&) { s.pose_age = 50; }},
  };
}

// Options for which the claim is made.
std::vector<Condition> options() {
  return {
      {"method_paper", true, "method: paper, the braking check on",
       [](Spec& s, Random&) { s.parameters.method = Method::paper; }},
      {"method_paper_delayed", true, "the same, odometry late by the latency",
       [](Spec& s, Random& r) {
         s.parameters.method = Method::paper;
         s.odometry = Odometry::delayed;
         latency(s, r.of({100, 300}));
       }},
      {"method_paper_outliers", true, "the same, with outliers",
       [](Spec& s, Random&) {
         s.parameters.method = Method::paper;
         s.odometry = Odometry::outliers;
       }},
      {"generator_dwa", true, "generator: dwa", [](Spec& s, Random&) { s.parameters.generator = Generator::dwa; }},
      {"short_sim_time", true, "sim_time 0.2 s: the braking check alone decides",
       [](Spec& s, Random& r) {
         s.parameters.sim_time = 0.2;
         fast(s, r.of({0.5, 1.0, 2.0}));
       }},
      {"quick_base", true, "2 m/s, 4 rad/s, strong brakes, sim_time 0.2 s, latencies of 50 to 170 ms",
       [](Spec& s, Random& r) {
         fast(s, 2.0);
         s.parameters.max_vel_theta = 4.0;
         s.parameters.acc_lim_x = 10.0;
         s.parameters.acc_lim_theta = 20.0;
         s.parameters.sim_time = 0.2;
         latency(s, r.of({50, 100, 120, 170}));
       }},
      {"lowered_limits", true, "max_vel_x and max_vel_theta are lowered and raised while it drives",
       [](Spec& s, Random&) {
         s.limits_change = true;
         fast(s, 1.0);
       }},
      {"lowered_limits_short", true, "the same, sim_time shorter than a period",
       [](Spec& s, Random& r) {
         s.limits_change = true;
         fast(s, 1.0);
         rate(s, 5);
         s.parameters.sim_time = r.of({0.1, 0.15});
       }},
      {"anything", true, "all of these at random", anything},
  };
}

// Somebody who moves.
std::vector<Condition> people() {
  return {
      {"beside_walls", true, "people who walk beside walls, and whose points explain cells",
       [](Spec& s, Random& r) {
         s.walkers = 4;
         s.points_told = true;
         s.bounds.position_error = r.of({0.01, 0.03});
         fast(s, r.of({0.5, 1.0, 2.0}));
         s.parameters.sim_time = r.of({1.85, 0.4, 0.2});
       }},
  };
}

// Starts in collision.
std::vector<Condition> starts() {
  return {
      {"stray_cells", true, "starts with cells under the outline", [](Spec& s, Random&) { s.start = Start::stray; }},
      {"grazing", true, "starts in the edge of an obstacle",
       [](Spec& s, Random& r) {
         s.start = Start::grazing;
         if (r.chance(0.3)) backwards(s, r);
       }},
      {"appearing", true, "the map adds cells under the robot while it drives",
       [](Spec& s, Random&) { s.start = Start::appearing; }},
  };
}

// Outside the promise.
std::vector<Condition> outside() {
  return {
      {"out_latency_more", false, "latency 0.1 s more than told", [](Spec& s, Random&) { s.latency += 100; }},
      {"out_latency_varies", false, "from command to command between 0 and what is told",
       [](Spec& s, Random& r) { latency_varies(s, r); }},
      {"out_latency_varies_short", false, "the same, short sim_time",
       [](Spec& s, Random& r) {
         latency_varies(s, r);
         s.parameters.sim_time = r.of({0.1, 0.2, 0.3, 0.4});
       }},
      {"out_weak_brakes", false, "decelerations half of those told",
       [](Spec& s, Random&) {
         s.brakes = 0.5;
         fast(s, 1.0);
       }},
      {"out_map_late", false, "what comes into sight is mapped 0.3 s late",
       [](Spec& s, Random&) {
         s.map_delay = 300;
         fast(s, 1.0);
         if (s.outline == Outline::circle) s.outline = Outline::octagon;
       }},
      {"out_very_late", false, "20 % of the cycles up to five periods late",
       [](Spec& s, Random&) {
         late(s, false);
         s.late_most = 5.0;
         s.surprises = true;
       }},
      {"out_late_unannounced", false, "20 % of the cycles up to two periods late, later than any of the last 3 s",
       [](Spec& s, Random&) {
         late(s, false);
         rate(s, 10);
         s.surprises = true;
       }},
      {"out_pose_unknown_age", false, "the pose is 0.1 s old and nobody knows",
       [](Spec& s, Random&) {
         s.pose_age = 100;
         s.age_told = false;
       }},
      {"out_odometry_dead", false, "odometry says 0 from some moment on",
       [](Spec& s, Random&) { s.odometry = Odometry::dead; }},
      {"out_horizon", false, "admissibility: horizon",
       [](Spec& s, Random&) { s.parameters.admissibility = Admissibility::horizon; }},
  };
}

// Likewise: what slips, what flickers, and people.
std::vector<Condition> outside_too() {
  return {
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
      {"out_walkers_doubtful", false, "errors of people thrice as large as told",
       [](Spec& s, Random&) {
         s.walkers = 4;
         s.bounds.told_errors = 1.0 / 3.0;
       }},
  };
}

std::vector<Condition> table() {
  std::vector<Condition> table;
  for (const auto group :
       {outlines, rates, reaching, lateness, sensing, options, people, starts, outside, outside_too}) {
    for (const Condition& condition : group()) table.push_back(condition);
  }
  return table;
}

}  // namespace

const std::vector<Condition>& all_conditions() {
  static const std::vector<Condition> conditions = table();
  return conditions;
}

const Condition* find_condition(const std::string& name) {
  for (const Condition& condition : all_conditions()) {
    if (name == condition.name) return &condition;
  }
  return nullptr;
}

// The draws of a seed are the same under every condition, so far as that leaves them: conditions compare in pairs.
Spec spec_of(const Condition& condition, std::uint64_t seed) {
  Random random(seed * 2);
  Spec spec = usual(random);
  Random own(seed * 2 + 1);
  condition.make(spec, own);
  return spec;
}

}  // namespace hidwa_attack
