// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ways/site.hpp"

namespace hidwa_ways {

/// The cylinders of one world of BARN [m] (Perille et al. 2020): upright, of radius 0.075 m.
using BarnField = std::vector<Spot>;

/// Reads one field a line, `index | column:row ... | path`; lines with # are comments. Throws std::invalid_argument.
std::vector<BarnField> read_barn_fields(const std::string& file);

/// A place in the midst of one of them.
Site barn(const std::vector<BarnField>& fields, const Measure& measure, Random& random);

}  // namespace hidwa_ways
