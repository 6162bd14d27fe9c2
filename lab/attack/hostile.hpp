// SPDX-License-Identifier: BSD-3-Clause
// The drives of a hostile study: every promised condition in turn, each on some ground, with somebody at some device,
// with or without people who walk; and, every twentieth, one outside the promise.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "spec.hpp"

namespace hidwa_attack {

/// Where drives may take place besides in drawn scenes.
struct Ground {
  std::string name;
  std::shared_ptr<const World> world;
};

struct HostileDrive {
  std::string condition;
  std::string place;  // a ground's name, or that of what is drawn
  bool promised = true;
  Spec spec;
  std::uint64_t seed = 0;

  int nominal_cycles() const { return 1000 * spec.seconds / spec.period; }
};

/// Drive `index` of the study with this seed: always the same one.
HostileDrive hostile_drive(std::uint64_t study_seed, std::uint64_t index, const std::vector<Ground>& grounds);

const char* name_of(Link link);

}  // namespace hidwa_attack
