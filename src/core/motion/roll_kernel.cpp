// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/roll_kernel.hpp"

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::kernel {
namespace {

inline double within(double value, double lo, double hi) {
  const double raised = value < lo ? lo : value;
  return raised > hi ? hi : raised;
}

// One step while speeds still ramp; w0 and w1 weigh the speeds at its start and end.
HIDWA_VECTOR_CLONES
void ramp_rows(const RollRequest& q, double w0, double w1, double* __restrict x, double* __restrict y) {
  const double* __restrict v = q.v;
  const std::size_t n = q.stride;
  for (std::size_t k = 0; k < q.ramp_steps; ++k) {
    const double lo0 = q.slowest[k], hi0 = q.fastest[k], lo1 = q.slowest[k + 1], hi1 = q.fastest[k + 1];
    const double dx = q.step_x[k], dy = q.step_y[k];
    const double* __restrict x0 = x + k * n;
    const double* __restrict y0 = y + k * n;
    double* __restrict x1 = x + (k + 1) * n;
    double* __restrict y1 = y + (k + 1) * n;
    for (std::size_t c = 0; c < n; ++c) {
      const double speed = w0 * within(v[c], lo0, hi0) + w1 * within(v[c], lo1, hi1);
      x1[c] = x0[c] + speed * dx;
      y1[c] = y0[c] + speed * dy;
    }
  }
}

// One step at the samples' own speeds.
HIDWA_VECTOR_CLONES
void steady_rows(const RollRequest& q, double* __restrict x, double* __restrict y) {
  const double* __restrict v = q.v;
  const std::size_t n = q.stride;
  for (std::size_t k = q.ramp_steps; k < q.steps; ++k) {
    const double dx = q.step_x[k], dy = q.step_y[k];
    const double* __restrict x0 = x + k * n;
    const double* __restrict y0 = y + k * n;
    double* __restrict x1 = x + (k + 1) * n;
    double* __restrict y1 = y + (k + 1) * n;
    for (std::size_t c = 0; c < n; ++c) {
      x1[c] = x0[c] + v[c] * dx;
      y1[c] = y0[c] + v[c] * dy;
    }
  }
}

}  // namespace

void roll(const RollRequest& request, double* x, double* y) {
  if (request.euler) {
    ramp_rows(request, 0.0, 1.0, x, y);
  } else {
    ramp_rows(request, 0.5, 0.5, x, y);
  }
  steady_rows(request, x, y);
}

}  // namespace hidwa_local_planner::kernel
