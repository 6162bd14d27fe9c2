// SPDX-License-Identifier: BSD-3-Clause
// What moves is part of a record, where anything does.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace {

record::CycleRecord faulty_cycle() {
  record::CycleRecord cycle;
  cycle.observation.fault = "no odometry";  // such a record needs no costmap
  return cycle;
}

Bytes encoded(const record::CycleRecord& cycle) {
  Bytes bytes;
  record::encode(cycle, bytes);
  return bytes;
}

// Into a record that held something else before.
record::CycleRecord decoded(const Bytes& bytes) {
  record::CycleRecord read;
  read.observation.moving_obstacles.resize(3);
  read.observation.sensor_sectors.resize(3);
  EXPECT_EQ(record::decode(bytes, read), "");
  EXPECT_TRUE(read.unknown.empty());
  return read;
}

bool holds(const Bytes& bytes, const std::string& text) {
  return std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) != bytes.end();
}

TEST(RecordedMovers, ComeBackToTheBit) {
  record::CycleRecord cycle = faulty_cycle();
  MovingObstacleEstimate mover;
  mover.id = 42;
  mover.position = {1.0 / 3.0, -2.0};
  mover.velocity = {0.1, 0.7};
  mover.radius = 0.3;
  mover.position_deviation = 0.01;
  mover.velocity_deviation = 0.02;
  mover.age = 0.05;
  mover.points = {{0.5, 0.25}, {0.1, 0.2}};
  cycle.observation.moving_obstacles = {mover};
  const record::CycleRecord read = decoded(encoded(cycle));
  ASSERT_EQ(read.observation.moving_obstacles.size(), 1U);
  Bytes before, after;
  ArchiveWriter{before}(mover);
  ArchiveWriter{after}(read.observation.moving_obstacles[0]);
  EXPECT_EQ(before, after);
}

TEST(RecordedMovers, AndSectorsTakeNoRoomWhereThereAreNone) {
  const Bytes bytes = encoded(faulty_cycle());
  EXPECT_FALSE(holds(bytes, "moving_obstacles"));
  EXPECT_FALSE(holds(bytes, "sensor_sectors"));
  EXPECT_TRUE(decoded(bytes).observation.moving_obstacles.empty());
  EXPECT_TRUE(decoded(bytes).observation.sensor_sectors.empty());
}

TEST(RecordedSectors, ComeBackToTheBit) {
  record::CycleRecord cycle = faulty_cycle();
  cycle.observation.sensor_sectors = {{{0.1, -1.0 / 3.0, 0.7}, 4.7, 12.0}, {{-0.2, 0.0, 3.1}, 1.5, 4.0}};
  EXPECT_TRUE(decoded(encoded(cycle)).observation.sensor_sectors == cycle.observation.sensor_sectors);
}

}  // namespace
}  // namespace hidwa_local_planner
