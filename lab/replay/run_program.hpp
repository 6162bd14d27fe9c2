// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace hidwa_local_planner {
namespace replay {

enum class Output { shown, silent };
constexpr int kNotFound = 127;

/// Runs a program of the path and waits for it; its exit status, kNotFound where there is none of that name, or -1
/// where a signal ended it.
int run_program(const std::vector<std::string>& words, Output output);

}  // namespace replay
}  // namespace hidwa_local_planner
