// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "ways/scene.hpp"
#include "ways/search.hpp"
#include "ways/target.hpp"

namespace hidwa_ways {

/// Whether there is a way: surely, surely not, or it depends on less than the margin.
enum class Class { sure, none, open };
const char* to_string(Class value);

constexpr double kFurther = 1.5;     // along the plan: there a way ends [m]
constexpr double kLongestWay = 3.0;  // [m]
constexpr double kArrives = 0.15;    // a way ends so near to the plan [m]

/// What the searches know of a scene.
struct Finding {
  Class answer = Class::open;
  Way way;                         // of class `sure`
  double remaining = 0.0;          // from the start, as `field` has it [m]
  std::unique_ptr<Search> field;   // the remaining way from everywhere; of class `sure`
  std::unique_ptr<Ground> ground;  // of the field
};

/// The steps of position: half a cell, or finer [m].
double step_of(const Scene& scene);

Finding examine(const Scene& scene);

/// Where a drive is through: so near to this [m]. No wall fits between, since robot and plan are each at least an
/// inscribed radius from it.
Target through_target(const Scene& scene);
/// The same and all of the plan after it: a robot that comes back to its plan farther on is through as well.
Target through_or_farther(const Scene& scene);
double through_distance(const Scene& scene);

}  // namespace hidwa_ways
