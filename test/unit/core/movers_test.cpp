// SPDX-License-Identifier: BSD-3-Clause
// What moves: where it may be, whether the robot rests before it can touch it, and cells that it explains.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/movers/departures.hpp"
#include "core/movers/explained_cells.hpp"
#include "core/movers/mover_check.hpp"
#include "core/movers/reachable_set.hpp"
#include "core/search/search_task.hpp"
#include "support/cycle_motion.hpp"
#include "support/naive_advance.hpp"
#include "support/naive_inflation.hpp"
#include "support/planner_bench.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::CycleMotion;
using test::mover_at;
using test::PlannerBench;
using test::Random;
using test::rejections_by;
using test::Scene;

TEST(ReachableSets, AreWhatAccelerationAndSpeedAllow) {
  Parameters p;
  p.moving_obstacle_acc = 1.5;
  p.moving_obstacle_speed = 1.8;
  MovingObstacleEstimate mover = mover_at(1.0, 2.0, 0.5, 0.0);
  mover.position_deviation = 0.02;
  mover.velocity_deviation = 0.1;
  mover.age = 0.1;
  const ReachableSet set(mover, p);
  // tau = 0.3 + 0.1 s
  EXPECT_NEAR(set.centre(0.3).x(), 1.0 + 0.5 * 0.4, 1e-12);
  EXPECT_NEAR(set.radius(0.3), 0.3 + 3 * 0.02 + 3 * 0.1 * 0.4 + 0.5 * 1.5 * 0.4 * 0.4, 1e-12);
  EXPECT_NEAR(set.speed_radius(0.3), 0.3 + 3 * 0.02 + 1.8 * 0.4, 1e-12);
  mover.velocity = {3.0, 0.0};  // faster than the parameter says: 3.0 + 3 * 0.1
  EXPECT_NEAR(ReachableSet(mover, p).fastest(), 3.3, 1e-12);
  p.moving_obstacle_deviations = 1.0;
  EXPECT_NEAR(ReachableSet(mover, p).fastest(), 3.0 + 1 * 0.1, 1e-12);
  EXPECT_NEAR(ReachableSet(mover, p).radius(0.3), 0.3 + 1 * 0.02 + 1 * 0.1 * 0.4 + 0.5 * 1.5 * 0.4 * 0.4, 1e-12);
  EXPECT_NEAR(ReachableSet(mover, p).speed_radius(0.3), 0.3 + 1 * 0.02 + (3.0 + 1 * 0.1) * 0.4, 1e-12);
}

const Footprint kBody({{0.3, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.3, -0.2}});

// The larger gap to the two discs [m].
double gap_to(const ReachableSet& set, const TurnedPose& at, double t) {
  const auto gap = [&at](const Point& centre, double radius) {
    return kBody.distance_to(test::in_frame_of(at.pose, centre)) - radius;
  };
  return std::max(gap(set.centre(t), set.radius(t)), gap(set.position(), set.speed_radius(t)));
}

// The least of that over the time until rest, in steps of half a millisecond, every mover at every step.
double least_gap(const CycleMotion& motion, const Twist2& command, const std::vector<ReachableSet>& sets,
                 double hold = 0.0) {
  ManoeuvreRoller roller = motion.roller(kBody.circumscribed_radius(), 1.0, 0.0005);
  double least = 1e9;
  roller.roll(motion.start.manoeuvre(0, command, hold), [&](const TurnedPose& at) {
    for (const ReachableSet& set : sets) least = std::min(least, gap_to(set, at, roller.time()));
    return true;
  });
  return least;
}

// What can_rest() asks, of this command alone: poses 0.05 s apart, each free for 5 ms before and after, and free where
// the robot stood before it moved on.
bool can_rest(const CycleMotion& motion, const Twist2& command, const std::vector<ReachableSet>& sets, double hold) {
  ManoeuvreRoller roller = motion.roller(kBody.circumscribed_radius(), 1e3, 0.05);
  TurnedPose before = TurnedPose::of(motion.start.origin);
  double then = -1.0;
  const auto free_at = [&](const TurnedPose& at, double t) {
    return std::all_of(sets.begin(), sets.end(), [&](const ReachableSet& set) {
      const double allowed = std::min(0.005, 0.5 * roller.step().duration);
      return gap_to(set, at, t) > roller.drift() + allowed * (roller.step().fastest + set.fastest());
    });
  };
  return roller.roll(motion.start.manoeuvre(0, command, hold), [&](const TurnedPose& at) {
    const double moves_on = roller.time() - roller.step().duration;
    if (moves_on > then + 1e-9 && !free_at(before, moves_on)) return false;
    before = at;
    then = roller.time();
    return free_at(at, then);
  });
}

// Between so far away [m], no faster along either axis than `fastest` [m/s].
MovingObstacleEstimates three_around(Random& random, double nearest, double farthest, double fastest) {
  MovingObstacleEstimates movers;
  for (std::uint32_t id = 0; id < 3; ++id) {
    const double angle = random.uniform(-M_PI, M_PI), away = random.uniform(nearest, farthest);
    const double vx = random.uniform(-fastest, fastest), vy = random.uniform(-fastest, fastest);
    movers.push_back(mover_at(away * std::cos(angle), away * std::sin(angle), vx, vy));
    movers.back().id = id;
    movers.back().age = random.uniform(0.0, 0.1);
  }
  return movers;
}

std::vector<ReachableSet> sets_of(const MovingObstacleEstimates& movers, const Parameters& parameters) {
  std::vector<ReachableSet> sets;
  for (const MovingObstacleEstimate& mover : movers) sets.emplace_back(mover, parameters);
  return sets;
}

bool confirms(const Parameters& p, const MovingObstacleEstimates& movers, const CycleMotion& motion,
              const Twist2& command) {
  MoverCheck check;
  check.prepare(p, kBody, movers, motion.start);
  return check.none_near() || check.confirm(command);
}

// All over the dynamic window, and beyond: what is found out for several commands at once holds for each of them. In
// each other scene cycles come up to 0.1 s late, and the first command to brake up to 0.2 s.
TEST(MoverChecks, AnswerForEachCommandAsForItAlone) {
  Random random(13);
  int refused = 0, free = 0, mixed = 0;
  for (int k = 0; k < 600; ++k) {
    Parameters p;
    p.min_vel_x = -0.5;
    const double lively = random.uniform(0.02, 1.0);
    p.moving_obstacle_speed *= lively;
    p.moving_obstacle_acc *= lively;
    p.acc_lim_x = random.uniform(0.5, 20.0);
    p.decel_lim_x = random.uniform(0.5, 20.0);
    p.acc_lim_theta = random.uniform(1.0, 40.0);
    const VelocityLimits limits = VelocityLimits::from(p);
    const Twist2 now{random.uniform(-0.5, 0.5), random.uniform(-1.0, 1.0)};
    const Twist2 commanded{now.v + random.uniform(-0.1, 0.1), now.omega + random.uniform(-0.1, 0.1)};
    p.control_latency = random.uniform(0.0, 0.1);
    const bool stale = random.chance(0.5);
    CycleMotion motion(p, now, {0.0, 0.0, random.uniform(-3.0, 3.0)}, stale ? commanded : now);
    CycleStart& start = motion.start;
    const MovingObstacleEstimates movers = three_around(random, 0.5, 1.2, 1.5 * lively);
    const std::vector<ReachableSet> sets = sets_of(movers, p);
    start.longest_period = k % 2 == 0 ? 0.05 : 0.15;
    const double latest = k % 2 == 0 ? 0.0 : 0.2;
    MoverCheck check;
    check.prepare(p, kBody, movers, start);
    int free_here = 0, refused_here = 0;
    for (int i = -1; i <= 11; ++i) {
      for (int j = -1; j <= 11; ++j) {
        const double most_v = std::max(limits.x.acc, limits.x.braking) * start.period;
        const double most_omega = std::max(limits.theta.acc, limits.theta.braking) * start.period;
        const Twist2 command{now.v + (0.2 * i - 1.0) * most_v, now.omega + (0.2 * j - 1.0) * most_omega};
        const bool answer = check.none_near() || check.can_rest(command);
        const bool rests = can_rest(motion, command, sets, 0.0) && can_rest(motion, command, sets, latest);
        EXPECT_EQ(answer, rests) << k << ": " << i << ", " << j;
        ++(answer ? free_here : refused_here);
      }
    }
    free += free_here;
    refused += refused_here;
    mixed += free_here > 0 && refused_here > 0;
  }
  EXPECT_GT(refused, 5000);
  EXPECT_GT(free, 5000);
  EXPECT_GT(mixed, 50);
}

// What the twin says is touched is rejected; what it says stays farther away than every allowance is not.
TEST(MoverChecks, AgreeWithASlowTwin) {
  Random random(11);
  test::GapTally tally;
  for (int k = 0; k < 1500; ++k) {
    SCOPED_TRACE(k);
    Parameters p;
    p.min_vel_x = -0.3;
    const Twist2 now{random.uniform(0.0, 0.5), random.uniform(-1.0, 1.0)};
    p.control_latency = random.chance(0.5) ? 0.1 : 0.0;
    const CycleMotion motion(p, now, {0.0, 0.0, random.uniform(-3.0, 3.0)});
    MovingObstacleEstimates movers = three_around(random, 0.65, 1.6, 1.5);
    for (MovingObstacleEstimate& mover : movers) {
      mover.position_deviation = 0.02;
      mover.velocity_deviation = 0.05;
    }
    const Twist2 wanted{random.uniform(-0.3, 0.5), random.uniform(-1.0, 1.0)};
    const Twist2 command = motion.start.limits.step(now, wanted, motion.start.period);
    // Half a short step at 1.8 + 0.9 m/s, and a drift of some millimetres, all twice: the discs are taken apart.
    tally.add(least_gap(motion, command, sets_of(movers, p)), 0.08, confirms(p, movers, motion, command));
  }
  EXPECT_GT(tally.touched, 200);
  EXPECT_GT(tally.free, 200);
}

// Cycles of up to 0.15 s where 0.05 s are asked for: the first command to brake comes up to 2 x (0.15 - 0.05) = 0.2 s
// late, and the robot must rest untouched whenever it comes.
TEST(MoverChecks, AgreeWithASlowTwinWhereCyclesAreLate) {
  Random random(12);
  test::GapTally tally;
  Parameters p;
  p.control_latency = 0.0;
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(k);
    const Twist2 now{random.uniform(0.3, 0.5), random.uniform(-0.5, 0.5)};
    CycleMotion motion(p, now);
    motion.start.longest_period = 0.15;
    const double angle = random.uniform(-0.6, 0.6), away = random.uniform(0.7, 1.3);
    const double vx = random.uniform(-0.6, 0.1), vy = random.uniform(-0.3, 0.3);
    MovingObstacleEstimates movers{mover_at(away * std::cos(angle), away * std::sin(angle), vx, vy)};
    movers[0].position_deviation = movers[0].velocity_deviation = 0.01;
    const Twist2 command = motion.start.limits.step(now, {0.5, random.uniform(-0.5, 0.5)}, motion.start.period);
    double gap = 1e9;
    for (int late = 0; late <= 8; ++late) {
      gap = std::min(gap, least_gap(motion, command, sets_of(movers, p), 0.025 * late));
    }
    // As above, and half of the 0.025 s between two commands to brake, at 0.9 m/s: 0.011 m.
    tally.add(gap, 0.06, confirms(p, movers, motion, command));
  }
  EXPECT_GT(tally.touched, 50);
  EXPECT_GT(tally.free, 50);
}

Scene among(const MovingObstacleEstimates& movers, double speed) {
  Scene scene = Scene::empty(121);
  scene.situation.velocity = scene.situation.last_command = {speed, 0.0};
  scene.situation.moving_obstacles = movers;
  return scene;
}

TEST(AmongMovers, WhatMayBeTouchedIsRefusedByName) {
  // 0.8 m ahead comes somebody at 1.5 m/s: 0.3 m of gap to the robot's front.
  Scene scene = among({mover_at(0.8, 0.0, -1.5)}, 0.4);
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_GT(rejections_by(decision, "Moving obstacle"), 0U);
  EXPECT_EQ(decision.operator_rejected_by, "Moving obstacle");
  EXPECT_LT(decision.command.v, 0.4);
}

TEST(AmongMovers, FarAwayTheyRefuseNothing) {
  Scene scene = among({mover_at(2.5, 0.0, -0.5)}, 0.4);
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(rejections_by(decision, "Moving obstacle"), 0U);
  EXPECT_EQ(decision.outcome, Outcome::drive);
}

TEST(AmongMovers, HorizonAsksNothingOfThem) {
  Scene scene = among({mover_at(0.8, 0.0, -1.5)}, 0.4);
  scene.parameters.admissibility = Admissibility::horizon;
  PlannerBench bench(scene);
  EXPECT_EQ(rejections_by(bench.cycle(), "Moving obstacle"), 0U);
}

TEST(AmongMovers, ARobotAtRestLeavesWhoStandsAtItAndNeverDrivesTowardsHim) {
  // The disc begins 0.01 m before the robot's front: 0.51 - 0.3 - 0.2.
  Scene scene = among({mover_at(0.51, 0.0)}, 0.0);
  scene.parameters.min_vel_x = -0.3;
  scene.steer({0.5, 0.0});
  PlannerBench forward(scene);
  for (int k = 0; k < 20; ++k) EXPECT_LE(forward.drive().command.v, 0.0);
  scene.steer({-0.3, 0.0});
  scene.parameters.linear = LinearPolicy::axis;
  PlannerBench back(scene);
  // First he may go on by himself; 1 s / 0.05 s = 20 cycles.
  for (int k = 0; k < 20; ++k) EXPECT_EQ(back.drive().command, Twist2{}) << k;
  // It creeps away from him, until it could rest in time at a walk.
  double fastest_near = 0.0;
  for (int k = 0; k < 60; ++k) {
    const double gap = 0.01 - back.scene().situation.pose.x;
    const double v = back.drive().command.v;
    if (gap < 0.05) fastest_near = std::max(fastest_near, -v);
  }
  EXPECT_GT(fastest_near, 0.0);
  EXPECT_LE(fastest_near, 0.15 + 1e-9);
  EXPECT_LT(back.scene().situation.pose.x, -0.3);
}

TEST(AdvancesNear, AgreesWithASlowTwin) {
  const Footprint bodies[] = {Footprint({}, 0.25), Footprint({{0.6, 0.25}, {-0.1, 0.25}, {-0.1, -0.25}, {0.6, -0.25}}),
                              Footprint({{0.3, -0.2}, {0.3, 0.2}, {0.0, 0.2}, {0.0, 0.0}, {-0.3, 0.0}, {-0.3, -0.2}})};
  Random random(17);
  int none = 0, compared = 0;
  for (int k = 0; k < 3000; ++k) {
    const Footprint& body = bodies[k % 3];
    VelocityRange u;
    if (random.chance(0.7)) u.include({random.uniform(-0.15, 0.15), 0.0});
    if (random.chance(0.7)) u.include({0.0, random.uniform(-0.4, 0.4)});
    const double angle = random.uniform(-M_PI, M_PI), away = random.uniform(0.3, 1.2);
    const Point point(away * std::cos(angle), away * std::sin(angle));
    if (body.distance_to(point) <= 0.0) continue;
    const double apart = 1e-3;  // [m]
    const double least = test::naive_distance_to_advancing(body, u, 0.02, point, apart);
    if (std::isinf(least)) {
      EXPECT_FALSE(advances_near(body, u, 0.02, point, 3.0)) << k;
      ++none;
      continue;
    }
    // Places that are `apart` from each other find it to within 1.5 times that.
    EXPECT_TRUE(advances_near(body, u, 0.02, point, least + 1.5 * apart)) << k;
    EXPECT_FALSE(advances_near(body, u, 0.02, point, least - 1.5 * apart)) << k;
    ++compared;
  }
  EXPECT_GT(none, 200);
  EXPECT_GT(compared, 1500);
}

// He stands 1 cm from the left rear corner of a robot that is to turn left: then its rear would move into where he may
// step. It may drive straight on.
TEST(AmongMovers, ARobotThatLeavesNeverMovesIntoWhereHeMayStep) {
  // hypot(0.43 - 0.21, 0.43 - 0.21) - 0.3 = 0.011 m, with 0.01 m of padding.
  Scene scene = among({mover_at(-0.43, 0.43)}, 0.0);
  scene.steer({0.5, 0.8});
  PlannerBench bench(scene);
  double turned = 0.0;
  int moved = 0;
  for (int k = 0; k < 60; ++k) {
    const Situation& s = bench.scene().situation;
    const bool near = std::hypot(s.pose.x + 0.43, s.pose.y - 0.43) < 0.63;  // 0.61 m at first
    const Twist2 u = bench.drive().command;
    moved += near && u.v > 0.0;
    if (near) turned = std::max(turned, u.omega);
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(turned, 0.1);  // 0.02 m/s at the end of a lever of 0.2 m
}

// He is soon past, and may turn towards it.
TEST(AmongMovers, WhoWalksPastIsNotLeft) {
  Scene scene = among({mover_at(-0.51, 0.0)}, 0.0);  // behind it
  scene.steer({0.5, 0.0});
  PlannerBench stands(scene);
  for (int k = 0; k < 20; ++k) stands.drive();
  EXPECT_GT(stands.cycle().command.v, 0.0);
  scene.situation.moving_obstacles = {mover_at(-0.51, 0.0, 0.0, 0.4)};
  PlannerBench walks(scene);
  for (int k = 0; k < 40; ++k) EXPECT_EQ(walks.drive().command, Twist2{}) << k;
}

TEST(AmongMovers, WhoWalksMeanwhileIsNotLeftAtOnceAfterwards) {
  Scene scene = among({mover_at(-0.51, 0.0)}, 0.0);
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  std::vector<MovingObstacleEstimate>& movers = bench.scene().situation.moving_obstacles;
  for (int k = 0; k < 15; ++k) bench.drive();
  movers = {mover_at(-0.51, 0.0, 0.0, 0.4)};
  bench.drive();
  movers = {mover_at(-0.51, 0.0)};
  for (int k = 0; k < 20; ++k) EXPECT_EQ(bench.drive().command, Twist2{}) << k;
  EXPECT_GT(bench.cycle().command.v, 0.0);
}

// A robot that drives when somebody comes so near must come to rest first.
TEST(AmongMovers, WhoComesAtARobotThatDrivesIsNotLeft) {
  Departures leaving;
  const auto cycles = [&](int count, bool rests) {
    int admitted = 0;
    for (int k = 0; k < count; ++k) {
      leaving.begin(0.25);
      admitted += leaving.admit(1, rests) ? 1 : 0;
    }
    return admitted;
  };
  EXPECT_EQ(cycles(10, false), 0);
  EXPECT_EQ(cycles(4, true), 0);   // at 0, 0.25, 0.5, 0.75 s
  EXPECT_EQ(cycles(1, true), 1);   // 1 s
  EXPECT_EQ(cycles(3, false), 3);  // it has been so near since the robot stood
  leaving.begin(0.25);             // and now it is not
  EXPECT_FALSE(leaving.any());
  EXPECT_EQ(cycles(10, false), 0);
}

TEST(AmongMovers, EachOfThemStandsForItsOwnTime) {
  Departures leaving;
  for (int k = 0; k < 5; ++k) {
    leaving.begin(0.25);
    EXPECT_EQ(leaving.admit(1, true), k == 4);
    if (k >= 2) {
      EXPECT_FALSE(leaving.admit(2, true));
    }
  }
  leaving.forget();
  leaving.begin(0.25);
  EXPECT_FALSE(leaving.admit(1, true));
}

TEST(AmongMovers, WhatIsLeftIsSavedAndLoaded) {
  Scene scene = among({mover_at(0.51, 0.0)}, 0.0);
  scene.parameters.min_vel_x = -0.3;
  scene.parameters.linear = LinearPolicy::axis;
  scene.steer({-0.3, 0.0});
  PlannerBench one(scene), other(scene), halfway(scene);
  const auto hand_over = [&one](PlannerBench& to) {
    Bytes state;
    one.planner().save(state);
    ASSERT_TRUE(to.planner().load(state));
    to.scene().situation = one.scene().situation;
  };
  for (int k = 0; k < 10; ++k) one.drive();
  hand_over(halfway);
  for (int k = 0; k < 11; ++k) {
    one.drive();
    halfway.drive();
  }
  hand_over(other);
  const Twist2 expected = one.cycle().command;
  EXPECT_TRUE(halfway.cycle().command == expected);
  EXPECT_LT(expected.v, 0.0);
  EXPECT_TRUE(other.cycle().command == expected);
  PlannerBench fresh(scene);
  fresh.scene().situation = one.scene().situation;
  EXPECT_FALSE(fresh.cycle().command == expected);  // without it, the robot brakes
}

TEST(AmongMovers, TheSearchTakesThemWhereTheyAreNow) {
  const Scene scene = Scene::empty(81);
  SearchTask task;
  const VelocityLimits limits = VelocityLimits::from(scene.parameters);
  make_search_task({}, scene.situation.plan, scene.grid(), Footprint(scene.outline), scene.parameters, limits, task);
  MovingObstacleEstimate mover = mover_at(1.0, 0.5, 1.0, 0.0);
  mover.age = 0.2;  // now at 1.2
  add_movers({mover}, Footprint(scene.outline), task);
  const GridView grid = task.grid();
  EXPECT_EQ(grid.at(grid.cell_at(1.45, 0.5)), cost::kLethal);
  EXPECT_EQ(grid.at(grid.cell_at(0.8, 0.5)), cost::kFree);
  std::fill(task.map.costs.begin(), task.map.costs.end(), cost::kFree);
  add_movers({mover_at(0.3, 0.0)}, Footprint(scene.outline), task);  // stands in the robot, whose front is at 0.2
  EXPECT_EQ(grid.at(grid.cell_at(0.15, 0.0)), cost::kFree);
  EXPECT_EQ(grid.at(grid.cell_at(0.45, 0.0)), cost::kLethal);
}

// A map with a person in it, whose points leave: the same as a map in which the person never was.
TEST(ExplainedCell, LeavesTheMapAsIfNobodyHadBeenThere) {
  Random random(5);
  for (int k = 0; k < 40; ++k) {
    Scene empty = Scene::empty(101);
    for (int wall = 0; wall < 6; ++wall) {
      const double x = random.uniform(-2.3, 2.3), y = random.uniform(-2.3, 2.3);
      if (std::hypot(x, y) < 0.75) continue;  // its cells are not the person's
      empty.fill(x - 0.1, y - 0.1, x + 0.1, y + 0.1);
    }
    Scene peopled = empty;
    MovingObstacleEstimate mover = mover_at(0.013, 0.021);
    mover.position_deviation = 0.01;  // 0.3 + 3 * 0.01 covers cells of 0.05 m that hold points at 0.25
    for (int i = 0; i < 12; ++i) {
      const double angle = 2.0 * M_PI * i / 12.0;
      mover.points.emplace_back(0.013 + 0.25 * std::cos(angle), 0.021 + 0.25 * std::sin(angle));
      peopled.at(peopled.grid().cell_at(mover.points.back().x(), mover.points.back().y())) = cost::kLethal;
    }
    test::inflate(empty, 0.2, 0.55, 4.0);
    test::inflate(peopled, 0.2, 0.55, 4.0);
    ExplainedCells cells;
    const GridView seen = cells.without(peopled.grid(), {mover}, {});
    int different = 0;
    for (std::size_t c = 0; c < empty.costs.size(); ++c) different += seen.costs[c] != empty.costs[c];
    EXPECT_EQ(different, 0) << k;
  }
}

// A wall beside a mover: its nearest cells are neighbours of one that holds a point.
TEST(ExplainedCell, WhatTheDiscDoesNotCoverStays) {
  Scene scene = Scene::empty(101);  // cells are centred on multiples of 0.05
  scene.fill(0.28, -0.3, 0.39, 0.3);
  MovingObstacleEstimate mover = mover_at(0.0, 0.0);
  mover.points.emplace_back(0.26, 0.01);  // in the column beside the wall
  const GridView grid = scene.grid();
  ExplainedCells cells;
  // The wall's cell around (0.30, 0.00) ends hypot(0.325, 0.025) = 0.3260 away from the mover's centre.
  EXPECT_EQ(cells.without(grid, {mover}, {}).costs, scene.costs.data());  // no copy
  mover.position_deviation = 0.008;                                       // 0.3 + 3 * 0.008 = 0.324
  EXPECT_EQ(cells.without(grid, {mover}, {}).costs, scene.costs.data());
  mover.position_deviation = 0.009;  // 0.327; the cells around (0.30, +-0.05) end hypot(0.325, 0.075) = 0.3335 away
  GridView seen = cells.without(grid, {mover}, {});
  EXPECT_LT(seen.at(grid.cell_at(0.30, 0.0)), cost::kLethal);
  EXPECT_EQ(seen.at(grid.cell_at(0.30, 0.05)), cost::kLethal);
  mover.position_deviation = 0.012;  // 0.336
  seen = cells.without(grid, {mover}, {});
  EXPECT_LT(seen.at(grid.cell_at(0.30, 0.05)), cost::kLethal);
  EXPECT_EQ(seen.at(grid.cell_at(0.35, 0.0)), cost::kLethal);
  Parameters p;
  p.moving_obstacle_deviations = 1.0;  // 0.312
  EXPECT_EQ(cells.without(grid, {mover}, p).costs, scene.costs.data());
}

TEST(ExplainedCell, TheDiscIsWhereTheMoverIsByNow) {
  Scene scene = Scene::empty(101);
  scene.fill(0.28, -0.02, 0.32, 0.02);  // one cell
  MovingObstacleEstimate mover = mover_at(0.0, 0.0, -1.0, 0.0);
  mover.radius = 0.33;  // covers it where the mover was: 0.3260
  mover.points.emplace_back(0.30, 0.0);
  Parameters p;
  p.moving_obstacle_acc = 1.5;
  ExplainedCells cells;
  EXPECT_LT(cells.without(scene.grid(), {mover}, p).at(scene.grid().cell_at(0.30, 0.0)), cost::kLethal);
  mover.age = 0.1;  // hypot(0.325 + 0.1, 0.025) = 0.426 from where it is, and 0.33 + 1.5 * 0.1 * 0.1 / 2 = 0.338
  EXPECT_EQ(cells.without(scene.grid(), {mover}, p).costs, scene.costs.data());
}

}  // namespace
}  // namespace hidwa_local_planner
