// SPDX-License-Identifier: BSD-3-Clause
#include "control/response_watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kWindow = 6.0;       // what counts [s]
constexpr double kEvery = 1.0;        // between estimates [s]
constexpr double kLongest = 1.0;      // latency that is looked for [s]
constexpr double kStep = 0.02;        // from one to the next [s]
constexpr double kLongestGap = 0.5;   // between cycles; after a longer one all begins anew [s]
constexpr double kChangeX = 0.05;     // root mean square of the measured velocity's changes that tell [m/s]
constexpr double kChangeTheta = 0.1;  // [rad/s]
constexpr double kUnexplained = 0.1;  // share of them that the commands need not explain
constexpr double kAsGood = 1.2;       // errors up to so many times the smallest are as good
constexpr double kTooLate = 0.05;     // beyond what was told, at least [s]
constexpr std::size_t kFewest = 40;   // cycles

}  // namespace

void ResponseWatch::add(double now, double period, const Twist2& command, double measured_at, const Twist2& measured) {
  const double last = count_ > 0 ? row(count_ - 1).sent_at : now;
  if (!(now >= last && now - last <= kLongestGap)) first_ = count_ = 0;  // the host was away, or time was set
  if (count_ == kMost) {
    first_ = (first_ + 1) % kMost;
    --count_;
  }
  rows_[(first_ + count_) % kMost] = {now, measured_at, command, measured};
  ++count_;
  while (now - row(0).sent_at > kWindow) {
    first_ = (first_ + 1) % kMost;
    --count_;
  }
  period_ = period;
  if (now - estimated_ < kEvery && now >= estimated_) return;
  estimated_ = now;
  if (count_ >= kFewest) estimate();
}

void ResponseWatch::estimate() {
  const std::optional<double> x = lag(&Twist2::v, kChangeX);
  const std::optional<double> theta = lag(&Twist2::omega, kChangeTheta);
  if (!x && !theta) return;  // the last estimate stands
  before_ = latency_;
  // A command is reached a period after it takes effect.
  latency_ = std::max(std::max(x.value_or(0.0), theta.value_or(0.0)) - period_, 0.0);
}

// The mean squared difference between what was measured and the commands `lag` [s] before.
double ResponseWatch::error(double Twist2::*axis, double lag) const {
  double sum = 0.0;
  std::size_t used = 0;
  std::size_t k = 0;  // the command that was in force
  for (std::size_t i = 0; i < count_; ++i) {
    const double time = row(i).measured_at - lag;
    if (row(i).measured_at - kLongest < row(0).sent_at) continue;  // the same rows for each lag
    while (k + 1 < count_ && row(k + 1).sent_at <= time) ++k;
    double expected = row(k).command.*axis;
    if (k + 1 < count_) {
      const double share = std::clamp((time - row(k).sent_at) / (row(k + 1).sent_at - row(k).sent_at), 0.0, 1.0);
      expected += share * (row(k + 1).command.*axis - expected);
    }
    const double off = row(i).measured.*axis - expected;
    sum += off * off;
    ++used;
  }
  return used < kFewest ? -1.0 : sum / static_cast<double>(used);
}

std::optional<double> ResponseWatch::lag(double Twist2::*axis, double least_change) const {
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    mean += row(i).measured.*axis / static_cast<double>(count_);
    square += row(i).measured.*axis * (row(i).measured.*axis) / static_cast<double>(count_);
  }
  const double change = square - mean * mean;
  if (!(change >= least_change * least_change)) return std::nullopt;
  double best = 0.0, smallest = error(axis, 0.0);
  if (smallest < 0.0) return std::nullopt;
  for (double tried = kStep; tried <= kLongest; tried += kStep) {
    const double here = error(axis, tried);
    if (here < smallest) {
      smallest = here;
      best = tried;
    }
  }
  if (smallest > kUnexplained * change) return std::nullopt;
  for (double tried = 0.0; tried < best; tried += kStep) {
    if (error(axis, tried) <= kAsGood * smallest) return tried;
  }
  return best;
}

std::optional<double> ResponseWatch::latency() const {
  return latency_ && before_ ? std::optional<double>(std::min(*latency_, *before_)) : std::nullopt;
}

std::string latency_complaint(double seen, double told, double period) {
  if (seen <= told + std::max(period, kTooLate)) return "";
  return format(
      "the base answers commands after about %.2f s, later than control_latency says (%.2f s), so the robot may touch "
      "obstacles: measure it (rosrun hidwa_local_planner measure_base) and set control_latency",
      seen, told);
}

}  // namespace hidwa_local_planner
