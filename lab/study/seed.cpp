// SPDX-License-Identifier: BSD-3-Clause
#include "study/seed.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// The finaliser of SplitMix64 (Steele, Lea and Flood 2014): near seeds give far ones.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

std::uint64_t seed_for(std::uint64_t study_seed, int participant, const std::string& purpose) {
  std::uint64_t seed = mixed(mixed(study_seed) + static_cast<std::uint64_t>(participant));
  for (const char c : purpose) seed = mixed(seed + static_cast<unsigned char>(c));
  return seed;
}

Seeds seeds_of(std::uint64_t study_seed, const Run& run) {
  constexpr std::uint64_t kWorlds = 1000000000ULL;
  return {seed_for(study_seed, run.participant, "world") % kWorlds,
          seed_for(study_seed, run.participant, "person " + run.condition)};
}

}  // namespace study
}  // namespace hidwa_local_planner
