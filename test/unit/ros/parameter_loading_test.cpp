// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_loading.hpp"

#include <gtest/gtest.h>

#include "unit/ros/parameter_files.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

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
  const LoadedParameters loaded = load_parameters(file_of({{"max_vel_x", 1},  // a whole number for a real one
                                                           {"acc_lim_x", 1.25},
                                                           {"vx_samples", 7},
                                                           {"record_cycles", true},
                                                           {"odom_topic", "wheels"},
                                                           {"generator", "dwa"}}));
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.max_vel_x, 1.0);
  EXPECT_EQ(loaded.parameters.acc_lim_x, 1.25);
  EXPECT_EQ(loaded.parameters.vx_samples, 7);
  EXPECT_TRUE(loaded.parameters.record_cycles);
  EXPECT_EQ(loaded.parameters.odom_topic, "wheels");
  EXPECT_EQ(loaded.parameters.generator, Generator::dwa);
  EXPECT_EQ(loaded.found.size(), 6u);
}

TEST(ParameterLoading, CriticsAreAListOrAText) {
  const auto loaded = [](const XmlRpcValue& critics) { return load_parameters(file_of({{"critics", critics}})); };
  const std::vector<std::string> two{"PathDist", "GoalDist"};
  EXPECT_EQ(split_names(loaded(list_of(two)).parameters.critics), two);
  EXPECT_EQ(split_names(loaded("PathDist, GoalDist").parameters.critics), two);
  EXPECT_TRUE(contains(loaded(list_of<std::string>({})).faults, "critics"));
  XmlRpcValue mixed = list_of(two);
  mixed[1] = 3;
  EXPECT_TRUE(contains(loaded(mixed).faults, "list of names"));
}

// YAML 1.1 makes `mode: off` a boolean.
TEST(ParameterLoading, TheBareWordOffIsAName) {
  const LoadedParameters loaded = load_parameters(file_of({{"mode", false}}));
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.parameters.mode, OperatorMode::off);
  EXPECT_TRUE(contains(load_parameters(file_of({{"mode", true}})).faults, "mode"));
  EXPECT_TRUE(contains(load_parameters(file_of({{"generator", false}})).faults, "generator"));  // has no off
}

TEST(ParameterLoading, NestedCriticParametersStandForFlatOnes) {
  const LoadedParameters loaded = load_parameters(file_of({{"PathAlign", file_of({{"scale", 16.0}})},
                                                           {"SocialDistance", file_of({{"fading_time", 0.2}})},
                                                           {"PathAlign_scale", 8.0}}));
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(loaded.parameters.PathAlign_scale, 16.0);
  EXPECT_EQ(loaded.parameters.SocialDistance_fading_time, 0.2);
  EXPECT_EQ(loaded.aliases.size(), 2u);
}

TEST(ParameterLoading, UnknownKeysAreNamedWithTheLikelyOne) {
  const LoadedParameters loaded = load_parameters(file_of({{"max_vel_X", 0.4},
                                                           {"max_trans_vel", 0.4},
                                                           {"something_else", 1},
                                                           {"PathAlign", file_of({{"scal", 1.0}})},
                                                           {"PahtAlign", file_of({{"scale", 1.0}})}}));
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.warnings.size(), 5u);
  EXPECT_TRUE(contains(loaded.warnings, "max_vel_X: it has no effect; do you mean max_vel_x?"));
  EXPECT_TRUE(contains(loaded.warnings, "max_trans_vel: it has no effect; do you mean max_vel_x?"));
  EXPECT_TRUE(contains(loaded.warnings, "something_else"));
  EXPECT_TRUE(contains(loaded.warnings, "PathAlign/scal: it has no effect; do you mean PathAlign_scale?"));
  EXPECT_TRUE(contains(loaded.warnings, "namespace PahtAlign"));
}

// The minima of dwa_local_planner bind only what is below both of them. Its window ends at min_vel_x, as ours does.
TEST(ParameterLoading, MinimaOfAnotherPlannerBindNothing) {
  for (const bool old_names : {true, false}) {
    const std::string trans = old_names ? "min_trans_vel" : "min_vel_trans";
    const std::string rot = old_names ? "min_rot_vel" : "min_vel_theta";
    const LoadedParameters loaded =
        load_parameters(file_of({{"min_vel_x", -0.22}, {"max_vel_theta", 2.75}, {trans, 0.11}, {rot, 1.37}}));
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.parameters.min_vel_x, -0.22);
    EXPECT_EQ(loaded.warnings.size(), 2u);
    EXPECT_TRUE(
        contains(loaded.warnings, trans + ": it has no effect; remove it. Where the motors cannot turn slowly"));
    EXPECT_TRUE(contains(loaded.warnings, rot));
    EXPECT_FALSE(contains(loaded.warnings, "do you mean"));
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
    const LoadedParameters loaded = load_parameters(file_of({{key, 1.0}}));
    ASSERT_EQ(loaded.warnings.size(), 1u) << key;
    EXPECT_TRUE(contains(loaded.warnings, part)) << loaded.warnings.front();
  }
  const XmlRpcValue teb = file_of({{"footprint_model", file_of({{"type", "point"}})}});
  EXPECT_TRUE(contains(load_parameters(teb).warnings, "the footprint is the local costmap's"));
}

TEST(ParameterLoading, NamespacesOfListedCriticsAreTheirs) {
  const auto warnings = [](const std::string& critics) {
    return load_parameters(file_of({{"critics", critics}, {"TurnLimit", file_of({{"limit", 0.5}})}})).warnings;
  };
  EXPECT_TRUE(warnings("PathDist, some_package/TurnLimit").empty());
  EXPECT_EQ(warnings("PathDist").size(), 1u);
}

TEST(ParameterLoading, FaultsNameTheValueAndTheRemedy) {
  const LoadedParameters loaded = load_parameters(file_of({{"max_vel_x", "fast"},
                                                           {"sim_time", "1e0"},  // YAML 1.1 takes it for a text
                                                           {"vx_samples", 20.5},
                                                           {"generator", "teb"},
                                                           {"min_in_place_vel_theta", -1.0}}));  // outside its range
  EXPECT_EQ(loaded.faults.size(), 5u);
  EXPECT_TRUE(contains(loaded.faults, "max_vel_x: fast"));
  EXPECT_TRUE(contains(loaded.faults, "1.0e-3"));
  EXPECT_TRUE(contains(loaded.faults, "without a decimal point"));
  EXPECT_TRUE(contains(loaded.faults, "one of standard dwa"));
  EXPECT_TRUE(contains(loaded.faults, "min_in_place_vel_theta"));
  EXPECT_EQ(loaded.parameters.max_vel_x, Parameters().max_vel_x);
}

TEST(ParameterLoading, WhatIsKnownBesidesCountsInTheValidation) {
  const XmlRpcValue content = file_of({{"max_wheel_speed", 0.5}});
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
  XmlRpcValue host = file_of({{"controller_frequency", 20.0},  // what move_base itself reads
                              {"base_local_planner", "hidwa_local_planner/HIDWAPlannerROS"},
                              {"odom_topic", "odom"},
                              {"HIDWAPlannerROS", file_of({{"max_vel_x", 0.4}})}});
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
