// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ros/host/controller.hpp"

namespace hidwa_local_planner {
namespace {

CycleResult failed(Missing missing) {
  CycleResult result;
  result.missing = missing;
  result.fault = "something is missing";
  return result;
}

ControllerOutcome failed(Problem problem, bool escaping = false) {
  Decision decision;
  decision.problem_kind = problem;
  decision.escaping = escaping;
  CycleResult result;
  result.decision = &decision;
  return outcome_of(result);
}

TEST(ControllerOutcome, WhateverIsToBeSentIsASuccess) {
  Decision decision;
  decision.problem_kind = Problem::rejected;
  for (const Outcome outcome : {Outcome::drive, Outcome::brake, Outcome::hold}) {
    CycleResult result;
    result.outcome = outcome;
    result.decision = &decision;
    EXPECT_EQ(outcome_of(result), ControllerOutcome::success) << to_string(outcome);
  }
}

TEST(ControllerOutcome, AFailureSaysWhatIsMissing) {
  EXPECT_EQ(outcome_of(failed(Missing::parameters)), ControllerOutcome::not_initialized);
  EXPECT_EQ(outcome_of(failed(Missing::footprint)), ControllerOutcome::not_initialized);
  EXPECT_EQ(outcome_of(failed(Missing::plan)), ControllerOutcome::invalid_path);
  EXPECT_EQ(outcome_of(failed(Missing::odometry)), ControllerOutcome::no_valid_command);
  EXPECT_EQ(outcome_of(failed(Missing::costmap)), ControllerOutcome::map_error);
  EXPECT_EQ(outcome_of(failed(Missing::transform)), ControllerOutcome::tf_error);
}

TEST(ControllerOutcome, AFailureSaysWhatTheProblemIs) {
  EXPECT_EQ(failed(Problem::rejected), ControllerOutcome::no_valid_command);
  EXPECT_EQ(failed(Problem::rejected, true), ControllerOutcome::collision);
  EXPECT_EQ(failed(Problem::off_map), ControllerOutcome::missed_path);
  EXPECT_EQ(failed(Problem::stuck), ControllerOutcome::blocked_path);
  EXPECT_EQ(failed(Problem::input), ControllerOutcome::internal_error);
}

TEST(ControllerOutcome, WordsNameFaultProblemAndEscape) {
  EXPECT_EQ(in_words(failed(Missing::odometry)), "something is missing");
  Decision decision;
  CycleResult result;
  result.decision = &decision;
  EXPECT_EQ(in_words(result), "");
  decision.escaping = true;
  EXPECT_EQ(in_words(result), kEscapes);
  decision.problem = "every candidate was rejected";
  decision.candidates = 30;
  decision.rejections = {{"Collision", 28}, {"Braking", 0}, {"Oscillation", 2}};
  EXPECT_EQ(in_words(result),
            "every candidate was rejected (of 30 candidates, Collision rejects 28, Oscillation rejects 2)");
}

TEST(Controller, BeforeItIsInitializedItSaysSo) {
  Controller controller;
  geometry_msgs::Twist command;
  command.linear.x = 1.0;
  std::string message;
  EXPECT_EQ(controller.compute(command, message), ControllerOutcome::not_initialized);
  EXPECT_EQ(command.linear.x, 0.0);
  EXPECT_NE(message.find("not initialized"), std::string::npos);
  EXPECT_FALSE(controller.set_plan({}));
  EXPECT_FALSE(controller.goal_reached(0.1, 0.1));
  controller.initialize("no_tf", nullptr, nullptr);
  EXPECT_EQ(controller.compute(command, message), ControllerOutcome::not_initialized);
}

}  // namespace
}  // namespace hidwa_local_planner
