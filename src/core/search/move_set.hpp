// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/search/search_task.hpp"

namespace hidwa_local_planner {

/// Headings of a search are whole multiples of this from the start's [rad]: a degree.
constexpr int kHeadings = 360;
constexpr double kHeadingStep = 2.0 * M_PI / kHeadings;

/// Cells of more than this are coarse for a robot: what is small does not grow with them [m].
constexpr double kUsualCell = 0.05;

/// A search looks coarsely first, and closely where it has found nothing.
enum class Pass : std::uint8_t { coarse = 0, close };

/// How closely poses are told apart.
enum class Fineness : std::uint8_t { open = 0, tight, touching };

enum class MoveKind : std::uint8_t { none = 0, turn, forward, backward };

/// One motion of constant velocity, from the origin of the robot's frame.
struct Move {
  MoveKind kind = MoveKind::none;
  int turn = 0;         // in kHeadingStep, left positive
  double length = 0.0;  // of the centre's way, negative backwards [m]
  double time = 0.0;    // [s]
  double reach = 0.0;   // no point of the robot moves farther [m]
  double x = 0.0;       // where it ends, in the frame of its start [m]
  double y = 0.0;       // [m]
};

/// The moves of one fineness, and its bins.
struct MoveSet {
  double bin = 0.0;     // side [m]
  int heading_bin = 1;  // in kHeadingStep
  std::vector<Move> moves;
};

class MoveSets {
 public:
  /// For the robot of a task. `radius` [m] reaches from its centre to its farthest point.
  void make(const SearchTask& task, double radius, Pass pass);
  const MoveSet& of(Fineness fineness) const { return sets_[static_cast<std::size_t>(fineness)]; }

 private:
  std::array<MoveSet, 3> sets_;
};

/// Where a part of a move ends: `share` of it, 0 to 1, in the frame of its start.
Pose2 part_of(const Move& move, double share);

}  // namespace hidwa_local_planner
