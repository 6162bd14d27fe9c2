// SPDX-License-Identifier: BSD-3-Clause
// The drives of an attack: of one condition after the other; or mixed, every promised condition in turn, each on some
// ground, with somebody at some device, with or without people who walk, and every twentieth outside the promise.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "conditions.hpp"

namespace hidwa_attack {

/// Where mixed drives may take place besides in drawn scenes.
struct Ground {
  std::string name;
  std::shared_ptr<const World> world;
};

/// One drive, before it is driven.
struct Case {
  const Condition* condition = nullptr;
  std::string place;  // a ground's name, or that of what is drawn
  Spec spec;
  std::uint64_t seed = 0;
};

/// The drive of a seed under a condition: always the same one.
Case case_of(const Condition& condition, std::uint64_t seed);
/// Mixed drive `number` of the attack with this seed: likewise.
Case mixed_case(std::uint64_t attack_seed, std::uint64_t number, const std::vector<Ground>& grounds);

const char* name_of(Link link);

}  // namespace hidwa_attack
