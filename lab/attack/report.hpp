// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "summary.hpp"

namespace hidwa_attack {

/// The table's head, and one condition's line in it.
std::string table_head();
std::string table_line(const Summary& summary);
/// How to repeat the worst drives of a condition alone; empty where it found nothing. `seconds`: of each drive [s].
std::string how_to_repeat(const Summary& summary, int seconds);
/// All of them, as JSON.
std::string as_json(const std::vector<Summary>& summaries, int seconds);
/// A line a drive, as CSV, with a head.
std::string drives_head();
std::string drive_line(const Summary& summary, const DriveResult& result);

}  // namespace hidwa_attack
