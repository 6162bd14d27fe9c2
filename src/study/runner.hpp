// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "study/plan.hpp"

namespace hidwa_local_planner {
namespace study {

/// Makes runs on several threads. `make` is called once for each, from any of them; `made` after each, one at
/// a time. The first exception ends it, after the runs under way, and is thrown on.
void make_runs(const std::vector<Run>& runs, std::size_t threads, const std::function<void(const Run&)>& make,
               const std::function<void()>& made);

}  // namespace study
}  // namespace hidwa_local_planner
