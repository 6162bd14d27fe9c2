// SPDX-License-Identifier: BSD-3-Clause
#include "sim/occupancy_map.hpp"

#include <string>

#include <gtest/gtest.h>

#include "temporary_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

std::string yaml(const std::string& image, const std::string& origin = "[1.0, 2.0, 0.0]", const char* negate = "0") {
  return "image: " + image + "\nresolution: 0.5\norigin: " + origin + "\nnegate: " + negate +
         "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

TEST(Map, PlainAndBinaryImagesGiveTheSame) {
  TemporaryFolder folder;
  // Top row: black, white, grey 205; bottom row: white, white, black.
  folder.write("a.pgm", "P2\n# a comment\n3 2\n255\n0 254 205\n254 254 0\n");
  folder.write("b.pgm", std::string("P5 3 2 255\n") + std::string("\x00\xfe\xcd\xfe\xfe\x00", 6));
  for (const char* image : {"a.pgm", "b.pgm"}) {
    const OccupancyMap map = load_map(folder.write("map.yaml", yaml(image)));
    ASSERT_EQ(map.width, 3);
    ASSERT_EQ(map.height, 2);
    EXPECT_TRUE(map.occupied(0, 1));  // the image's top row is the map's upper one
    EXPECT_TRUE(map.occupied(2, 0));
    EXPECT_EQ(map.cells[map.index(1, 0)], Cell::kFree);
    // (255 - 205) / 255 = 0.19608 is not below 0.196: unknown.
    EXPECT_EQ(map.cells[map.index(2, 1)], Cell::kUnknown);
    EXPECT_FALSE(map.occupied(3, 0));  // outside
    EXPECT_DOUBLE_EQ(map.center_x(0), 1.25);
    EXPECT_EQ(map.column(1.49), 0);
    EXPECT_EQ(map.row(2.51), 1);
  }
}

TEST(Map, NegateTurnsTheScale) {
  TemporaryFolder folder;
  folder.write("a.pgm", "P2 2 1 255 0 255");
  const OccupancyMap map = load_map(folder.write("map.yaml", yaml("a.pgm", "[0, 0, 0]", "1")));
  EXPECT_FALSE(map.occupied(0, 0));
  EXPECT_TRUE(map.occupied(1, 0));
}

TEST(Map, FaultsAreNamed) {
  TemporaryFolder folder;
  folder.write("a.pgm", "P2 2 1 255 0 255");
  folder.write("short.pgm", "P2 2 2 255 0 255");
  folder.write("picture.png", "\x89PNG");
  folder.write("vast.pgm", "P5 100000 100000 255 0");  // 80 GB, if it were true
  const auto fault = [&](const std::string& text) {
    return error_of([&] { load_map(folder.write("map.yaml", text)); });
  };
  EXPECT_NE(fault(yaml("a.pgm", "[0, 0, 0.5]")).find("yaw"), std::string::npos);
  EXPECT_NE(fault(yaml("missing.pgm")).find("missing.pgm"), std::string::npos);
  EXPECT_NE(fault(yaml("short.pgm")).find("ends before"), std::string::npos);
  EXPECT_NE(fault(yaml("vast.pgm")).find("ends before"), std::string::npos);
  EXPECT_NE(fault(yaml("a.pgm", "[.nan, 0, 0]")).find("'origin'"), std::string::npos);
  EXPECT_NE(fault(yaml("a.pgm", "[0, .inf, 0]")).find("'origin'"), std::string::npos);
  EXPECT_NE(fault("resolution: .inf\norigin: [0, 0, 0]\n").find("'resolution'"), std::string::npos);
  EXPECT_NE(fault(yaml("picture.png")).find("PGM"), std::string::npos);
  EXPECT_NE(fault("image: a.pgm\n").find("resolution"), std::string::npos);
  EXPECT_NE(fault(yaml("a.pgm") + "mode: scale\n").find("trinary"), std::string::npos);
  EXPECT_NE(error_of([] { load_map("/nowhere/map.yaml"); }).find("/nowhere/map.yaml"), std::string::npos);
}

TEST(Map, OfficeIsReadable) {
  const OccupancyMap map = load_map(HIDWA_MAPS_DIR "/office.yaml");
  EXPECT_DOUBLE_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.width, 1240);  // 60 m and a margin of 1 m on both sides
  EXPECT_EQ(map.height, 640);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
