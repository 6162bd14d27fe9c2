// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "random.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// One way to attack.
struct Condition {
  const char* name;
  bool promised;  // the planner must hold; else it is reported only
  const char* what;
  void (*make)(Spec& spec, Random& random);
};

const std::vector<Condition>& all_conditions();
/// Null where there is none of that name.
const Condition* find_condition(const std::string& name);

/// The drive of a seed under a condition: the same drive each time.
Spec spec_of(const Condition& condition, std::uint64_t seed);

}  // namespace hidwa_attack
