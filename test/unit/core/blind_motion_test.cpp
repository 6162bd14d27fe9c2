// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/blind_motion.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/naive_blind.hpp"
#include "support/naive_planner.hpp"
#include "support/planner_bench.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveBlind;
using test::PlannerBench;
using test::Random;
using test::Scene;

constexpr double kDegree = M_PI / 180.0;
constexpr double kRounding = 1e-6;  // more than the bound's own

SensorSector sector(double x, double direction, double width, double range = 10.0) {
  return {{x, 0.0, kDegree * direction}, kDegree * width, range};
}

// It drives and backs at up to 0.5 m/s and turns at up to 1 rad/s. The limits are 2.5 m/s2 and 3.2 rad/s2.
Parameters robot(double blind_speed = 0.1) {
  Parameters p;
  p.min_vel_x = -0.5;
  p.blind_speed = blind_speed;
  return p;
}
VelocityLimits limits() { return VelocityLimits::from(robot()); }

BlindMotion bound_of(const Footprint& footprint, const SensorSectors& sectors, const Parameters& p = robot()) {
  BlindMotion blind;
  blind.prepare(p, footprint, VelocityLimits::from(p), sectors);
  return blind;
}

const Footprint kCircle(Polygon{}, 0.3);
const Footprint kBox(Polygon{{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}});

TEST(BlindMotion, WithoutSectorsOrWithAViewAllRoundNothingIsBounded) {
  for (const SensorSectors& sectors : {SensorSectors{}, SensorSectors{sector(0.0, 0.0, 360.0)},
                                       SensorSectors{sector(0.25, 0.0, 270.0), sector(-0.25, 180.0, 270.0)}}) {
    EXPECT_FALSE(bound_of(kBox, sectors).bounds());
    EXPECT_FALSE(bound_of(kCircle, sectors).bounds());
  }
}

TEST(BlindMotion, ACircleThatDoesNotSeeBehindItGoesBackSlowlyAndTurnsFreely) {
  const BlindMotion blind = bound_of(kCircle, {sector(0.0, 0.0, 270.0)});
  for (const double omega : {-1.0, 0.0, 1.0}) {
    EXPECT_NEAR(blind.speeds(omega).lo, -0.1, kRounding);  // the rearmost place moves with -v
    EXPECT_GT(blind.speeds(omega).hi, 0.5);
  }
  EXPECT_NEAR(blind.narrowed(limits()).x.min, -0.1, kRounding);
  EXPECT_EQ(blind.narrowed(limits()).x.max, 0.5);
  EXPECT_EQ(blind.narrowed(limits()).theta.max, 1.0);
}

TEST(BlindMotion, TheRearOfABoxSwingsOut) {
  // Beside the box the laser at its front sees 135 degrees to each side; behind it nothing.
  const BlindMotion blind = bound_of(kBox, {sector(0.3, 0.0, 270.0)});
  EXPECT_NEAR(blind.speeds(0.0).lo, -0.1, kRounding);
  // The rear's corners, 0.2 m beside the middle, move back with -v + 0.2 omega: v >= 0.2 omega - 0.1.
  EXPECT_NEAR(blind.speeds(0.3).lo, -0.04, kRounding);
  EXPECT_NEAR(blind.speeds(-0.3).lo, -0.04, kRounding);
  // Beside the rear's end, 0.2 m away: (-0.6, 0.4) from the laser, 146 degrees, is not seen; (-0.4, 0.4), 135 degrees,
  // just is. So places of the side behind x = -0.1 swing out slowly: 0.3 m * omega <= 0.1 m/s.
  EXPECT_TRUE(blind.allows({0.3, 0.33}));
  EXPECT_FALSE(blind.allows({0.3, 0.34}));
  EXPECT_FALSE(blind.allows({0.3, -0.34}));
}

TEST(BlindMotion, SlowedGoesTheSameWay) {
  const BlindMotion blind = bound_of(kBox, {sector(0.3, 0.0, 270.0)});
  const Twist2 u = blind.slowed({-0.4, 0.8});  // the rear moves with 0.4 + 0.2 * 0.8 = 0.56 m/s: 0.1 / 0.56 of it
  EXPECT_NEAR(u.v, -0.4 / 5.6, 1e-12);
  EXPECT_NEAR(u.omega, 0.8 / 5.6, 1e-12);
  EXPECT_TRUE(blind.allows(u));
  EXPECT_TRUE(blind.slowed({0.5, 0.2}) == (Twist2{0.5, 0.2}));
}

TEST(BlindMotion, NeverIsNever) {
  const BlindMotion blind = bound_of(kCircle, {sector(0.0, 0.0, 270.0)}, robot(0.0));
  EXPECT_NEAR(blind.speeds(0.0).lo, 0.0, kRounding);
  EXPECT_TRUE(blind.allows({0.0, 0.0}));
  EXPECT_TRUE(blind.allows({0.5, 1.0}));
  EXPECT_FALSE(blind.allows({-0.01, 0.0}));
}

TEST(BlindMotion, ASensorThatSeesNothingBoundsAllDirections) {
  const BlindMotion blind = bound_of(kCircle, {SensorSector{}});
  EXPECT_NEAR(blind.speeds(0.0).lo, -0.1, kRounding);
  EXPECT_NEAR(blind.speeds(0.0).hi, 0.1, kRounding);
}

TEST(BlindMotion, AShortRangeIsBlindWhereTheRobotGetsFarther) {
  // 0.5 m/s, 0.1 s of latency, 0.1 s of reaction and 0.2 s to rest, or 0.31 s for the turn: somebody's middle is looked
  // for from 0.5 m to 0.5 + 0.5 * (0.2 + 0.16) = 0.68 m ahead.
  EXPECT_FALSE(bound_of(kCircle, {sector(0.0, 0.0, 360.0, 0.69)}).bounds());
  EXPECT_TRUE(bound_of(kCircle, {sector(0.0, 0.0, 360.0, 0.67)}).bounds());
}

TEST(BlindMotion, ACornerThatIsToldTwiceDoesNotMatter) {
  const Polygon corners = kBox.outline();
  Polygon twice;
  for (const Point& corner : corners) twice.insert(twice.end(), 2, corner);
  twice.push_back(corners[0]);
  const SensorSectors sectors{sector(0.3, 10.0, 270.0)};
  const BlindMotion blind = bound_of(kBox, sectors);
  Random random(4803);
  for (int k = 0; k < 200; ++k) {
    const Twist2 u{random.uniform(-0.3, 0.5), random.uniform(-1.0, 1.0)};
    EXPECT_EQ(bound_of(Footprint(twice), sectors).allows(u), blind.allows(u));
  }
}

TEST(BlindMotion, BrakingCountsToo) {
  const BlindMotion blind = bound_of(kBox, {sector(0.3, 0.0, 200.0)});
  // 0.1 m/s is at rest after 0.04 s; 0.33 rad/s then still are 0.33 - 3.2 * 0.04 = 0.2, which is slow enough.
  EXPECT_TRUE(blind.allows_braking_from({0.1, 0.33}));
  // Where only the rear is blind, its corners move with 0.2 * 0.65 - 0.1 = 0.03 m/s, and when 0.1 m/s is at rest, with
  // 0.2 * (0.65 - 3.2 * 0.04) = 0.104.
  const BlindMotion rear = bound_of(kBox, {sector(0.3, 0.0, 300.0)});
  EXPECT_TRUE(rear.allows({0.1, 0.65}));
  EXPECT_FALSE(rear.allows_braking_from({0.1, 0.65}));
}

TEST(BlindMotion, AnotherFootprintIsTakenOnceTheFormerIsForgotten) {
  Parameters parameters;
  BlindMotion blind;
  const SensorSectors sectors{sector(0.3, 0.0, 270.0)};
  blind.prepare(parameters, kBox, limits(), sectors);
  EXPECT_FALSE(blind.allows({0.0, 1.0}));
  blind.forget();
  blind.prepare(parameters, kCircle, limits(), sectors);
  EXPECT_TRUE(blind.allows({0.0, 1.0}));
  blind.prepare(parameters, kCircle, limits(), {});
  EXPECT_FALSE(blind.bounds());
}

// Whichever way round the outline is told.
TEST(BlindMotion, IsWhatASlowTwinSays) {
  Random random(4801);
  int allowed = 0, refused = 0;
  for (int k = 0; k < 150; ++k) {
    Scene scene = Scene::empty();
    scene.outline = test::random_outline(random);
    test::add_sectors(random, scene);
    for (SensorSector& one : scene.situation.sensor_sectors) one.pose.theta = random.uniform(-M_PI, M_PI);
    Polygon told = scene.outline;
    if (random.chance(0.5)) std::reverse(told.begin(), told.end());
    const BlindMotion blind =
        bound_of(Footprint::from_outline(told, 0.0), scene.situation.sensor_sectors, scene.parameters);
    const NaiveBlind twin(scene, test::naive_body(scene));
    for (int i = 0; i < 4; ++i) {
      const Twist2 u{random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)};
      ASSERT_EQ(blind.allows(u), !twin.too_fast(u)) << k << ": " << u.v << " " << u.omega;
      ++(twin.too_fast(u) ? refused : allowed);
    }
  }
  EXPECT_GT(allowed, 100);
  EXPECT_GT(refused, 100);
}

TEST(BlindMotion, TheSectorsAreReadOrTheFaultNamesThem) {
  std::string fault;
  const SensorSectors two = parse_sensor_sectors("0.1 0 0 270 10; -0.2 0.05 180 87 4.5", fault);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(fault, "");
  EXPECT_DOUBLE_EQ(two[0].width, 1.5 * M_PI);
  EXPECT_DOUBLE_EQ(two[1].pose.theta, M_PI);
  EXPECT_DOUBLE_EQ(two[1].pose.y, 0.05);
  EXPECT_EQ(two[1].range, 4.5);
  for (const char* text :
       {"0 0 0 270", "0 0 0 270 10 1", "0 0 0 0 10", "0 0 0 361 10", "0 0 0 90 -1", "all;", "nan 0 0 90 1"}) {
    fault.clear();
    EXPECT_TRUE(parse_sensor_sectors(text, fault).empty()) << text;
    EXPECT_NE(fault.find("sensor_sectors"), std::string::npos) << text;
    Parameters parameters;
    parameters.sensor_sectors = text;
    EXPECT_EQ(validate(parameters).size(), 1U) << text;
  }
  for (const char* text : {"", "all"}) {
    fault.clear();
    EXPECT_EQ(parse_sensor_sectors(text, fault).size(), text[0] == 'a' ? 1U : 0U);
    EXPECT_EQ(fault, "");
  }
}

Scene with_laser(double width) {
  Scene scene = Scene::empty(121);
  scene.parameters.min_vel_x = -0.5;
  scene.situation.sensor_sectors = {sector(0.2, 0.0, width)};
  return scene;
}

TEST(PlannerThatIsBlindBehind, TheOperatorBacksSlowlyAndIsTold) {
  for (const double width : {270.0, 360.0}) {
    Scene scene = with_laser(width);
    scene.steer({-0.5, 0.0});
    PlannerBench bench(scene);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(bench.drive().operator_rejected_by, width < 300.0 ? "Blind" : "");
    EXPECT_NEAR(bench.scene().situation.last_command.v, width < 300.0 ? -0.1 : -0.5, 1e-6);
  }
}

TEST(PlannerThatIsBlindBehind, WhatTheParameterSaysGoesBefore) {
  Scene scene = with_laser(270.0);
  scene.parameters.sensor_sectors = "all";
  scene.steer({-0.5, 0.0});
  PlannerBench all(scene);
  EXPECT_EQ(all.cycle().operator_rejected_by, "");
  scene.situation.sensor_sectors.clear();
  scene.parameters.sensor_sectors = "0.2 0 0 270 10";
  PlannerBench listed(scene);
  EXPECT_EQ(listed.cycle().operator_rejected_by, "Blind");
}

// From rest, so that every command is one that the bound let pass.
TEST(PlannerThatIsBlindBehind, NoCommandAndNoBrakingMovesItsOutlineFast) {
  Random random(4802);
  int moved = 0;
  for (int k = 0; k < 40; ++k) {
    Scene scene = with_laser(random.uniform(90.0, 280.0));
    scene.outline = test::random_outline(random);
    scene.situation.sensor_sectors[0].pose.x = random.uniform(-0.1, 0.2);
    scene.situation.pose.theta = random.uniform(-M_PI, M_PI);
    PlannerBench bench(scene);
    const NaiveBlind twin(scene, test::naive_body(scene));
    for (int i = 0; i < 30; ++i) {
      if (i % 10 == 0 && k % 2 == 0) bench.scene().steer({random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)});
      const Twist2 u = bench.drive().command;
      ASSERT_FALSE(twin.too_fast(u)) << k << " " << i << ": " << u.v << " " << u.omega;
      moved += std::abs(u.v) > 0.2 || std::abs(u.omega) > 0.3 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 100);
}

}  // namespace
}  // namespace hidwa_local_planner
