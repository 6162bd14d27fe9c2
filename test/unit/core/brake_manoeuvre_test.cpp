// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/brake_manoeuvre.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/collision/admissibility.hpp"
#include "core/motion/command_history.hpp"
#include "core/motion/late_cycles.hpp"
#include "support/naive_collision.hpp"
#include "support/naive_gap.hpp"
#include "support/naive_manoeuvre.hpp"
#include "support/naive_reference.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

VelocityLimits limits(double braking_x, double braking_theta) {
  VelocityLimits l;
  l.x = {-2.0, 2.0, 2.5, braking_x};
  l.theta = {-3.0, 3.0, 3.2, braking_theta};
  return l;
}

std::vector<Pose2> poses(const BrakeManoeuvre& m, const VelocityLimits& l, double radius = 0.3,
                         double spacing = 0.025) {
  std::vector<Pose2> out;
  ManoeuvreRoller roller(l, radius, spacing, TurnedPose::of(m.start));
  roller.roll(m, [&out](const TurnedPose& at) {
    out.push_back(at.pose);
    return true;
  });
  return out;
}

PendingMotion motion_of(const Twist2& begin, const std::vector<PendingMotion::Leg>& legs) {
  PendingMotion motion;
  motion.begin(begin);
  for (const PendingMotion::Leg& leg : legs) motion.add(leg.end, leg.duration, leg.spread);
  return motion;
}

// From 0.1 m/s to 0.5, to -0.7 and to 0.2 m/s, in 1 s each, and to 0.4 rad/s in the last of them.
TEST(PendingMotions, AreBoundedLegByLeg) {
  const PendingMotion motion =
      motion_of({0.1, 0.0}, {{{0.5, 0.0}, 1.0, {0.01, 0.0}}, {{-0.7, 0.0}, 1.0, {0.02, 0.03}}, {{0.2, 0.4}, 1.0, {}}});
  EXPECT_EQ(motion.fastest(), (Twist2{0.7, 0.4}));
  EXPECT_NEAR(motion.reach(), 0.5 + 0.7 + 0.7, 1e-12);
  EXPECT_NEAR(motion.reach(2.0), 0.5 + 0.7 + 1.0, 1e-12);  // 0.2 + 2 x 0.4 m/s in the last
  EXPECT_NEAR(motion.spread().v, 0.01 + 0.02, 1e-12);
  EXPECT_NEAR(motion.spread().omega, 0.03, 1e-12);
  EXPECT_EQ(PendingMotion({-0.3, 0.0}, 1.0).fastest().v, 0.3);
}

// A cycle that comes 0.15 s after the last one, at 0.05 s, and another such: 2 (0.15 - 0.05) = 0.2 s later.
TEST(LateCycles, AreLookedAtHalfAPeriodApartButNotWithoutEnd) {
  EXPECT_NEAR(latest_hold(0.05, 0.15), 0.2, 1e-12);
  const auto parts = [](double latest, double period) {
    return late_parts(latest, late_times_apart(latest, period), period);
  };
  EXPECT_EQ(parts(0.19, 0.05), 8.0);    // 7.6 parts of 0.025 s
  EXPECT_EQ(parts(0.19, 0.001), 19.0);  // of 0.01 s: half a period is less
  EXPECT_EQ(parts(19.9, 0.05), 200.0);  // of 0.0995 s: half a period would be 796
  EXPECT_EQ(parts(0.006, 0.05), 1.0);
  EXPECT_EQ(parts(0.004, 0.05), 0.0);  // below 0.005 s it is punctual
  EXPECT_EQ(parts(0.0, 0.05), 0.0);
}

// The last of braking, what takes half a period at the limit, is done evenly over a period: with a limit b and a period
// T that is b T / 2 over T instead of T / 2, b T^2 / 8 more.
double tail(double braking) { return braking * 0.05 * 0.05 / 8.0; }

// A robot is sent a command while a motion is pending.
struct Stop {
  const char* of;
  PendingMotion pending;
  Twist2 command;
  double x, theta;    // where it rests [m], [rad]
  double hold = 0.0;  // the command to brake is so late [s]
};

// It brakes at 2 m/s^2 and at 1.6 rad/s^2.
TEST(BrakeManoeuvreDistance, IsThatOfEachPart) {
  for (const Stop& stop : {
           // 0.1 s at 0.5, 0.05 s from 0.5 to 0.4, then 0.4^2 / (2 * 2) and the tail.
           Stop{"straight on", {{0.5, 0.0}, 0.1}, {0.4, 0.0}, 0.05 + 0.0225 + 0.04 + tail(2.0), 0.0},
           // 0.05 s at 0.4, 0.03 s more, then 0.4^2 / (2 * 2).
           Stop{"late", {{0.4, 0.0}, 0.0}, {0.4, 0.0}, 0.02 + 0.012 + 0.04 + tail(2.0), 0.0, 0.03},
           // From 0.03 m/s, less than 2 * 0.05 / 2: 0.05 s at it, and evenly over 0.05 s.
           Stop{"nothing but a tail", {{0.03, 0.0}, 0.0}, {0.03, 0.0}, 0.0015 + 0.00075, 0.0},
           // From -0.05 evenly to 0.05 it gets nowhere; then, all of it tail, evenly to rest: 0.05 * 0.05 / 2.
           Stop{"the other way", {{-0.05, 0.0}, 0.0}, {0.05, 0.0}, 0.00125, 0.0},
           // 0.1 * 1.0, 0.05 s from 1 to 0.92: it is on its way to 0.8 yet when the next command takes effect. Then
           // 0.92^2 / (2 * 1.6) = 0.2645 rad.
           Stop{"on the spot", {{0.0, 1.0}, 0.1}, {0.0, 0.8}, 0.0, 0.1 + 0.048 + 0.2645 + tail(1.6)},
       }) {
    const BrakeManoeuvre manoeuvre{{1.0, 2.0, 0.0}, stop.pending, stop.command, 0.05, stop.hold};
    const Pose2 end = poses(manoeuvre, limits(2.0, 1.6)).back();
    EXPECT_NEAR(end.x, 1.0 + stop.x, 1e-12) << stop.of;
    EXPECT_EQ(end.y, 2.0) << stop.of;
    EXPECT_NEAR(end.theta, stop.theta, 1e-12) << stop.of;
  }
}

// It has begun to brake at 2.5 m/s^2 and the robot does not yet: 0.5^2 / (2 * 2.5) = 0.05 m from here, of which
// 0.05 * (0.4375 + 0.3125) = 0.0375 m within the latency. The last command alone would have said 0.1 * 0.25.
TEST(BrakeManoeuvreDistance, ThePendingMotionComesFirst) {
  const PendingMotion braking = motion_of({0.5, 0.0}, {{{0.375, 0.0}, 0.05, {}}, {{0.25, 0.0}, 0.05, {}}});
  const BrakeManoeuvre m{{}, braking, {0.125, 0.0}, 0.05};
  EXPECT_NEAR(poses(m, limits(2.5, 3.0)).back().x, 0.05 + tail(2.5), 1e-12);
  // The faster end of each leg: 0.05 * (0.5 + 0.375); two periods at 0.25, and 0.25^2 / 5.
  EXPECT_NEAR(m.reach(limits(2.5, 3.0)), 0.04375 + 0.025 + 0.0125, 1e-12);
  // Late by 0.03 s: two periods and that at 0.4, and 0.4^2 / (2 * 2) to rest.
  const PendingMotion steady({0.4, 0.0}, 0.0);
  const BrakeManoeuvre late{{}, steady, {0.4, 0.0}, 0.05, 0.03};
  EXPECT_NEAR(late.reach(limits(2.0, 3.0)), 0.4 * 0.13 + 0.04, 1e-12);
}

TEST(BrakeManoeuvreDistance, AtRestItDoesNotMove) {
  const PendingMotion rest({}, 0.5);
  EXPECT_TRUE(poses({{1.0, 2.0, 0.3}, rest, {}, 0.05}, limits(2.0, 3.0)).empty());
}

Twist2 random_velocity(test::Random& random) { return {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)}; }

PendingMotion random_way(test::Random& random) {
  PendingMotion way;
  way.begin(random_velocity(random));
  for (int legs = random.integer(0, 3); legs > 0; --legs) {
    const double duration = random.uniform(0.0, 0.1);
    way.add(random.chance(0.3) ? way.end() : random_velocity(random), duration);
  }
  return way;
}

// Of a disc of `radius` [m], the point that moves farthest between two poses.
double displacement(const Pose2& a, const Pose2& b, double radius) {
  return std::hypot(a.x - b.x, a.y - b.y) + 2.0 * radius * std::abs(std::sin(0.5 * (a.theta - b.theta)));
}

TEST(BrakeManoeuvrePoses, NoPointOfTheRobotMovesFartherThanTheSpacing) {
  test::Random random(7);
  for (int k = 0; k < 300; ++k) {
    const PendingMotion way = random_way(random);
    const BrakeManoeuvre m{{0.0, 0.0, random.uniform(-3.0, 3.0)}, way, random_velocity(random), 0.05};
    const double radius = random.uniform(0.1, 0.6);
    Pose2 before = m.start;
    for (const Pose2& pose : poses(m, limits(1.0, 2.0), radius, 0.02)) {
      ASSERT_LE(displacement(before, pose, radius), 0.02 + 1e-9);
      ASSERT_LE(std::hypot(pose.x, pose.y), m.reach(limits(1.0, 2.0)) + 1e-9);
      before = pose;
    }
  }
}

TEST(BrakeManoeuvrePoses, EndsWhereAFineIntegrationEnds) {
  test::Random random(8);
  Parameters p;
  p.acc_lim_x = 2.5;
  p.acc_lim_theta = 3.2;
  p.decel_lim_x = -1.0;
  p.decel_lim_theta = -2.0;
  const VelocityLimits l = VelocityLimits::from(p);
  constexpr double kPeriod = 0.05;
  for (int k = 0; k < 300; ++k) {
    p.control_latency = random.uniform(0.0, 0.3);
    CommandHistory history;
    std::vector<test::NaiveCycle> cycles{{0.0, kPeriod, random_velocity(random), {}, 0.0}};
    for (int cycle = 0; cycle < 10; ++cycle) {
      if (cycle > 0) {
        const double late = random.chance(0.2) ? random.uniform(-0.02, 0.05) : 0.0;
        const Twist2 next = l.step(cycles.back().last_command, random_velocity(random), kPeriod);
        cycles.push_back({cycles.back().time + kPeriod + late, kPeriod, next, {}, 0.0});
      }
      history.observe(cycles.back().time, kPeriod, p.control_latency + kPeriod, cycles.back().last_command, l);
    }
    PendingMotion pending;
    const test::NaiveLag lag{random.chance(0.5), random.chance(0.5)};
    history.play(l, kPeriod, p.control_latency, 0.0, pending, {lag.v, lag.omega});
    const Pose2 start{0.3, -0.2, random.uniform(-3.0, 3.0)};
    const double hold = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.1);
    const Twist2 command = l.step(history.last(), random_velocity(random), kPeriod);
    const Pose2 end = poses({start, pending, command, kPeriod, hold}, l, 0.3, 1e-4).back();
    const test::NaiveHistory twin(p, cycles);
    const test::NaiveEffects effects = twin.effects().lagging(twin.first_shown(), lag);
    const test::NaiveManoeuvre naive = test::naive_manoeuvre(p, start, effects, command, kPeriod, hold);
    const Pose2 fine = test::naive_poses(naive, 0.3, 0.005).back();
    ASSERT_NEAR(end.x, fine.x, 1e-4) << k;
    ASSERT_NEAR(end.y, fine.y, 1e-4) << k;
    ASSERT_NEAR(end.theta, fine.theta, 1e-4) << k;
  }
}

// A base that reaches every command in a way of its own between the two ends, which changes at random times.
class RandomBase {
 public:
  // `ends`: it takes one of the two ends for each command.
  RandomBase(const test::NaiveAxis& axis, double velocity, test::Random& random, bool ends)
      : axis_(axis),
        from_(velocity),
        to_(velocity),
        random_(&random),
        share_(random.pick({0.0, 1.0, 0.5})),
        ends_(ends),
        restless_(!ends && random.chance(0.5)) {}
  void command(double time, double velocity) {
    from_ = at(time);
    if (ends_) share_ = random_->pick({0.0, 1.0});
    to_ = velocity;
    since_ = time;
  }
  double at(double time) {
    if (restless_ && random_->chance(0.05))
      share_ = random_->chance(0.5) ? random_->pick({0.0, 1.0}) : random_->uniform(0.0, 1.0);
    const double t = time - since_, limit = test::naive_at_limit(axis_, from_, to_, t);
    // A command that asks for all that the limits allow may be reached evenly too.
    if (!test::naive_has_time(axis_, from_, to_)) return limit;
    return share_ * limit + (1.0 - share_) * test::naive_evenly(axis_, from_, to_, t);
  }

 private:
  test::NaiveAxis axis_;
  double from_, to_, since_ = -1e9;
  test::Random* random_;
  double share_;
  bool ends_, restless_;
};

// Commands of the past, one that is sent now, and those that brake after it.
struct Sending {
  std::vector<test::NaiveEffect> effects;
  PendingMotionSet pending;
  Twist2 last, own;
};

Sending random_sending(const Parameters& p, double period, test::Random& random) {
  const VelocityLimits l = VelocityLimits::from(p);
  const double gentle = random.chance(0.5) ? random.uniform(0.0, 1.0) : 1.0;
  const auto next = [&](const Twist2& u, const Twist2& target) {
    const Twist2 full = l.step(u, target, period);
    return Twist2{u.v + gentle * (full.v - u.v), u.omega + gentle * (full.omega - u.omega)};
  };
  const auto any = [&] {
    return Twist2{random.uniform(p.min_vel_x, p.max_vel_x), random.uniform(-p.max_vel_theta, p.max_vel_theta)};
  };
  constexpr int kCycles = 14;
  Sending sending;
  CommandHistory history;
  Twist2 u = any(), target = any();
  for (int k = 0; k < kCycles; ++k) {
    if (random.chance(0.4)) target = any();
    if (k > 0) u = next(u, target);
    history.observe(k * period, period, p.control_latency + period, u, l);
    sending.effects.push_back({(std::max(k - 1, 0) - kCycles + 1) * period + p.control_latency, u});
  }
  history.play(l, period, p.control_latency, 0.0, sending.pending.first());
  for (const Lag& lag : kLags) history.play(l, period, p.control_latency, 0.0, sending.pending.add_lagging(), lag);
  sending.last = u;
  sending.own = u = next(u, any());
  for (int k = 0; k == 0 || !(u == Twist2{}); ++k) {
    sending.effects.push_back({k * period + p.control_latency, u});
    u = l.brake(u, period);
  }
  sending.effects.push_back({sending.effects.back().time + period, {}});
  return sending;
}

// The poses from now on.
std::vector<Pose2> drive(const Parameters& p, double period, const Sending& sending, test::Random& random,
                         bool ends = false) {
  constexpr double kDt = 5e-4;  // [s]
  RandomBase v(test::naive_axis_x(p, period), sending.effects[0].command.v, random, ends);
  RandomBase omega(test::naive_axis_theta(p, period), sending.effects[0].command.omega, random, ends);
  std::vector<Pose2> poses;
  Pose2 q;
  std::size_t next = 0;
  for (double t = sending.effects[0].time; t < sending.effects.back().time + period; t += kDt) {
    const double middle = t + 0.5 * kDt;
    for (; next < sending.effects.size() && sending.effects[next].time <= middle; ++next) {
      v.command(sending.effects[next].time, sending.effects[next].command.v);
      omega.command(sending.effects[next].time, sending.effects[next].command.omega);
    }
    const Twist2 u{v.at(middle), omega.at(middle)};
    if (t < 0.0) continue;
    q.x += u.v * std::cos(q.theta + 0.5 * u.omega * kDt) * kDt;
    q.y += u.v * std::sin(q.theta + 0.5 * u.omega * kDt) * kDt;
    q.theta += u.omega * kDt;
    poses.push_back(q);
  }
  return poses;
}

Parameters random_robot(test::Random& random) {
  Parameters p;
  p.acc_lim_x = random.uniform(0.5, 4.0);
  p.acc_lim_theta = random.uniform(1.0, 6.0);
  p.decel_lim_x = random.chance(0.5) ? 0.0 : -random.uniform(0.5, 4.0);
  p.decel_lim_theta = random.chance(0.5) ? 0.0 : random.uniform(1.0, 6.0);
  p.min_vel_x = -0.3;
  p.max_vel_x = random.uniform(0.3, 2.0);
  p.max_vel_theta = random.uniform(0.5, 3.0);
  p.control_latency = random.chance(0.3) ? 0.0 : random.uniform(0.0, 0.3);
  return p;
}

// How far beyond the growth the robot is from where the nearest rolled-out pose has it, at most [m].
double beyond_growth(const std::vector<Pose2>& driven, const std::vector<std::pair<Pose2, double>>& rolled,
                     double radius) {
  double most = 0.0;
  for (std::size_t k = 0; k < driven.size(); k += 10) {
    double least = INFINITY;
    for (const auto& [pose, growth] : rolled) least = std::min(least, displacement(driven[k], pose, radius) - growth);
    most = std::max(most, least);
  }
  return most;
}

// No base that keeps between the two ends gets farther from the rolled-out manoeuvre than the growth; and what is
// rolled out at 1 mm is 0.5 mm away from some pose.
TEST(BrakeManoeuvreGrowth, NoBaseIsFartherOff) {
  constexpr double kSpacing = 1e-3, kIntegration = 3e-4;  // [m]
  int parted = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    test::Random random(seed);
    const Parameters p = random_robot(random);
    const VelocityLimits l = VelocityLimits::from(p);
    const double period = random.pick({0.04, 0.05, 0.1, 0.2}), radius = random.uniform(0.15, 0.5);
    const Sending sending = random_sending(p, period, random);
    ManoeuvreRoller roller(l, radius, kSpacing, {{}, {1.0, 0.0}});
    std::vector<std::pair<Pose2, double>> rolled{{Pose2{}, 0.0}};
    roller.roll({{}, sending.pending[0], sending.own, period}, [&](const TurnedPose& at) {
      rolled.push_back({at.pose, roller.growth()});
      return true;
    });
    const std::vector<Pose2> driven = drive(p, period, sending, random);
    ASSERT_LE(beyond_growth(driven, rolled, radius), 0.5 * kSpacing + kIntegration) << seed;
    for (auto& pose : rolled) pose.second = 0.0;
    parted += beyond_growth(driven, rolled, radius) > 2e-3;
  }
  EXPECT_GT(parted, 60);  // without the growth many are
}

// What grows up to rest [m].
double growth_of(const PendingMotion& pending, const Twist2& command) {
  const VelocityLimits l = limits(2.0, 3.2);
  ManoeuvreRoller roller(l, 0.3, 1e-3, {{}, {1.0, 0.0}});
  roller.roll({{}, pending, command, 0.05}, [](const TurnedPose&) { return true; });
  return roller.growth();
}

TEST(BrakeManoeuvreGrowth, StraightOnAndAtRestThereIsNone) {
  EXPECT_EQ(growth_of(PendingMotion({0.5, 0.0}, 0.1), {0.52, 0.0}), 0.0);
  EXPECT_EQ(growth_of(PendingMotion({}, 0.1), {}), 0.0);
}

TEST(BrakeManoeuvreGrowth, ATurnOnTheSpot) {
  // From 0.5 to 0.4 rad/s at 3.2 rad/s^2 in 0.03125 s or evenly in 0.05 s: 0.1 * (0.05 - 0.03125) / 2 = 0.9375 mrad.
  // The tail of 0.08 rad/s in 0.025 s or in 0.05 s: 0.08 * 0.025 / 2 = 1 mrad. At 0.3 m: 0.58 mm.
  EXPECT_NEAR(growth_of(PendingMotion({0.0, 0.5}, 0.0), {0.0, 0.4}), 0.3 * (0.0009375 + 0.001), 1e-9);
}

// One cell of 5 cm, which a driven robot would graze.
struct Grazed {
  std::vector<std::uint8_t> costs = std::vector<std::uint8_t>(161U * 161U, cost::kFree);
  double origin_x = 0.0, origin_y = 0.0;

  // The cell's corner lies `deep` [m] inside the outline of a square robot (outside: negative), in the middle of its
  // front, a side or its rear, or near a corner: `side` and `along` choose.
  Grazed(const Pose2& at, int side, double along, double half, double deep) {
    costs[80U * 161U + 80U] = cost::kLethal;
    const double facing = at.theta + side * M_PI / 2.0, nx = std::cos(facing), ny = std::sin(facing);
    const double x = at.x + (half - deep) * nx - along * ny, y = at.y + (half - deep) * ny + along * nx;
    origin_x = x - (nx > 0.0 ? 80 : 81) * 0.05;
    origin_y = y - (ny > 0.0 ? 80 : 81) * 0.05;
  }
  GridView grid() const { return {costs.data(), 161, 161, 0.05, origin_x, origin_y}; }
};

// Beside something that is nearer than the growth a command passes only if all four ends are free. What lies between
// them hardly ever goes deeper than a millimetre.
TEST(BrakeManoeuvreWays, ABaseAtEitherEndTouchesNothingBesideIt) {
  constexpr double kHalf = 0.2, kDeepest = 1e-3;  // [m]
  const Polygon outline{{kHalf, kHalf}, {-kHalf, kHalf}, {-kHalf, -kHalf}, {kHalf, -kHalf}};
  const double less = kHalf - kDeepest;
  const test::NaiveBody body{outline, 0.0}, core{{{less, less}, {-less, less}, {-less, -less}, {less, -less}}, 0.0};
  const Footprint footprint(outline);
  int passed = 0, asked = 0, touched = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    test::Random random(seed);
    Parameters p = random_robot(random);
    p.control_latency = random.pick({0.0, 0.1, 0.2});
    const VelocityLimits l = VelocityLimits::from(p);
    const double period = random.pick({0.1, 0.2});
    const Sending sending = random_sending(p, period, random);
    const std::vector<Pose2> driven = drive(p, period, sending, random, true);
    const Pose2 grazes = driven[static_cast<std::size_t>(random.integer(0, static_cast<int>(driven.size()) - 1))];
    const double along = random.chance(0.5) ? random.pick({-0.99, 0.99}) * kHalf : random.uniform(-kHalf, kHalf);
    const int side = random.integer(0, 3);
    const Grazed scene(grazes, side, along, kHalf, random.uniform(-5e-3, 3e-3));
    const GridView grid = scene.grid();
    const double gap = test::naive_gap(grid, body, {}, true, 0.02);
    if (!(gap > 1e-5 && gap < 0.015) || test::naive_overlap(grid, body, {}, true) > 0.0) continue;
    CollisionChecker checker;
    checker.prepare(grid, footprint, true, {}, 2.0, 0.05, 0.5);
    AdmissibilityCheck check;
    CycleStart start;
    start.reference = sending.last;
    start.limits = l;
    start.pending = &sending.pending;
    start.period = start.longest_period = period;
    check.prepare(p, checker, footprint, 0.05, {&start});
    ++asked;
    if (!check.confirm_braking(sending.own)) continue;
    ++passed;
    for (int base = 0; base < 10; ++base) {
      const std::vector<Pose2> other = drive(p, period, sending, random, true);
      bool touches = false;
      for (std::size_t k = 0; k < other.size() && !touches; k += 8) {
        touches = test::naive_overlap(grid, core, other[k], true) > 0.0;
      }
      touched += touches;
    }
  }
  EXPECT_GT(passed, 20) << "of " << asked;
  EXPECT_LE(touched, 3) << passed << " of " << asked << "; by the farthest way alone it is 12 of 410";
}

}  // namespace
}  // namespace hidwa_local_planner
