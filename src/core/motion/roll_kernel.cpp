// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/roll_kernel.hpp"

#include <cstring>

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

// A few candidates from row to row, without a look back: their positions stay in registers. Four at a time.
HIDWA_VECTOR_CLONES
void steady_rows(const RollRequest& q, double* x, double* y) {
  static_assert(kLaneMultiple % 4 == 0);
  const std::size_t n = q.stride, first = q.ramp_steps * n;
  for (std::size_t c = 0; c < n; c += 8) {
    const std::size_t second = c + 8 <= n ? c + 4 : c;  // where there is no second four, the first one twice
    Four va, vb, xa, xb, ya, yb;
    std::memcpy(&va, q.v + c, sizeof(va));
    std::memcpy(&vb, q.v + second, sizeof(vb));
    std::memcpy(&xa, x + first + c, sizeof(xa));
    std::memcpy(&xb, x + first + second, sizeof(xb));
    std::memcpy(&ya, y + first + c, sizeof(ya));
    std::memcpy(&yb, y + first + second, sizeof(yb));
    for (std::size_t k = q.ramp_steps; k < q.steps; ++k) {
      const double dx = q.step_x[k], dy = q.step_y[k];
      xa += va * dx;
      xb += vb * dx;
      ya += va * dy;
      yb += vb * dy;
      const std::size_t row = (k + 1) * n;
      std::memcpy(x + row + c, &xa, sizeof(xa));
      std::memcpy(x + row + second, &xb, sizeof(xb));
      std::memcpy(y + row + c, &ya, sizeof(ya));
      std::memcpy(y + row + second, &yb, sizeof(yb));
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
