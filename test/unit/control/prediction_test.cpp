// SPDX-License-Identifier: BSD-3-Clause
// What those who watch are told of the next seconds.
#include "control/prediction.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/naive_prediction.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner::control {
namespace {

// A map of 8 m around a robot at its origin that is 0.4 m wide, and a decision as the test wants it.
class Predictions : public testing::Test {
 protected:
  Predictions() : loop_(critics::built_in()) {
    parameters_.vx_samples = parameters_.vth_samples = 3;
    configure();
    loop_.set_footprint({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
    seen_.timing.now = 1.0;
    seen_.velocity = Twist2{};
    seen_.costmap = {costs_.data(), 80, 80, 0.1, -4.0, -4.0};
  }
  void configure() { ASSERT_TRUE(loop_.configure(parameters_).empty()); }
  // Poses at 0.025 m, 0.075 m, ... ahead of the robot.
  void plan_to(double length, double heading = 0.0) {
    plan_.clear();
    for (double arc = 0.025; arc <= length + 1e-9; arc += 0.05) {
      plan_.push_back({arc * std::cos(heading), arc * std::sin(heading), heading});
    }
  }
  // One cycle, whose decision is then as `change` makes it.
  template <typename Change>
  const Prediction& predicted(Change change) {
    loop_.set_plan(plan_, "map", seen_.timing.now, 0.05);
    result_ = loop_.step(seen_, {});
    decision_ = *result_.decision;
    decision_.recovering = decision_.waiting = false;
    result_.decision = &decision_;
    result_.outcome = Outcome::drive;
    change(result_, decision_);
    prediction_.update(loop_, seen_, result_);
    return prediction_;
  }
  // One cycle and its decision as it is.
  const Prediction& predicted() {
    loop_.set_plan(plan_, "map", seen_.timing.now, 0.05);
    prediction_.update(loop_, seen_, loop_.step(seen_, {}));
    for (const TimedPose& said : prediction_.poses()) EXPECT_TRUE(is_finite(said.pose)) << said.time;
    return prediction_;
  }
  // The operator has just let go at a speed of `v`: the plan is followed from here on.
  const Prediction& driving(double v) {
    return predicted([v](Result& result, Decision& decision) {
      result.command = {v, 0.0};
      decision.trajectory.clear();
    });
  }
  std::vector<std::uint8_t> costs_ = std::vector<std::uint8_t>(6400, cost::kFree);
  Parameters parameters_;
  std::vector<Pose2> plan_;
  ControlLoop loop_;
  Observation seen_;
  Result result_;
  Decision decision_;
  Prediction prediction_;
};

// 3 s at 0.5 m/s.
TEST_F(Predictions, StraightOnAlongAPlanWhateverItsHeading) {
  for (const double heading : {0.0, 1.5, 3.1, -2.0}) {
    plan_to(3.5, heading);
    seen_.pose.theta = heading;
    EXPECT_EQ(driving(0.5).next(), NextMove::straight) << heading;
    EXPECT_EQ(prediction_.reason(), "");
    ASSERT_EQ(prediction_.poses().size(), 31u);
    const TimedPose& last = prediction_.poses().back();
    EXPECT_NEAR(last.time, 3.0, 1e-9);
    EXPECT_NEAR(last.pose.x, 1.5 * std::cos(heading), 1e-6);
    EXPECT_NEAR(last.pose.y, 1.5 * std::sin(heading), 1e-6);
    seen_.timing.now += 1.0;
  }
}

TEST_F(Predictions, RestsAtTheGoal) {
  plan_to(1.025);
  EXPECT_EQ(driving(0.5).next(), NextMove::stop);
  EXPECT_EQ(prediction_.reason(), "it comes to the goal");
  EXPECT_NEAR(prediction_.poses().back().pose.x, 1.025, 0.051);  // a pose of the plan more or less
  EXPECT_NEAR(prediction_.poses().back().pose.theta, 0.0, 1e-9);
}

// The obstacle reaches from 0.6 m to 0.7 m: the first pose of the plan in it is at 0.625 m. The robot's inscribed
// radius is 0.2 m.
TEST_F(Predictions, RestsBeforeAnObstacleOnThePlan) {
  plan_to(3.0);
  costs_[40 * 80 + 46] = costs_[39 * 80 + 46] = cost::kLethal;
  EXPECT_EQ(driving(0.5).next(), NextMove::stop);
  EXPECT_EQ(prediction_.reason(), "an obstacle is on the plan");
  EXPECT_NEAR(prediction_.poses().back().pose.x, 0.625, 0.05);
  EXPECT_NEAR(prediction_.poses().back().pose.theta, 0.0, 1e-9);
}

TEST_F(Predictions, AreAsASlowTwinSays) {
  test::Random random(20261123);
  int blocked = 0, latched = 0, turns = 0, own = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    std::fill(costs_.begin(), costs_.end(), cost::kFree);
    for (int k = random.integer(0, 20); k > 0; --k) {
      const Cell corner{random.integer(44, 74), random.integer(20, 60)};
      for (int d = 0; d < 4; ++d) {
        costs_[seen_.costmap.index({corner.i + d % 2, corner.j + d / 2})] = cost::kLethal;
      }
    }
    parameters_.max_vel_x = random.uniform(0.3, 1.0);
    parameters_.max_vel_theta = random.uniform(0.4, 1.5);
    parameters_.sim_time = random.pick({0.4, 1.7});
    configure();
    plan_.clear();
    Pose2 pose{random.uniform(-0.2, 0.0), random.uniform(-0.1, 0.1), random.uniform(-0.5, 0.5)};
    const double length = random.pick({0.1, 1.0, 3.5});
    for (double arc = 0.0; arc <= length; arc += 0.047) {  // no whole number of steps is a look-ahead
      plan_.push_back(pose);
      pose = {pose.x + 0.047 * std::cos(pose.theta), pose.y + 0.047 * std::sin(pose.theta),
              pose.theta + random.uniform(-0.12, 0.14)};
    }
    plan_.back().theta = random.uniform(-3.0, 3.0);
    seen_.pose = {0.0, random.uniform(-0.05, 0.05), random.uniform(-3.0, 3.0) * random.pick({0.1, 1.0})};
    seen_.timing.now += 5.0;
    predicted([&](Result& result, Decision& decision) {
      result.command = {random.uniform(0.0, parameters_.max_vel_x), random.uniform(-0.4, 0.4)};
      result.outcome = random.pick({Outcome::drive, Outcome::drive, Outcome::drive, Outcome::brake, Outcome::fail});
      if (random.chance(0.2)) result.intent.influence = Influence::shared;
      decision.recovering = random.chance(0.1);
      decision.waiting = random.chance(0.1);
      decision.sample = {random.uniform(0.0, parameters_.max_vel_x), random.uniform(-0.4, 0.4)};
      decision.step = random.pick({0.05, 0.085, 0.3, 0.0});
      decision.trajectory = {seen_.pose};
      for (int k = random.integer(0, 8); k > 0; --k) {
        const Pose2 q = decision.trajectory.back();
        decision.trajectory.push_back({q.x + 0.03, q.y + random.uniform(-0.02, 0.02), wrap_angle(q.theta + 0.02)});
      }
    });
    if (prediction_.poses().empty()) continue;  // refused
    const test::NaivePrediction twin(loop_, seen_, result_);
    ASSERT_EQ(prediction_.poses().size(), twin.poses.size());
    for (std::size_t k = 0; k < twin.poses.size(); ++k) {
      ASSERT_NEAR(prediction_.poses()[k].time, twin.poses[k].time, 1e-9) << k;
      ASSERT_NEAR(distance(prediction_.poses()[k].pose, twin.poses[k].pose), 0.0, 1e-9) << k;
      ASSERT_NEAR(wrap_angle(prediction_.poses()[k].pose.theta - twin.poses[k].pose.theta), 0.0, 1e-9) << k;
    }
    EXPECT_EQ(prediction_.next(), twin.next());
    blocked += twin.blocked;
    latched += loop_.situation().goal_latched;
    turns += twin.next() == NextMove::left || twin.next() == NextMove::right;
    own += decision_.step > 0.0 && decision_.trajectory.size() > 1;
  }
  EXPECT_GT(blocked, 30);
  EXPECT_GT(latched, 30);
  EXPECT_GT(turns, 30);
  EXPECT_GT(own, 100);
}

TEST_F(Predictions, AReasonIsGivenWhereItDoesNotJustFollowThePlan) {
  plan_to(3.0);
  predicted([](Result& result, Decision& decision) {
    result.outcome = Outcome::brake;
    decision.problem = "every candidate was rejected";
  });
  EXPECT_EQ(prediction_.next(), NextMove::stop);
  EXPECT_EQ(prediction_.reason(), "every candidate was rejected");
  predicted([](Result&, Decision& decision) { decision.recovering = true; });
  EXPECT_EQ(prediction_.next(), NextMove::recover);
  EXPECT_NE(prediction_.reason().find("stuck"), std::string::npos);
  predicted([](Result&, Decision& decision) { decision.waiting = true; });
  EXPECT_EQ(prediction_.next(), NextMove::stop);
  EXPECT_EQ(prediction_.reason(), "it waits for what moves to go");
  seen_.fault = "no transform";
  seen_.velocity.reset();
  EXPECT_TRUE(predicted().poses().empty());
  EXPECT_EQ(prediction_.reason(), "no transform");
  EXPECT_EQ(prediction_.next(), NextMove::stop);
}

TEST_F(Predictions, InputThatThePlannerRefusesIsNotPredictedFrom) {
  plan_to(3.0);
  EXPECT_EQ(predicted().poses().size(), 31u);
  plan_[3].y = std::nan("");
  EXPECT_TRUE(predicted().poses().empty());
  EXPECT_NE(prediction_.reason().find("plan"), std::string::npos) << prediction_.reason();
}

// A robot that stops does so whatever is known, but not where nobody knows where it is.
TEST_F(Predictions, ARobotThatStopsIsPredictedWhateverItsPlan) {
  plan_to(3.0);
  seen_.host_stops = true;
  for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
    plan_[3].y = bad;
    plan_.back().theta = bad;
    EXPECT_EQ(predicted().poses().size(), 31u);
  }
  seen_.pose.x = std::nan("");
  EXPECT_TRUE(predicted().poses().empty());
}

TEST(NextMoves, HaveNames) {
  const std::pair<NextMove, const char*> names[] = {{NextMove::straight, "straight"},
                                                    {NextMove::left, "left"},
                                                    {NextMove::right, "right"},
                                                    {NextMove::stop, "stop"},
                                                    {NextMove::recover, "recover"}};
  for (const auto& [move, name] : names) EXPECT_STREQ(to_string(move), name);
}

// At the goal, with 1.5 rad to turn at 1 rad/s at most.
TEST_F(Predictions, AtTheGoalItTurnsToItsHeading) {
  plan_ = {{0.0, 0.0, 0.0}, {0.05, 0.0, -1.5}};
  EXPECT_EQ(driving(0.0).next(), NextMove::right);
  EXPECT_EQ(prediction_.reason(), "it turns to the goal's heading");
  EXPECT_NEAR(prediction_.poses().back().pose.theta, -1.5, parameters_.yaw_goal_tolerance);
}

}  // namespace
}  // namespace hidwa_local_planner::control
