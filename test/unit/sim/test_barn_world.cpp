// SPDX-License-Identifier: BSD-3-Clause
#include "sim/barn_world.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "temporary_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

// Straight up column 15, from row 0 to the last one.
std::string straight_path(int rows = 30) {
  std::string path;
  for (int row = 0; row < rows; ++row) path += " 15:" + std::to_string(row);
  return path;
}

TEST(BarnWorld, IsReadWithItsGeometry) {
  TemporaryFolder folder;
  const std::string file = folder.write("worlds.txt", "# head\n\n7 | 0:0 2:3 |" + straight_path() + "\r\n");
  const std::vector<BarnWorld> worlds = load_barn_worlds(file);
  ASSERT_EQ(worlds.size(), 1u);
  EXPECT_EQ(worlds[0].index, 7);
  ASSERT_EQ(worlds[0].cylinders.size(), 2u);
  EXPECT_NEAR(worlds[0].cylinders[1].x(), -0.375, 1e-12);  // -0.075 - 2 * 0.15
  EXPECT_NEAR(worlds[0].cylinders[1].y(), 0.525, 1e-12);   // 0.075 + 3 * 0.15
  ASSERT_EQ(worlds[0].path.size(), 30u);
  EXPECT_NEAR(worlds[0].path[0].x(), -2.325, 1e-12);  // 15 * 0.15 - 4.575
  EXPECT_NEAR(worlds[0].path[29].y(), 9.425, 1e-12);  // 29 * 0.15 + 5.075
  // From (-2.25, 3) to the path, 29 steps of it, and on to (-2.25, 13).
  const double expected = std::hypot(0.075, 5.075 - 3.0) + 29 * 0.15 + std::hypot(0.075, 13.0 - 9.425);
  EXPECT_NEAR(reference_length(worlds[0]), expected, 1e-12);
}

TEST(BarnWorld, FaultsNameTheLineAndTheRemedy) {
  TemporaryFolder folder;
  const std::string good = "1 | 0:0 |" + straight_path() + "\n";
  const auto fault = [&folder](const std::string& text) {
    const std::string file = folder.write("worlds.txt", text);
    return error_of([&file] { load_barn_worlds(file); });
  };
  const auto expect = [&](const std::string& line, const std::string& part) {
    const std::string text = fault("# head\n" + good + line + "\n");
    EXPECT_NE(text.find("worlds.txt' line 3: "), std::string::npos) << text;
    EXPECT_NE(text.find(part), std::string::npos) << line << ": " << text;
    EXPECT_NE(text.find("correct the line, or remove it"), std::string::npos) << text;
  };
  expect("2 | 0:0 0:1", "2 parts, not three");
  expect("2 | 0:0 | 1:1 | 2:2", "4 parts, not three");
  expect("2 | 0:0 |" + straight_path(20), "ends in row 19, not 29: the line is cut off");
  expect("2 | 0:0 |" + straight_path(3) + " 15:9", "leaps from 15:2 to 15:9");
  expect("2 | 0:0 |", "there is no path");
  expect("2 | |" + straight_path(), "there are no cells");
  expect("2 | 0:0 1 |" + straight_path(), "'1' is not two numbers");
  expect("2 | 0:0 1:2:3 |" + straight_path(), "'1:2:3' is not two numbers");
  expect("2 | 0:0 1:x |" + straight_path(), "'x' is not a whole number");
  expect("2 | 0:0 1: |" + straight_path(), "'' is not a whole number");
  expect("2 | 0:0 -1:2 |" + straight_path(), "-1 is not within 0 to 999");
  expect("two | 0:0 |" + straight_path(), "'two' is not a whole number");
  expect("2 3 | 0:0 |" + straight_path(), "the index '2 3' is not one number");
  expect("1 | 0:0 |" + straight_path(), "world 1 is there twice");
  EXPECT_EQ(fault(good), "");
  EXPECT_NE(fault("# nothing\n").find("holds no world"), std::string::npos);
  EXPECT_NE(error_of([] { load_barn_worlds("/nowhere/worlds.txt"); }).find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
