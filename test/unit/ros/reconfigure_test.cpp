// SPDX-License-Identifier: BSD-3-Clause
// cfg/HIDWAPlanner.cfg against the parameters' one declaration.
#include "ros/reconfigure.hpp"

#include <limits>
#include <map>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

using Messages = std::map<std::string, ParameterValue>;

Messages values_of(const HIDWAPlannerConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  Messages values;
  for (const auto& v : message.bools) values[v.name] = static_cast<bool>(v.value);
  for (const auto& v : message.ints) values[v.name] = v.value;
  for (const auto& v : message.doubles) values[v.name] = v.value;
  for (const auto& v : message.strs) values[v.name] = v.value;
  return values;
}

double as_number(const ParameterValue& value) {
  if (const int* whole = std::get_if<int>(&value)) return *whole;
  return std::get<double>(value);
}

TEST(Reconfigure, DefaultsAndRangesAreTheDeclaredOnes) {
  const Messages defaults = values_of(HIDWAPlannerConfig::__getDefault__());
  const Messages low = values_of(HIDWAPlannerConfig::__getMin__());
  const Messages high = values_of(HIDWAPlannerConfig::__getMax__());
  EXPECT_EQ(defaults.size(), parameter_table().size());
  for (const ParameterInfo& info : parameter_table()) {
    ASSERT_EQ(defaults.count(info.name), 1u) << info.name;
    EXPECT_EQ(defaults.at(info.name), info.value) << info.name;
    if (info.type != "double" && info.type != "int") continue;
    EXPECT_EQ(as_number(low.at(info.name)), info.min) << info.name;
    EXPECT_EQ(as_number(high.at(info.name)), info.max) << info.name;
  }
}

TEST(Reconfigure, DescriptionsEndWithTheUnitAndChoicesAreListed) {
  std::map<std::string, dynamic_reconfigure::ParamDescription> described;
  std::map<std::string, std::string> tab_of;
  for (const auto& group : HIDWAPlannerConfig::__getDescriptionMessage__().groups) {
    if (!group.parameters.empty()) {
      EXPECT_EQ(group.type, "tab") << group.name;
    }
    for (const auto& parameter : group.parameters) {
      described[parameter.name] = parameter;
      tab_of[parameter.name] = group.name;
    }
  }
  for (const ParameterInfo& info : parameter_table()) {
    ASSERT_EQ(described.count(info.name), 1u) << info.name;
    const dynamic_reconfigure::ParamDescription& parameter = described.at(info.name);
    const std::string text = info.unit.empty() ? info.description : info.description + " [" + info.unit + "]";
    EXPECT_EQ(parameter.description, text);
    EXPECT_EQ(tab_of.at(info.name).rfind(info.tab, 0), 0u) << info.name << " in " << tab_of.at(info.name);
    for (const std::string& choice : info.choices) {
      EXPECT_NE(parameter.edit_method.find("'value': '" + choice + "'"), std::string::npos)
          << info.name << ": " << choice;
    }
  }
}

TEST(Reconfigure, ParametersThereAndBack) {
  Parameters p;
  p.max_vel_x = 0.77;
  p.vx_samples = 13;
  p.record_cycles = true;
  p.critics = "PathDist";
  p.generator = Generator::dwa;
  p.method = Method::paper;
  std::vector<std::string> faults;
  const Parameters back = from_config(to_config(p), faults);
  EXPECT_TRUE(faults.empty());
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(get_parameter(back, info.name), get_parameter(p, info.name)) << info.name;
  }
}

TEST(Reconfigure, UnknownNamesOfChoicesAreFaults) {
  HIDWAPlannerConfig config = to_config(Parameters());
  config.generator = "teb";
  config.method = "DWB";
  std::vector<std::string> faults;
  from_config(config, faults);
  EXPECT_EQ(faults.size(), 2u);
  config = to_config(Parameters());
  config.mode = "False";  // dynparam's off
  faults.clear();
  EXPECT_EQ(from_config(config, faults).mode, OperatorMode::off);
  EXPECT_TRUE(faults.empty());
}

TEST(Reconfigure, NothingIsCutToItsRange) {
  StrictConfig config(to_config(Parameters()));
  config.max_vel_x = 99.0;
  config.__clamp__();
  EXPECT_EQ(config.max_vel_x, 99.0);
}

}  // namespace
}  // namespace hidwa_local_planner
