// SPDX-License-Identifier: BSD-3-Clause
#include "drive/gentleness.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace drive {
namespace {

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// The smallest of the values that 99 % of them do not exceed.
double percentile_99(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double share_from(const std::vector<double>& values, double least) {
  if (values.empty()) return 0.0;
  const auto count = std::count_if(values.begin(), values.end(), [least](double value) { return value >= least; });
  return static_cast<double>(count) / static_cast<double>(values.size());
}

}  // namespace

void GentlenessMeter::add(bool autonomy, double omega, double period) {
  const double acc = (omega - omega_) / period, jerk = (acc - acc_) / period;
  omega_ = omega;
  acc_ = acc;
  if (!autonomy) return;
  accs_.push_back(std::abs(acc));
  jerks_.push_back(std::abs(jerk));
  if (std::abs(omega) >= kBend) bend_accs_.push_back(std::abs(acc));
}

Gentleness GentlenessMeter::result() const {
  Gentleness result;
  result.acc_rms = root_mean_square(accs_);
  result.acc_p99 = percentile_99(accs_);
  result.bend_acc_rms = root_mean_square(bend_accs_);
  result.jerk_rms = root_mean_square(jerks_);
  result.jerk_p99 = percentile_99(jerks_);
  result.at_limit = share_from(accs_, kAtLimit * limit_);
  result.bend_at_limit = share_from(bend_accs_, kAtLimit * limit_);
  return result;
}

}  // namespace drive
}  // namespace hidwa_local_planner
