// SPDX-License-Identifier: BSD-3-Clause
// How what moves changes its velocity, told by estimates that differ.
#include "core/movers/accelerations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;  // [s]

MovingObstacleEstimate mover(std::uint32_t id, const Point& velocity, double age = 0.0) {
  MovingObstacleEstimate m;
  m.id = id;
  m.velocity = velocity;
  m.age = age;
  return m;
}

// On a circle at 1.5 m/s with a radius of 2 m: 1.5^2 / 2 = 1.125 m/s2 towards its middle. It lags 0.2 s, 0.15 rad:
// 0.17 m/s2.
TEST(Accelerations, OfACircleLeadToItsMiddle) {
  Accelerations all;
  double angle = 0.0;
  for (int k = 0; k <= 40; ++k) {
    angle = 1.5 / 2.0 * kPeriod * k;
    all.watch({mover(7, 1.5 * Point(-std::sin(angle), std::cos(angle)))}, kPeriod * k);
  }
  EXPECT_LT((all.of(7) + 1.125 * Point(std::cos(angle), std::sin(angle))).norm(), 0.2);
  EXPECT_EQ(all.of(8), Point(0.0, 0.0));
}

// Known for longer than it takes to settle, at this velocity [m/s].
Accelerations known(const MovingObstacleEstimates& movers, double until) {
  Accelerations all;
  for (int k = 6; k >= 0; --k) all.watch(movers, until - kPeriod * k);
  return all;
}

// After 0.2 s of 1 m/s2 it is 1 - 1/e of that, however often the estimates come, and with messages that are used twice.
TEST(Accelerations, AreMeansOverAFifthOfASecond) {
  for (const int cycles : {1, 2, 5, 10}) {
    Accelerations all = known({mover(1, {0.3, 0.0})}, 10.0);
    for (int k = 1; k <= cycles; ++k) {
      const double later = 0.2 * k / cycles;
      all.watch({mover(1, {0.3, later})}, 10.0 + later);
      all.watch({mover(1, {0.3, later}, 0.02)}, 10.0 + later + 0.02);
    }
    EXPECT_NEAR(all.of(1).y(), 1.0 - std::exp(-1.0), 1e-9) << cycles;
    EXPECT_EQ(all.of(1).x(), 0.0);
  }
}

// 0.5 m/s within 0.05 s is 10 m/s2: more than anything that goes on. What follows within 0.2 s, 4 m/s2 here, is how the
// estimate comes to the new velocity. 0.22 m/s a cycle is 4.4 m/s2, of which 2.5 are believed.
TEST(Accelerations, OfALeapSayNothing) {
  Accelerations all = known({mover(1, {0.0, 0.0}), mover(2, {0.0, 0.0})}, 0.0);
  int k = 1;
  for (; k <= 40; ++k) all.watch({mover(1, {0.05 * k, 0.0}), mover(2, {0.22 * k, 0.0})}, kPeriod * k);
  EXPECT_NEAR(all.of(1).x(), 1.0, 1e-3);
  EXPECT_NEAR(all.of(2).x(), 2.5, 1e-3);
  double velocity = 0.05 * 40 + 0.5;
  for (int after = 0; after <= 20; ++after, ++k) {
    all.watch({mover(1, {velocity, 0.0}), mover(2, {0.22 * k, 0.0})}, kPeriod * k);
    if (after <= 3) {
      EXPECT_EQ(all.of(1), Point(0.0, 0.0)) << after;
    }
    velocity += after < 2 ? 0.2 : 0.05;
  }
  EXPECT_NEAR(all.of(1).x(), 1.0, 0.2);
  EXPECT_NEAR(all.of(2).x(), 2.5, 1e-3);
}

// An estimate that is wrong by 0.3 m/s and comes back within 0.05 s: 6 m/s2, of which 2.5 are believed, by the share
// 1 - exp(-0.25) of the mean. If it is known to 0.1 m/s only, nothing counts.
TEST(Accelerations, AreHardlyMovedByOneEstimate) {
  for (const double deviation : {0.0, 0.1}) {
    Accelerations all = known({mover(1, {0.7, 0.0})}, 10.0);
    MovingObstacleEstimate m = mover(1, {1.0, 0.0});
    m.velocity_deviation = deviation;
    all.watch({m}, 10.0 + kPeriod);
    EXPECT_NEAR(all.of(1).x(), deviation > 0.0 ? 0.0 : 2.5 * (1.0 - std::exp(-0.25)), 1e-9);
  }
}

// 2 m/s2, told by velocities that are right, and known to 0.1 m/s: 1.25 x 0.1 / 0.2 = 0.625 m/s2 may be chance. Known
// to 0.4 m/s, all of it.
TEST(Accelerations, DoNotCountWhatDeviationsExplain) {
  for (const double deviation : {0.0, 0.1, 0.4}) {
    Accelerations all;
    for (int k = 0; k <= 60; ++k) {
      MovingObstacleEstimate m = mover(1, {0.0, -2.0 * kPeriod * k});
      m.velocity_deviation = deviation;
      all.watch({m}, kPeriod * k);
    }
    EXPECT_NEAR(all.of(1).y(), -std::max(0.0, 2.0 - 6.25 * deviation), 1e-5) << deviation;
    EXPECT_EQ(all.of(1).x(), 0.0);
  }
}

// A new track's velocity is on its way to that of its body.
TEST(Accelerations, OfANewTrackSayNothing) {
  Accelerations all;
  for (int k = 0; k < 4; ++k) {
    all.watch({mover(1, {0.3 * k, 0.0})}, 5.0 + kPeriod * k);
    EXPECT_EQ(all.of(1), Point(0.0, 0.0));
  }
}

TEST(Accelerations, AreForgottenWithWhoIsGoneAndWhereTimeJumps) {
  const auto after = [](double elapsed) {
    Accelerations all = known({mover(1, {0.0, 0.0})}, 5.0);
    all.watch({mover(1, {0.05, 0.0})}, 5.0 + kPeriod);
    EXPECT_GT(all.of(1).x(), 0.2);
    all.watch({mover(1, {0.1, 0.0})}, 5.0 + kPeriod + elapsed);
    return all.of(1).x();
  };
  EXPECT_GT(after(kPeriod), 0.35);
  EXPECT_EQ(after(0.6), 0.0);
  EXPECT_EQ(after(-1.0), 0.0);
  Accelerations all = known({mover(1, {0.0, 0.0})}, 5.0);
  all.watch({}, 5.05);
  all.watch({mover(1, {0.05, 0.0})}, 5.1);
  EXPECT_EQ(all.of(1), Point(0.0, 0.0));
}

// No more than it has room for, in any order, and the same after it was saved.
TEST(Accelerations, KeepTheFirst64AndAreSaved) {
  MovingObstacleEstimates many;
  for (std::uint32_t id = 0; id < 100; ++id) many.push_back(mover(id, {0.0, 0.0}));
  Accelerations all = known(many, 0.0);
  for (MovingObstacleEstimate& m : many) m.velocity = {0.001 * m.id, 0.0};
  const MovingObstacleEstimates turned(many.rbegin() + 36, many.rend());  // 63 to 0
  all.watch(turned, kPeriod);
  Bytes state;
  ArchiveWriter write(state);
  write(all);
  Accelerations loaded;
  ArchiveReader read(state);
  read(loaded);
  EXPECT_TRUE(read.complete());
  for (std::uint32_t id = 0; id < 100; ++id) {
    // 0.001 m/s in 0.05 s, of which it takes 1 - exp(-0.25).
    EXPECT_NEAR(all.of(id).x(), id < 64 ? 0.02 * id * (1.0 - std::exp(-0.25)) : 0.0, 1e-9) << id;
    EXPECT_EQ(all.of(id), loaded.of(id)) << id;
  }
}

}  // namespace
}  // namespace hidwa_local_planner
