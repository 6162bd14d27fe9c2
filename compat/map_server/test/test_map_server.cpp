// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <map_server/image_loader.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace map_server {
namespace {

MapDescription described(Mode mode) {
  MapDescription description;
  description.resolution = 0.05;
  description.occupied_thresh = 0.65;
  description.free_thresh = 0.196;
  description.mode = mode;
  return description;
}

std::string file(const std::string& name, const std::string& content) {
  const std::string path = testing::TempDir() + "map_server_" + name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string message(const std::string& yaml) {
  try {
    readDescription(yaml);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "";
}

TEST(Occupancy, Trinary) {
  const auto description = described(Mode::kTrinary);
  EXPECT_EQ(occupancy(0, 255, description), 100);
  EXPECT_EQ(occupancy(254, 255, description), 0);   // (255 - 254) / 255 = 0.004
  EXPECT_EQ(occupancy(205, 255, description), -1);  // 0.19608, just above 0.196
  EXPECT_EQ(occupancy(206, 255, description), 0);   // 0.19216
  EXPECT_EQ(occupancy(89, 255, description), 100);  // 0.65098
  EXPECT_EQ(occupancy(90, 255, description), -1);   // 0.647
}

TEST(Occupancy, Negated) {
  auto description = described(Mode::kTrinary);
  description.negate = true;
  EXPECT_EQ(occupancy(0, 255, description), 0);
  EXPECT_EQ(occupancy(255, 255, description), 100);
}

TEST(Occupancy, Scale) {
  const auto description = described(Mode::kScale);
  EXPECT_EQ(occupancy(128, 255, description), 66);  // 1 + 98 (0.49804 - 0.196) / 0.454 = 66.2
  EXPECT_EQ(occupancy(128, 0, description), -1);    // transparent
}

TEST(Occupancy, Raw) {
  EXPECT_EQ(occupancy(42, 255, described(Mode::kRaw)), 42);
  EXPECT_EQ(occupancy(255, 255, described(Mode::kRaw)), -1);
}

TEST(Picture, GreyRowsFromTheTopMapRowsFromTheBottom) {
  const std::string path = file("grey.pgm", std::string("P5\n3 2\n255\n") + std::string("\x00\xfe\xfe\xfe\xcd\x00", 6));
  auto description = described(Mode::kTrinary);
  description.origin = {1.0, 2.0, 0.5};
  const auto map = makeMap(readPicture(path, description.mode), description);
  EXPECT_EQ(map.info.width, 3u);
  EXPECT_EQ(map.info.height, 2u);
  EXPECT_EQ((std::vector<int>(map.data.begin(), map.data.end())), (std::vector<int>{0, -1, 100, 100, 0, 0}));
  EXPECT_NEAR(2.0 * std::atan2(map.info.origin.orientation.z, map.info.origin.orientation.w), 0.5, 1e-12);
}

TEST(Picture, ColourCountsByItsMean) {
  const std::string path = file("colour.ppm", std::string("P6\n1 1\n255\n") + std::string("\xff\x00\x33", 3));
  EXPECT_DOUBLE_EQ(readPicture(path, Mode::kTrinary).grey.at(0), (255 + 0 + 51) / 3.0);
}

TEST(Picture, AMissingImageIsNamed) {
  EXPECT_THROW(readPicture("/nowhere/map.png", Mode::kTrinary), std::runtime_error);
}

TEST(Description, ReadsTheFileAndResolvesTheImage) {
  const auto description =
      readDescription(file("good.yaml",
                           "image: maps/office.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.25]\nnegate: 0\n"
                           "occupied_thresh: 0.65\nfree_thresh: 0.196\nmode: scale\n"));
  EXPECT_EQ(description.image, testing::TempDir() + "maps/office.pgm");
  EXPECT_DOUBLE_EQ(description.origin[2], 0.25);
  EXPECT_EQ(description.mode, Mode::kScale);
  EXPECT_FALSE(description.negate);
}

TEST(Description, FaultsNameTheKey) {
  EXPECT_NE(message(file("no_image.yaml", "resolution: 0.05\n")).find("\"image\""), std::string::npos);
  EXPECT_NE(message(file("bad_mode.yaml",
                         "image: a.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: "
                         "0.65\nfree_thresh: 0.196\n"
                         "mode: colour\n"))
                .find("trinary, scale or raw"),
            std::string::npos);
  EXPECT_NE(message("/nowhere.yaml").find("/nowhere.yaml"), std::string::npos);
  EXPECT_NE(message(file("text.yaml", "just words")).find("not a map description"), std::string::npos);
}

}  // namespace
}  // namespace map_server
