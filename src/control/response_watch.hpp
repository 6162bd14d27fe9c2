// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How late the base answers while it drives: by how much what odometry measured lags behind the commands of the last
/// seconds. Nothing is decided by it; it tells where control_latency is too small. Allocates nothing.
class ResponseWatch {
 public:
  /// A cycle of `period` [s] has sent `command` at `now` [s]; odometry `measured` was taken at `measured_at` [s].
  void add(double now, double period, const Twist2& command, double measured_at, const Twist2& measured);

  /// The latency that was seen [s], the smaller of the last two estimates. Nothing before there are two: where the
  /// commands changed too little to tell, or the base did something else than they ask, there is none.
  std::optional<double> latency() const;

 private:
  static constexpr std::size_t kMost = 256;  // cycles
  struct Row {
    double sent_at = 0.0;      // [s]
    double measured_at = 0.0;  // [s]
    Twist2 command, measured;  // [m/s, rad/s]
  };
  const Row& row(std::size_t i) const { return rows_[(first_ + i) % kMost]; }
  void estimate();
  std::optional<double> lag(double Twist2::*axis, double least_change) const;
  double error(double Twist2::*axis, double lag) const;

  std::array<Row, kMost> rows_;  // a ring
  std::size_t first_ = 0, count_ = 0;
  double period_ = 0.0;                     // [s]
  double estimated_ = 0.0;                  // when [s]
  std::optional<double> latency_, before_;  // the last two estimates [s]
};

/// Why control_latency, `told` [s], is too small where `seen` [s] was seen and cycles come every `period` [s], with the
/// remedy; empty: it is not.
std::string latency_complaint(double seen, double told, double period);

}  // namespace hidwa_local_planner
