// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/barn_worlds.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hidwa_local_planner::test {
namespace {

// Calls take(first, second) for every pair "first:second" of a list.
template <typename Take>
void each_pair(const std::string& list, const Take& take) {
  std::istringstream words(list);
  int first = 0, second = 0;
  char colon = 0;
  while (words >> first >> colon >> second) {
    if (colon != ':') break;
    take(first, second);
  }
  if (!words.eof()) throw std::runtime_error("no pairs of numbers: " + list.substr(0, 40));
}

// The lattice's and the path's geometry, as the head of the file has it.
BarnWorld read_world(const std::string& line) {
  const std::size_t one = line.find('|');
  const std::size_t two = line.find('|', one + 1);
  if (one == std::string::npos || two == std::string::npos) throw std::runtime_error("no world: " + line);
  BarnWorld world;
  each_pair(line.substr(one + 1, two - one - 1), [&](int column, int row) {
    world.cylinders.emplace_back(-0.075 - 0.15 * column, 0.075 + 0.15 * row);
  });
  each_pair(line.substr(two + 1),
            [&](int column, int row) { world.path.emplace_back(0.15 * column - 4.575, 0.15 * row + 5.075); });
  if (world.path.size() < 2) throw std::runtime_error("a world without a path");
  return world;
}

}  // namespace

std::vector<BarnWorld> read_barn_worlds(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  std::vector<BarnWorld> worlds;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.front() != '#') worlds.push_back(read_world(line));
  }
  if (worlds.empty()) throw std::runtime_error("no worlds in " + file);
  return worlds;
}

std::string barn_worlds_file() {
  const char* folder = std::getenv("HIDWA_DATA");
  return std::string(folder != nullptr ? folder : HIDWA_DATA_DEFAULT) + "/barn/worlds.txt";
}

}  // namespace hidwa_local_planner::test
