// SPDX-License-Identifier: BSD-3-Clause
// The YAML files that ship with the planner, as the parameter server holds them: every key known, every set
// valid.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include "ros/parameter_loading.hpp"

namespace hidwa_plugin_tests {
namespace {

using namespace hidwa_local_planner;

LoadedParameters load(const std::string& file) {
  XmlRpc::XmlRpcValue content;
  EXPECT_TRUE(ros::param::get("/files/" + file + "/HIDWAPlannerROS", content)) << file;
  return load_parameters(content);
}

class ParameterFile : public ::testing::TestWithParam<const char*> {};

TEST_P(ParameterFile, IsKnownAndValid) {
  const LoadedParameters loaded = load(GetParam());
  EXPECT_FALSE(loaded.found.empty());
  for (const std::string& fault : loaded.faults) ADD_FAILURE() << fault;
  for (const std::string& warning : loaded.warnings) ADD_FAILURE() << warning;
}

INSTANTIATE_TEST_SUITE_P(All, ParameterFile,
                         ::testing::Values("barn", "dwa", "hidwa", "jackal", "paper", "pmb2", "telepresence_base",
                                           "turtlebot3"),
                         [](const auto& file) { return std::string(file.param); });

TEST(ParameterFiles, HidwaHoldsTheDefaults) {
  const Parameters parameters = load("hidwa").parameters;
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(get_parameter(parameters, info.name), info.value) << info.name;
  }
}

}  // namespace
}  // namespace hidwa_plugin_tests
