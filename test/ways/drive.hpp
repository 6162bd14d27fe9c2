// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include "ways/result.hpp"

namespace hidwa_ways {

/// Lets the planner drive a scene, with nobody steering, and fills in what became of it. With `trace` a CSV line a
/// cycle; with `driven` the pose of each cycle.
void drive(const Scene& scene, const Finding& finding, Result& result, std::ostream* trace = nullptr,
           std::vector<Pose2>* driven = nullptr);

}  // namespace hidwa_ways
