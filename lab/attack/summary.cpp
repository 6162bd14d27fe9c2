// SPDX-License-Identifier: BSD-3-Clause
#include "summary.hpp"

#include <algorithm>

namespace hidwa_attack {

Summary::Summary(const Condition& of, const std::vector<DriveResult>& all)
    : condition(of.name), promised(of.promised), drives(static_cast<int>(all.size())) {
  int moved = 0;
  double worst_beyond = 0.0;
  for (const DriveResult& one : all) {
    cycles += one.cycles;
    moved += one.moving;
    threatened += one.threatened;
    contacts += one.touched;
    if (one.touched && one.depth >= worst_depth) {
      worst_depth = one.depth;
      worst_seed = one.seed;
    }
    beyond += one.beyond;
    hard += one.hard;
    beyond_v = std::max(beyond_v, one.beyond_worst.v);
    beyond_omega = std::max(beyond_omega, one.beyond_worst.omega);
    if (one.beyond_worst.v + one.beyond_worst.omega > worst_beyond) {
      worst_beyond = one.beyond_worst.v + one.beyond_worst.omega;
      beyond_seed = one.seed;
    }
    stood_in += one.stood_in;
    came_out += one.came_out;
    entered += one.entered > 0;
    too_fast += one.fastest_inside > 1.02 * one.speed_bound;
    worst_growth = std::max(worst_growth, one.growth);
    worst_excess = std::max(worst_excess, one.excess);
    if (one.touched || one.beyond > 0 || one.hard > 0) found.push_back(one.seed);
  }
  moving = cycles > 0 ? static_cast<double>(moved) / cycles : 0.0;
}

}  // namespace hidwa_attack
