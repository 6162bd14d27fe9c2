// SPDX-License-Identifier: BSD-3-Clause
#include "core/util/outline.hpp"

namespace hidwa_local_planner {

double signed_area(const Polygon& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

Polygon without_repeats(const Polygon& outline) {
  Polygon kept;
  for (const Point& p : outline) {
    if (kept.empty() || !((p - kept.back()).norm() <= 1e-9)) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= 1e-9) kept.pop_back();
  return kept;
}

}  // namespace hidwa_local_planner
