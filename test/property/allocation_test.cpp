// SPDX-License-Identifier: BSD-3-Clause
// A cycle allocates nothing once it has seen situations like it: 10,000 of them, in whatever order they come.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/allocation_counter.hpp"
#include "support/planner_bench.hpp"
#include "support/random_scene.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner {
namespace {

using test::AllocationCounter;
using test::Random;
using test::Scene;

constexpr std::uint64_t kScenes = 250;  // of each case
constexpr int kRounds = 10;             // over them all; there are four cases

enum class Body { circle, polygon };

struct Case {
  Method method;
  Body body;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << (c.method == Method::hidwa ? "hidwa" : "paper") << ", " << (c.body == Body::circle ? "circle" : "polygon");
}

Polygon outline_of(Body body) {
  if (body == Body::polygon) return {{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};
  return test::round_outline(0.2);
}

// Default parameters with fewer samples. Some robots stand in collision, for the outline is not the scene's
// own; some cannot stop any more; some have reached their goal; some have no plan; one person in ten steers
// alone, half of them without a goal, one in twenty stops the robot.
Scene make_scene(std::uint64_t seed, const Case& c) {
  Scene scene = test::random_scene(seed);
  scene.parameters = Parameters();
  scene.parameters.vx_samples = 8;
  scene.parameters.vth_samples = 12;
  scene.parameters.method = c.method;
  scene.outline = outline_of(c.body);
  Random random(seed + 1000000);
  if (random.chance(0.2)) scene.situation.velocity = scene.situation.last_command = {};
  if (random.chance(0.1)) scene.situation.plan.clear();
  if (random.chance(0.1)) scene.situation.goal_latched = true;
  if (random.chance(0.1)) scene.intent.influence = Influence::direct;
  if (scene.intent.influence == Influence::direct) scene.intent.guarded = random.chance(0.7);
  if (random.chance(0.05)) scene.intent.influence = Influence::stop;
  if (scene.intent.influence == Influence::direct && scene.intent.guarded && random.chance(0.5)) {
    scene.situation.goalless = true;
    scene.situation.plan.clear();
    scene.situation.goal = scene.situation.pose;
  }
  return scene;
}

struct Seen {
  std::uint64_t driven = 0, braked = 0, failed = 0, steered = 0, autonomous = 0, rejecting = 0, escaping = 0;
};

class Allocations : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    for (std::uint64_t seed = 0; seed < kScenes; ++seed) scenes_.push_back(make_scene(seed, GetParam()));
    ASSERT_TRUE(planner_.configure(scenes_.front().parameters).empty());
    planner_.set_footprint(scenes_.front().outline);
  }
  void note(const Scene& scene, const Decision& decision) {
    seen_.driven += decision.outcome == Outcome::drive;
    seen_.braked += decision.outcome == Outcome::brake;
    seen_.failed += decision.outcome == Outcome::fail;
    seen_.steered += scene.intent.influence != Influence::none;
    seen_.autonomous += scene.intent.influence == Influence::none;
    seen_.rejecting += decision.legal < decision.candidates;
    seen_.escaping += decision.escaping;
  }
  /// One round over all scenes allocates nothing after two more: in the second one it remembers the first. In how many
  /// scenes it rejects a candidate by this name.
  std::uint64_t rejecting_in_a_quiet_round(const std::string& name) {
    for (int round = 0; round < 2; ++round) {
      for (const Scene& scene : scenes_) planner_.plan(scene.situation, scene.grid(), scene.intent);
    }
    std::uint64_t rejecting = 0;
    for (const Scene& scene : scenes_) {
      const AllocationCounter counter;
      const Decision& decision = planner_.plan(scene.situation, scene.grid(), scene.intent);
      EXPECT_EQ(counter.count(), 0U) << scene.situation.time;
      rejecting += test::rejections_by(decision, name) > 0;
    }
    return rejecting;
  }

  std::vector<Scene> scenes_;
  Planner planner_{critics::built_in()};
  Seen seen_;
};

TEST_P(Allocations, NoneAfterTheFirstRound) {
  // The first rounds see the largest map, and a search on it: what that remembers of the scene before decides.
  for (int round = -2; round < kRounds; ++round) {
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
      // Another order every time: 7 and 250 have no common divisor.
      const Scene& scene = scenes_[round % 2 == 0 ? k : (7 * k + static_cast<std::size_t>(round + 2)) % scenes_.size()];
      const AllocationCounter counter;
      const Decision& decision = planner_.plan(scene.situation, scene.grid(), scene.intent);
      if (round < 0) continue;
      ASSERT_EQ(counter.count(), 0U) << "round " << round << ", call " << k;
      note(scene, decision);
    }
  }
  std::printf("%llu driven, %llu braked, %llu failed, %llu steered, %llu rejecting, %llu escaping\n",
              static_cast<unsigned long long>(seen_.driven), static_cast<unsigned long long>(seen_.braked),
              static_cast<unsigned long long>(seen_.failed), static_cast<unsigned long long>(seen_.steered),
              static_cast<unsigned long long>(seen_.rejecting), static_cast<unsigned long long>(seen_.escaping));
  const auto often = {seen_.driven, seen_.steered, seen_.autonomous, seen_.rejecting};
  const auto seldom = {seen_.braked, seen_.failed};
  for (const std::uint64_t count : often) EXPECT_GT(count, 250U);
  for (const std::uint64_t count : seldom) EXPECT_GT(count, 20U);
  EXPECT_EQ(seen_.escaping > 20U, GetParam().method == Method::hidwa) << seen_.escaping;  // the paper's method does not
}

// Five movers around the robot, whose points explain cells. As many in each scene: more need more memory once.
TEST_P(Allocations, NoneAmongMovers) {
  Random random(17);
  for (Scene& scene : scenes_) {
    for (std::uint32_t id = 0; id < 5; ++id) {
      const double angle = random.uniform(-M_PI, M_PI), away = random.uniform(0.6, 2.0);
      MovingObstacleEstimate mover;
      mover.id = id;
      mover.position =
          Point(scene.situation.pose.x, scene.situation.pose.y) + away * Point(std::cos(angle), std::sin(angle));
      mover.velocity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      mover.radius = 0.3;
      mover.position_deviation = 0.02;
      for (int k = 0; k < 8; ++k) mover.points.push_back(mover.position + 0.2 * Point(std::cos(k), std::sin(k)));
      scene.situation.moving_obstacles.push_back(mover);
    }
  }
  EXPECT_GT(rejecting_in_a_quiet_round("Moving obstacle"), 20U);
}

// A sensor in the middle that sees all round, and one at the front; somebody may step out of every shadow.
TEST_P(Allocations, NoneAtCorners) {
  for (const Occlusion occlusion : {Occlusion::cost, Occlusion::bound}) {
    Parameters parameters = scenes_.front().parameters;
    parameters.occlusion = occlusion;
    ASSERT_TRUE(planner_.configure(parameters).empty());
    for (Scene& scene : scenes_) {
      scene.situation.sensor_sectors = {{{0.0, 0.0, 0.0}, 7.0, 8.0}, {{0.2, 0.0, 0.0}, 3.0, 8.0}};
    }
    const std::uint64_t rejecting = rejecting_in_a_quiet_round("Occlusion");
    EXPECT_EQ(rejecting > 20U, occlusion == Occlusion::bound) << rejecting;
  }
}

INSTANTIATE_TEST_SUITE_P(MethodsAndBodies, Allocations,
                         ::testing::Values(Case{Method::hidwa, Body::circle}, Case{Method::hidwa, Body::polygon},
                                           Case{Method::paper, Body::circle}, Case{Method::paper, Body::polygon}));

struct alignas(64) Wide {
  double values[8] = {};
};

// Where nothing were counted, nothing would ever be found.
TEST(AllocationCounter, SeesEveryKindOfAllocation) {
  const AllocationCounter counter;
  EXPECT_EQ(counter.count(), 0U);
  std::vector<int> grown(1);
  EXPECT_EQ(counter.count(), 1U);
  grown.resize(grown.capacity() + 1);
  EXPECT_EQ(counter.count(), 2U);
  const std::vector<Wide> aligned(3);
  EXPECT_EQ(counter.count(), 3U);
  const std::unique_ptr<int[]> array(new int[grown.size() + aligned.size()]());
  int* volatile const seen = array.get();  // what nobody sees a compiler may leave out
  EXPECT_NE(seen, nullptr);
  EXPECT_EQ(counter.count(), 4U);
}

TEST(AllocationCounter, SeesTheLibrarysAllocations) {
  Scene scene = make_scene(1, {Method::hidwa, Body::polygon});
  Planner fresh(critics::built_in());
  ASSERT_TRUE(fresh.configure(scene.parameters).empty());
  fresh.set_footprint(scene.outline);
  const AllocationCounter counter;
  fresh.plan(scene.situation, scene.grid(), scene.intent);
  EXPECT_GT(counter.count(), 0U);
}

TEST(AllocationCounter, SeesOtherThreadsAndTellsThemApart) {
  const std::size_t own_before = test::allocations_of_this_thread();
  std::size_t of_the_other = 0, all = 0;
  std::thread other([&] {
    const AllocationCounter counter;
    const std::size_t before = test::allocations_of_this_thread();
    std::vector<int> memory(1000);
    memory.clear();
    of_the_other = test::allocations_of_this_thread() - before;
    all = counter.count();
  });
  const std::size_t own = test::allocations_of_this_thread() - own_before;  // starting the thread
  other.join();
  EXPECT_EQ(of_the_other, 1U);
  EXPECT_GE(all, of_the_other);
  EXPECT_EQ(test::allocations_of_this_thread() - own_before, own);
}

}  // namespace
}  // namespace hidwa_local_planner
