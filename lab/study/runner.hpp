// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace hidwa_local_planner {
namespace study {

/// As many threads as asked for; 0: as many as the computer has cores.
std::size_t threads_for(std::size_t asked);

/// Makes `count` runs on several threads. `make` is called once with each number below `count`, from any of them;
/// `made` after each, one at a time. The first exception ends it, after the runs under way, and is thrown on.
void make_runs(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& make,
               const std::function<void()>& made);

}  // namespace study
}  // namespace hidwa_local_planner
