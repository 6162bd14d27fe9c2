// SPDX-License-Identifier: BSD-3-Clause
// The campaign's own arithmetic: a measure that is wrong finds nothing, or what is not there.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base.hpp"
#include "command_watch.hpp"
#include "contact_watch.hpp"
#include "escape_watch.hpp"
#include "local_map.hpp"
#include "rhythm.hpp"
#include "shape.hpp"
#include "world.hpp"

namespace hidwa_attack {
namespace {

constexpr double kSquare = 0.05;  // a cell [m]

TEST(Shape, MitredCornersKeepTheirSidesApart) {
  const Shape grown = padded(shape_of(Outline::long_rectangle), 0.02);
  // 0.45 + 0.02 and 0.20 + 0.02.
  EXPECT_NEAR(std::hypot(grown.corners[0].x + 0.47, grown.corners[0].y + 0.22), 0.0, 1e-12);
  EXPECT_NEAR(outermost(grown), std::hypot(0.47, 0.22), 1e-12);
  EXPECT_NEAR(padded(shape_of(Outline::circle), 0.02).radius, 0.27, 1e-12);
}

TEST(Shape, SharpCornersGoAsFarAsTheirSidesMeet) {
  // Sides at 30 degrees to the axis meet in a corner of 60 degrees: it moves by 0.01 / sin(30 degrees) = 0.02.
  const Shape sharp{{{0.0, 0.0}, {-0.3, 0.3 * std::tan(M_PI / 6.0)}, {-0.3, -0.3 * std::tan(M_PI / 6.0)}}, 0.0};
  EXPECT_NEAR(padded(sharp, 0.01).corners[0].x, 0.02, 1e-12);
}

TEST(Shape, DepthOfARectangleInACell) {
  const Shape box = shape_of(Outline::long_rectangle);  // its nose is at x = 0.45
  EXPECT_NEAR(Placed(box, {0.0, 0.0, 0.0}).depth_in(0.44, 0.0, kSquare), 0.01, 1e-12);
  EXPECT_NEAR(Placed(box, {0.0, 0.0, 0.0}).depth_in(0.47, 0.0, kSquare), -0.02, 1e-12);
  // Turned by 90 degrees the side at y = 0.20 is at x = -0.20.
  EXPECT_NEAR(Placed(box, {0.0, 0.0, 0.5 * M_PI}).depth_in(-0.24, 0.0, kSquare), 0.01, 1e-12);
}

TEST(Shape, DepthAlongASlantedSide) {
  // At 45 degrees the nose's middle is at (0.45, 0.45) / sqrt(2); a cell whose lower left corner lies 3 mm inside of it
  // along the side's normal is entered by 3 mm.
  const double at = (0.45 - 0.003) / std::sqrt(2.0);
  EXPECT_NEAR(Placed(shape_of(Outline::long_rectangle), {0.0, 0.0, 0.25 * M_PI}).depth_in(at, at, kSquare), 0.003,
              1e-12);
}

TEST(Shape, DepthOfACircle) {
  const Placed placed({{}, 0.25}, {0.0, 0.0, 1.0});
  EXPECT_NEAR(placed.depth_in(0.24, -0.02, kSquare), 0.01, 1e-12);
  EXPECT_NEAR(placed.depth_in(0.15, 0.20, kSquare), 0.0, 1e-12);        // hypot(0.15, 0.20) = 0.25
  EXPECT_NEAR(placed.depth_in(-0.025, -0.025, kSquare), 0.275, 1e-12);  // 0.25 and 0.025 to the cell's edge
}

TEST(World, TheDeepestOfAllCells) {
  World world(2.0, 2.0, kSquare);
  world.set(25, 20, true);  // x from 1.25, y from 1.00
  const Shape circle{{}, 0.25};
  EXPECT_NEAR(deepest(world, Placed(circle, {1.01, 1.02, 0.0}), 0.3), 0.01, 1e-12);
  EXPECT_NEAR(deepest(world, Placed(circle, {0.90, 1.02, 0.0}), 0.3), -0.10, 1e-12);
  EXPECT_NEAR(deepest(world, Placed(circle, {0.30, 1.02, 0.0}), 0.3), -0.3, 1e-12);
}

TEST(LocalMap, LethalInscribedAndFallingOff) {
  World world(4.0, 4.0, kSquare);
  world.set(40, 40, true);
  LocalMap map(world, 2.0, 0.10);
  const GridView view = map.around({2.0, 2.0, 0.0});  // 40 cells, the first one is 20
  EXPECT_NEAR(view.origin_x, 1.0, 1e-12);
  const auto cost = [&view](int i, int j) { return static_cast<int>(view.costs[j * 40 + i]); };
  EXPECT_EQ(cost(20, 20), 254);
  EXPECT_EQ(cost(22, 20), 253);                                        // 0.10 m away
  EXPECT_EQ(cost(23, 20), static_cast<int>(252.0 * std::exp(-0.25)));  // 0.05 m beyond, 5 a metre
  EXPECT_EQ(cost(35, 20), 0);                                          // 0.75 m away
}

TEST(AxisDrive, AtOnceEvenlyAndBetween) {
  const AxisPower power{2.0, 4.0};
  AxisDrive at_once(power), evenly(power), between(power);
  at_once.begin(0.1, 0.1, 0.0);
  evenly.begin(0.1, 0.1, 1.0);
  between.begin(0.1, 0.1, 0.5);
  for (int k = 0; k < 25; ++k) {
    for (AxisDrive* axis : {&at_once, &evenly, &between}) axis->step(1e-3);
  }
  EXPECT_NEAR(at_once.now(), 0.05, 1e-9);  // 2.0 x 0.025
  EXPECT_NEAR(evenly.now(), 0.025, 1e-9);  // a quarter of the period
  EXPECT_NEAR(between.now(), 0.0375, 1e-9);
}

TEST(AxisDrive, NeverBeyondItsLimitsAndInTimeWhereTheyAllowIt) {
  Random random(3);
  for (int drive = 0; drive < 3000; ++drive) {
    const AxisPower power{random.in(0.5, 5.0), random.in(0.5, 5.0)};
    AxisDrive axis(power);
    double target = 0.0;
    for (int command = 0; command < 5; ++command) {
      const double from = axis.now(), period = 0.1;
      do {
        target = from + random.in(-0.5, 0.5);
      } while (time_between(power, from, target) > period);
      axis.begin(target, period, random.in(0.0, 1.0));
      for (int k = 0; k < 100; ++k) {
        const double before = axis.now();
        axis.step(1e-3);
        ASSERT_LE(time_between(power, before, axis.now()), 1e-3 + 1e-9) << drive;
      }
      ASSERT_NEAR(axis.now(), target, 1e-9) << drive;
    }
  }
}

TEST(Base, TakesACommandUpAfterItsLatencyAndDrivesAnArc) {
  Base::Make make;
  make.x = make.theta = {1e4, 1e4};
  make.period = 1e-3;
  make.latency = 100;
  Base base(make, {0.0, 0.0, 0.0}, 1);
  base.send(0, {0.5, 1.0});
  int now = 0;
  for (; now < 100; ++now) base.step(now);
  EXPECT_EQ(base.velocity().v, 0.0);
  for (; now < 1100; ++now) base.step(now);
  // A second on a circle of 0.5 m, but for the first millisecond, in which it speeds up.
  EXPECT_NEAR(base.pose().theta, 0.9995, 1e-9);
  EXPECT_NEAR(base.pose().x, 0.5 * std::sin(0.9995), 1e-6);
  EXPECT_NEAR(base.pose().y, 0.5 * (1.0 - std::cos(0.9995)), 1e-6);
}

TEST(Base, TakesEachCommandUpAtEitherEndOrNothingElse) {
  Base::Make make;
  make.x = make.theta = {2.0, 4.0};
  make.period = 0.1;
  make.latency = 0;
  make.reaching = Reaching::either;
  int at_once = 0, evenly = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Base base(make, {}, seed);
    base.send(0, {0.1, 0.0});
    for (int now = 0; now < 25; ++now) base.step(now);
    at_once += std::abs(base.velocity().v - 0.05) < 1e-9;  // 2.0 x 0.025
    evenly += std::abs(base.velocity().v - 0.025) < 1e-9;  // a quarter of the period
  }
  EXPECT_EQ(at_once + evenly, 100);
  EXPECT_GT(std::min(at_once, evenly), 30);
}

TEST(Base, LatencyThatVariesIsBoundedAndKeepsTheOrder) {
  Base::Make make;
  make.x = make.theta = {1e4, 1e4};
  make.period = 1e-3;
  make.latency_varies = true;  // up to 100 ms
  int first = 1000, last = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Base base(make, {}, seed);
    base.send(0, {0.1, 0.0});
    double before = 0.0;
    int jumps = 0;
    for (int now = 0; now < 200; ++now) {
      if (now == 10) base.send(now, {0.2, 0.0});
      base.step(now);
      ASSERT_GE(base.velocity().v, before);
      if (before < 0.1 && base.velocity().v >= 0.1) {
        first = std::min(first, now);
        last = std::max(last, now);
      }
      jumps += base.velocity().v > before;
      before = base.velocity().v;
    }
    EXPECT_EQ(before, 0.2);
    EXPECT_LE(jumps, 2);
  }
  EXPECT_LE(first, 5);
  EXPECT_GE(last, 90);
  EXPECT_LE(last, 100);
}

struct Lateness {
  int cycles = 0, late = 0, longest = 0, unannounced = 0;  // longest [ms]
};

// 200 s of a host. Unannounced: later than it had told at the cycle before.
Lateness lateness_of(Rhythm& rhythm, int period, bool rests) {
  Lateness found;
  int last = 0, told = 0;
  for (int now = 0; now < 200000; ++now) {
    if (!rhythm.due(now)) continue;
    rhythm.tick(now);
    rhythm.plan_next(now, rests);
    if (now > 0) {
      found.longest = std::max(found.longest, now - last);
      found.late += now - last > period;
      found.unannounced += now - last > told;
    }
    told = static_cast<int>(std::lround(1e3 * rhythm.longest()));
    last = now;
    ++found.cycles;
  }
  return found;
}

Spec late_host(double share) {
  Spec spec;  // 50 ms
  spec.late_share = share;
  spec.late_most = 2.0;
  return spec;
}

TEST(Rhythm, LateCyclesAreLateByWhatTheyShould) {
  Spec spec = late_host(0.2);
  spec.surprises = true;
  Rhythm rhythm(spec, 5);
  EXPECT_EQ(rhythm.longest(), 0.15) << "it was late before: 50 ms and two periods";
  const Lateness found = lateness_of(rhythm, spec.period, false);
  EXPECT_NEAR(static_cast<double>(found.late) / found.cycles, 0.2, 0.02);
  EXPECT_GT(found.longest, 140);
  EXPECT_LE(found.longest, 150);
  EXPECT_GT(rhythm.longest(), 0.1);
  EXPECT_LE(rhythm.longest(), 0.15);
}

// One cycle of a hundred is late: after 3 s without one the next is a surprise.
TEST(Rhythm, NoCycleIsLaterThanToldWhereTheRobotMoves) {
  Spec spec = late_host(0.01);
  Rhythm moving(spec, 5), resting(spec, 5);
  EXPECT_EQ(lateness_of(moving, spec.period, false).unannounced, 0);
  EXPECT_GT(lateness_of(resting, spec.period, true).unannounced, 5);
  spec.surprises = true;
  Rhythm surprising(spec, 5);
  EXPECT_GT(lateness_of(surprising, spec.period, false).unannounced, 5);
}

// At 5 Hz, two periods late: 0.6 s. The cycle 3.0 s after the late one still counts it, and so does the next, at 3.2 s.
TEST(Rhythm, LateAgainWhenTheLastOneIsAboutToBeForgotten) {
  Spec spec;
  spec.period = 200;
  spec.late_most = 2.0;
  spec.late_again = true;
  Rhythm rhythm(spec, 5);
  EXPECT_EQ(rhythm.before(), 0.6);
  std::vector<int> cycles;
  for (int now = 0; now < 8000; ++now) {
    if (!rhythm.due(now)) continue;
    rhythm.tick(now);
    rhythm.plan_next(now, false);
    cycles.push_back(now);
  }
  std::vector<int> late;
  for (std::size_t k = 1; k < cycles.size(); ++k) {
    if (cycles[k] - cycles[k - 1] > 200) late.push_back(cycles[k]);
  }
  EXPECT_EQ(late, (std::vector<int>{3800, 7600}));  // 3200 + 600, 3800 + 3200 + 600
}

TEST(CommandWatch, TheLimitOrTheLastCommandReduced) {
  Parameters p;  // 0.5 m/s forwards only, 1 rad/s, 2.5 m/s^2, 3.2 rad/s^2
  CommandWatch watch;
  watch.observe(p, 0.05, {0.8, 0.0}, {0.675, 1.0});     // 0.8 - 2.5 x 0.05
  watch.observe(p, 0.05, {-0.2, 1.5}, {-0.075, 1.34});  // 1.5 - 3.2 x 0.05
  EXPECT_EQ(watch.count(), 0);
  watch.observe(p, 0.05, {0.8, 0.0}, {0.70, 0.0});
  EXPECT_NEAR(watch.worst().v, 0.025, 1e-9);
  watch.observe(p, 0.05, {}, {-2.875, 19.84});
  EXPECT_EQ(watch.count(), 2);
  EXPECT_NEAR(watch.worst().v, 2.875, 1e-9);
  EXPECT_NEAR(watch.worst().omega, 18.84, 1e-9);
}

TEST(CommandWatch, WithinReachOfTheLastCommand) {
  const Parameters p;  // 2.5 m/s^2, 3.2 rad/s^2
  CommandWatch watch;
  // 0.3 m/s and 2.5 x 0.1 either way: 0.05 to 0.55; 3.2 x 0.1 rad/s. Whatever was read or moved.
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.0, 0.0}, {0.9, 0.9}, {0.55, 0.32});
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.0, 0.0}, {0.9, 0.9}, {0.05, -0.32});
  EXPECT_EQ(watch.hard(), 0);
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.0, 0.0}, {0.9, 0.9}, {0.551, 0.0});
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.0, 0.0}, {0.9, 0.9}, {0.049, 0.0});
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.3, -0.2}, {0.9, 0.9}, {0.3, -0.321});
  EXPECT_EQ(watch.hard(), 3);
}

TEST(CommandWatch, WithinReachOfWhatLiesBetweenLastCommandAndReadingWhereItStartsFromThat) {
  Parameters p;
  p.method = hidwa_local_planner::Method::paper;
  CommandWatch watch;
  // Between 0.2 and 0.3 m/s, 2.5 x 0.1 either way: -0.05 to 0.55; between 0 and 0 rad/s, 3.2 x 0.1: -0.32 to 0.32.
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.2, 0.0}, {0.55, 0.32});
  watch.judge_acceleration(p, 0.1, {0.2, 0.0}, {0.3, 0.0}, {0.3, 0.0}, {-0.05, -0.32});
  EXPECT_EQ(watch.hard(), 0);
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.2, 0.0}, {0.551, 0.0});
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.2, 0.0}, {-0.051, 0.0});
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.2, 0.0}, {0.3, 0.321});
  EXPECT_EQ(watch.hard(), 3);
  // The poses tell 0.4 m/s and 0.1 rad/s: -0.05 to 0.65, -0.32 to 0.42.
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.4, 0.1}, {0.65, 0.42});
  EXPECT_EQ(watch.hard(), 3);
  watch.judge_acceleration(p, 0.1, {0.3, 0.0}, {0.2, 0.0}, {0.4, 0.1}, {0.651, 0.42});
  EXPECT_EQ(watch.hard(), 4);
}

TEST(ContactWatch, SeesATouch) {
  World world(3.0, 2.0, kSquare);
  world.set(40, 20, true);  // x from 2.00
  ContactWatch watch(world, {{}, 0.25});
  int now = 0;
  // At 0.4 m/s from 0.5 m before it, then at 0.1 m/s into it by 3 mm.
  double x = 1.25;
  for (; x < 1.70; x += 0.4e-3) watch.observe(now++, {x, 1.02, 0.0}, {0.4, 0.0});
  for (; x < 1.753; x += 0.1e-3) watch.observe(now++, {x, 1.02, 0.0}, {0.1, 0.0});
  ASSERT_TRUE(watch.touched());
  EXPECT_NEAR(watch.deepest_touch(), 0.003, 2e-4);
}

// Pushes a robot of 0.25 m forwards through a world, 0.1 m/s, a cycle each 50 ms.
EscapeWatch pushed(const World& world, double from, double to) {
  Spec spec;
  EscapeWatch watch(world, {{}, 0.25}, spec);
  double x = from;
  for (int now = 0; x < to; ++now, x += 1e-4) {
    if (now % 50 == 0) watch.decide(now, {x, 1.025, 0.0}, {0.1, 0.0});
    watch.observe(now, {x, 1.025, 0.0}, {0.1, 0.0});
  }
  return watch;
}

TEST(EscapeWatch, AFarCellMustNotBeEntered) {
  World world(3.0, 2.0, kSquare);
  world.set(15, 20, true);  // under its rear: x from 0.75 to 0.80
  world.set(26, 20, true);  // ahead: x from 1.30
  // From 1.04 on it leaves the rear cell, which ends at 0.80, by 1.05, and enters the other one from 1.05 on.
  const EscapeWatch out = pushed(world, 1.04, 1.05);
  EXPECT_EQ(out.entered(), 0);
  EXPECT_FALSE(out.broken());
  const EscapeWatch into = pushed(world, 1.02, 1.06);
  EXPECT_EQ(into.entered(), 1);
  EXPECT_NEAR(into.entered_depth(), 0.01, 3e-4);
  EXPECT_TRUE(into.broken());
}

TEST(EscapeWatch, TheSumOfDepthsMustNotGrow) {
  World world(3.0, 2.0, kSquare);
  world.set(26, 20, true);                               // x from 1.30
  const EscapeWatch deeper = pushed(world, 1.06, 1.09);  // from 1 cm to 4 cm
  EXPECT_NEAR(deeper.growth(), 0.03, 3e-4);
  EXPECT_TRUE(deeper.broken());
}

TEST(EscapeWatch, TheSpeedThatStopsWithinHalfACell) {
  const World world(3.0, 2.0, kSquare);
  // 0.1404 x (0.1 + 0.05) + 0.1404^2 / (2 x 2.5) = 0.0211 + 0.0039 = 0.025.
  EXPECT_NEAR(EscapeWatch(world, {{}, 0.25}, Spec()).speed_bound(), 0.1404, 1e-4);
}

}  // namespace
}  // namespace hidwa_attack
