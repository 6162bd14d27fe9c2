// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <mutex>

namespace hidwa_local_planner {

/// A host's request to end the present drive, until the robot rests. It comes from another thread than the cycles, at
/// any time. A plan that arrives meanwhile may be older than the request, so it does not end it. Times are of a clock
/// that never jumps [s].
class CancelRequest {
 public:
  void request(double now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    pending_ = true;
    heard_ = now;
  }
  /// A cycle begins. True while there is a request.
  bool pending(double now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_ = std::max(heard_, now);
    return pending_;
  }
  /// A plan arrives. After a long silence the cancelled drive has ended without notice (the host lost patience), and
  /// the plan belongs to another drive.
  void plan_arrives(double now) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (now - heard_ > kSilence) pending_ = false;
    heard_ = std::max(heard_, now);
  }
  /// It was met: the robot rests, or has arrived.
  void met() {
    const std::lock_guard<std::mutex> lock(mutex_);
    pending_ = false;
  }

 private:
  static constexpr double kSilence = 1.0;  // many control periods [s]
  std::mutex mutex_;
  bool pending_ = false;
  double heard_ = 0.0;  // the newest of request, cycle and plan [s]
};

}  // namespace hidwa_local_planner
