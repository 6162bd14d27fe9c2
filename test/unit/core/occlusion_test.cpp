// SPDX-License-Identifier: BSD-3-Clause
// Somebody who may step out: whether the robot rests before, and what its candidates cost.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/movers/hidden_places.hpp"
#include "core/movers/mover_check.hpp"
#include "core/movers/reachable_set.hpp"
#include "support/critic_bench.hpp"
#include "support/cycle_motion.hpp"
#include "support/naive_advance.hpp"
#include "support/naive_hidden.hpp"
#include "support/naive_inflation.hpp"
#include "support/planner_bench.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticBench;
using test::CycleMotion;
using test::naive_occlusion;
using test::PlannerBench;
using test::Random;
using test::rejections_by;
using test::Scene;

constexpr double kDisc = HiddenPlaces::kRadius;

TEST(HiddenSets, GrowAtOneSpeedFromWhereHeWasNotSeen) {
  const ReachableSet set = ReachableSet::of_hidden({1.0, 2.0}, 0.4, 1.3, 0.15);
  for (const double t : {0.0, 0.5}) {
    EXPECT_EQ(set.centre(t), Point(1.0, 2.0));
    EXPECT_NEAR(set.radius(t), 0.4 + 1.3 * (t + 0.15), 1e-12);
    EXPECT_NEAR(set.speed_radius(t), 0.4 + 1.3 * (t + 0.15), 1e-12);
  }
  EXPECT_EQ(set.fastest(), 1.3);
}

const Footprint kBody({{0.3, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.3, -0.2}});

bool confirms(const Parameters& p, const CycleMotion& motion, const std::vector<Point>& places, const Twist2& command) {
  MoverCheck check;
  check.prepare_hidden(p, kBody, places, motion.start);
  return check.none_near() || check.confirm(command);
}

TEST(RestBeforeHidden, ARobotThatStaysAtRestIsFree) {
  const Parameters p;
  const CycleMotion rests(p, {});
  EXPECT_TRUE(confirms(p, rests, {{0.0, 0.0}, {0.5, 0.0}}, {}));
  EXPECT_TRUE(confirms(p, rests, {}, {0.1, 0.0}));
}

TEST(RestBeforeHidden, ARobotThatCreepsIsFreeEvenWhereHeMayBe) {
  const Parameters p;        // blind_speed 0.1
  const double lever = 0.3;  // of the corners, outwards along the normals of the long sides
  const CycleMotion rests(p, {}), creeps(p, {0.1, 0.0}), turns(p, {0.0, 0.1 / lever}), turns_fast(p, {0.0, 0.11 / 0.3});
  for (const std::vector<Point>& places :
       {std::vector<Point>{{0.4, 0.0}}, std::vector<Point>{{0.0, 0.0}, {0.5, 0.3}}}) {
    EXPECT_TRUE(confirms(p, rests, places, {0.1, 0.0}));
    EXPECT_TRUE(confirms(p, creeps, places, {0.1, 0.0}));
    EXPECT_TRUE(confirms(p, creeps, places, {}));
    EXPECT_TRUE(confirms(p, turns, places, {0.0, 0.1 / lever}));
    EXPECT_FALSE(confirms(p, rests, places, {0.11, 0.0}));
    EXPECT_FALSE(confirms(p, turns_fast, places, {0.0, 0.11 / 0.3}));
  }
}

TEST(RestBeforeHidden, AFastRobotIsRefusedNearAPlaceAndFreeFarAway) {
  const Parameters p;  // 0.1 s of latency, 2.5 m/s^2
  const CycleMotion fast(p, {0.5, 0.0});
  // It brakes 0.1 + 0.05 s from now on, and is slower than 0.1 m/s 0.4 / 2.5 = 0.16 s later: after 0.31 s he has come
  // 0.5 + 1.3 * (0.31 + 0.4) = 1.4 m from the place, and the robot's front is at 0.3 + 0.5 * 0.15 + 0.3 * 0.16 = 0.42.
  EXPECT_FALSE(confirms(p, fast, {{1.3, 0.0}}, {0.5, 0.0}));
  EXPECT_FALSE(confirms(p, fast, {{-3.0, 0.0}, {1.3, 0.0}}, {0.5, 0.0}));
  EXPECT_TRUE(confirms(p, fast, {{2.1, 0.0}}, {0.5, 0.0}));
  EXPECT_TRUE(confirms(p, fast, {{5.0, 0.0}, {0.0, -5.0}}, {0.5, 0.0}));
  // Who steps out more slowly, 0.5 + 0.3 * 0.71 = 0.71 m, is nearer.
  Parameters slow = p;
  slow.occlusion_speed = 0.3;
  EXPECT_TRUE(confirms(slow, fast, {{1.3, 0.0}}, {0.5, 0.0}));
}

// Every half of a millisecond until rest, every place.
struct SlowRest {
  double gap = 1e9;       // the least one [m]
  double fast_gap = 1e9;  // likewise to the places that move outwards faster than blind_speed [m]
  double fastest = 0.0;   // of these points [m/s]
};

SlowRest rest_slowly(const CycleMotion& motion, const Twist2& command, const std::vector<Point>& places,
                     const Parameters& p) {
  const double radius = kBody.circumscribed_radius();
  ManoeuvreRoller roller = motion.roller(radius, 1.0, 0.0005);
  SlowRest rest;
  Pose2 before = motion.start.origin;
  double then = 0.0;
  roller.roll(motion.start.manoeuvre(0, command, 0.0), [&](const TurnedPose& at) {
    const double dt = roller.time() - then, turn = at.pose.theta - before.theta;
    const Point moved(at.pose.x - before.x, at.pose.y - before.y);
    const Twist2 u{moved.dot(Point(std::cos(before.theta), std::sin(before.theta))) / dt, turn / dt};
    rest.fastest = std::max(rest.fastest, (moved.norm() + radius * std::abs(turn)) / dt);
    before = at.pose;
    then = roller.time();
    for (const Point& place : places) {
      const Point seen = test::in_frame_of(at.pose, place);
      const double grown = 0.5 + p.occlusion_speed * (roller.time() + 0.4);
      const double gap = kBody.distance_to(seen) - grown;
      rest.gap = std::min(rest.gap, gap);
      if (gap > 0.0) continue;  // so are all places of the outline
      const double fast = test::naive_distance_to_advancing(kBody, {u, u}, p.blind_speed + 1e-6, seen, 0.01) - grown;
      rest.fast_gap = std::min(rest.fast_gap, fast);
    }
    return true;
  });
  return rest;
}

TEST(RestBeforeHidden, AgreesWithASlowTwin) {
  Random random(4861);
  int touched = 0, free = 0, slow = 0, met_slowly = 0;
  for (int k = 0; k < 2000; ++k) {
    Parameters p;
    p.min_vel_x = -0.3;
    p.control_latency = random.pick({0.0, 0.1});
    p.blind_speed = random.pick({0.0, 0.1, 0.2});
    p.occlusion_speed = random.uniform(0.2, 1.5);
    const double most = random.pick({0.08, 0.5});
    const double v = random.uniform(0.0, most), omega = random.uniform(-2.0 * most, 2.0 * most);
    const CycleMotion motion(p, {v, omega}, {0.3, -0.2, random.uniform(-3.0, 3.0)});
    std::vector<Point> places;
    for (int i = 0; i < 3; ++i) {
      const double angle = random.uniform(-M_PI, M_PI), away = random.uniform(0.8, 2.5);
      places.emplace_back(0.3 + away * std::cos(angle), -0.2 + away * std::sin(angle));
    }
    const double wanted_v = random.uniform(-0.3, most), wanted_omega = random.uniform(-2.0 * most, 2.0 * most);
    const Twist2 command = motion.start.limits.step({v, omega}, {wanted_v, wanted_omega}, motion.start.period);
    const SlowRest twin = rest_slowly(motion, command, places, p);
    const bool passes = confirms(p, motion, places, command);
    if (twin.fast_gap <= 0.0) {
      EXPECT_FALSE(passes) << k << ": " << twin.fast_gap;
      ++touched;
    }
    // Half a short step at 1.5 + 0.9 m/s, and a drift of some millimetres, all twice.
    if (twin.gap > 0.08) {
      EXPECT_TRUE(passes) << k << ": " << twin.gap;
      ++free;
    }
    // Slow is what is slow with the fastest v and the fastest omega of a leg, though they may come one after the other.
    const double v_most = std::max(v, std::abs(command.v));
    const double omega_most = std::max(std::abs(omega), std::abs(command.omega));
    if (v_most + kBody.circumscribed_radius() * omega_most <= p.blind_speed) {
      EXPECT_TRUE(passes) << k;
      EXPECT_LE(twin.fastest, p.blind_speed + 1e-9) << k;
      ++slow;
      met_slowly += twin.gap <= 0.0;
    }
  }
  EXPECT_GT(touched, 200);
  EXPECT_GT(free, 200);
  EXPECT_GT(slow, 100);
  EXPECT_GT(met_slowly, 10);
}

// The critic, with places by hand.
struct OcclusionBench {
  explicit OcclusionBench(const Parameters& p = {})
      : scene(scene_of(p)), footprint(Footprint::from_outline(scene.outline, 0.0)), bench("Occlusion", scene) {}
  static Scene scene_of(const Parameters& p) {
    Scene scene = Scene::empty();
    scene.parameters = p;
    return scene;
  }
  void prepare(const std::vector<Point>& all) {
    places = all;
    CycleView view;
    view.footprint = &footprint;
    view.hidden_places = &places;
    view.hidden_radius = kDisc;
    bench.critic().prepare(view);
  }
  double raw(double v, const std::vector<Pose2>& poses, double dt = 0.125) {
    return bench.score({v, 0.0}, poses, dt).raw;
  }
  Scene scene;
  Footprint footprint;
  CriticBench bench;
  std::vector<Point> places;
};

std::vector<Pose2> straight(double v, double dt = 0.125, int steps = 8) {
  std::vector<Pose2> poses;
  for (int k = 0; k <= steps; ++k) poses.push_back({v * dt * k, 0.0, 0.0});
  return poses;
}

TEST(Occlusions, WeighOnlyWhereTheyAreACost) {
  Parameters p;
  EXPECT_GT(OcclusionBench(p).bench.weight(), 0.0);
  p.occlusion = Occlusion::off;
  EXPECT_EQ(OcclusionBench(p).bench.weight(), 0.0);
  p.occlusion = Occlusion::bound;
  EXPECT_EQ(OcclusionBench(p).bench.weight(), 0.0);
}

TEST(Occlusions, CostTheShareOfTheRoomThatIsMissingTimesTheSpeed) {
  Parameters p;
  p.control_latency = 0.1;
  p.decel_lim_x = -2.0;
  p.occlusion_speed = 1.0;
  p.blind_speed = 0.1;
  OcclusionBench bench(p);
  bench.prepare({{2.0, 3.0}, {1.3, 0.0}});
  // 0.4 m/s rests 0.1 + 0.1 + 0.4 / 2 = 0.4 s from now: he 0.4 m farther, the robot 0.4 * 0.2 + 0.4^2 / 4 = 0.12 m:
  // 0.52 m. Standing there the gap is 1.3 - 0.5 - 0.2 = 0.6 m: nothing. After 0.5 s, at 0.2, it is 0.4 m, after 0.75 s
  // 0.3, after 1 s 0.2, and after 0.25 s 0.5.
  const double missing = 4.0 - (0.5 + 0.4 + 0.3 + 0.2) / 0.52;
  EXPECT_NEAR(bench.raw(0.4, straight(0.4)), 0.25 * missing * (0.4 - 0.1), 1e-12);
  // Backwards it is as fast.
  EXPECT_NEAR(bench.raw(-0.4, straight(0.4)), 0.25 * missing * (0.4 - 0.1), 1e-12);
  EXPECT_EQ(bench.raw(0.4, std::vector<Pose2>(9, Pose2{})), 0.0);
  // In the disc it is the full risk, and no more.
  bench.prepare({{0.1, 0.0}});
  EXPECT_NEAR(bench.raw(0.4, std::vector<Pose2>(9, Pose2{})), 1.0 * (0.4 - 0.1), 1e-12);
  bench.prepare({});
  EXPECT_EQ(bench.raw(0.4, straight(0.4)), 0.0);
}

TEST(Occlusions, WithoutPlacesOfTheCycleCostNothing) {
  OcclusionBench bench;
  bench.prepare({{0.5, 0.0}});
  EXPECT_GT(bench.raw(0.4, straight(0.4)), 0.0);
  bench.bench.prepare();  // of a cycle that tells of none
  EXPECT_EQ(bench.raw(0.4, straight(0.4)), 0.0);
}

// Arcs of one rate of turn, of these speeds [m/s].
class ArcTile {
 public:
  ArcTile(std::vector<double> speeds, double omega, double dt, int steps) : v_(std::move(speeds)) {
    poses.resize(v_.size());
    for (int k = 0; k <= steps; ++k) {
      const double heading = omega * dt * k, length = std::abs(omega) > 1e-9 ? std::sin(heading) / omega : dt * k;
      const double side = std::abs(omega) > 1e-9 ? (1.0 - std::cos(heading)) / omega : 0.0;
      for (std::size_t c = 0; c < v_.size(); ++c) {
        x_.push_back(v_[c] * length);
        y_.push_back(v_[c] * side);
        poses[c].push_back({x_.back(), y_.back(), heading});
      }
      heading_.push_back(heading);
    }
    tile_.omega = omega;
    tile_.dt = dt;
    tile_.steps = static_cast<std::size_t>(steps);
    tile_.count = tile_.stride = v_.size();
    tile_.v = v_.data();
    tile_.x = x_.data();
    tile_.y = y_.data();
    tile_.heading = heading_.data();
  }
  ArcTile(const ArcTile&) = delete;
  ArcTile& operator=(const ArcTile&) = delete;

  std::vector<double> scores(Critic& critic) {
    std::vector<double> raw(v_.size(), 0.0);
    std::vector<const char*> reasons(v_.size(), nullptr);
    TileScores scores(raw.data(), reasons.data(), raw.size());
    critic.score(CycleView(), tile_, scores);
    for (const char* reason : reasons) EXPECT_EQ(reason, nullptr);
    return raw;
  }
  std::vector<std::vector<Pose2>> poses;  // of each candidate

 private:
  std::vector<double> v_, x_, y_, heading_;
  Tile tile_;
};

std::vector<double> speeds_apart(double first, double apart, int count) {
  std::vector<double> speeds;
  for (int i = 0; i < count; ++i) speeds.push_back(first + apart * i);
  return speeds;
}

// Tiles of speeds 0.11 m/s apart and in no order, of which all are measured. Where they are 0.02 m/s apart, those about
// 0.1 m/s apart are, and the others lie on straight lines between.
TEST(Occlusions, AreWhatASlowTwinSaysOfEveryCandidate) {
  Random random(4862);
  int some = 0;
  double off = 0.0, sum = 0.0;
  for (int k = 0; k < 300; ++k) {
    Parameters p;
    p.control_latency = random.uniform(0.0, 0.3);
    p.acc_lim_x = random.uniform(0.5, 3.0);
    p.decel_lim_x = random.chance(0.5) ? 0.0 : -random.uniform(0.5, 3.0);
    p.occlusion_speed = random.uniform(0.0, 2.0);
    p.blind_speed = random.uniform(0.0, 0.3);
    OcclusionBench bench(p);
    std::vector<Point> places;
    for (int i = random.integer(1, 6); i > 0; --i) {
      const double x = random.uniform(-1.5, 2.5), y = random.uniform(-1.5, 1.5);
      places.emplace_back(x, y);
    }
    bench.prepare(places);
    const double omega = random.chance(0.2) ? 0.0 : random.uniform(-1.0, 1.0), dt = random.uniform(0.03, 0.4);
    const int steps = random.integer(1, 30);
    std::vector<double> all = speeds_apart(random.uniform(-0.4, 0.1), 0.11, 8);
    if (random.chance(0.5)) std::swap(all.front(), all.back());
    const auto twin = [&](const ArcTile& tile, std::size_t c, double v) {
      return naive_occlusion(tile.poses[c], dt, v, 0.2, places, kDisc, p);
    };
    ArcTile tile(all, omega, dt, steps);
    const std::vector<double> raw = tile.scores(bench.bench.critic());
    for (std::size_t c = 0; c < all.size(); ++c) {
      EXPECT_NEAR(raw[c], twin(tile, c, all[c]), 1e-9) << k << ": " << c;
      some += raw[c] > 0.0;
    }
    const std::vector<double> fine = speeds_apart(0.0, 0.02, 41);
    ArcTile fine_tile(fine, omega, dt, steps);
    const std::vector<double> between = fine_tile.scores(bench.bench.critic());
    EXPECT_NEAR(between.front(), twin(fine_tile, 0, fine.front()), 1e-9);
    EXPECT_NEAR(between.back(), twin(fine_tile, 40, fine.back()), 1e-9);
    for (std::size_t c = 0; c < fine.size(); ++c) {
      off += std::abs(between[c] - twin(fine_tile, c, fine[c]));
      sum += twin(fine_tile, c, fine[c]);
    }
  }
  EXPECT_GT(some, 500);
  EXPECT_LT(off, 0.03 * sum);
}

SensorSectors all_round() { return {{{}, 2.0 * M_PI, 10.0}}; }

// A wall on the left, 0.6 m beside the plan, that ends at x = 0.6.
Scene beside_a_corner(Occlusion occlusion) {
  Scene scene = Scene::empty(161);
  scene.parameters.occlusion = occlusion;
  scene.situation.plan.clear();
  for (int i = -20; i <= 60; ++i) scene.situation.plan.push_back({0.05 * i, 0.0, 0.0});
  scene.situation.sensor_sectors = all_round();
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  scene.fill(-4.1, 0.58, 0.62, 0.62);
  return scene;
}

TEST(PlannerThatThinksOfWhoIsHidden, RefusesByTheNameOfOcclusionOnlyWhereItIsABound) {
  for (const Occlusion occlusion : {Occlusion::off, Occlusion::cost, Occlusion::bound}) {
    Scene scene = beside_a_corner(occlusion);
    scene.steer({0.5, 0.0});
    PlannerBench bench(scene);
    const Decision& decision = bench.cycle();
    const bool bound = occlusion == Occlusion::bound;
    EXPECT_EQ(rejections_by(decision, "Occlusion") > 0, bound);
    EXPECT_EQ(decision.operator_rejected_by, bound ? "Occlusion" : "");
    EXPECT_EQ(decision.command.v < 0.45, bound);
    const auto term = std::find_if(decision.terms.begin(), decision.terms.end(),
                                   [](const CriticTerm& t) { return t.name == "Occlusion"; });
    const bool costs = term != decision.terms.end() && term->weight > 0.0 && term->raw > 0.0;
    EXPECT_EQ(costs, occlusion == Occlusion::cost);
  }
}

TEST(PlannerThatThinksOfWhoIsHidden, WithoutSensorsOrInTheOpenRefusesNothing) {
  Scene blind = beside_a_corner(Occlusion::bound);
  blind.situation.sensor_sectors.clear();
  EXPECT_EQ(rejections_by(PlannerBench(blind).cycle(), "Occlusion"), 0U);
  Scene open = beside_a_corner(Occlusion::bound);
  std::fill(open.costs.begin(), open.costs.end(), cost::kFree);
  EXPECT_EQ(rejections_by(PlannerBench(open).cycle(), "Occlusion"), 0U);
}

TEST(PlannerThatThinksOfWhoIsHidden, TakesBrakingForABound) {
  Parameters p;
  p.occlusion = Occlusion::bound;
  EXPECT_TRUE(validate(p).empty());
  p.admissibility = Admissibility::horizon;
  ASSERT_EQ(validate(p).size(), 1U);
  EXPECT_EQ(validate(p).front().find("occlusion: bound needs admissibility: braking"), 0U);
  p.occlusion = Occlusion::cost;
  EXPECT_TRUE(validate(p).empty());
}

// Two speeds are far apart: 0 and 0.5 m/s, and the one between them.
TEST(PlannerThatThinksOfWhoIsHidden, HasASampleThatCreepsPastADoorPost) {
  Scene scene = beside_a_corner(Occlusion::bound);
  scene.parameters.vx_samples = 2;
  scene.situation.velocity = scene.situation.last_command = {};
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  for (int k = 0; k < 40; ++k) bench.drive();
  EXPECT_GT(bench.scene().situation.pose.x, 0.05);
  EXPECT_NEAR(bench.scene().situation.velocity.v, scene.parameters.blind_speed, 1e-9);
}

TEST(PlannerThatThinksOfWhoIsHidden, NamesOcclusionOfEveryFastCandidate) {
  Scene scene = beside_a_corner(Occlusion::bound);
  PlannerBench bench(scene);
  Sampling full;
  full.report = Report::full;
  bench.planner().plan(scene.situation, scene.grid(), scene.intent, full);
  int refused = 0, faster = 0, fast = 0;
  for (const CandidateReport& candidate : bench.planner().candidates()) {
    const bool named = std::any_of(candidate.rejections.begin(), candidate.rejections.end(),
                                   [](const Rejection& r) { return r.name == "Occlusion"; });
    refused += named;
    fast += candidate.sample.v > 0.4;
    faster += candidate.sample.v > 0.4 && named;
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(fast, 0);
  EXPECT_EQ(faster, fast);
}

TEST(PlannerThatThinksOfWhoIsHidden, DecidesTheSameBitsWhereNobodyCanHide) {
  Random random(4863);
  for (const bool steered : {false, true}) {
    Scene scene = Scene::empty(121);
    scene.situation.sensor_sectors = all_round();
    scene.situation.pose.y = random.uniform(-0.2, 0.2);
    scene.situation.pose.theta = random.uniform(-0.5, 0.5);
    if (steered) scene.steer({0.4, 0.3});
    scene.parameters.occlusion = Occlusion::off;
    PlannerBench off(scene);
    scene.parameters.occlusion = Occlusion::cost;
    PlannerBench cost(scene);
    scene.parameters.occlusion = Occlusion::bound;
    PlannerBench bound(scene);
    for (int k = 0; k < 30; ++k) {
      const Decision a = off.drive();
      for (PlannerBench* other : {&cost, &bound}) {
        const Decision b = other->drive();
        EXPECT_EQ(a.command, b.command) << k;
        EXPECT_EQ(a.sample, b.sample) << k;
        EXPECT_EQ(a.total, b.total) << k;
        EXPECT_EQ(a.outcome, b.outcome) << k;
      }
    }
  }
}

// Cells as far away are not to be counted.
TEST(PlannerThatThinksOfWhoIsHidden, TakesNoPlaceForAPoseThatIsNone) {
  for (const double x : {-1e12, 1e12, 1e300}) {
    for (const Occlusion occlusion : {Occlusion::cost, Occlusion::bound}) {
      Scene scene = beside_a_corner(occlusion);
      scene.situation.pose.x = x;
      EXPECT_EQ(PlannerBench(scene).cycle().problem_kind, Problem::input) << x;
    }
  }
}

struct DoorwayDrive {
  bool arrived = false;
  double duration = 0.0;    // [s]
  double slowest = 1e9;     // from 0.6 m before the wall up to it [m/s]
  std::size_t refused = 0;  // candidates, by Occlusion
  int braked = 0;           // cycles in which nothing was legal: places appear from one cycle to the next
  bool failed = false;
};

// From x = -2 to 1.5 through a wall at x = 0, 0.2 m thick, by an opening of 1 m.
DoorwayDrive through_doorway(Occlusion occlusion) {
  Scene scene = Scene::empty(161);
  scene.parameters.occlusion = occlusion;
  scene.situation.sensor_sectors = all_round();
  scene.situation.pose = {-2.0, 0.0, 0.0};
  scene.situation.plan.clear();
  for (int i = 0; i <= 80; ++i) scene.situation.plan.push_back({-2.0 + 0.05 * i, 0.0, 0.0});
  scene.situation.goal = scene.situation.plan.back();
  scene.fill(-0.11, 0.5, 0.11, 4.1);
  scene.fill(-0.11, -4.1, 0.11, -0.5);
  test::inflate(scene, 0.2, 0.55, 4.0);
  PlannerBench bench(scene);
  DoorwayDrive result;
  for (int k = 0; k < 1200 && !result.arrived; ++k) {
    const Decision& decision = bench.drive();
    result.refused += rejections_by(decision, "Occlusion");
    const Situation& now = bench.scene().situation;
    result.braked += decision.outcome == Outcome::brake;
    result.failed = result.failed || decision.outcome == Outcome::fail;
    if (now.pose.x > -0.6 && now.pose.x < 0.0) result.slowest = std::min(result.slowest, now.velocity.v);
    result.duration += now.period;
    result.arrived = now.pose.x > 1.5;
  }
  return result;
}

TEST(DriveThroughADoorway, IsSlowWhereSomebodyMayStepOutAndGetsThrough) {
  const DoorwayDrive off = through_doorway(Occlusion::off), cost = through_doorway(Occlusion::cost);
  const DoorwayDrive bound = through_doorway(Occlusion::bound);
  for (const DoorwayDrive* drive : {&off, &cost, &bound}) {
    EXPECT_TRUE(drive->arrived);
    EXPECT_FALSE(drive->failed);
    EXPECT_LE(drive->braked, drive == &bound ? 5 : 0);
    EXPECT_EQ(drive->refused > 0, drive == &bound);
  }
  EXPECT_GT(off.slowest, 0.4);
  EXPECT_LT(bound.slowest, 0.15);  // it creeps
  EXPECT_GT(bound.slowest, 0.01);  // and does not stand
  EXPECT_GT(bound.duration, off.duration + 1.0);
}

}  // namespace
}  // namespace hidwa_local_planner
