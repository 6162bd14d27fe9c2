// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <move_base/planning_thread.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace move_base {
namespace {

typedef PlanningThread::Plan Plan;

class PlanningThreadTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { ros::Time::init(); }

  // Plans hold one pose, the goal; `possible_` says whether there are any.
  PlanningThread::MakePlan planner() {
    return [this](const geometry_msgs::PoseStamped& goal, Plan& plan) {
      ++calls_;
      if (!possible_) return false;
      plan.assign(1, goal);
      return true;
    };
  }

  template <typename Condition>
  static bool becomes(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);  // a slow machine takes long
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }

  static geometry_msgs::PoseStamped goalAt(double x) {
    geometry_msgs::PoseStamped goal;
    goal.pose.position.x = x;
    return goal;
  }

  std::atomic<int> calls_{0};
  std::atomic<bool> possible_{true};
};

TEST_F(PlanningThreadTest, OnePlanForAGoalWithoutAFrequency) {
  PlanningThread thread(planner(), {});
  Plan plan;
  EXPECT_FALSE(thread.takePlan(plan));
  thread.begin(goalAt(3.0));
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
  EXPECT_EQ(plan.at(0).pose.position.x, 3.0);
  EXPECT_FALSE(thread.takePlan(plan));
  EXPECT_EQ(calls_, 1);
  thread.replan();
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
  EXPECT_EQ(calls_, 2);
}

TEST_F(PlanningThreadTest, PlansAgainAtItsFrequencyUntilHalted) {
  PlanningThread::Settings settings;
  settings.frequency = 50.0;
  PlanningThread thread(planner(), settings);
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return calls_ >= 4; }));
  thread.halt();
  Plan plan;
  EXPECT_FALSE(thread.takePlan(plan));
  EXPECT_FALSE(thread.gaveUp());
}

TEST_F(PlanningThreadTest, AReplanDoesNotWaitForThePeriod) {
  PlanningThread::Settings settings;
  settings.frequency = 0.001;
  PlanningThread thread(planner(), settings);
  Plan plan;
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
  thread.replan();
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
}

TEST_F(PlanningThreadTest, GivesUpAfterItsRetries) {
  possible_ = false;
  PlanningThread::Settings settings;
  settings.patience = 1e6;
  settings.max_retries = 3;
  PlanningThread thread(planner(), settings);
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return thread.gaveUp(); }));
  EXPECT_EQ(calls_, 4);  // the first and three more
  possible_ = true;
  thread.begin(goalAt(2.0));  // a new goal starts afresh
  EXPECT_FALSE(thread.gaveUp());
  Plan plan;
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
}

TEST_F(PlanningThreadTest, GivesUpAfterItsPatience) {
  possible_ = false;
  PlanningThread::Settings settings;
  settings.patience = 0.05;
  PlanningThread thread(planner(), settings);
  const ros::Time begun = ros::Time::now();
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return thread.gaveUp(); }));
  EXPECT_GE((ros::Time::now() - begun).toSec(), 0.05);
}

TEST_F(PlanningThreadTest, WhileDrivingAFailedReplanIsNoReasonToGiveUp) {
  PlanningThread::Settings settings;
  settings.frequency = 200.0;
  settings.patience = 0.0;
  PlanningThread thread(planner(), settings);
  Plan plan;
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
  possible_ = false;
  const int before = calls_;
  ASSERT_TRUE(becomes([&] { return calls_ >= before + 5; }));
  EXPECT_FALSE(thread.gaveUp());
}

TEST_F(PlanningThreadTest, APlanForAnOlderGoalIsDropped) {
  std::atomic<bool> inside{false}, go_on{false};
  PlanningThread thread(
      [&](const geometry_msgs::PoseStamped& goal, Plan& plan) {
        plan.assign(1, goal);
        if (goal.pose.position.x == 1.0) {
          inside = true;
          while (!go_on) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
      },
      {});
  thread.begin(goalAt(1.0));
  ASSERT_TRUE(becomes([&] { return inside.load(); }));
  thread.begin(goalAt(2.0));
  go_on = true;
  Plan plan;
  ASSERT_TRUE(becomes([&] { return thread.takePlan(plan); }));
  EXPECT_EQ(plan.at(0).pose.position.x, 2.0);
}

}  // namespace
}  // namespace move_base
