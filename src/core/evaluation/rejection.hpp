// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace hidwa_local_planner {

/// Who rejected a candidate: nobody, the collision check, the braking check, the check for what moves, the
/// bound where nobody sees, the check for who may come out of a shadow, or critic number (value - kFirstCritic).
using Rejecter = std::uint8_t;
constexpr Rejecter kNobody = 0;
constexpr Rejecter kCollision = 1;
constexpr Rejecter kBraking = 2;
constexpr Rejecter kMovingObstacle = 3;
constexpr Rejecter kBlind = 4;
constexpr Rejecter kOcclusion = 5;
constexpr Rejecter kFirstCritic = 6;

// Arrays: a reason is known again by its address, and a literal may have another one in each source file.
inline constexpr char kCannotBrake[] = "cannot stop in free space";
inline constexpr char kMayBeTouched[] = "something that moves may touch the robot before it rests";
inline constexpr char kUnseen[] = "it moves too fast towards where nobody sees";
inline constexpr char kHidden[] = "somebody may step out of where no sensor sees, and touch the robot while it drives";
inline constexpr char kNotANumber[] = "total is not a number";

}  // namespace hidwa_local_planner
