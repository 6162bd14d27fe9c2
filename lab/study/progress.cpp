// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kBetween = 2.0;  // [s], lines

}  // namespace

void Progress::step() {
  ++done_;
  const double now = elapsed();
  if (done_ < total_ && now < told_ + kBetween) return;
  told_ = now;
  const double left = now / static_cast<double>(done_) * static_cast<double>(total_ - std::min(done_, total_));
  stream_ << done_ << " of " << total_ << " runs, " << std::lround(left) << " s left" << std::endl;
}

double Progress::elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

}  // namespace study
}  // namespace hidwa_local_planner
