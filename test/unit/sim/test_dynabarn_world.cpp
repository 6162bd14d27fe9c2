// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/contact.hpp"
#include "sim/dynabarn_world.hpp"
#include "temporary_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

std::string fault_of(const std::string& text) {
  TemporaryFolder folder;
  return error_of([&] { load_dynabarn_worlds(folder.write("worlds.txt", text)); });
}

TEST(DynabarnWorlds, AreReadLineByLine) {
  TemporaryFolder folder;
  const std::string file = folder.write(
      "worlds.txt", "# head\n\n3 easy | a 0:1:2 1.5:-3:4.25 | b_7 0:0:0 2:1:1 4:2:-1.5\r\n12 hard | c 0:9:9 1:8:8\n");
  const std::vector<DynabarnWorld> worlds = load_dynabarn_worlds(file);
  ASSERT_EQ(worlds.size(), 2U);
  EXPECT_EQ(worlds[0].index, 3);
  EXPECT_EQ(worlds[0].difficulty, "easy");
  ASSERT_EQ(worlds[0].tracks.size(), 2U);
  ASSERT_EQ(worlds[0].tracks[0].size(), 2U);
  EXPECT_EQ(worlds[0].tracks[0][1].time, 1.5);
  EXPECT_EQ(worlds[0].tracks[0][1].position, Eigen::Vector2d(-3.0, 4.25));
  EXPECT_EQ(worlds[0].tracks[1].size(), 3U);
  EXPECT_EQ(worlds[1].difficulty, "hard");
}

TEST(DynabarnWorlds, BrokenFilesAreRefusedWithLineAndRemedy) {
  const std::string good = "1 easy | a 0:1:2 1:3:4\n";
  const std::vector<std::pair<std::string, std::string>> broken{
      {"", "holds no world"},
      {good + good, "line 2: world 1 is there twice"},
      {good + "x easy | a 0:1:2 1:3:4\n", "line 2: the index 'x'"},
      {"100 easy | a 0:1:2 1:3:4\n", "line 1: the index '100' is not within 0 to 99"},
      {"1 simple | a 0:1:2 1:3:4\n", "easy, medium or hard"},
      {"1 easy now | a 0:1:2 1:3:4\n", "easy, medium or hard alone"},
      {"1 easy\n", "there are no obstacles"},
      {"1 easy |\n1 easy | a 0:1:2 1:3:4 |  \n", "line 1: there are no obstacles"},
      {"1 easy | a 0:1:2 1:3:4 |  \n", "line 1: an obstacle is empty"},
      {"1 easy | a 0:1:2\n", "the obstacle 'a': a track needs two key frames"},
      {"1 easy | a 0:1:2 1:3\n", "the key frame '1:3' is not three numbers"},
      {"1 easy | a 0:1:2 1:3:4:5\n", "the key frame '1:3:4:5' is not three numbers"},
      {"1 easy | a 0:1:2 1:three:4\n", "the key frame '1:three:4' is not three numbers"},
      {"1 easy | a 0:1:2 1:nan:4\n", "the key frame '1:nan:4' is not three numbers"},
      {"1 easy | a 0:1:2 1:1e9:4\n", "the key frame '1:1e9:4' is out of bounds"},
      {"1 easy | a 0:1:2 -1:3:4\n", "out of bounds"},
      {"1 easy | a 1:1:2 2:3:4\n", "first key frame must be at time 0"},
      {"1 easy | a 0:1:2 2:3:4 2:5:6\n", "must rise"}};
  for (const auto& [text, part] : broken)
    EXPECT_NE(fault_of(text).find(part), std::string::npos) << text << fault_of(text);
  EXPECT_NE(fault_of("1 easy\n").find("correct the line, or remove it"), std::string::npos);
  EXPECT_THROW(load_dynabarn_worlds("/nowhere"), std::runtime_error);
}

TEST(DynabarnWorlds, TheCourtHasThreeWallsAndAnOpenSide) {
  const OccupancyMap court = dynabarn_court(0.05);
  const auto wall = [&](double x, double y) { return court.occupied(court.column(x), court.row(y)); };
  EXPECT_TRUE(wall(-10.2, 0.0) && wall(-9.8, 0.0) && wall(0.0, 10.2) && wall(0.0, 9.8) && wall(0.0, -10.0));
  EXPECT_FALSE(wall(-9.7, 0.0) || wall(-10.3, 0.0) || wall(0.0, 9.7) || wall(10.0, 0.0) || wall(12.0, 9.0));
  EXPECT_TRUE(court.inside(court.column(dynabarn_start().x), court.row(dynabarn_start().y)));
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
