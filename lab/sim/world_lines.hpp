// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hidwa_local_planner {
namespace sim {

/// The parts of a text between separators, empty ones included.
inline std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// What is wrong with a line, without its place.
struct LineFault {
  std::string text;
};

/// The worlds of a file, one a line; empty lines and those that begin with # do not count. `read` makes a world with an
/// index of its own out of a line, or throws LineFault. `kind`: how the worlds are called. Throws std::runtime_error
/// naming file, line, fault and remedy.
template <typename World, typename Read>
std::vector<World> read_worlds(const std::string& file, const std::string& kind, Read&& read) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("'" + file + "' cannot be read: give a file of " + kind + " worlds");
  std::vector<World> worlds;
  std::set<int> indices;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.find_first_not_of(" \t") == std::string::npos || line.front() == '#') continue;
    try {
      worlds.push_back(read(line));
      const int index = worlds.back().index;
      if (!indices.insert(index).second) throw LineFault{"world " + std::to_string(index) + " is there twice"};
    } catch (const LineFault& fault) {
      throw std::runtime_error("'" + file + "' line " + std::to_string(number) + ": " + fault.text +
                               "; correct the line, or remove it");
    }
  }
  if (worlds.empty()) throw std::runtime_error("'" + file + "' holds no world: give a file of " + kind + " worlds");
  return worlds;
}

}  // namespace sim
}  // namespace hidwa_local_planner
