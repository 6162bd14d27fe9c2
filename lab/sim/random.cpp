// SPDX-License-Identifier: BSD-3-Clause
#include "sim/random.hpp"

#include <cmath>

namespace hidwa_local_planner {
namespace sim {

double Random::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * M_PI * uniform());
}

}  // namespace sim
}  // namespace hidwa_local_planner
