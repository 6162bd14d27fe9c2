// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "study/options.hpp"
#include "study/scene.hpp"

namespace hidwa_local_planner {
namespace study {

/// The options with map and regions where they name none: the package's office, another map without regions.
Options with_floor(Options options);

/// The floor of options whose map and regions are named. Throws UsageError.
Scene scene_of(const Options& options);

nlohmann::json json_of(const sim::Pose& pose);

/// What decides about drives across a floor, for study.json.
nlohmann::json json_of_floor(const Options& options, const Scene& scene);

}  // namespace study
}  // namespace hidwa_local_planner
