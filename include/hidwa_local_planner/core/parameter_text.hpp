// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// A value as people write it. A double is read back to the same bits.
std::string to_text(const ParameterValue& value);

/// Sets the parameter `name` from a text like "0.5", "true" or "geodesic". Returns the fault in words, empty when it
/// was set.
std::string set_parameter_text(Parameters& parameters, const std::string& name, const std::string& text);

/// All parameters, a line `name=value` each.
std::string to_lines(const Parameters& parameters);

/// Takes such lines. Returns a fault for each that cannot be taken.
std::vector<std::string> set_lines(Parameters& parameters, const std::string& lines);

}  // namespace hidwa_local_planner
