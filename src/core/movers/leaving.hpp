// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// The moving obstacles that the robot may leave although their sets are around it: it stood when they came so near,
/// and they have been so near ever since. One that comes so near to a robot that moves is not among them.
class Leaving {
 public:
  static constexpr std::size_t kMost = 64;

  Leaving() { reserve(); }
  void forget() {
    ids_.clear();
    now_.clear();
  }
  /// Once a cycle, before any admit().
  void begin() {
    ids_.swap(now_);
    now_.clear();
  }
  /// Whether it may leave this one, whose set is around it. `rests`: the robot does.
  bool admit(std::uint32_t id, bool rests) {
    const bool leaves = rests || std::find(ids_.begin(), ids_.end(), id) != ids_.end();
    if (leaves && now_.size() < kMost) now_.push_back(id);
    return leaves;
  }
  bool any() const { return !now_.empty(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.now_);
  }

 private:
  void reserve() {
    ids_.reserve(kMost);
    now_.reserve(kMost);
  }
  std::vector<std::uint32_t> ids_, now_;  // of the cycle before, and of this one
};

}  // namespace hidwa_local_planner
