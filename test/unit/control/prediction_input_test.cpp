// SPDX-License-Identifier: BSD-3-Clause
// What cannot be predicted from is not: no pose that is no number goes to those who watch.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "control/prediction.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"

namespace hidwa_local_planner::control {
namespace {

// An empty map of 4 m around a robot that follows a straight plan.
class PredictionInput : public testing::Test {
 protected:
  PredictionInput() : loop_(critics::built_in()) {
    Parameters parameters;
    parameters.vx_samples = parameters.vth_samples = 5;
    EXPECT_TRUE(loop_.configure(parameters).empty());
    loop_.set_footprint({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
    seen_.timing.now = 1.0;
    seen_.velocity = Twist2{0.2, 0.0};
    seen_.costmap = {costs_.data(), 40, 40, 0.1, -2.0, -2.0};
    for (int k = 0; k < 30; ++k) plan_.push_back({0.05 * k, 0.0, 0.0});
  }
  const Prediction& predicted() {
    loop_.set_plan(plan_, "map", 1.0, 0.05);
    prediction_.update(loop_, seen_, loop_.step(seen_, {}));
    for (const TimedPose& said : prediction_.poses()) EXPECT_TRUE(is_finite(said.pose)) << said.time;
    return prediction_;
  }
  std::vector<std::uint8_t> costs_ = std::vector<std::uint8_t>(1600, cost::kFree);
  std::vector<Pose2> plan_;
  ControlLoop loop_;
  Observation seen_;
  Prediction prediction_;
};

TEST_F(PredictionInput, AGoodOneReachesToTheHorizon) { EXPECT_EQ(predicted().poses().size(), 31u); }

TEST_F(PredictionInput, InputThatThePlannerRefusesIsNotPredictedFrom) {
  plan_[3].y = std::nan("");
  EXPECT_TRUE(predicted().poses().empty());
  EXPECT_NE(prediction_.reason().find("plan"), std::string::npos) << prediction_.reason();
}

// A robot that stops does so whatever is known.
TEST_F(PredictionInput, ARobotThatStopsNowhereIsNotPredicted) {
  seen_.host_stops = true;
  seen_.pose.x = std::nan("");
  EXPECT_TRUE(predicted().poses().empty());
}

TEST_F(PredictionInput, ARobotThatStopsIsPredictedWhateverItsPlan) {
  seen_.host_stops = true;
  for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
    plan_[3].y = bad;
    plan_.back().theta = bad;
    EXPECT_EQ(predicted().poses().size(), 31u);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::control
