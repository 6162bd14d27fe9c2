// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "drive/result.hpp"
#include "study/options.hpp"
#include "study/store.hpp"

namespace hidwa_local_planner {
namespace study {

/// A finished run.
struct Made {
  Row row;
  drive::DriveResult result;
};

/// Makes the runs of this part of a plan that are not finished, on as many threads as asked for, and the
/// tables of all that are; `make` may be called from several threads. `deciding`: what decides about the
/// results besides version, seed, --set and --paths, by name. Returns the program's exit code.
int execute(const Options& options, const Plan& plan, const nlohmann::json& deciding,
            const std::function<Made(const Run&)>& make, std::ostream& out, std::ostream& errors);

/// Joins the parts that `options` name. Returns the program's exit code.
int merge(const Options& options, std::ostream& out, std::ostream& errors);

}  // namespace study
}  // namespace hidwa_local_planner
