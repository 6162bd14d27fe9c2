// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/search/way.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What remains of a way from many poses near one stretch of it. Keeps its memory.
class WayAhead {
 public:
  /// Four parts of the way.
  struct Parts {
    using Each = std::array<double, 4>;
    Each x, y, heading;  // where it begins [m], [rad]
    Each dx, dy, turn;   // to where it ends, turns as lengths [m]
    Each squared;        // its length, 1 where it has none [m^2]
    Each left, passes;   // the remaining time where it begins, and what it adds to that [s]
    Each turned;         // from its heading to that of the pose that is asked about, as a length [m]
  };

  WayAhead();
  /// The parts from `from` on, before `end`, one at least. The way must not be empty.
  void look(const Way& way, std::size_t from, std::size_t end, double room);
  /// The same bits as way.nearest(pose, from, end, room).remaining() [s].
  double remaining(const Pose2& pose);

 private:
  std::vector<Parts> parts_;  // the last one repeats
  double room_ = 0.0;         // [m]
};

}  // namespace hidwa_local_planner
