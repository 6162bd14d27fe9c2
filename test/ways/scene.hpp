// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "attack/local_map.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "ways/lattice.hpp"
#include "ways/site.hpp"
#include "ways/way.hpp"

namespace hidwa_ways {

/// A kind of scenes: where they are.
struct Kind {
  std::string name;
  std::function<Site(const Measure&, Random&)> make;
  bool any_resolution = true;
  std::string source;  // the option that makes it available; empty where none is needed
};

/// Those that need no file.
const std::vector<Kind>& drawn_kinds();
Kind barn_kind(const std::string& file);
/// Named as the map's file is.
Kind map_kind(const std::string& yaml);

/// Where a robot is left alone: at rest, with a plan.
struct Scene {
  const Kind* kind = nullptr;
  std::uint64_t seed = 0;
  Body body;
  bool reverse = false;  // it drives backwards too
  bool rolling = true;   // the local map moves with it; else it stays where it is
  bool replans = false;  // the plan is made anew each second
  World world;
  Pose2 start;
  std::vector<Pose2> plan;  // from the start to the goal, in points

  /// Half a cell: the margin of a way that must be found [m].
  double margin() const { return 0.5 * world.resolution(); }
  Region local_map() const;  // at the start
  hidwa_local_planner::Parameters parameters() const;
  Pace pace() const;
};

constexpr double kLocalMap = 6.0;  // its side [m]

/// The inscribed radius that a costmap computes from the corners it is told [m].
double inscribed(const Shape& shape);

/// The scene of a seed: the same one each time.
Scene scene_of(const Kind& kind, std::uint64_t seed);

}  // namespace hidwa_ways
