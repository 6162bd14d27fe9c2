// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/blind_motion.hpp"

#include <gtest/gtest.h>

#include "support/planner_bench.hpp"
#include "support/random_scene.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Random;
using test::Scene;

constexpr double kDegree = M_PI / 180.0;
constexpr double kRounding = 1e-6;  // more than the bound's own

SensorSector sector(double x, double direction, double width, double range = 10.0) {
  return {{x, 0.0, kDegree * direction}, kDegree * width, range};
}

VelocityLimits limits() {
  VelocityLimits limits;
  limits.x = {-0.5, 0.5, 2.5, 2.5};
  limits.theta = {-1.0, 1.0, 3.2, 3.2};
  return limits;
}

BlindMotion bound_of(const Footprint& footprint, const SensorSectors& sectors, double blind_speed = 0.1) {
  Parameters parameters;
  parameters.blind_speed = blind_speed;
  BlindMotion blind;
  blind.prepare(parameters, footprint, limits(), sectors);
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
  const BlindMotion blind = bound_of(kCircle, {sector(0.0, 0.0, 270.0)}, 0.0);
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

TEST(BlindMotion, ACornerThatIsToldTwiceAndTheWayRoundDoNotMatter) {
  const Polygon corners = kBox.outline();
  Polygon twice, backwards(corners.rbegin(), corners.rend());
  for (const Point& corner : corners) twice.insert(twice.end(), 2, corner);
  twice.push_back(corners[0]);
  const SensorSectors sectors{sector(0.3, 10.0, 270.0)};
  const BlindMotion blind = bound_of(kBox, sectors);
  Random random(4803);
  for (int k = 0; k < 200; ++k) {
    const Twist2 u{random.uniform(-0.3, 0.5), random.uniform(-1.0, 1.0)};
    EXPECT_EQ(bound_of(Footprint(twice), sectors).allows(u), blind.allows(u));
    EXPECT_EQ(bound_of(Footprint(backwards), sectors).allows(u), blind.allows(u));
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

// Every millimetre of the outline, by the definition.
struct SlowTwin {
  const Footprint& footprint;
  const SensorSectors& sectors;

  static bool in_view(const SensorSector& s, const Point& p) {
    const double dx = p.x() - s.pose.x, dy = p.y() - s.pose.y;
    if (std::hypot(dx, dy) > s.range) return false;
    double angle = std::atan2(dy, dx) - s.pose.theta;
    while (angle > M_PI) angle -= 2.0 * M_PI;
    while (angle < -M_PI) angle += 2.0 * M_PI;
    return std::abs(angle) <= 0.5 * s.width;
  }
  bool seen(const Point& p) const {
    for (const SensorSector& s : sectors) {
      if (in_view(s, p)) return true;
    }
    return false;
  }
  // How fast a place moves outwards that is blind for somebody who touches it; those beside which all is seen, up to
  // `reach`, do not count.
  double fastest(const Twist2& u, double reach) const {
    double most = -1e9;
    const auto ask = [&](const Point& place, const Point& normal) {
      bool all = true;
      for (double away = 0.2; away <= 0.2 + reach; away += 0.005) all = all && seen(place + away * normal);
      if (all) return;
      const double x = u.v - u.omega * place.y(), y = u.omega * place.x();
      most = std::max(most, x * normal.x() + y * normal.y());
    };
    if (footprint.is_circle()) {
      for (int i = 0; i < 3600; ++i) {
        const Point normal(std::cos(0.1 * i * kDegree), std::sin(0.1 * i * kDegree));
        ask(footprint.radius() * normal, normal);
      }
    }
    const Polygon& corners = footprint.outline();  // the random outlines go left round
    for (std::size_t i = 0; !footprint.is_circle() && i < corners.size(); ++i) {
      const Point from = corners[i], way = corners[(i + 1) % corners.size()] - from;
      const Point normal = Point(way.y(), -way.x()) / way.norm();
      for (double along = 0.0; along <= 1.0; along += 0.001 / way.norm()) ask(from + along * way, normal);
      const Point to = from + way, on = corners[(i + 2) % corners.size()] - to;
      const double turn = std::atan2(way.x() * on.y() - way.y() * on.x(), way.dot(on));
      for (double angle = 0.0; angle < turn; angle += kDegree) {
        ask(to, std::cos(angle) * normal + std::sin(angle) * Point(-normal.y(), normal.x()));
      }
    }
    return most;
  }
};

TEST(BlindMotion, IsWhatTheDefinitionSays) {
  Random random(4801);
  int bound = 0, free = 0;
  for (int k = 0; k < 150; ++k) {
    const Footprint footprint = Footprint::from_outline(test::random_outline(random), 0.0);
    SensorSectors sectors;
    for (int s = random.integer(1, 2); s > 0; --s) {
      sectors.push_back({{random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), random.uniform(-M_PI, M_PI)},
                         random.uniform(1.0, 6.2),
                         random.uniform(0.5, 5.0)});
    }
    const BlindMotion blind = bound_of(footprint, sectors);
    const SlowTwin twin{footprint, sectors};
    for (int i = 0; i < 4; ++i) {
      const Twist2 u{random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)};
      const Interval allowed = blind.speeds(u.omega);
      // The same at the borders but for rounding.
      const bool in = u.v >= allowed.lo && u.v <= allowed.hi;
      ASSERT_EQ(in, blind.allows(u)) << k;
      // Places are looked at every 0.02 m, or 2 degrees, corners every 5 degrees: the next one is as fast but for
      // 0.02 |omega| and 5 degrees, 0.09 rad, of its speed.
      const double slack = 0.02 * std::abs(u.omega) + 0.09 * (std::abs(u.v) + 0.35 * std::abs(u.omega)) + kRounding;
      // The reach is at most 0.5 m/s * (0.2 + 0.156 s) + 0.35 m * 1 rad/s * (0.356 s) = 0.3 m, and at least 0.
      if (twin.fastest(u, 0.0) > 0.1 + slack) {
        EXPECT_FALSE(blind.allows(u)) << k;
        ++bound;
      }
      if (twin.fastest(u, 0.31) <= 0.1 - slack) {
        EXPECT_TRUE(blind.allows(u)) << k;
        ++free;
      }
    }
  }
  EXPECT_GT(bound, 100);
  EXPECT_GT(free, 100);
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
    const Footprint footprint = Footprint::from_outline(scene.outline, 0.0);
    const SlowTwin twin{footprint, scene.situation.sensor_sectors};
    for (int i = 0; i < 30; ++i) {
      if (i % 10 == 0 && k % 2 == 0) bench.scene().steer({random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)});
      const Twist2 u = bench.drive().command;
      const double slack = 0.02 * std::abs(u.omega) + 0.09 * (std::abs(u.v) + 0.35 * std::abs(u.omega)) + kRounding;
      ASSERT_LE(twin.fastest(u, 0.0), 0.1 + slack) << k << " " << i << ": " << u.v << " " << u.omega;
      moved += std::abs(u.v) > 0.2 || std::abs(u.omega) > 0.3 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 100);
}

}  // namespace
}  // namespace hidwa_local_planner
