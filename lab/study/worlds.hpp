// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {

/// The worlds of a file by their index. `load` reads the file; what it throws becomes a UsageError.
template <typename World>
std::map<int, World> worlds_by_index(std::vector<World> (*load)(const std::string&), const std::string& file) {
  std::map<int, World> worlds;
  try {
    for (World& world : load(file)) worlds.emplace(world.index, std::move(world));
  } catch (const std::exception& e) {
    throw UsageError(e.what());
  }
  return worlds;
}

}  // namespace study
}  // namespace hidwa_local_planner
