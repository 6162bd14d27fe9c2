// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

bool names(const std::vector<std::string>& faults, const std::string& parameter) {
  return std::any_of(faults.begin(), faults.end(),
                     [&](const std::string& fault) { return fault.find(parameter) != std::string::npos; });
}

TEST(ParameterTable, NamesAreUniqueAndDefaultsAreTheStructs) {
  std::set<std::string> seen;
  const Parameters defaults;
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_TRUE(seen.insert(info.name).second) << info.name;
    EXPECT_TRUE(get_parameter(defaults, info.name) == info.value) << info.name;
    EXPECT_FALSE(info.description.empty()) << info.name;
    EXPECT_FALSE(info.tab.empty()) << info.name;
  }
  EXPECT_EQ(seen.count("max_vel_x"), 1u);
  EXPECT_TRUE(validate(defaults).empty());
}

TEST(ParameterAccess, SetAndGetEveryOneByName) {
  for (const ParameterInfo& info : parameter_table()) {
    Parameters p;
    ParameterValue value = info.value;
    if (info.type == "double") value = 0.5 * (info.min + info.max);
    if (info.type == "int") value = static_cast<int>(info.max);
    if (info.type == "bool") value = !std::get<bool>(info.value);
    if (info.type == "str") value = std::string("something else");
    if (info.type == "enum") value = info.choices.back();
    if (info.type == "axis") value = std::string("31 reversed");
    ASSERT_EQ(set_parameter(p, info.name, value), "") << info.name;
    EXPECT_TRUE(get_parameter(p, info.name) == value) << info.name;
    // Nothing else changed.
    for (const ParameterInfo& other : parameter_table()) {
      if (other.name == info.name) continue;
      EXPECT_TRUE(get_parameter(p, other.name) == other.value) << other.name;
    }
  }
}

TEST(ParameterAccess, WholeNumbersServeAsDoublesNotTheOtherWayRound) {
  Parameters p;
  EXPECT_EQ(set_parameter(p, "max_vel_x", 1), "");
  EXPECT_EQ(p.max_vel_x, 1.0);
  EXPECT_NE(set_parameter(p, "vx_samples", 7.0), "");
  EXPECT_EQ(p.vx_samples, Parameters().vx_samples);
}

TEST(ParameterAccess, EnumerationsByName) {
  Parameters p;
  EXPECT_EQ(set_parameter(p, "generator", std::string("dwa")), "");
  EXPECT_EQ(p.generator, Generator::dwa);
  EXPECT_EQ(std::get<std::string>(get_parameter(p, "generator")), "dwa");
  const std::string fault = set_parameter(p, "generator", std::string("nonsense"));
  for (const char* word : {"generator", "standard", "dwa"}) EXPECT_NE(fault.find(word), std::string::npos) << fault;
  EXPECT_EQ(p.generator, Generator::dwa);
}

TEST(ParameterAccess, AnAxisIsItsIndexOrReversed) {
  Parameters p;
  EXPECT_EQ(set_parameter(p, "axis_angular", 3), "");  // as YAML reads it
  EXPECT_TRUE(p.axis_angular == (JoyAxis{3, false}));
  EXPECT_EQ(set_parameter(p, "axis_angular", std::string("0 reversed")), "");
  EXPECT_TRUE(p.axis_angular == (JoyAxis{0, true}));
  EXPECT_EQ(p.axis_angular.turned(0.5F), -0.5F);
  EXPECT_EQ(std::get<std::string>(get_parameter(p, "axis_angular")), "0 reversed");
  EXPECT_EQ(set_parameter(p, "axis_angular", std::string("2")), "");
  EXPECT_TRUE(p.axis_angular == (JoyAxis{2, false}));
  EXPECT_EQ(set_parameter(p, "clutch_axis", -1), "");
  std::vector<ParameterValue> wrong{-1, 32, 2.0, true};
  for (const char* text : {"-0", "2 reverse", "32 reversed", "reversed", "1.5", "2 reversed reversed", ""}) {
    wrong.emplace_back(std::string(text));
  }
  for (const ParameterValue& value : wrong) {
    EXPECT_EQ(set_parameter(p, "axis_angular", value),
              "axis_angular: expected an axis, 0 to 31, or such as 31 reversed");
  }
  EXPECT_NE(set_parameter(p, "clutch_axis", std::string("-1 reversed")), "");
  EXPECT_TRUE(p.axis_angular == (JoyAxis{2, false}));
}

TEST(ParameterAccess, FaultsNameTheParameterAndWhatItWants) {
  Parameters p;
  EXPECT_NE(set_parameter(p, "max_vel_x", std::string("fast")).find("max_vel_x: expected a number"), std::string::npos);
  EXPECT_NE(set_parameter(p, "unknown_is_obstacle", 1).find("true or false"), std::string::npos);
  EXPECT_NE(set_parameter(p, "vx_samples", true).find("a whole number"), std::string::npos);
  EXPECT_NE(set_parameter(p, "odom_topic", 3).find("a text"), std::string::npos);
  EXPECT_NE(set_parameter(p, "max_vel", 3).find("max_vel"), std::string::npos);
  EXPECT_THROW(get_parameter(p, "max_vel"), std::out_of_range);
}

TEST(Validate, EveryNumberIsHeldToItsRange) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.type != "double" && info.type != "int") continue;
    for (const double off : {-1.0, 1.0}) {
      Parameters p;
      const double bound = off < 0.0 ? info.min : info.max;
      const ParameterValue value =
          info.type == "int" ? ParameterValue(static_cast<int>(bound + off)) : ParameterValue(bound + off);
      ASSERT_EQ(set_parameter(p, info.name, value), "");
      EXPECT_TRUE(names(validate(p), info.name)) << info.name << " " << bound + off;
    }
    if (info.type == "int") continue;
    Parameters p;
    set_parameter(p, info.name, std::nan(""));
    EXPECT_TRUE(names(validate(p), info.name)) << info.name;
  }
}

struct Rollouts {
  const char* what;
  double linear_granularity, angular_granularity, min_vel_x, max_vel_x, max_vel_theta;
  int samples;  // of each axis
  bool refused;
};

// The larger of what speed and turn need, each over the whole sim_time of 10 s.
TEST(Validate, RolloutsWithoutEndAreRefused) {
  const Rollouts all[] = {
      {"10 m / 1 mm = 10,000 poses of 400 samples", 0.001, 0.05, 0.0, 1.0, 1.0, 20, false},
      {"10 rad / 1 mrad, as many", 0.05, 0.001, 0.0, 1.0, 1.0, 20, false},
      {"30,000 poses", 0.001, 0.05, 0.0, 3.0, 1.0, 20, true},
      {"as many backwards", 0.001, 0.05, -3.0, 1.0, 1.0, 20, true},
      {"30,000 poses of a turn", 0.05, 0.001, 0.0, 1.0, 3.0, 20, true},
      {"10,000 poses of 2,500 samples", 0.001, 0.05, 0.0, 1.0, 1.0, 50, true},
  };
  for (const Rollouts& rollouts : all) {
    Parameters p;
    p.sim_time = 10.0;
    p.linear_granularity = rollouts.linear_granularity;
    p.angular_granularity = rollouts.angular_granularity;
    p.min_vel_x = rollouts.min_vel_x;
    p.max_vel_x = rollouts.max_vel_x;
    p.max_vel_theta = rollouts.max_vel_theta;
    p.vx_samples = p.vth_samples = rollouts.samples;
    EXPECT_EQ(!validate(p).empty(), rollouts.refused) << rollouts.what;
  }
}

TEST(Validate, ReturnsEveryFaultAtOnce) {
  Parameters p;
  p.sim_time = -1.0;
  p.acc_lim_x = INFINITY;
  p.min_vel_x = 0.6;               // above max_vel_x
  p.min_in_place_vel_theta = 1.2;  // above max_vel_theta
  p.max_wheel_speed = 1.0;         // alone
  p.odom_topic = "";
  p.critics = " , ";
  p.vx_samples = p.vth_samples = 500;  // 250000 candidates
  const std::vector<std::string> faults = validate(p);
  EXPECT_EQ(faults.size(), 8u);
  for (const char* name : {"sim_time", "acc_lim_x", "min_vel_x", "min_in_place_vel_theta", "wheel_separation",
                           "odom_topic", "critics", "vx_samples"}) {
    EXPECT_TRUE(names(faults, name)) << name;
  }
}

// A device that cannot be read is refused when it is set, with what to set.
TEST(Validate, TellsWhatADeviceLacks) {
  const auto faults_with = [](auto&& change) {
    Parameters p;
    change(p);
    std::string all;
    for (const std::string& fault : validate(p)) all += fault + '\n';
    return all;
  };
  EXPECT_EQ(faults_with([](Parameters&) {}), "");
  EXPECT_EQ(faults_with([](Parameters& p) { p.gesture_frame = "hand"; }).find("gesture_frame and gesture_parent_frame"),
            0u);
  const auto by_hand = [](Parameters& p) {
    p.mode = OperatorMode::gesture;
    p.clutch_button = -1;
    p.gesture_topic.clear();
  };
  EXPECT_NE(faults_with(by_hand).find("needs a clutch: set clutch_button or clutch_axis"), std::string::npos);
  EXPECT_NE(faults_with(by_hand).find("needs a hand: set gesture_topic"), std::string::npos);
  const auto with_axis = [&](Parameters& p) {
    by_hand(p);
    p.clutch_axis = {0};
    p.gesture_frame = "hand";
    p.gesture_parent_frame = "room";
  };
  EXPECT_EQ(faults_with(with_axis), "");
}

TEST(BrakingLimits, EitherSignAndZeroForTheAcceleration) {
  Parameters p;
  EXPECT_EQ(p.braking_x(), 2.5);
  EXPECT_EQ(p.braking_theta(), 3.2);
  p.decel_lim_x = -1.5;
  p.decel_lim_theta = 2.0;
  EXPECT_EQ(p.braking_x(), 1.5);
  EXPECT_EQ(p.braking_theta(), 2.0);
}

TEST(SplitNames, CommasBracketsAndQuotes) {
  const std::vector<std::string> expected{"PathDist", "GoalDist"};
  for (const char* text : {"PathDist, GoalDist", "[PathDist, GoalDist]", "['PathDist','GoalDist']", "PathDist GoalDist",
                           "\"PathDist\";\"GoalDist\",", "\tPathDist\n GoalDist"}) {
    EXPECT_EQ(split_names(text), expected) << text;
  }
  EXPECT_TRUE(split_names("").empty());
  EXPECT_TRUE(split_names("[]").empty());
  EXPECT_EQ(split_names("my_pkg/MyCritic").front(), "my_pkg/MyCritic");
}

}  // namespace
}  // namespace hidwa_local_planner
