// SPDX-License-Identifier: BSD-3-Clause
#include "sim/dynabarn_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "sim/world_lines.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr int kLastWorld = 99;
constexpr double kFarthestKey = 100.0;    // [m]
constexpr double kLongestTrack = 3600.0;  // [s]

double figure(const std::string& text, const std::string& key, double least, double greatest) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) {
    throw LineFault{"the key frame '" + key + "' is not three numbers, such as 2.5:-1:4.75"};
  }
  if (value < least || value > greatest) throw LineFault{"the key frame '" + key + "' is out of bounds"};
  return value;
}

KeyFrame key_frame(const std::string& word) {
  const std::vector<std::string> parts = parts_of(word, ':');
  if (parts.size() != 3) throw LineFault{"the key frame '" + word + "' is not three numbers, such as 2.5:-1:4.75"};
  return {figure(parts[0], word, 0.0, kLongestTrack),
          {figure(parts[1], word, -kFarthestKey, kFarthestKey), figure(parts[2], word, -kFarthestKey, kFarthestKey)}};
}

std::vector<KeyFrame> track_of(const std::string& text) {
  std::istringstream words(text);
  std::string name;
  words >> name;
  if (name.empty()) throw LineFault{"an obstacle is empty"};
  std::vector<KeyFrame> frames;
  for (std::string word; words >> word;) frames.push_back(key_frame(word));
  try {
    const KeyFrameTrack track(frames, KeyMotion::linear);  // for its faults
  } catch (const std::invalid_argument& fault) {
    throw LineFault{"the obstacle '" + name + "': " + fault.what()};
  }
  return frames;
}

DynabarnWorld world_of(const std::string& line) {
  DynabarnWorld world;
  std::istringstream parts(line);
  std::string head;
  std::getline(parts, head, '|');
  std::istringstream words(head);
  std::string index, more;
  words >> index >> world.difficulty >> more;
  const bool digits = !index.empty() && index.size() < 4 && index.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::atoi(index.c_str()) > kLastWorld) {
    throw LineFault{"the index '" + index + "' is not within 0 to " + std::to_string(kLastWorld)};
  }
  world.index = std::atoi(index.c_str());
  const std::string& d = world.difficulty;
  if ((d != "easy" && d != "medium" && d != "hard") || !more.empty()) {
    throw LineFault{"after the index there must be easy, medium or hard alone"};
  }
  for (std::string part; std::getline(parts, part, '|');) world.tracks.push_back(track_of(part));
  if (world.tracks.empty()) throw LineFault{"there are no obstacles"};
  return world;
}

}  // namespace

Pose dynabarn_start() { return {11.0, 0.0, M_PI}; }
Pose dynabarn_goal() { return {-9.0, 0.0, M_PI}; }

OccupancyMap dynabarn_court(double resolution) {
  // Walls of 0.5 m about x = -10, y = 10 and y = -10, 20 m long; 5 m of room beyond x = 10.
  constexpr double kLow = -10.5, kHigh = 10.5, kRoom = 15.0, kHalf = 0.25;  // [m]
  OccupancyMap map = make_map(static_cast<int>(std::lround((kRoom - kLow) / resolution)),
                              static_cast<int>(std::lround((kHigh - kLow) / resolution)), resolution, kLow, kLow);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double x = map.center_x(column), y = map.center_y(row);
      const bool side = std::abs(std::abs(y) - 10.0) < kHalf && std::abs(x) < 10.0;
      const bool end = std::abs(x + 10.0) < kHalf && std::abs(y) < 10.0;
      if (side || end) map.cells[map.index(column, row)] = Cell::kOccupied;
    }
  }
  return map;
}

std::shared_ptr<KeyFramePeople> dynabarn_people(const DynabarnWorld& world, KeyMotion motion, double release) {
  std::vector<KeyFrameTrack> tracks;
  tracks.reserve(world.tracks.size());
  for (const std::vector<KeyFrame>& frames : world.tracks) tracks.emplace_back(frames, motion);
  return std::make_shared<KeyFramePeople>(std::move(tracks), kDynabarnCylinder, release);
}

std::vector<DynabarnWorld> load_dynabarn_worlds(const std::string& file) {
  return read_worlds<DynabarnWorld>(file, "DynaBARN", world_of);
}

}  // namespace sim
}  // namespace hidwa_local_planner
