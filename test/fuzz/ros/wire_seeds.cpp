// SPDX-License-Identifier: BSD-3-Clause
// Writes the first files of corpus/messages and corpus/bag: a message of each kind, and a recorded drive as bags.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/serialization.h>

#include "hidwa_local_planner/Cycle.h"
#include "hidwa_local_planner/MovingObstacles.h"
#include "support/recorded_drive.hpp"
#include "support/wire_bytes.hpp"

namespace hidwa_local_planner {
namespace {

namespace fs = std::filesystem;
using test::WireBytes;

void write(const fs::path& path, int kind, const std::vector<std::uint8_t>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.put(static_cast<char>(kind));  // as messages.cpp reads it
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

template <typename Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

nav_msgs::Path path() {
  nav_msgs::Path path;
  for (int k = 0; k < 5; ++k) {
    path.poses.emplace_back();
    path.poses.back().header.frame_id = "map";
    path.poses.back().pose.position.x = 0.1 * k;
    path.poses.back().pose.orientation.w = 1.0;
  }
  return path;
}

nav_msgs::Odometry odometry() {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(10.0);
  odometry.header.frame_id = "odom";
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.orientation.w = 1.0;
  odometry.twist.twist.linear.x = 0.3;
  return odometry;
}

MovingObstacles movers(const std::string& frame) {
  MovingObstacles movers;
  movers.header.stamp = ros::Time(9.9);
  movers.header.frame_id = frame;
  for (std::uint32_t k = 0; k < 2; ++k) {
    movers.obstacles.emplace_back();
    movers.obstacles.back().id = k;
    movers.obstacles.back().position.x = 2.0 + k;
    movers.obstacles.back().velocity.y = 0.5;
    movers.obstacles.back().radius = 0.25;
    movers.obstacles.back().points.resize(k);
  }
  return movers;
}

void write_messages(const fs::path& folder) {
  write(folder / "path", 0, bytes_of(path()));
  write(folder / "odometry", 1, bytes_of(odometry()));
  write(folder / "movers_elsewhere", 2, bytes_of(movers("laser")));
  write(folder / "movers", 3, bytes_of(movers("odom")));
  WireBytes people;
  people.header("odom", 10).count(2).person("anna", 3.0, 1.0, 0.5, -0.25).person("bo", -2.0, 0.0, 0.0, 0.0);
  write(folder / "people", 4, people.all());
  WireBytes array;
  array.header("odom", 10).count(2);
  array.obstacle(7, {{1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}}, 0.25, 0.5, 0.25, {1.0, 0.1, 1.0});
  array.obstacle(8, {{1.0, -1.0}}, 0.3, 0.0, 0.4, {0.1, 0.0, 0.1});
  write(folder / "obstacles", 5, array.all());
}

// What bag.cpp reads first: not cut, the compression, chunks of 12800 bytes.
std::ofstream begin_bag(const fs::path& path, char compression) {
  std::ofstream file(path, std::ios::binary);
  file.put(1).put(compression).put(static_cast<char>(200));
  return file;
}

// A text, after the two bytes that bag.cpp reads its length from.
void put(std::ofstream& file, std::size_t length, const std::uint8_t* bytes, std::size_t size) {
  file.put(static_cast<char>(length & 0xffU)).put(static_cast<char>(length >> 8U));
  file.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
}

void write_bag(const fs::path& path, char compression, int cycles) {
  std::ofstream file = begin_bag(path, compression);
  test::RecordedDrive drive(1, OperatorMode::joystick);
  char time = 10;
  for (const test::RecordedDrive::Cycle& cycle : drive.run(cycles)) {
    file.put(0).put(++time).put(0).put(0);  // the topic, its time, a cycle well formed ...
    file.put(time).put(0);                  // ... of that time
    put(file, cycle.record.size(), cycle.record.data(), cycle.record.size());
  }
}

// A bag with one cycle whose list of names is longer than memory.
void write_lie(const fs::path& path) {
  Cycle message;
  std::vector<std::uint8_t> bytes = bytes_of(message);
  // The header's 16 bytes, the outcome, two texts' lengths, twelve numbers of 8 bytes and four of 4: 16 + 1 + 8 + 96 +
  // 16 = 137.
  std::fill_n(bytes.begin() + 137, 4, std::uint8_t{0xff});
  std::ofstream file = begin_bag(path, 0);
  file.put(0).put(10).put(0).put(1).put(0);  // the topic, its time, bytes as they are, the type of cycles
  put(file, bytes.size() - 1, bytes.data(), bytes.size());  // a length of 0 stands for 1
}

}  // namespace
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  using namespace hidwa_local_planner;
  if (argc != 2) {
    std::fprintf(stderr, "hidwa_wire_seeds FOLDER\n");
    return 2;
  }
  const fs::path folder(argv[1]);
  for (const char* name : {"messages", "bag"}) fs::create_directories(folder / name);
  write_messages(folder / "messages");
  write_bag(folder / "bag" / "plain", 0, 2);
  write_bag(folder / "bag" / "bz2", 1, 2);
  write_bag(folder / "bag" / "lz4", 2, 1);
  write_lie(folder / "bag" / "mended_length");
  return 0;
}
