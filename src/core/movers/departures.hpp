// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/movers/mover_memory.hpp"

namespace hidwa_local_planner {

/// The moving obstacles that the robot may leave although their sets are around it: it stood when they came so near,
/// and they have been so near ever since, for a while. Who has just come is likely to go on. One that comes so near to
/// a robot that moves is not among them.
class Departures {
 public:
  /// The robot leaves a mover after standing near it for this time [s].
  static constexpr double kPatience = 1.0;

  void forget() { memory_.forget(); }
  /// Once a cycle, before any admit(). `period`: since the cycle before [s].
  void begin(double period) {
    period_ = period;
    memory_.begin();
  }
  /// Whether it may leave this one, whose set is around it. `rests`: the robot does.
  bool admit(std::uint32_t id, bool rests) {
    const One* known = memory_.before(id);
    if ((!rests && known == nullptr) || memory_.full()) return false;
    const double stood = known == nullptr ? 0.0 : std::min(known->stood + period_, kPatience);
    return memory_.keep({id, stood}).stood > kPatience - kSame;
  }
  /// Something stands so near, whether it may be left yet or not.
  bool any() const { return memory_.any(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.memory_);
  }

 private:
  static constexpr double kSame = 1e-6;  // [s]
  struct One {
    std::uint32_t id = 0;
    double stood = 0.0;  // so near [s]

    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.id, self.stood);
    }
  };
  double period_ = 0.0;  // [s]
  MoverMemory<One> memory_;
};

}  // namespace hidwa_local_planner
