// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.hpp"

#include <atomic>
#include <thread>

#include "drive.hpp"

namespace hidwa_attack {

std::vector<DriveResult> run(const Condition& condition, const Extent& extent) {
  std::vector<DriveResult> results(static_cast<std::size_t>(extent.drives));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < results.size(); k = next++) {
      const std::uint64_t seed = extent.first_seed + k;
      const Spec spec = spec_of(condition, seed, extent.seconds);
      results[k] = drive(spec, seed);
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < extent.threads; ++k) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return results;
}

}  // namespace hidwa_attack
