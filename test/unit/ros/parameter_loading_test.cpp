// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_loading.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue list(const std::vector<std::string>& names) {
  XmlRpcValue value;
  value.setSize(static_cast<int>(names.size()));
  for (int i = 0; i < value.size(); ++i) value[i] = names[static_cast<std::size_t>(i)];
  return value;
}

bool contains(const std::vector<std::string>& texts, const std::string& part) {
  for (const std::string& text : texts) {
    if (text.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(ParameterLoading, AnEmptyNamespaceIsAllDefaults) {
  const LoadedParameters loaded = load_parameters(XmlRpcValue());
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(get_parameter(loaded.parameters, info.name), info.value) << info.name;
  }
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_TRUE(loaded.found.empty());
}

TEST(ParameterLoading, TakesEveryKindOfValue) {
  XmlRpcValue content;
  content["max_vel_x"] = 1;  // a whole number for a real one
  content["acc_lim_x"] = 1.25;
  content["vx_samples"] = 7;
  content["escape"] = false;
  content["odom_topic"] = "wheels";
  content["generator"] = "dwa";
  const LoadedParameters loaded = load_parameters(content);
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.max_vel_x, 1.0);
  EXPECT_EQ(loaded.parameters.acc_lim_x, 1.25);
  EXPECT_EQ(loaded.parameters.vx_samples, 7);
  EXPECT_FALSE(loaded.parameters.escape);
  EXPECT_EQ(loaded.parameters.odom_topic, "wheels");
  EXPECT_EQ(loaded.parameters.generator, Generator::dwa);
  EXPECT_EQ(loaded.found.size(), 6u);
}

TEST(ParameterLoading, CriticsAreAListOrAText) {
  XmlRpcValue content;
  content["critics"] = list({"PathDist", "GoalDist"});
  EXPECT_EQ(split_names(load_parameters(content).parameters.critics),
            (std::vector<std::string>{"PathDist", "GoalDist"}));
  content["critics"] = "GoalDist, PathDist";
  EXPECT_EQ(split_names(load_parameters(content).parameters.critics),
            (std::vector<std::string>{"GoalDist", "PathDist"}));
  content["critics"] = list({});
  EXPECT_TRUE(contains(load_parameters(content).faults, "critics"));
  XmlRpcValue mixed = list({"PathDist", "GoalDist"});
  mixed[1] = 3;
  content["critics"] = mixed;
  EXPECT_TRUE(contains(load_parameters(content).faults, "list of names"));
}

// YAML 1.1 makes `mode: off` a boolean.
TEST(ParameterLoading, TheBareWordOffIsAName) {
  XmlRpcValue content;
  content["mode"] = false;
  const LoadedParameters loaded = load_parameters(content);
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.mode, OperatorMode::off);
  content["mode"] = true;
  EXPECT_TRUE(contains(load_parameters(content).faults, "mode"));
  content.clear();
  content["generator"] = false;  // has no off
  EXPECT_TRUE(contains(load_parameters(content).faults, "generator"));
}

TEST(ParameterLoading, NestedCriticParametersStandForFlatOnes) {
  XmlRpcValue content;
  content["PathAlign"]["scale"] = 16.0;
  content["SocialDistance"]["fading_time"] = 0.2;
  content["PathAlign_scale"] = 8.0;
  const LoadedParameters loaded = load_parameters(content);
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(loaded.parameters.PathAlign_scale, 16.0);
  EXPECT_EQ(loaded.parameters.SocialDistance_fading_time, 0.2);
  EXPECT_EQ(loaded.aliases.size(), 2u);
}

TEST(ParameterLoading, UnknownKeysAreNamedWithTheLikelyOne) {
  XmlRpcValue content;
  content["max_vel_X"] = 0.4;
  content["max_trans_vel"] = 0.4;
  content["something_else"] = 1;
  content["PathAlign"]["scal"] = 1.0;
  content["PahtAlign"]["scale"] = 1.0;
  const LoadedParameters loaded = load_parameters(content);
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.warnings.size(), 5u);
  EXPECT_TRUE(contains(loaded.warnings, "max_vel_X: it has no effect; do you mean max_vel_x?"));
  EXPECT_TRUE(contains(loaded.warnings, "max_trans_vel: it has no effect; do you mean max_vel_x?"));
  EXPECT_TRUE(contains(loaded.warnings, "something_else"));
  EXPECT_TRUE(contains(loaded.warnings, "PathAlign/scal: it has no effect; do you mean PathAlign_scale?"));
  EXPECT_TRUE(contains(loaded.warnings, "namespace PahtAlign"));
}

/// A parameter file's numbers.
XmlRpcValue numbers(const std::vector<std::pair<std::string, double>>& all) {
  XmlRpcValue content;
  for (const auto& [key, value] : all) content[key] = value;
  return content;
}

// The minima of dwa_local_planner bind only what is below both of them. Its window ends at min_vel_x, as ours does.
TEST(ParameterLoading, MinimaOfAnotherPlannerBindNothing) {
  for (const bool old_names : {true, false}) {
    const std::string trans = old_names ? "min_trans_vel" : "min_vel_trans";
    const std::string rot = old_names ? "min_rot_vel" : "min_vel_theta";
    const LoadedParameters loaded =
        load_parameters(numbers({{"min_vel_x", -0.22}, {"max_vel_theta", 2.75}, {trans, 0.11}, {rot, 1.37}}));
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.parameters.min_vel_x, -0.22);
    EXPECT_EQ(loaded.parameters.min_vel_theta, 0.0);
    EXPECT_EQ(loaded.warnings.size(), 2u);
    EXPECT_TRUE(
        contains(loaded.warnings, trans + ": it has no effect; remove it. Where the motors cannot turn slowly"));
    EXPECT_TRUE(contains(loaded.warnings, rot));
    EXPECT_FALSE(contains(loaded.warnings, "do you mean"));
  }
  // Alone it is ours.
  EXPECT_EQ(load_parameters(numbers({{"min_vel_theta", 0.3}})).parameters.min_vel_theta, 0.3);
}

// base_local_planner's is the fastest turn to the right: a range that ends below 0.
TEST(ParameterLoading, AFastestTurnToTheRightIsNoSlowestTurn) {
  XmlRpcValue content = numbers({{"min_vel_x", 0.1}, {"max_vel_theta", 1.57}, {"min_in_place_vel_theta", 0.314}});
  for (const bool whole : {false, true}) {
    if (whole) content["min_vel_theta"] = -1;
    if (!whole) content["min_vel_theta"] = -1.57;
    const LoadedParameters loaded = load_parameters(content);
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.parameters.min_vel_theta, 0.0);
    EXPECT_EQ(loaded.parameters.min_in_place_vel_theta, 0.314);
    EXPECT_TRUE(contains(loaded.warnings, "min_vel_theta: -1"));
    EXPECT_EQ(loaded.aliases, std::vector<std::string>{"min_vel_theta"});
  }
}

// Of the files for TurtleBot 2 and 3, Husky and Jackal, of TEB's tutorial and of Nav2's DWB.
TEST(ParameterLoading, WhatOtherPlannersHaveIsToldWithWhatToDo) {
  const std::vector<std::pair<std::string, std::string>> told = {
      {"max_vel_y", "sideways"},
      {"acc_lim_y", "sideways"},
      {"vy_samples", "sideways"},
      {"holonomic_robot", "sideways"},
      {"max_trans_vel", "do you mean max_vel_x?"},
      {"max_rot_vel", "do you mean max_vel_theta?"},
      {"acc_lim_th", "do you mean acc_lim_theta?"},
      {"min_speed_theta", "min_in_place_vel_theta"},
      {"vtheta_samples", "do you mean vth_samples?"},
      {"pdist_scale", "do you mean PathDist_scale (its unit differs)?"},
      {"max_vel_x_backwards", "do you mean min_vel_x (negative)?"},
      {"min_obstacle_dist", "do you mean footprint_padding?"},
      {"stop_time_buffer", "admissibility"},
      {"publish_traj_pc", "remove it"},
      {"escape_vel", "negative min_vel_x"},
      {"BaseObstacle.scale", "do you mean BaseObstacle_scale?"},
      {"PathAlign.forward_point_distance", "do you mean forward_point_distance?"},
      {"short_circuit_trajectory_evaluation", "remove it"}};
  for (const auto& [key, part] : told) {
    const LoadedParameters loaded = load_parameters(numbers({{key, 1.0}}));
    ASSERT_EQ(loaded.warnings.size(), 1u) << key;
    EXPECT_TRUE(contains(loaded.warnings, part)) << loaded.warnings.front();
  }
  XmlRpcValue teb;
  teb["footprint_model"]["type"] = "point";
  EXPECT_TRUE(contains(load_parameters(teb).warnings, "the footprint is the local costmap's"));
}

TEST(ParameterLoading, NamespacesOfListedCriticsAreTheirs) {
  XmlRpcValue content;
  content["critics"] = list({"PathDist", "some_package/TurnLimit"});
  content["TurnLimit"]["limit"] = 0.5;
  EXPECT_TRUE(load_parameters(content).warnings.empty());
  content["critics"] = list({"PathDist"});
  EXPECT_EQ(load_parameters(content).warnings.size(), 1u);
}

TEST(ParameterLoading, FaultsNameTheValueAndTheRemedy) {
  XmlRpcValue content;
  content["max_vel_x"] = "fast";
  content["sim_time"] = "1e0";  // YAML 1.1 takes it for a text
  content["vx_samples"] = 20.5;
  content["generator"] = "teb";
  content["min_in_place_vel_theta"] = -1.0;  // outside its range
  const LoadedParameters loaded = load_parameters(content);
  EXPECT_EQ(loaded.faults.size(), 5u);
  EXPECT_TRUE(contains(loaded.faults, "max_vel_x: fast"));
  EXPECT_TRUE(contains(loaded.faults, "1.0e-3"));
  EXPECT_TRUE(contains(loaded.faults, "without a decimal point"));
  EXPECT_TRUE(contains(loaded.faults, "one of standard dwa"));
  EXPECT_TRUE(contains(loaded.faults, "min_in_place_vel_theta"));
  EXPECT_EQ(loaded.parameters.max_vel_x, Parameters().max_vel_x);
}

TEST(ParameterLoading, WhatIsKnownBesidesCountsInTheValidation) {
  XmlRpcValue content;
  content["max_wheel_speed"] = 0.5;
  EXPECT_TRUE(contains(load_parameters(content).faults, "belong together"));
  const LoadedParameters loaded = load_parameters(content, [](Parameters p) {
    p.wheel_separation = 0.4;
    return p;
  });
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.max_wheel_speed, 0.5);
  EXPECT_EQ(loaded.parameters.wheel_separation, 0.0);  // what was written stays what was written
}

TEST(ParameterLoading, SomethingElseThanParametersIsAFault) {
  EXPECT_EQ(load_parameters(XmlRpcValue(3)).faults.size(), 1u);
}

// As a dump of the planner's namespace lands that is loaded into its host's.
TEST(ParameterLoading, ParametersInTheHostsNamespaceAreNamed) {
  XmlRpcValue host;
  host["controller_frequency"] = 20.0;  // what move_base itself reads
  host["base_local_planner"] = "hidwa_local_planner/HIDWAPlannerROS";
  host["odom_topic"] = "odom";
  host["HIDWAPlannerROS"]["max_vel_x"] = 0.4;
  EXPECT_TRUE(misplaced_parameters(host).empty());
  EXPECT_TRUE(misplaced_parameters(XmlRpcValue()).empty());
  host["max_vel_x"] = 0.3;
  host["control_latency"] = 0.2;
  EXPECT_EQ(misplaced_parameters(host), (std::vector<std::string>{"control_latency", "max_vel_x"}));
}

TEST(ParameterLoading, ShortNames) {
  EXPECT_EQ(short_name("PathDist"), "PathDist");
  EXPECT_EQ(short_name("package/Class"), "Class");
  EXPECT_EQ(short_name("package::Class"), "Class");
}

TEST(ParameterLoading, NothingNearNothingSuggested) { EXPECT_EQ(suggestion_for("zzzzzzzzzzzz"), ""); }

}  // namespace
}  // namespace hidwa_local_planner
