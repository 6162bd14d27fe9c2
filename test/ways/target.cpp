// SPDX-License-Identifier: BSD-3-Clause
#include "ways/target.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_ways {

Target::Target(const std::vector<Pose2>& plan, double from, double to) {
  double arc = 0.0;
  for (std::size_t k = 0; k < plan.size(); ++k) {
    if (k > 0) arc += std::hypot(plan[k].x - plan[k - 1].x, plan[k].y - plan[k - 1].y);
    if (arc >= from && arc <= to) points_.push_back({plan[k].x, plan[k].y});
  }
  if (points_.empty()) points_.push_back({plan.back().x, plan.back().y});
}

double Target::distance(double x, double y) const { return std::sqrt(squared(x, y)); }

double Target::squared(double x, double y) const {
  double least = 1e18;
  for (const Spot& p : points_) least = std::min(least, (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
  return least;
}

}  // namespace hidwa_ways
