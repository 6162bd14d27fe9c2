// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ways/result.hpp"

namespace hidwa_ways {

/// Which scenes: of each kind so many, from a seed on.
struct Extent {
  std::vector<const Kind*> kinds;
  int scenes = 500;  // of each kind
  std::uint64_t first_seed = 1;
  int threads = 1;
};

/// One scene: made, searched, checked and driven. With `driven` the finding and the poses too.
struct Account {
  Result result;
  Scene scene;
  Finding finding;
  std::vector<Pose2> driven;
};
Account run_scene(const Kind& kind, std::uint64_t seed, std::ostream* trace = nullptr);

/// All of them, in the order of kinds and seeds, whatever the number of threads; `seen` hears of each as it ends.
std::vector<Result> run(const Extent& extent, const std::function<void(const Result&)>& seen = {});

}  // namespace hidwa_ways
