// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/ros/critic_loading.hpp"
#include "hidwa_local_planner/ros/parameter_set.hpp"

namespace hidwa_local_planner {
namespace {

TEST(StoredParameters, NumbersAndFlagsWithFallbacks) {
  XmlRpc::XmlRpcValue content;
  content["limit"] = 0.5;
  content["count"] = 3;
  content["strict"] = true;
  content["name"] = "x";
  const StoredParameters own("TurnLimit", content);
  EXPECT_EQ(own.number("limit", 1.0), 0.5);
  EXPECT_EQ(own.number("count", 1.0), 3.0);
  EXPECT_EQ(own.number("missing", 1.5), 1.5);
  EXPECT_EQ(own.number("name", 2.5), 2.5);  // said, and the fallback taken
  EXPECT_TRUE(own.flag("strict", false));
  EXPECT_TRUE(own.flag("missing", true));
  EXPECT_FALSE(own.flag("limit", false));
}

TEST(StoredParameters, OfACriticByItsShortName) {
  ParameterSet set;
  set.content["TurnLimit"]["limit"] = 0.25;
  EXPECT_EQ(set.source_for("some_package/TurnLimit")->number("limit", 1.0), 0.25);
  EXPECT_EQ(set.source_for("Other")->number("limit", 1.0), 1.0);
  EXPECT_EQ(ParameterSet().source_for("Other")->number("limit", 1.0), 1.0);
}

// What a record holds: only critics of other packages, and every number to the bit.
TEST(ParameterSet, ForeignCriticsGoThroughXml) {
  ParameterSet set;
  set.parameters.critics = "PathDist, some_package/TurnLimit, Silent";
  set.content["TurnLimit"]["limit"] = 1.0 / 3.0;
  set.content["TurnLimit"]["strict"] = true;
  set.content["PathDist"]["scale"] = 7.0;
  set.content["sim_time"] = 1.0;
  const std::string text = foreign_content(set);
  EXPECT_EQ(text.find("PathDist"), std::string::npos);
  EXPECT_EQ(text.find("sim_time"), std::string::npos);
  const ParameterSet read = with_foreign_content(text);
  EXPECT_EQ(read.source_for("some_package/TurnLimit")->number("limit", 0.0), 1.0 / 3.0);
  EXPECT_TRUE(read.source_for("some_package/TurnLimit")->flag("strict", false));
  set.parameters.critics = "PathDist";
  EXPECT_EQ(foreign_content(set), "");
  EXPECT_EQ(foreign_content(ParameterSet()), "");
  for (const char* bad : {"", "no xml", "<value><struct>"}) {
    EXPECT_EQ(with_foreign_content(bad).source_for("TurnLimit")->number("limit", 4.0), 4.0) << bad;
  }
}

TEST(ParameterSet, FaultsNameUnknownCriticsAndWhatThereIs) {
  ParameterSet set;
  set.parameters.critics = "PathDist, NoSuchCritic";
  const auto faults = faults_of(set, critics::built_in());
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("NoSuchCritic"), std::string::npos);
  EXPECT_NE(faults[0].find("GoalDist"), std::string::npos);
  set.parameters.critics = "PathDist";
  EXPECT_TRUE(faults_of(set, critics::built_in()).empty());
}

TEST(ParameterSet, ACriticThatCannotBeMadeIsAFault) {
  CriticRegistry registry = critics::built_in();
  registry.add("Broken", [] { return std::shared_ptr<Critic>(); });
  ParameterSet set;
  set.parameters.critics = "PathDist, Broken";
  const auto faults = faults_of(set, registry);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("Broken"), std::string::npos);
}

}  // namespace
}  // namespace hidwa_local_planner
