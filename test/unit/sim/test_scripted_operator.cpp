// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scripted_operator.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "temporary_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// Times [s] at which the stick changes, and to what, for a robot driving along x at 0.5 m/s, seen at 20 Hz.
struct Change {
  double time;
  double left;
};

std::vector<Change> changes(ScriptedOperator& person, double seconds) {
  std::vector<Change> result;
  double left = 0.0;
  for (int i = 0; i <= static_cast<int>(seconds * 20); ++i) {
    const double t = 0.05 * i;
    const Stick stick = person.update({t, {0.5 * t, 0.0, 0.0}, {0.5, 0.0}});
    if (stick.left != left) result.push_back({t, stick.left});
    left = stick.left;
  }
  return result;
}

TEST(ScriptedOperator, DistanceAndPlaceBeginEntriesInOrder) {
  TemporaryFolder folder;
  ScriptedOperator person(load_script(folder.write("s.yaml",
                                                   "- {after_m: 12.0, for_s: 3.0, stick: [1.0, 0.0]}\n"
                                                   "- {when_x_above: 1.0, for_s: 1.0, stick: [-0.5, 0]}\n")));
  // 12 m at 0.5 m/s: 24 s, until 27 s. x > 1 holds all along but waits for the first to end.
  const std::vector<Change> seen = changes(person, 40.0);
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_NEAR(seen[0].time, 24.0, 0.051);
  EXPECT_EQ(seen[0].left, 1.0);
  EXPECT_NEAR(seen[1].time - seen[0].time, 3.0, 1e-9);
  EXPECT_EQ(seen[1].left, -0.5);
  EXPECT_NEAR(seen[2].time - seen[1].time, 1.0, 1e-9);
  EXPECT_EQ(seen[2].left, 0.0);
}

TEST(ScriptedOperator, AllConditionsGivenMustHold) {
  TemporaryFolder folder;
  ScriptedOperator person(
      load_script(folder.write("s.yaml", "- {after_m: 1.0, when_y_above: 1.0, for_s: 1.0, stick: [1, 0]}\n")));
  EXPECT_TRUE(changes(person, 10.0).empty());
  EXPECT_EQ(person.update({20.0, {5.0, 2.0, 0.0}, {}}).left, 1.0);
}

TEST(ScriptedOperator, FaultsAreNamed) {
  TemporaryFolder folder;
  const auto fault = [&](const std::string& text) {
    return error_of([&] { load_script(folder.write("s.yaml", text)); });
  };
  EXPECT_NE(fault("after_m: 1\n").find("list"), std::string::npos);
  EXPECT_NE(fault("- {for_s: 1.0, stick: [1, 0]}\n").find("entry 1"), std::string::npos);
  EXPECT_NE(fault("- {after_m: 1, for_s: 0, stick: [1, 0]}\n").find("for_s"), std::string::npos);
  EXPECT_NE(fault("- {after_m: 1, for_s: 1, stick: [1.5, 0]}\n").find("stick"), std::string::npos);
  EXPECT_NE(fault("- {after_m: 1, for_s: 1, stick: [1, 0], until: 3}\n").find("until"), std::string::npos);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
