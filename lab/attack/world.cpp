// SPDX-License-Identifier: BSD-3-Clause
#include "world.hpp"

#include <algorithm>

namespace hidwa_attack {

double deepest(const World& world, const Placed& placed, double cap) {
  double most = -cap;
  world.near(placed, cap, [&most](int, int, double depth) { most = std::max(most, depth); });
  return most;
}

}  // namespace hidwa_attack
