// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/util/elapsed.hpp"

namespace hidwa_local_planner {

/// Where moving obstacles alone block the way, the robot waits for them to clear it, for some time.
class MoverWait {
 public:
  static constexpr double kLongest = 30.0;  // [s]

  void reset() { *this = {}; }
  void begin(double now) {
    if (!waits_) since_ = now;
    waits_ = true;
  }
  bool waits() const { return waits_; }
  /// It has waited as long as it will. `now` [s].
  bool over(double now) const { return waits_ && elapsed(since_, kLongest, now); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.waits_, self.since_);
  }

 private:
  bool waits_ = false;
  double since_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
