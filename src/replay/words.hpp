// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace replay {

/// printf into a string.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
format(const char* text, ...);

/// "DRIVE (0.500 m/s, -0.123 rad/s)"
std::string in_words(const record::Verdict& verdict);
/// "(0.500 m/s, -0.123 rad/s)"
std::string in_words(const Twist2& u);
/// A text as JSON has it, quotes included.
std::string json(const std::string& text);
/// A number as JSON has it: what is not finite is null.
std::string json(double number);

}  // namespace replay
}  // namespace hidwa_local_planner
