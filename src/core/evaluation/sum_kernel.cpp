// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/sum_kernel.hpp"

#include <cmath>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::kernel {

HIDWA_VECTOR_CLONES
void sum_up(const WeightedScores* scores, std::size_t critics, const Deviation& deviation, std::size_t count,
            double* totals) {
  double* __restrict total = totals;
  for (std::size_t c = 0; c < count; ++c) total[c] = 0.0;
  for (std::size_t i = 0; i < critics; ++i) {
    const double weight = scores[i].weight;
    const double* __restrict raw = scores[i].raw;
    for (std::size_t c = 0; c < count; ++c) total[c] += weight * raw[c];
  }
  const double* __restrict v = deviation.v;
  const double target_v = deviation.target_v, s_v = deviation.s_v, of_turn = deviation.of_turn;
  if (v != nullptr) {
    for (std::size_t c = 0; c < count; ++c) total[c] = total[c] + (s_v * std::abs(target_v - v[c]) + of_turn);
  }
}

}  // namespace hidwa_local_planner::kernel
