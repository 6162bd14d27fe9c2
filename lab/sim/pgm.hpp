// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace hidwa_local_planner {
namespace sim {

/// A grey image, row 0 at the top.
struct GreyImage {
  int width = 0;               // [pixels]
  int height = 0;              // [pixels]
  std::vector<double> pixels;  // 0 (black) to 1 (white), row by row
};

/// Reads a PGM image, plain (P2) or binary (P5), 8 or 16 bit. Throws std::runtime_error naming file and
/// fault.
GreyImage read_pgm(const std::string& path);

}  // namespace sim
}  // namespace hidwa_local_planner
