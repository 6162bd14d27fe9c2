// SPDX-License-Identifier: BSD-3-Clause
// By hand; test/oracle/oscillation_twin_test.cpp compares Oscillation on random histories.
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticBench;
using test::Scene;

// Resets after 0.05 m or 0.2 rad, never by time; turning counts at 0.05 m/s or slower.
class OscillationTest : public ::testing::Test {
 protected:
  OscillationTest() : bench_("Oscillation", Scene::empty()) {}
  void command(const Twist2& u) {
    bench_.prepare();
    bench_.debrief(u);
  }
  bool legal(const Twist2& u) {
    bench_.prepare();
    return !bench_.score(u, {{}, {}}).rejected();
  }
  Situation& situation() { return bench_.scene().situation; }
  CriticBench bench_;
};

TEST_F(OscillationTest, AfterAChangeOnlyTheNewDirection) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
  EXPECT_FALSE(legal({0.3, 0.1}));
  EXPECT_TRUE(legal({0.0, -0.5}));
  EXPECT_TRUE(legal({0.3, 0.0}));
  EXPECT_TRUE(legal({0.0, 0.0}));
  EXPECT_EQ(bench_.score({0.0, -0.5}, {{}, {}}).raw, 0.0);
}

TEST_F(OscillationTest, TurningWhileDrivingDoesNotCount) {
  command({0.06, 0.5});
  command({0.06, -0.5});
  EXPECT_TRUE(legal({0.0, 0.5}));
  command({0.05, 0.5});
  command({0.05, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
}

TEST_F(OscillationTest, TurningEndsTheBanAndAnglesWrap) {
  situation().pose.theta = 3.1;
  command({0.0, 0.5});
  command({0.0, -0.5});
  situation().pose.theta = -3.1;  // 2 pi - 6.2 = 0.083 rad away
  command({0.0, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
  situation().pose.theta = -2.9;  // 0.283 rad
  command({0.0, -0.5});
  EXPECT_TRUE(legal({0.0, 0.5}));
}

TEST_F(OscillationTest, ANewGoalForgets) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  bench_.critic().reset();
  EXPECT_TRUE(legal({0.0, 0.5}));
  command({0.0, 0.5});  // not a change: the old sign is forgotten too
  EXPECT_TRUE(legal({0.0, -0.5}));
}

struct Silence {
  const char* when;
  Method method;
  Influence influence;
  bool goal_latched, rejects;
};

// It keeps count all the same.
TEST(OscillationPerson, WhileAPersonSteersOnlyThePapersMethodRejects) {
  const Silence cases[] = {
      {"a person steers", Method::hidwa, Influence::shared, false, false},
      {"a person steers in the paper's method", Method::paper, Influence::shared, false, true},
      {"a person steers at the goal", Method::paper, Influence::shared, true, false},
      {"a person decides", Method::paper, Influence::direct, false, false},
  };
  for (const Silence& c : cases) {
    Scene scene = Scene::empty();
    scene.parameters.method = c.method;
    scene.intent.influence = c.influence;
    scene.situation.goal_latched = c.goal_latched;
    CriticBench bench("Oscillation", scene);
    bench.prepare();
    bench.debrief({0.0, 0.5});
    bench.debrief({0.0, -0.5});
    EXPECT_EQ(bench.score({0.0, 0.5}, {{}, {}}).rejected(), c.rejects) << c.when;
    bench.scene().intent = OperatorIntent();
    bench.prepare();
    EXPECT_TRUE(bench.score({0.0, 0.5}, {{}, {}}).rejected()) << c.when << ", and lets go";
  }
}

}  // namespace
}  // namespace hidwa_local_planner
