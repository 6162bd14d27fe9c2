// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "study/plan.hpp"
#include "study/scene.hpp"

namespace hidwa_local_planner {
namespace study {

/// A line of runs.csv as its cells.
using Row = std::vector<std::string>;

/// The names of runs.csv's columns.
const std::vector<std::string>& columns();

/// Those of them that are measured.
const std::vector<std::string>& measures();

/// A number as it is written everywhere: six decimals, and no negative zero.
std::string number(double value);

/// The line of one run in a table with the columns `names`. `own`: the cells of columns that only this table has; the
/// others are of the run and of what became of it, in the words of columns().
Row row_in(const std::vector<std::string>& names, const Plan& plan, const Run& run, std::uint64_t world_seed,
           const drive::DriveResult& result, std::map<std::string, std::string> own);

/// The line of one run of the study with simulated people.
Row row_of(const Plan& plan, const Run& run, std::uint64_t world_seed, const Driven& driven);

/// A cell by its column's name; a measure as a number. `names`: of the table's columns.
const std::string& cell(const Row& row, const std::string& column, const std::vector<std::string>& names = columns());
double value(const Row& row, const std::string& column, const std::vector<std::string>& names = columns());

/// Cells joined, without an end of line; and split again.
std::string to_line(const Row& row);
Row from_line(const std::string& line);

/// A run's way: t [s], x, y [m], theta [rad] (map frame), v [m/s], omega [rad/s] as commanded, and the
/// operator's state.
std::string path_csv(const drive::DriveResult& result);

}  // namespace study
}  // namespace hidwa_local_planner
