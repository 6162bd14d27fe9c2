// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tracking/beams.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// Neighbouring beams that end at one surface, none of them at something that stands.
struct Segment {
  std::size_t first = 0;        // index of the first beam; in a whole turn `last` may be below it
  std::size_t last = 0;         // index of the last beam
  std::size_t points = 0;       // beams that end there
  std::size_t free_before = 0;  // of these, how many end where space was seen free
  bool hidden_first = false;    // something nearer may hide more of it before the first beam
  bool hidden_last = false;     // and after the last one
  Point chord_begin{0.0, 0.0};  // [m]
  Point chord_end{0.0, 0.0};    // [m]
  std::int32_t track = -1;      // that it is taken for

  double chord() const { return (chord_end - chord_begin).norm(); }
};

/// Segments of a scan, those wider than `widest` [m] left out. Bodies that touch each other are taken apart at the dent
/// between them. `hull` is room to work in.
void find_segments(const Beams& beams, double range_noise, double widest, std::vector<Segment>& out,
                   std::vector<std::size_t>& hull);

/// Calls visit(beam index) for each beam of a segment that ends at something.
template <typename Visit>
void for_points(const Beams& beams, const Segment& segment, Visit visit) {
  std::size_t i = segment.first;
  while (true) {
    if (beams.all[i].hit) visit(i);
    if (i == segment.last) return;
    i = i + 1 == beams.all.size() ? 0 : i + 1;
  }
}

}  // namespace tracking
}  // namespace hidwa_local_planner
