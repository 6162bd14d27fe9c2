// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>
#include <utility>

namespace hidwa_attack {

// A planner that does not ask for them is not told.
template <typename Situation, typename = void>
struct AsksForLongestPeriod : std::false_type {};
template <typename Situation>
struct AsksForLongestPeriod<Situation, std::void_t<decltype(std::declval<Situation&>().longest_period)>>
    : std::true_type {};

template <typename Situation, typename = void>
struct AsksForPoseAge : std::false_type {};
template <typename Situation>
struct AsksForPoseAge<Situation, std::void_t<decltype(std::declval<Situation&>().pose_age)>> : std::true_type {};

/// The longest period of late, measured, and the age of the pose [s], where the planner asks for them.
template <typename Situation>
void tell_times(Situation& situation, [[maybe_unused]] double longest_period, [[maybe_unused]] double pose_age) {
  if constexpr (AsksForLongestPeriod<Situation>::value) situation.longest_period = longest_period;
  if constexpr (AsksForPoseAge<Situation>::value) situation.pose_age = pose_age;
}

}  // namespace hidwa_attack
