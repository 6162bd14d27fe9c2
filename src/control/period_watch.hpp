// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hidwa_local_planner {

/// The longest control period of the last seconds. The braking check allows for it, since a late cycle lets the robot
/// go on for longer. Knows no clock.
class PeriodWatch {
 public:
  /// The time for which an interval counts at least [s]. A control period of up to a slot is added to it.
  static constexpr double kMemory = 3.0;
  /// The longest interval that counts [control periods]. A host that is later breaks an assumption
  /// (docs/understand/safety.md).
  static constexpr double kMost = 3.0;

  /// A cycle came `interval` [s] after the one before.
  void observe(double now, double interval) {
    const double slot = std::floor(now / kSlot);
    if (slot < newest_) reset();
    for (double s = std::max(newest_ + 1.0, slot - kSlots + 1.0); s <= slot; s += 1.0) at(s) = 0.0;
    newest_ = slot;
    at(slot) = std::max(at(slot), interval);
  }
  void reset() {
    slots_.fill(0.0);
    newest_ = -std::numeric_limits<double>::infinity();
  }
  /// The larger of `period` and the longest interval, at most kMost periods [s].
  double longest(double period) const {
    double most = period;
    for (const double interval : slots_) most = std::max(most, interval);
    return std::min(most, kMost * period);
  }

 private:
  static constexpr double kSlot = 0.25;  // [s]
  static constexpr std::size_t kSlots = 14;
  // The slot of now has only begun, and one slot is for the period that is more.
  static_assert((kSlots - 2) * kSlot == kMemory, "the slots cover the memory");
  double& at(double slot) {
    const double left = std::fmod(slot, static_cast<double>(kSlots));
    return slots_[static_cast<std::size_t>(left < 0.0 ? left + kSlots : left)];
  }

  std::array<double, kSlots> slots_{};  // the longest interval of each quarter of a second [s]
  double newest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace hidwa_local_planner
