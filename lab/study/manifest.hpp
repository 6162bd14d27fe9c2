// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// Seeds of worlds stay below it: they fit 2^53, so that every reader of CSV takes them for the same number.
constexpr std::uint64_t kSeeds = 1000000000ULL;

/// What a file says, so that another file of the same name is another study (FNV-1a).
std::string fingerprint_of_file(const std::string& path);

/// `--set` as a JSON list.
nlohmann::json json_of(const std::vector<Assignment>& sets);

}  // namespace study
}  // namespace hidwa_local_planner
