// SPDX-License-Identifier: BSD-3-Clause
// Whole cycles against the naive twin: every candidate's rejection, every critic's score, the choice and its command;
// 10,000 scenes in the long form. All candidates are checked here. That the choice is the same where they are not:
// check_all_test.
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/naive_planner.hpp"
#include "support/random_scene.hpp"
#include "support/renewed_planner.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveCandidate;
using test::NaiveCycle;
using test::NaivePlanner;
using test::Random;
using test::Scene;

struct Tally {
  int compared = 0, in_collision = 0, doubtful = 0, tied = 0, braked = 0, lagging = 0, told_apart = 0;
  int odometry_doubted = 0, ways = 0;
  std::map<std::string, int> rejections;
};

void compare_candidates(const Scene& scene, const NaivePlanner& naive, const Planner& planner, Tally& tally) {
  const std::vector<CandidateReport> records = planner.candidates();
  ASSERT_EQ(records.size(), naive.candidates().size());
  for (std::size_t c = 0; c < records.size(); ++c) {
    const CandidateReport& core = records[c];
    const NaiveCandidate& twin = naive.candidates()[c];
    ASSERT_NEAR(core.sample.v, twin.u.v, 1e-9) << "candidate " << c;
    ASSERT_NEAR(core.sample.omega, twin.u.omega, 1e-9) << "candidate " << c;
    ASSERT_EQ(core.legal() ? "" : core.rejections.front().name, twin.rejected_by)
        << "candidate " << c << " " << twin.u.v << " " << twin.u.omega;
    ASSERT_EQ(core.poses.size(), twin.poses.size());
    ASSERT_NEAR(core.poses.back().x, twin.poses.back().x, 1e-9);
    ASSERT_NEAR(core.poses.back().y, twin.poses.back().y, 1e-9);
    ASSERT_NEAR(core.poses.back().theta, twin.poses.back().theta, 1e-9);
    if (!twin.rejected_by.empty()) {
      ++tally.rejections[twin.rejected_by];
      continue;
    }
    const std::vector<std::string> critics = split_names(scene.parameters.critics);
    for (std::size_t i = 0; i < critics.size(); ++i) {
      ASSERT_EQ(core.terms[i].name, critics[i]);
      ASSERT_NEAR(core.terms[i].raw, twin.raw[i], 1e-9) << critics[i] << " of candidate " << c;
    }
    ASSERT_NEAR(core.total, twin.total, 1e-9) << "candidate " << c;
  }
}

void compare_choice(const NaivePlanner& naive, const Decision& decision, Tally& tally) {
  const bool chosen = decision.outcome == Outcome::drive || decision.outcome == Outcome::hold;
  ASSERT_EQ(chosen, naive.best() != nullptr);
  if (!chosen) {
    ++tally.braked;
    return;
  }
  ASSERT_NEAR(decision.total, naive.best()->total, 1e-9);
  if (!naive.gets_out() && naive.runner_up() < naive.best()->total + 1e-6) {
    ++tally.tied;
    return;
  }
  ASSERT_NEAR(decision.sample.v, naive.best()->u.v, 1e-9);
  ASSERT_NEAR(decision.sample.omega, naive.best()->u.omega, 1e-9);
  ASSERT_NEAR(decision.command.v, naive.command().v, 1e-9);
  ASSERT_NEAR(decision.command.omega, naive.command().omega, 1e-9);
}

void compare_start(const test::NaiveReference& twin, const Decision& decision, Tally& tally) {
  EXPECT_NEAR(decision.reference.v, twin.reference().v, 1e-9);
  EXPECT_NEAR(decision.reference.omega, twin.reference().omega, 1e-9);
  EXPECT_TRUE(decision.velocity == twin.believed());
  EXPECT_EQ(decision.odometry_doubted, twin.doubted());
  EXPECT_EQ(decision.odometry_fast, twin.fast());
  tally.odometry_doubted += decision.odometry_doubted;
  tally.ways += static_cast<int>(twin.ways().size());
}

void stop(Planner& planner, const Scene& scene, const std::vector<NaiveCycle>& cycles) {
  OperatorIntent stopped;
  stopped.influence = Influence::stop;
  for (const NaiveCycle& cycle : cycles) {
    Situation situation = scene.situation;
    situation.time = cycle.time;
    situation.last_command = cycle.last_command;
    situation.velocity = cycle.measured;
    planner.plan(situation, scene.grid(), stopped);
  }
}

// Without the former commands something else would have been rejected.
bool former_commands_count(const Scene& scene, const NaivePlanner& with) {
  Scene steady = scene;
  steady.situation.velocity = scene.situation.last_command;
  const NaivePlanner without(steady);
  for (std::size_t c = 0; c < with.candidates().size(); ++c) {
    if (with.candidates()[c].rejected_by != without.candidates()[c].rejected_by) return true;
  }
  return false;
}

void compare(const Scene& scene, const std::vector<NaiveCycle>& former, Tally& tally) {
  const NaivePlanner naive(scene, former);
  tally.in_collision += naive.stands_in_collision();
  if (naive.stands_in_collision() && scene.parameters.method == Method::paper) return;
  if (naive.doubtful()) {
    ++tally.doubtful;
    return;
  }
  static test::RenewedPlanner renewed;
  Planner& planner = renewed(scene);
  stop(planner, scene, former);
  Sampling sampling;
  sampling.report = Report::legality;
  const Decision& decision = planner.plan(scene.situation, scene.grid(), scene.intent, sampling);
  ++tally.compared;
  compare_start(naive.reference(), decision, tally);
  const double lag = std::abs(scene.situation.velocity.v - decision.reference.v);
  const bool goes_on = decision.reference == scene.situation.last_command;
  tally.lagging += goes_on && lag > 0.2;
  tally.told_apart += !former.empty() && goes_on && former_commands_count(scene, naive);
  if (naive.gives_up()) {
    ASSERT_NE(decision.outcome, Outcome::drive);
    return;
  }
  compare_candidates(scene, naive, planner, tally);
  compare_choice(naive, decision, tally);
}

using FormerCycles = std::function<std::vector<NaiveCycle>(Scene&)>;

void compare_all(int scenes, std::uint64_t first_seed, const std::function<void(Scene&)>& adjust, Tally& tally,
                 const FormerCycles& former = {}) {
  for (int k = 0; k < scenes; ++k) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(k);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = test::random_scene(seed);
    if (seed % 4 == 0) test::arrive(scene);
    adjust(scene);
    const std::vector<NaiveCycle> before = former ? former(scene) : std::vector<NaiveCycle>{};
    compare(scene, before, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
  std::printf("%d compared, %d in collision, %d doubtful, %d tied, %d braked; rejections:", tally.compared,
              tally.in_collision, tally.doubtful, tally.tied, tally.braked);
  for (const auto& [name, count] : tally.rejections) std::printf(" %s %d", name.c_str(), count);
  std::printf("\n");
}

// The default profile; the robot, its outline and the scene are random.
TEST(PlannerTwin, DefaultProfile) {
  Tally tally;
  const int scenes = test::effort(1100, 5000);
  compare_all(
      scenes, 1000000, [](Scene& scene) { test::take_default_profile(scene.parameters); }, tally);
  EXPECT_GE(tally.compared, scenes * 10 / 11);
  EXPECT_LE(tally.doubtful, scenes / 200);
  for (const char* name : {"Collision", "Braking", "BaseObstacle", "RotateToGoal"}) {
    EXPECT_GT(tally.rejections[name], 20) << name;
  }
}

// Everything random: both generators, both integrations, both distances, all ten critics, wheels, dead bands,
// reverse.
TEST(PlannerTwin, RandomParameters) {
  Tally tally;
  const int scenes = test::effort(600, 5000);
  compare_all(
      scenes, 2000000, [](Scene& /*scene*/) {}, tally);
  EXPECT_GE(tally.compared, scenes * 5 / 6);
  EXPECT_LE(tally.doubtful, scenes / 120);
  for (const char* name : {"Collision", "Braking", "BaseObstacle", "RotateToGoal"}) {
    EXPECT_GT(tally.rejections[name], 5) << name;
  }
  EXPECT_GT(tally.odometry_doubted, 20);
  EXPECT_GT(tally.ways, tally.compared + 100);
}

// Late cycles, and poses that are old.
TEST(PlannerTwin, LateCyclesAndOldPoses) {
  Tally tally;
  Random random(4);
  compare_all(
      500, 4000000,
      [&random](Scene& scene) {
        Situation& s = scene.situation;
        if (random.chance(0.7)) s.longest_period = random.uniform(0.9, 2.0) * s.period;
        if (random.chance(0.7)) s.pose_age = random.uniform(0.0, 0.15);
      },
      tally);
  EXPECT_GE(tally.compared, 350);
  EXPECT_LE(tally.doubtful, 5);
  EXPECT_GT(tally.rejections["Braking"], 50);
}

// Robots with one sensor or two that drive backwards, too.
TEST(PlannerTwin, WhereNobodySees) {
  Tally tally;
  Random random(48);
  compare_all(
      500, 5000000, [&random](Scene& scene) { test::add_sectors(random, scene); }, tally);
  EXPECT_GE(tally.compared, 400);
  EXPECT_LE(tally.doubtful, 5);
  EXPECT_GT(tally.rejections["Blind"], 500);
}

// Random robots in all states of motion with some cells under their outline, as a new scan may have put them there.
TEST(PlannerTwin, InCollision) {
  Tally tally;
  Random random(4);
  const auto put_cells_under = [&random](Scene& scene) {
    scene.parameters.method = Method::hidwa;
    const Pose2& at = scene.situation.pose;
    const double outer = test::naive_outer_radius({scene.outline, 0.0});
    const int cells = random.integer(1, 3);
    for (int k = 0; k < cells; ++k) {
      const double angle = random.uniform(-M_PI, M_PI), r = random.uniform(0.5, 1.0) * outer;
      scene.at(scene.grid().cell_at(at.x + r * std::cos(angle), at.y + r * std::sin(angle))) = cost::kLethal;
    }
    if (random.chance(0.5)) scene.situation.velocity = scene.situation.last_command = {};
    if (random.chance(0.5)) scene.intent = {};
  };
  compare_all(300, 4000000, put_cells_under, tally);
  EXPECT_GE(tally.compared, 280);
  EXPECT_GE(tally.in_collision, 200);
  EXPECT_LE(tally.doubtful, 10);
  EXPECT_GE(tally.compared - tally.braked, 60);
}

// The robot's command has changed as fast as it may, and odometry shows one of the last.
TEST(PlannerTwin, OdometryLagsBehindTheCommand) {
  Tally tally;
  Random random(3);
  const auto former = [&random](Scene& scene) {
    Situation& s = scene.situation;
    std::vector<NaiveCycle> cycles(6, test::naive_cycle(s));
    Twist2 u = s.last_command;
    const double share = random.pick({-1.0, 1.0});
    for (std::size_t back = 1; back <= cycles.size(); ++back) {
      NaiveCycle& cycle = cycles[cycles.size() - back];
      u.v += share * scene.parameters.acc_lim_x * s.period;
      u.omega += random.uniform(-1.0, 1.0) * scene.parameters.acc_lim_theta * s.period;
      cycle.last_command = cycle.measured = u;
      cycle.time -= static_cast<double>(back) * s.period;
    }
    s.velocity = cycles[static_cast<std::size_t>(random.integer(0, 5))].last_command;
    return cycles;
  };
  compare_all(
      300, 3000000, [](Scene& scene) { scene.parameters.method = Method::hidwa; }, tally, former);
  EXPECT_GE(tally.compared, 250);
  EXPECT_LE(tally.doubtful, 5);
  EXPECT_GE(tally.lagging, 50);
  EXPECT_LE(tally.lagging, 220);
  EXPECT_GE(tally.told_apart, 5);
}

}  // namespace
}  // namespace hidwa_local_planner
