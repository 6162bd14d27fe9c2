// SPDX-License-Identifier: BSD-3-Clause
#include "ways/barn_field.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "ways/drawing.hpp"

namespace hidwa_ways {
namespace {

constexpr double kLattice = 0.15;  // between neighbours [m]
constexpr double kRadius = 0.075;  // [m]
constexpr double kAround = 0.8;    // free around a field [m]

BarnField read_field(const std::string& cells, const std::string& file) {
  BarnField field;
  std::istringstream words(cells);
  for (std::string word; words >> word;) {
    int column = 0, row = 0;
    if (std::sscanf(word.c_str(), "%d:%d", &column, &row) != 2)
      throw std::invalid_argument(file + ": '" + word + "' is no cell of a BARN field");
    field.push_back({-kLattice * (column + 0.5), kLattice * (row + 0.5)});
  }
  return field;
}

}  // namespace

std::vector<BarnField> read_barn_fields(const std::string& file) {
  std::ifstream in(file);
  std::vector<BarnField> fields;
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = line.find('|'), end = line.find('|', begin + 1);
    if (line.empty() || line.front() == '#' || end == std::string::npos) continue;
    fields.push_back(read_field(line.substr(begin + 1, end - begin - 1), file));
  }
  if (fields.empty()) throw std::invalid_argument("no BARN field in '" + file + "'");
  return fields;
}

Site barn(const std::vector<BarnField>& fields, const Measure& measure, Random& random) {
  const BarnField& field = fields[static_cast<std::size_t>(random.whole(0, static_cast<int>(fields.size()) - 1))];
  Spot low = field.front(), high = field.front();
  for (const Spot& p : field) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low.x + 2.0 * kAround, height = high.y - low.y + 2.0 * kAround;
  Site site{World(width, height, measure.resolution), {}, 1.5, false};
  for (const Spot& p : field) fill_disc(site.world, {p.x - low.x + kAround, p.y - low.y + kAround}, kRadius, true);
  wall_in(site.world);
  site.at = {random.in(0.25, 0.75) * width, random.in(0.15, 0.85) * height};
  return site;
}

}  // namespace hidwa_ways
