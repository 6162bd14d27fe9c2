// SPDX-License-Identifier: BSD-3-Clause
#include "sim/barn_world.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "sim/grid_route.hpp"
#include "sim/world_lines.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kLattice = 0.15;  // [m], between neighbouring cylinders
constexpr int kRows = 30;          // of the field that the path crosses
constexpr int kFarthest = 999;     // cell

using Cells = std::vector<std::pair<int, int>>;

int whole(const std::string& text, const std::string& what) {
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0') throw LineFault{what + " '" + text + "' is not a whole number"};
  if (value < 0 || value > kFarthest)
    throw LineFault{what + " " + text + " is not within 0 to " + std::to_string(kFarthest)};
  return static_cast<int>(value);
}

Cells read_cells(const std::string& list, const std::string& what) {
  Cells cells;
  std::istringstream words(list);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos || word.find(':', colon + 1) != std::string::npos) {
      throw LineFault{what + " '" + word + "' is not two numbers, such as 3:14"};
    }
    cells.emplace_back(whole(word.substr(0, colon), what), whole(word.substr(colon + 1), what));
  }
  return cells;
}

void check_path(const Cells& path) {
  if (path.empty()) throw LineFault{"there is no path"};
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (std::abs(path[k].first - path[k - 1].first) > 1 || std::abs(path[k].second - path[k - 1].second) > 1) {
      throw LineFault{"the path leaps from " + std::to_string(path[k - 1].first) + ":" +
                      std::to_string(path[k - 1].second) + " to " + std::to_string(path[k].first) + ":" +
                      std::to_string(path[k].second)};
    }
  }
  if (path.back().second != kRows - 1) {
    throw LineFault{"the path ends in row " + std::to_string(path.back().second) + ", not " +
                    std::to_string(kRows - 1) + ": the line is cut off"};
  }
}

BarnWorld read_world(const std::string& line) {
  const std::vector<std::string> parts = parts_of(line, '|');
  if (parts.size() != 3) {
    throw LineFault{"it has " + std::to_string(parts.size()) + " parts, not three (index | cells | path)"};
  }
  BarnWorld world;
  std::istringstream words(parts[0]);
  std::string index, more;
  words >> index >> more;
  if (!more.empty()) throw LineFault{"the index '" + index + " " + more + "' is not one number"};
  world.index = whole(index, "the index");
  const Cells cells = read_cells(parts[1], "the cell");
  const Cells path = read_cells(parts[2], "the path cell");
  if (cells.empty()) throw LineFault{"there are no cells"};
  check_path(path);
  // The lattice's and the path's geometry, as the head of BARN's file has it.
  for (const auto& [column, row] : cells) {
    world.cylinders.emplace_back(-0.5 * kLattice - kLattice * column, 0.5 * kLattice + kLattice * row);
  }
  for (const auto& [column, row] : path) world.path.emplace_back(kLattice * column - 4.575, kLattice * row + 5.075);
  return world;
}

}  // namespace

Pose barn_start() { return {-2.25, 3.0, 0.5 * M_PI}; }
Pose barn_goal() { return {-2.25, 13.0, 0.5 * M_PI}; }

double reference_length(const BarnWorld& world) {
  Route way{{barn_start().x, barn_start().y}};
  way.insert(way.end(), world.path.begin(), world.path.end());
  way.emplace_back(barn_goal().x, barn_goal().y);
  return length(way);
}

std::vector<BarnWorld> load_barn_worlds(const std::string& file) {
  return read_worlds<BarnWorld>(file, "BARN", read_world);
}

}  // namespace sim
}  // namespace hidwa_local_planner
