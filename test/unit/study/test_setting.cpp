// SPDX-License-Identifier: BSD-3-Clause
#include "study/setting.hpp"

#include <gtest/gtest.h>

#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::string fault_of(const std::string& text) {
  Subject subject;
  try {
    assign(subject, parse_assignment(text));
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(Setting, SetsEveryKindOfValue) {
  Subject subject;
  for (const char* text : {"s_v=123.5", "vx_samples=7", "record_cycles=true", "generator=dwa",
                           "participant.look_ahead=2", "link_delay=0.2", "critics=PathDist, GoalDist"}) {
    assign(subject, parse_assignment(text));
  }
  EXPECT_EQ(subject.parameters.s_v, 123.5);
  EXPECT_EQ(subject.parameters.vx_samples, 7);
  EXPECT_TRUE(subject.parameters.record_cycles);
  EXPECT_EQ(subject.parameters.generator, Generator::dwa);
  EXPECT_EQ(subject.participant.look_ahead, 2.0);
  EXPECT_EQ(subject.link_delay, 0.2);
  EXPECT_EQ(subject.parameters.critics, "PathDist, GoalDist");
}

TEST(Setting, FaultsNameTheThingAndTheRemedy) {
  EXPECT_NE(fault_of("s_w=1").find("no parameter 's_w'"), std::string::npos);
  EXPECT_NE(fault_of("s_v=much").find("s_v needs a number"), std::string::npos);
  EXPECT_NE(fault_of("s_v=nan"), "");
  EXPECT_NE(fault_of("vx_samples=2.5").find("whole number"), std::string::npos);
  EXPECT_NE(fault_of("record_cycles=yes").find("true or false"), std::string::npos);
  EXPECT_NE(fault_of("generator=best"), "");
  EXPECT_NE(fault_of("participant.mood=1").find("there are reaction_time"), std::string::npos);
  EXPECT_NE(fault_of("link_delay=-1"), "");
  EXPECT_NE(fault_of("mode=joystick").find("--conditions"), std::string::npos);
  EXPECT_NE(fault_of("guard=none").find("--guard"), std::string::npos);
  EXPECT_NE(fault_of("s_v").find("name=value"), std::string::npos);
  EXPECT_EQ(fault_of("delta=1"), "");
}

TEST(Setting, CombinationsAreAllOfThem) {
  const std::vector<Setting> settings = combinations({"s_v=1,2", "delta=0,1,2"});
  ASSERT_EQ(settings.size(), 6u);
  EXPECT_EQ(to_string(settings[0]), "s_v=1;delta=0");
  EXPECT_EQ(to_string(settings[1]), "s_v=1;delta=1");
  EXPECT_EQ(to_string(settings[5]), "s_v=2;delta=2");
  ASSERT_EQ(combinations({}).size(), 1u);
  EXPECT_EQ(to_string(combinations({})[0]), "default");
  for (const char* bad : {"s_v", "s_v=1,,2", "s_v=1,1", "=1"}) EXPECT_THROW(combinations({bad}), UsageError) << bad;
  EXPECT_THROW(combinations({"s_v=1", "s_v=2"}), UsageError);
}

TEST(Setting, VariationsAreOneAtATime) {
  const std::vector<Setting> settings = variations({"s_v=1,2", "delta=0"});
  ASSERT_EQ(settings.size(), 4u);
  EXPECT_EQ(to_string(settings[0]), "default");
  EXPECT_EQ(to_string(settings[2]), "s_v=2");
  EXPECT_EQ(to_string(settings[3]), "delta=0");
  EXPECT_THROW(variations({"delta=0", "delta=1"}), UsageError);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
