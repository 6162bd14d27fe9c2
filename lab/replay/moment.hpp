// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace hidwa_local_planner {
namespace replay {

/// A time as the user gives it.
struct Moment {
  double seconds = 0.0;
  bool ros_time = false;  // surely; else seconds since the first record, or a ROS time where no record is so late
};

/// Of "71.2" or "ros:1606014071.2"; nothing where it is neither.
std::optional<Moment> moment_of(const std::string& text);

/// Finds the record that a moment means. Times are ROS times [s].
class MomentSearch {
 public:
  explicit MomentSearch(const Moment& wanted) : wanted_(wanted) {}
  /// The times of all records, in order.
  void see(double time);
  /// Of the record within a second of the moment; nothing where there is none.
  std::optional<double> found() const;
  /// What else the moment may mean, or why there is no such record; empty where it is clear.
  std::string remark() const;

 private:
  /// The record nearest to a time.
  struct Nearest {
    std::optional<double> time;
    void see(double candidate, double wanted);
    bool hits(double wanted) const;
  };
  double since_first() const { return *first_ + wanted_.seconds; }

  Moment wanted_;
  std::optional<double> first_;
  double last_ = 0.0;
  Nearest since_first_, ros_time_;
};

}  // namespace replay
}  // namespace hidwa_local_planner
