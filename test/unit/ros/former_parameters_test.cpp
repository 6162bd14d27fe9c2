// SPDX-License-Identifier: BSD-3-Clause
// Files that set parameters of before.
#include "ros/former_parameters.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/parameter_text.hpp"
#include "ros/parameter_loading.hpp"
#include "unit/ros/parameter_files.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

/// Both drive the same, the former one with `lines` lines that say what to write.
void expect_same(const XmlRpcValue& former, const XmlRpcValue& present, const std::vector<std::string>& lines) {
  const LoadedParameters loaded = load_parameters(former), wanted = load_parameters(present);
  EXPECT_EQ(loaded.faults, std::vector<std::string>());
  EXPECT_EQ(to_lines(loaded.parameters), to_lines(wanted.parameters));
  EXPECT_EQ(loaded.warnings, lines);
  EXPECT_EQ(wanted.warnings, std::vector<std::string>());
}

TEST(FormerParameters, ASignTurnsItsAxisRound) {
  expect_same(file_of({{"axis_angular_sign", -1}}), file_of({{"axis_angular", "0 reversed"}}),
              {"axis_angular_sign: -1 is taken as axis_angular: 0 reversed: write that instead"});
  expect_same(file_of({{"axis_linear", 3}, {"axis_linear_sign", -1}}), file_of({{"axis_linear", "3 reversed"}}),
              {"axis_linear_sign: -1 is taken as axis_linear: 3 reversed: write that instead"});
  expect_same(file_of({{"clutch_axis", 4}, {"clutch_axis_sign", -1}}), file_of({{"clutch_axis", "4 reversed"}}),
              {"clutch_axis_sign: -1 is taken as clutch_axis: 4 reversed: write that instead"});
  expect_same(file_of({{"gesture_axis", "x"}, {"gesture_axis_sign", -1}, {"gesture_linear_sign", -1}}),
              file_of({{"gesture_axis", "-x"}, {"gesture_linear_axis", "-x"}}),
              {"gesture_axis_sign: -1 is taken as gesture_axis: -x: write that instead",
               "gesture_linear_sign: -1 is taken as gesture_linear_axis: -x: write that instead"});
}

TEST(FormerParameters, ASignThatSaysNothingNewIsNoMatter) {
  const XmlRpcValue axis = file_of({{"axis_angular", 2}});
  expect_same(file_of({{"axis_angular", 2}, {"axis_angular_sign", 1}}), axis, {});
  // A parameter server that still has it beside what it became.
  expect_same(file_of({{"axis_angular", "2 reversed"}, {"axis_angular_sign", -1}}),
              file_of({{"axis_angular", "2 reversed"}}),
              {"axis_angular_sign: -1 is taken as axis_angular: 2 reversed: write that instead"});
  expect_same(file_of({{"axis_angular", 2}, {"axis_angular_sign", 0}}), axis,
              {"unknown parameter axis_angular_sign: 0 has no effect; axis_angular says it: 2, or such as 3 reversed"});
  expect_same(file_of({{"clutch_axis_sign", -1}}), XmlRpcValue(file_of({{"clutch_axis", -1}})),
              {"unknown parameter clutch_axis_sign: -1 has no effect; clutch_axis says it: -1, or such as 3 reversed"});
}

TEST(FormerParameters, TheWheelsRadiusTimesTheirTurningIsTheirSpeed) {
  const XmlRpcValue present = file_of({{"wheel_separation", 0.16}, {"max_wheel_speed", 0.22011}});
  XmlRpcValue former = file_of({{"wheel_radius", 0.033}, {"wheel_separation", 0.16}, {"max_wheel_velocity", 6.67}});
  expect_same(
      former, present,
      {"wheel_radius: 0.033 and max_wheel_velocity: 6.67 are taken as max_wheel_speed: 0.22011: write that instead"});
  former["max_wheel_speed"] = 0.22011;  // beside it, as on a parameter server
  expect_same(former, present, {});
  expect_same(file_of({{"wheel_radius", 0.0}, {"max_wheel_velocity", 0}}), file_of({{"max_vel_x", 0.5}}), {});
  const LoadedParameters alone = load_parameters(file_of({{"max_wheel_velocity", 6.67}}));
  EXPECT_TRUE(
      contains(alone.faults, "max_wheel_velocity: 6.67 without wheel_radius is no speed: write max_wheel_speed"));
  EXPECT_TRUE(
      contains(load_parameters(file_of({{"wheel_radius", 1}})).faults, "wheel_radius: 1 without max_wheel_velocity"));
}

TEST(FormerParameters, TheTimeUntilBlockedWasAutonomysToo) {
  expect_same(file_of({{"blocked_time", 2.5}}), file_of({{"blocked_time", 2.5}, {"stall_time", 2.5}}),
              {"blocked_time: 2.5 is taken as stall_time: 2.5 too, which it was until 2026-11-29: write both"});
  EXPECT_EQ(load_parameters(file_of({{"blocked_time", 2.5}, {"stall_time", 1.0}})).parameters.stall_time, 1.0);
  EXPECT_TRUE(load_parameters(file_of({{"blocked_time", 1.0}})).warnings.empty());  // the default of both
}

TEST(FormerParameters, TheForwardPointIsOneForBothCritics) {
  const std::string line = "_forward_point_distance: 0.3 is taken as forward_point_distance: 0.3: write that instead";
  const XmlRpcValue present = file_of({{"forward_point_distance", 0.3}});
  expect_same(file_of({{"PathAlign_forward_point_distance", 0.3}, {"GoalAlign_forward_point_distance", 0.3}}), present,
              {"PathAlign" + line});
  XmlRpcValue nested;
  nested["GoalAlign"]["forward_point_distance"] = 0.3;
  expect_same(nested, present, {"GoalAlign" + line});
  EXPECT_EQ(load_parameters(nested).aliases, std::vector<std::string>{"GoalAlign/forward_point_distance"});
  nested["PathAlign_forward_point_distance"] = 0.2;
  expect_same(
      nested, file_of({{"forward_point_distance", 0.2}}),
      {"PathAlign_forward_point_distance: 0.2 is taken as forward_point_distance: 0.2: write that instead",
       "unknown parameter GoalAlign_forward_point_distance: 0.3 has no effect: forward_point_distance: 0.2 holds"});
}

TEST(FormerParameters, AWeightThatOnlySwitchedACriticOffLeavesItOut) {
  expect_same(file_of({{"critics", "RotateToGoal, Oscillation, PathDist"}, {"Oscillation_scale", 0.0}}),
              file_of({{"critics", "RotateToGoal, PathDist"}}),
              {"Oscillation_scale: 0 is taken as critics: RotateToGoal, PathDist: write that instead"});
  const XmlRpcValue critics = list_of<std::string>({"Oscillation", "PathDist"});
  EXPECT_EQ(load_parameters(file_of({{"Oscillation_scale", 0}, {"critics", critics}})).parameters.critics, "PathDist");
  expect_same(file_of({{"Oscillation_scale", 2.0}}), file_of({{"max_vel_x", 0.5}}),
              {"unknown parameter Oscillation_scale: 2 has no effect: Oscillation only rejects: remove it"});
}

TEST(FormerParameters, ACriticWithoutParametersTakesNoneUnnoticed) {
  XmlRpcValue nested;
  nested["Oscillation"]["scale"] = 1.0;
  EXPECT_TRUE(load_parameters(nested).warnings.empty());
  nested["Oscillation"]["reset_distance"] = 1.0;
  EXPECT_TRUE(contains(load_parameters(nested).warnings, "unknown parameter Oscillation/reset_distance"));
}

TEST(FormerParameters, AWeightOfTermsWithWeightsGoesIntoThem) {
  expect_same(
      file_of({{"PreferForward_theta_scale", 4.0}, {"PreferForward", file_of({{"scale", 3.0}, {"penalty", 2}})}}),
      file_of({{"PreferForward_penalty", 6.0}, {"PreferForward_theta_scale", 12.0}}),
      {"PreferForward_scale: 3 is taken as PreferForward_penalty: 6 and PreferForward_theta_scale: 12: write "
       "those instead"});
}

TEST(FormerParameters, WhatIsFixedNowSaysWhatItIs) {
  const std::pair<const char*, const char*> told[] = {{"Oscillation_x_only_threshold", "it is 0.05 m/s: remove it"},
                                                      {"escape", "false with method: paper"},
                                                      {"turn_when_stuck", "false with method: paper"},
                                                      {"velocity_reference", "odometry with method: paper"},
                                                      {"min_vel_theta", "max_vel_theta holds to both sides"},
                                                      {"Oscillation_reset_dist", "it is 0.05 m"},
                                                      {"Oscillation_reset_angle", "it is 0.2 rad"},
                                                      {"velocity_reference_tolerance_x", "it is 0.2 m/s"},
                                                      {"velocity_reference_tolerance_theta", "it is 0.5 rad/s"},
                                                      {"prune_distance", "it is 1 m"},
                                                      {"forward_prune_auto", "false with method: paper"},
                                                      {"clutch_threshold", "it is 0.5"},
                                                      {"gesture_jump", "it is 0.3 m"},
                                                      {"Oscillation_reset_time", "time alone allows nothing again"},
                                                      {"PreferForward_strafe_x", "it is 0.1 m/s"},
                                                      {"PreferForward_strafe_theta", "it is 0.2 rad/s"},
                                                      {"RotateToGoal_slowing_factor", "it is 5"},
                                                      {"RotateToGoal_lookahead_time", "-1 with method: paper"},
                                                      {"BaseObstacle_sum_scores", "the cost at the last pose counts"},
                                                      {"ObstacleFootprint_sum_scores", "the last pose counts"}};
  for (const auto& [name, line] : told) {
    const LoadedParameters loaded = load_parameters(file_of({{name, 0.7}}));
    ASSERT_EQ(loaded.warnings.size(), 1u) << name;
    EXPECT_EQ(loaded.warnings[0].rfind(std::string("unknown parameter ") + name + ": ", 0), 0u) << loaded.warnings[0];
    EXPECT_NE(loaded.warnings[0].find(line), std::string::npos) << loaded.warnings[0];
  }
  expect_same(file_of({{"method", "paper"}, {"RotateToGoal_lookahead_time", -1.0}}), file_of({{"method", "paper"}}),
              {});
  expect_same(file_of({{"RotateToGoal_lookahead_time", 0.5}}), file_of({{"max_vel_x", 0.5}}), {});
}

TEST(FormerParameters, TheWeightOfAutonomyGoesIntoTheOperators) {
  expect_same(file_of({{"s_nv", 2.0}, {"s_v", 300.0}}), file_of({{"s_v", 150.0}, {"s_omega", 400.0}}),
              {"s_nv: 2 is taken as s_v: 150 and s_omega: 400: write those instead"});
  const LoadedParameters refused = load_parameters(file_of({{"s_nv", 0}}));
  EXPECT_TRUE(contains(refused.faults, "s_nv: 0 is no weight now: raise s_v"));
  EXPECT_TRUE(refused.aliases.empty());  // the next start finds it again
}

TEST(FormerParameters, TwoJointsAreAList) {
  expect_same(file_of({{"left_wheel_joint", "l"}, {"right_wheel_joint", "r"}}), file_of({{"wheel_joints", "l, r"}}),
              {"left_wheel_joint and right_wheel_joint are taken as wheel_joints: [l, r]: write that instead"});
  expect_same(file_of({{"left_wheel_joint", ""}, {"right_wheel_joint", ""}}), file_of({{"max_vel_x", 0.5}}), {});
  EXPECT_TRUE(contains(load_parameters(file_of({{"left_wheel_joint", "l"}})).faults, "name two joints"));
}

// What the planner takes off the parameter server, where it would hide later changes from the next start.
TEST(FormerParameters, WhatWasTakenOverIsNamed) {
  EXPECT_EQ(load_parameters(file_of({{"axis_angular_sign", -1}, {"max_vel_x", 0.4}})).aliases,
            std::vector<std::string>{"axis_angular_sign"});
}

/// What paper.yaml set before `method` took its place.
XmlRpcValue former_paper_switches() {
  return file_of({{"sample_zero", false},
                  {"sample_operator", false},
                  {"sample_previous", false},
                  {"hold_ends_when_refused", false},
                  {"oscillation_while_steering", true},
                  {"operator_in_goal_window", true},
                  {"plan_hysteresis", 0.0},
                  {"tie_break", "first"},
                  {"command", "target"},
                  {"integration", "euler"},
                  {"map_grid", "l1"},
                  {"hold_linear", "operator"}});
}

TEST(FormerParameters, TheFormerSwitchesOfThePaperAreItsMethod) {
  LoadedParameters loaded = load_parameters(former_paper_switches());
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.method, Method::paper);
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_TRUE(contains(loaded.warnings, "write method: paper"));
  XmlRpcValue both = former_paper_switches();  // as a parameter server has it once the planner ran
  both["method"] = "paper";
  loaded = load_parameters(both);
  EXPECT_EQ(loaded.parameters.method, Method::paper);
  EXPECT_TRUE(loaded.warnings.empty());
  both["method"] = "hidwa";  // the file's own word counts
  loaded = load_parameters(both);
  EXPECT_EQ(loaded.parameters.method, Method::hidwa);
  EXPECT_EQ(loaded.warnings.size(), 11u);  // all but hold_linear, which is the same in both
}

TEST(FormerParameters, AFormerSwitchAloneHasNoEffectAndSaysWhatToWrite) {
  for (const auto& [name, value] : former_paper_switches()) {
    XmlRpcValue content;
    content[name] = value;
    const LoadedParameters loaded = load_parameters(content);
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.parameters.method, Method::hidwa) << name;
    EXPECT_EQ(loaded.warnings.size(), name == "hold_linear" ? 0u : 1u) << name;
    if (name == "hold_linear") continue;
    EXPECT_TRUE(contains(loaded.warnings, "unknown parameter " + name + ": it has no effect")) << name;
    EXPECT_TRUE(contains(loaded.warnings, as_text(value) + " with method: paper")) << name;
  }
  XmlRpcValue one_missing = former_paper_switches();
  one_missing["tie_break"] = "least_change";
  EXPECT_EQ(load_parameters(one_missing).parameters.method, Method::hidwa);
  XmlRpcValue content;  // what the default method does anyway
  content["sample_zero"] = true;
  content["plan_hysteresis"] = 0.2;
  content["command"] = "feasible";
  EXPECT_TRUE(load_parameters(content).warnings.empty());
  content["plan_hysteresis"] = 0.3;
  content["hold_linear"] = "robot";
  const LoadedParameters others = load_parameters(content);
  EXPECT_EQ(others.warnings.size(), 2u);
  EXPECT_TRUE(contains(others.warnings, "hold_linear: it has no effect; it is operator with either method: remove it"));
  XmlRpcValue paper = former_paper_switches();
  paper["hold_linear"] = "robot";
  EXPECT_EQ(load_parameters(paper).parameters.method, Method::paper);
}

}  // namespace
}  // namespace hidwa_local_planner
