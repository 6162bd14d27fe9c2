// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace costmap_2d {

/// What a cell's cost means; between FREE_SPACE and INSCRIBED_INFLATED_OBSTACLE it falls with distance from
/// obstacles.
static const unsigned char NO_INFORMATION = 255;
static const unsigned char LETHAL_OBSTACLE = 254;
static const unsigned char INSCRIBED_INFLATED_OBSTACLE = 253;
static const unsigned char FREE_SPACE = 0;

}  // namespace costmap_2d
