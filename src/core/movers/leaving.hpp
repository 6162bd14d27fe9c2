// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// The moving obstacles that the robot may leave although their sets are around it: it stood when they came so near,
/// and they have been so near ever since, for a while. Who has just come is likely to go on. One that comes so near to
/// a robot that moves is not among them.
class Leaving {
 public:
  static constexpr std::size_t kMost = 64;
  /// So long it has stood there before it is left [s].
  static constexpr double kPatience = 1.0;

  Leaving() { reserve(); }
  void forget() {
    before_.clear();
    now_.clear();
  }
  /// Once a cycle, before any admit(). `period`: since the cycle before [s].
  void begin(double period) {
    period_ = period;
    before_.swap(now_);
    now_.clear();
  }
  /// Whether it may leave this one, whose set is around it. `rests`: the robot does.
  bool admit(std::uint32_t id, bool rests) {
    const auto known = std::find_if(before_.begin(), before_.end(), [id](const One& one) { return one.id == id; });
    if ((!rests && known == before_.end()) || now_.size() >= kMost) return false;
    now_.push_back({id, known == before_.end() ? 0.0 : std::min(known->stood + period_, kPatience)});
    return now_.back().stood > kPatience - kSame;
  }
  /// Something stands so near, whether it may be left yet or not.
  bool any() const { return !now_.empty(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.now_);
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
  void reserve() {
    before_.reserve(kMost);
    now_.reserve(kMost);
  }
  double period_ = 0.0;            // [s]
  std::vector<One> before_, now_;  // of the cycle before, and of this one
};

}  // namespace hidwa_local_planner
