// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/movers/mover_memory.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How moving obstacles change their velocities of late, by how their estimates differ: a way that bends is foretold
/// closer than by the velocity alone. Detectors need not tell it. Velocities that are not known well differ by chance:
/// what their deviations explain does not count.
class Accelerations {
 public:
  /// What changes faster has leapt to another velocity, which says nothing of the next change [m/s^2].
  static constexpr double kLeap = 8.0;
  /// Of each change so much is believed at most [m/s^2]: an estimate that was wrong comes back within a scan or two.
  static constexpr double kBelieved = 2.5;

  void forget() { memory_.forget(); }

  /// Once a cycle, at its start [s]. Of more than can be remembered the first ones.
  void watch(const MovingObstacleEstimates& movers, double time);

  /// That of the one with this id, costmap frame [m/s^2]; zero where nothing is known of it.
  Point of(std::uint32_t id) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.memory_);
  }

 private:
  struct One {
    std::uint32_t id = 0;
    Point velocity{0.0, 0.0};      // last [m/s]
    Point acceleration{0.0, 0.0};  // mean of late [m/s^2]
    double explained = 0.0;        // so much of it the deviation of the velocity explains [m/s^2]
    double stamp = 0.0;            // of that velocity [s]
    double leapt = 0.0;            // to another velocity, or seen first, last [s]

    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.id, self.velocity, self.acceleration, self.explained, self.stamp, self.leapt);
    }
  };

  MoverMemory<One> memory_;
};

}  // namespace hidwa_local_planner
