// SPDX-License-Identifier: BSD-3-Clause
// What the search finds is free, pose by pose; what it does not find is not there; portions and memory change nothing.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/search/target_distance.hpp"
#include "core/search/way_search.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "support/effort.hpp"
#include "support/naive_collision.hpp"
#include "support/random.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::Scene;
using State = WaySearch::State;

constexpr int kEnough = 1 << 20;  // poses

const Polygon kLong = {{0.35, 0.2}, {-0.35, 0.2}, {-0.35, -0.2}, {0.35, -0.2}};

// 4 m x 4 m, the robot at the origin; the plan leads 1.8 m along +x.
Scene room() {
  Scene scene = Scene::empty(81, 0.05);
  scene.parameters = Parameters();
  scene.outline = kLong;
  scene.situation.plan.clear();
  for (int i = 0; i <= 36; ++i) scene.situation.plan.push_back({0.05 * i, 0.0, 0.0});
  return scene;
}

// A corridor from x = -1 to x = 0.5, 0.55 m wide, closed at x = 0.5. The plan leads back out of it.
Scene dead_end() {
  Scene scene = room();
  scene.fill(-1.0, 0.275, 0.6, 2.0);
  scene.fill(-1.0, -2.0, 0.6, -0.275);
  scene.fill(0.5, -0.3, 0.6, 0.3);
  for (Pose2& pose : scene.situation.plan) pose.x = -pose.x;
  return scene;
}

SearchTask task_of(const Scene& scene) {
  SearchTask task;
  make_search_task(scene.situation.pose, scene.situation.plan, scene.grid(),
                   Footprint::from_outline(scene.outline, scene.parameters.footprint_padding), scene.parameters,
                   VelocityLimits::from(scene.parameters), task);
  return task;
}

double off_plan(const Scene& scene, const Pose2& pose) {
  double least = INFINITY;
  for (const Pose2& q : scene.situation.plan) least = std::min(least, distance(pose, q));
  return least;
}

// Millimetre by millimetre; true when the outline overlaps nothing.
bool is_free(const Scene& scene, const Way& way) {
  const test::NaiveBody body{scene.outline, 0.0};
  for (std::size_t k = 0; k + 1 < way.stations().size(); ++k) {
    const Pose2& a = way.stations()[k].pose;
    const Pose2& b = way.stations()[k + 1].pose;
    const double turn = wrap_angle(b.theta - a.theta), chord = distance(a, b);
    // An arc's chord leaves at half its turn; backwards the robot faces away from it.
    const double facing = std::cos(std::atan2(b.y - a.y, b.x - a.x) - a.theta - 0.5 * turn);
    const double length =
        std::copysign(std::abs(turn) > 1e-9 ? chord * 0.5 * turn / std::sin(0.5 * turn) : chord, facing);
    const int parts = 1 + static_cast<int>(std::max(chord, std::abs(turn) * 0.4) / 0.001);
    for (int p = 0; p <= parts; ++p) {
      const double share = static_cast<double>(p) / parts, angle = share * turn;
      const double part = std::abs(turn) > 1e-9 ? length / turn * 2.0 * std::sin(0.5 * angle) : share * length;
      const double direction = a.theta + 0.5 * angle;
      const Pose2 at{a.x + part * std::cos(direction), a.y + part * std::sin(direction), a.theta + angle};
      if (test::naive_overlap(scene.grid(), body, at, true) > 1e-6) return false;
    }
  }
  return true;
}

// A search that is over. Its way, where it has found one, is free.
struct Searched {
  State state;
  Pass pass;
  Way way;
};
Searched searched(const Scene& scene, const SearchTask& task) {
  WaySearch search;
  search.begin(task);
  Searched result;
  result.state = search.run(kEnough);
  result.pass = search.pass();
  search.write(result.way);
  EXPECT_EQ(result.way.empty(), result.state != State::found);
  EXPECT_TRUE(is_free(scene, result.way));
  return result;
}
Searched searched(const Scene& scene) { return searched(scene, task_of(scene)); }

TEST(WaySearch, StraightOnWhereNothingIs) {
  const Scene scene = room();
  const Way way = searched(scene).way;
  ASSERT_FALSE(way.empty());
  EXPECT_EQ(distance(way.stations().front().pose, scene.situation.pose), 0.0);
  // The target begins 1.5 m along the plan, and counts from 0.15 m before: 1.35 m at 0.5 m/s, and no more than a move
  // of 0.15 m beyond that.
  EXPECT_GE(way.duration(), 1.3 / scene.parameters.max_vel_x);
  EXPECT_LE(way.duration(), (1.35 + 0.15) / scene.parameters.max_vel_x);
  EXPECT_EQ(way.stations().back().left, 0.0);
}

// Boxes anywhere. False where one lies under the robot.
bool clutter(Scene& scene, Random& random, int boxes) {
  for (int k = 0; k < boxes; ++k) {
    const double x = random.uniform(-1.9, 1.6), y = random.uniform(-1.9, 1.6), side = random.uniform(0.1, 0.4);
    scene.fill(x, y, x + side, y + side);
  }
  return test::naive_overlap(scene.grid(), {scene.outline, 0.0}, scene.situation.pose, true) <= 0.0;
}

// At the goal's pose, within 80 % of both tolerances: 0.2 m, to the width of half a cell's diagonal, and 0.2 rad.
TEST(WaySearch, EndsAtTheGoalsPoseWhereThatIsAskedFor) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Scene scene = room();
    Random random(seed);
    if (random.chance(0.5)) scene.parameters.min_vel_x = -0.25;
    if (!clutter(scene, random, 8)) continue;
    const Pose2 goal{random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25), random.uniform(-M_PI, M_PI)};
    SearchTask task = task_of(scene);
    aim_at_goal(goal, scene.parameters, task);
    SCOPED_TRACE(seed);
    const Searched search = searched(scene, task);
    if (search.state != State::found) continue;
    ++found;
    const Pose2& end = search.way.stations().back().pose;
    EXPECT_LE(distance(end, goal), 0.2 + 0.036);
    EXPECT_LE(std::abs(wrap_angle(end.theta - goal.theta)), 0.2 + 1e-9);
  }
  EXPECT_GT(found, 8);
}

TEST(WaySearch, WaysAreFree) {
  const std::uint64_t kScenes = test::effort<std::uint64_t>(24, 120);
  int found = 0, none = 0, turned = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    Scene scene = room();
    Random random(seed);
    scene.situation.pose.theta = random.uniform(-M_PI, M_PI);
    if (random.chance(0.5)) scene.parameters.min_vel_x = -0.25;
    if (!clutter(scene, random, 14)) continue;
    SCOPED_TRACE(seed);
    const Searched search = searched(scene);
    ++(search.state == State::found ? found : none);
    if (search.state != State::found) continue;
    const std::vector<Way::Station>& stations = search.way.stations();
    EXPECT_LE(off_plan(scene, stations.back().pose), 0.15 + 0.05);
    turned += std::abs(wrap_angle(stations.back().pose.theta - scene.situation.pose.theta)) > 1.0;
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) EXPECT_GT(stations[k].left, stations[k + 1].left);
  }
  EXPECT_GE(found, test::effort(3, 15));  // or these scenes show nothing
  EXPECT_GE(none, test::effort(1, 3));
  EXPECT_GE(turned, test::effort(1, 5));
}

// 0.7 m long and 0.4 m wide it cannot turn in 0.55 m.
TEST(WaySearch, BackwardsOutOfADeadEndWhereTheRobotCan) {
  Scene scene = dead_end();
  EXPECT_EQ(searched(scene).state, State::no_way);
  scene.parameters.min_vel_x = -0.2;
  const Way way = searched(scene).way;
  ASSERT_FALSE(way.empty());
  EXPECT_LT(way.stations().back().pose.x, -1.3);
}

TEST(WaySearch, SaysHowFarItGetsAndWhatIsThere) {
  WaySearch search;
  search.begin(task_of(dead_end()));
  EXPECT_EQ(search.run(kEnough), State::no_way);
  const WaySearch::End end = search.end();
  ASSERT_TRUE(end.obstacle_known);
  // It may only go on towards the wall ahead, and the plan leads the other way: where it stands is nearest. Cells fill
  // |y| > 0.275: the first ones have their edge there, 0.075 m from its side.
  EXPECT_NEAR(end.pose.x, 0.0, 0.05);
  EXPECT_NEAR(end.gap, 0.275 - 0.2, 0.03);
  EXPECT_NEAR(std::abs(end.obstacle.y()), 0.3, 0.05);
}

// Gaps in a wall ahead, for a robot 0.4 m wide that faces it: by whole cells of 0.05 m.
TEST(WaySearch, ThroughGapsThatAreWideEnough) {
  for (const int cells : {7, 8, 9, 10}) {
    Scene scene = room();
    const double half = 0.025 * cells;
    // Cells' borders lie at odd multiples of 0.025 m.
    const double shift = cells % 2 == 0 ? 0.025 : 0.0;
    scene.fill(0.7, half + shift, 0.8, 2.1);
    scene.fill(0.7, -2.1, 0.8, -half + shift);
    for (Pose2& pose : scene.situation.plan) pose.y = shift;
    EXPECT_EQ(searched(scene).state == State::found, cells > 8) << cells;
  }
}

// In clutter: of these scenes one has a way that only the second pass finds.
TEST(WaySearch, LooksCloselyWhereItHasFoundNothing) {
  int closely = 0, coarsely = 0;
  for (std::uint64_t seed = 300; seed < 320; ++seed) {
    Scene scene = room();
    Random random(seed);
    scene.situation.pose.theta = random.uniform(-M_PI, M_PI);
    scene.parameters.min_vel_x = -0.25;
    if (!clutter(scene, random, 18)) continue;
    SCOPED_TRACE(seed);
    const Searched search = searched(scene);
    if (search.state != State::found) continue;
    ++(search.pass == Pass::close ? closely : coarsely);
  }
  EXPECT_GE(closely, 1);
  EXPECT_GE(coarsely, 3);
}

TEST(WaySearch, PortionsChangeNothing) {
  Scene scene = dead_end();
  scene.parameters.min_vel_x = -0.2;
  const Way whole = searched(scene).way;
  WaySearch search;
  search.begin(task_of(scene));
  int portions = 1;
  while (search.run(37) == State::searching) ++portions;
  EXPECT_GT(portions, 5);
  Way way;
  search.write(way);
  ASSERT_EQ(way.stations().size(), whole.stations().size());
  for (std::size_t k = 0; k < whole.stations().size(); ++k) {
    EXPECT_EQ(way.stations()[k].left, whole.stations()[k].left);
    EXPECT_EQ(distance(way.stations()[k].pose, whole.stations()[k].pose), 0.0);
  }
}

TEST(WaySearch, IsRepeatedFromItsBytes) {
  Scene scene = dead_end();
  scene.parameters.min_vel_x = -0.2;
  WaySearch search, other, fresh;
  search.begin(task_of(scene));
  State state = State::searching;
  for (int portion = 0; state == State::searching; ++portion) {
    Bytes bytes;
    ArchiveWriter write(bytes);
    write(static_cast<const WaySearch&>(search));
    for (WaySearch* copy : {&other, &fresh}) {  // one goes on, one begins from nothing each time
      if (copy == &fresh && portion % 8 != 0) continue;
      if (copy == &fresh) copy->clear();
      ArchiveReader read(bytes);
      read(*copy);
      ASSERT_TRUE(read.complete());
      ASSERT_EQ(copy->state(), State::searching);
    }
    state = search.run(100);
    ASSERT_EQ(other.run(100), state);
    ASSERT_TRUE(portion % 8 != 0 || fresh.run(100) == state);
  }
  Way a, b;
  search.write(a);
  other.write(b);
  ASSERT_EQ(a.stations().size(), b.stations().size());
  EXPECT_EQ(a.duration(), b.duration());
}

TEST(WaySearch, DamagedBytesAreNoSearch) {
  WaySearch search;
  search.begin(task_of(dead_end()));
  search.run(10);
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(static_cast<const WaySearch&>(search));
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 50) {
    ArchiveReader read(bytes.data(), length);
    WaySearch other;
    read(other);
    EXPECT_FALSE(read.complete());
    EXPECT_NE(other.state(), State::searching);
  }
}

// A wall one cell wide closes the map, in whatever column of it; cells are looked at 64 at a time.
TEST(TargetDistance, NoColumnOfAWallIsOpen) {
  for (const int column : {1, 63, 64, 65, 127, 128}) {
    Scene scene = Scene::empty(161, 0.05);
    for (int j = 0; j < scene.size_y; ++j) scene.at({column, j}) = cost::kLethal;
    SearchTask task = task_of(scene);
    task.outline.clear();
    task.radius = 0.01;  // it fits between any two walls, and through none
    const Point target = scene.grid().centre({140, 80});
    task.target = {target};
    task.near_target = 0.05;
    const Footprint footprint = task.footprint();
    CollisionChecker checker;
    checker.prepare(task.grid(), footprint, true, {}, 10.0, task.map.resolution / 16.0);
    TargetDistance distances;
    distances.prepare(task, checker);
    const Point before = scene.grid().centre({column + 1, 80});
    EXPECT_GE(distances.at(before.x(), before.y()), 0.05 * (140 - column - 1) - 2 * 0.05) << "column " << column;
    const Point behind = scene.grid().centre({column - 1, 80});
    EXPECT_LT(distances.at(behind.x(), behind.y()), 0.0) << "column " << column;
  }
}

Way way_of(const std::vector<Way::Station>& stations) {
  Way way;
  for (const Way::Station& station : stations) way.add(station);
  return way;
}

// The remaining time beside a way: that of the nearest place on it, and what it takes to get there: 0.1 m/s within its
// room, 0.04 m/s beyond.
TEST(Way, TellsTheRemainingTime) {
  const Way way = way_of({{{0.0, 0.0, 0.0}, 3.0}, {{1.0, 0.0, 0.0}, 1.0}, {{1.0, 0.0, 1.0}, 0.0}});
  const Way::Projection beside = way.nearest({0.5, 0.02, 0.0}, 0, 2, 0.05);
  EXPECT_EQ(beside.part, 0U);
  EXPECT_NEAR(beside.left, 2.0, 1e-12);                      // half of the first part
  EXPECT_NEAR(beside.remaining(), 2.0 + 0.02 / 0.1, 1e-12);  // and back
  EXPECT_NEAR(way.nearest({0.5, 0.07, 0.0}, 0, 1, 0.05).remaining(), 2.0 + 0.05 / 0.1 + 0.02 / 0.04, 1e-12);
  const Way::Projection turning = way.nearest({1.0, 0.0, 0.4}, 0, 2, 0.05);
  EXPECT_EQ(turning.part, 1U);
  EXPECT_NEAR(turning.remaining(), 0.6, 1e-12);
  // From beside the turn's beginning its end is 0.9 rad away, 0.36 m: 0.5 s and 0.31 m / 0.04 m/s, more than the turn.
  EXPECT_EQ(way.nearest({1.0, 0.0, 0.1}, 0, 2, 0.05).part, 1U);
  EXPECT_NEAR(way.nearest({1.0, 0.0, 0.1}, 0, 2, 0.05).left, 0.9, 1e-12);
  EXPECT_EQ(way.nearest({1.0, 0.0, 0.4}, 0, 1, 0.05).part, 0U);
  const Way::Projection beyond = way.nearest({1.3, 0.0, 0.0}, 0, 1, 0.05);  // the part ends at x = 1
  EXPECT_NEAR(beyond.left, 1.0, 1e-12);
  EXPECT_NEAR(beyond.off, 0.3, 1e-12);
  EXPECT_EQ(way.end_of_parts({0.0, 0.0, 0.0}, 0, 10.0, 0.02), 2U);
  EXPECT_EQ(way.end_of_parts({0.0, 0.0, 0.0}, 0, 0.5, 0.02), 1U);  // the second part begins 2 s later
}

TEST(Way, TimeUntilItIsNearAPose) {
  const Way way = way_of({{{0.0, 0.0, 0.0}, 3.0}, {{1.0, 0.0, 0.0}, 1.0}, {{1.2, 0.0, 0.0}, 0.5}});
  EXPECT_EQ(way.time_until_near({1.0, 0.1, 2.0}, 0.1), 2.0);  // 3.0 - 1.0, whatever the heading
  EXPECT_EQ(way.time_until_near({1.2, 0.0, 0.0}, 0.1), 2.5);  // the station before is 0.2 m away
  EXPECT_EQ(way.time_until_near({0.0, 0.1, 0.0}, 0.1), 0.0);
  EXPECT_EQ(way.time_until_near({0.5, 0.0, 0.0}, 0.1), 3.0);  // no station
  EXPECT_EQ(Way().time_until_near({0.5, 0.0, 0.0}, 0.1), 0.0);
}

// 0.5 m forwards, a turn of 0.5 rad, and 0.5 m backwards: the last part counts once the robot is within `near` of where
// that begins.
TEST(Way, IsFollowedToWhereItTurnsBack) {
  const Way way = way_of({{{0.0, 0.0, 0.0}, 2.5},
                          {{0.5, 0.0, 0.0}, 1.5},
                          {{0.5, 0.0, 0.5}, 1.0},
                          {{0.5 - 0.5 * std::cos(0.5), -0.5 * std::sin(0.5), 0.5}, 0.0}});
  EXPECT_EQ(way.end_of_parts({0.3, 0.0, 0.0}, 0, 10.0, 0.02), 2U);  // forwards, and the turn
  EXPECT_EQ(way.end_of_parts({0.5, 0.0, 0.4}, 0, 10.0, 0.02), 2U);  // 0.1 rad are 0.04 m
  EXPECT_EQ(way.end_of_parts({0.5, 0.0, 0.46}, 0, 10.0, 0.02), 3U);
  EXPECT_EQ(way.end_of_parts({0.5, 0.03, 0.5}, 0, 10.0, 0.02), 2U);
  EXPECT_EQ(way.end_of_parts({0.5, 0.03, 0.5}, 0, 10.0, 0.04), 3U);
  EXPECT_EQ(way.end_of_parts({0.5, 0.03, 0.5}, 1, 10.0, 0.02), 2U);  // it turns already
  EXPECT_EQ(way.end_of_parts({0.3, 0.0, 0.0}, 2, 10.0, 0.02), 3U);   // it is on the last one already
}

// With 1 s left at each pose: what is smoothed does not count on that.
Way along(const std::vector<Pose2>& poses) {
  Way way;
  for (const Pose2& pose : poses) way.add({pose, 1.0});
  return way;
}

// Headings that alternate by 0.1 rad come to their mean, and a station beside the line halfway to it.
TEST(Way, SmoothsWhereItGoesOn) {
  Way way = along({{0.0, 0.0, 3.1}, {-0.1, 0.0, -3.1}, {-0.2, 0.02, 3.1}, {-0.3, 0.0, -3.1}});
  Way stays = way;
  stays.smooth([](const Pose2&, const Pose2&) { return false; });
  way.smooth([](const Pose2& from, const Pose2& to) { return distance(from, to) < 0.011; });
  const double mean = M_PI;  // of 3.1 and -3.1 = 3.1832: their neighbours have the other one
  for (const std::size_t k : {1U, 2U}) EXPECT_NEAR(wrap_angle(way.stations()[k].pose.theta - mean), 0.0, 1e-12) << k;
  EXPECT_NEAR(way.stations()[1].pose.y, 0.25 * 0.02, 1e-12);
  EXPECT_NEAR(way.stations()[2].pose.y, 0.5 * 0.02, 1e-12);
  for (const std::size_t k : {0U, 1U, 2U, 3U}) {
    EXPECT_NEAR(way.stations()[k].pose.x, -0.1 * static_cast<double>(k), 1e-12);
    EXPECT_EQ(way.stations()[k].left, 1.0);
    EXPECT_EQ(stays.stations()[k].pose.y, k == 2 ? 0.02 : 0.0);
  }
  EXPECT_EQ(way.stations()[0].pose.theta, 3.1);
  EXPECT_EQ(way.stations()[3].pose.theta, -3.1);
}

// 0.1 m and 0.1 m forwards, a turn, and as far backwards twice: only what is halfway forwards or backwards moves.
TEST(Way, SmoothsNoTurn) {
  Way way =
      along({{0.0, 0.0, 0.0}, {0.1, 0.01, 0.0}, {0.2, 0.0, 0.0}, {0.2, 0.0, 0.1}, {0.1, 0.01, 0.1}, {0.0, 0.0, 0.1}});
  const Way before = way;
  way.smooth([](const Pose2&, const Pose2&) { return true; });
  for (const std::size_t k : {0U, 1U, 2U, 3U, 4U, 5U}) {
    const bool moves = k == 1 || k == 4;
    EXPECT_NEAR(distance(way.stations()[k].pose, before.stations()[k].pose), moves ? 0.005 : 0.0, 1e-12) << k;
  }
}

// Arcs of 0.4 rad. Beside the ends, which stay, none moves, nor beside one that stays: the way would leave its start in
// another direction than the robot faces. Where the arcs are of 0.2 rad all may move.
TEST(Way, SmoothsNothingBesideAStationThatStaysInABend) {
  for (const double turn : {0.2, 0.4}) {
    std::vector<Pose2> arc;
    for (int k = 0; k < 6; ++k) {
      arc.push_back({0.4 * std::sin(turn * k), 0.4 * (1.0 - std::cos(turn * k)), turn * k});
    }
    Way way = along(arc);
    const Way before = way;
    way.smooth([](const Pose2&, const Pose2&) { return true; });
    // A quarter of the second difference of a circle's points: 0.25 * 2 * 0.4 * (1 - cos 0.2).
    const double moved = turn < 0.3 ? 0.5 * 0.4 * (1.0 - std::cos(turn)) : 0.0;
    for (std::size_t k = 1; k < 5; ++k) {
      EXPECT_NEAR(distance(way.stations()[k].pose, before.stations()[k].pose), moved, 1e-12) << turn << ' ' << k;
    }
  }
}

// Straight on, a bend of 0.4 rad between two stations that move, straight on.
TEST(Way, SmoothsABendAmongStationsThatMove) {
  Way way = along(
      {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.3, 0.02, 0.4}, {0.39, 0.059, 0.4}, {0.48, 0.098, 0.4}});
  way.smooth([](const Pose2&, const Pose2&) { return true; });
  EXPECT_NEAR(way.stations()[1].pose.theta, 0.0, 1e-12);
  EXPECT_NEAR(way.stations()[2].pose.theta, 0.25 * 0.4, 1e-12);
  EXPECT_NEAR(way.stations()[2].pose.y, 0.25 * 0.02, 1e-12);
  EXPECT_NEAR(way.stations()[3].pose.theta, 0.75 * 0.4, 1e-12);
  EXPECT_NEAR(way.stations()[4].pose.theta, 0.4, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
