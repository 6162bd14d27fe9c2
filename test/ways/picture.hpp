// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "ways/campaign.hpp"

namespace hidwa_ways {

/// An SVG: the map, the plan (green), the way that was found (blue) and the way that was driven (red), each with the
/// outline now and then.
std::string picture(const Account& account);

}  // namespace hidwa_ways
