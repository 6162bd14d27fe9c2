// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ways/summary.hpp"

namespace hidwa_ways {

std::string table(const std::vector<Summary>& summaries);
std::string scenes_csv(const std::vector<Result>& results);
/// What became of one scene, in words.
std::string in_words(const Result& result);
/// A line for each scene that was not as asked, with the arguments that repeat it.
std::string failures(const std::vector<Result>& results);

}  // namespace hidwa_ways
