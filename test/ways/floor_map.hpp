// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ways/site.hpp"

namespace hidwa_ways {

/// A part of 12 m about a random gap, between 0.5 m and 1.2 m wide.
Site gap_of(const World& map, Random& random);

}  // namespace hidwa_ways
