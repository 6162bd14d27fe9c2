// SPDX-License-Identifier: BSD-3-Clause
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

TEST_F(OscillationTest, FreeUntilTheFirstChangeOfSign) {
  EXPECT_TRUE(legal({0.0, 0.5}));
  command({0.0, 0.5});
  EXPECT_TRUE(legal({0.0, -0.5}));
  EXPECT_TRUE(legal({-0.1, 0.0}));
}

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

TEST_F(OscillationTest, DrivingBackAndForthToo) {
  command({0.3, 0.0});
  command({0.0, 0.0});  // a stop in between does not help
  command({-0.1, 0.0});
  EXPECT_FALSE(legal({0.1, 0.0}));
  EXPECT_TRUE(legal({-0.1, 0.0}));
  EXPECT_TRUE(legal({0.0, 0.4}));
}

TEST_F(OscillationTest, TurningWhileDrivingDoesNotCount) {
  command({0.06, 0.5});
  command({0.06, -0.5});
  EXPECT_TRUE(legal({0.0, 0.5}));
  command({0.05, 0.5});
  command({0.05, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
}

TEST_F(OscillationTest, MovingEndsTheBan) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  situation().pose.x = 0.05;  // not more than the distance
  command({0.0, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
  situation().pose.x = 0.051;
  command({0.0, -0.5});
  EXPECT_TRUE(legal({0.0, 0.5}));
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

TEST_F(OscillationTest, TimeAloneEndsNoBan) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  situation().time = 1e6;
  command({0.0, -0.5});
  EXPECT_FALSE(legal({0.0, 0.5}));
}

TEST_F(OscillationTest, ANewGoalForgets) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  bench_.critic().reset();
  EXPECT_TRUE(legal({0.0, 0.5}));
  command({0.0, 0.5});  // not a change: the old sign is forgotten too
  EXPECT_TRUE(legal({0.0, -0.5}));
}

TEST_F(OscillationTest, SilentWhileThePersonSteersButItKeepsCount) {
  command({0.0, 0.5});
  command({0.0, -0.5});
  bench_.scene().steer({0.5, 1.0});
  EXPECT_TRUE(legal({0.0, 0.5}));
  bench_.scene().intent = OperatorIntent();
  EXPECT_FALSE(legal({0.0, 0.5}));

  Scene scene = Scene::empty();
  scene.parameters.method = Method::paper;
  scene.steer({0.5, 1.0});
  CriticBench strict("Oscillation", scene);
  strict.prepare();
  strict.debrief({0.0, 0.5});
  strict.debrief({0.0, -0.5});
  EXPECT_TRUE(strict.score({0.0, 0.5}, {{}, {}}).rejected());
}

TEST(OscillationPerson, WhereThePersonDecidesNoMethodMakesItReject) {
  for (const Influence influence : {Influence::direct, Influence::shared}) {
    Scene scene = Scene::empty();
    scene.parameters.method = Method::paper;
    scene.steer({0.5, 1.0});
    scene.intent.influence = influence;
    scene.situation.goal_latched = influence == Influence::shared;
    CriticBench bench("Oscillation", scene);
    bench.prepare();
    bench.debrief({0.0, 0.5});
    bench.debrief({0.0, -0.5});
    EXPECT_FALSE(bench.score({0.0, 0.5}, {{}, {}}).rejected());
  }
}

}  // namespace
}  // namespace hidwa_local_planner
