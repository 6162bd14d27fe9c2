// SPDX-License-Identifier: BSD-3-Clause
#include "ways/arguments.hpp"

#include <cstdlib>
#include <stdexcept>

#include "core/util/words.hpp"

namespace hidwa_ways {

Arguments::Arguments(int count, char** words, const std::set<std::string>& valued, const std::set<std::string>& alone,
                     const std::map<std::string, std::string>& needs) {
  for (int k = 1; k < count; ++k) {
    const std::string name = words[k];
    const bool takes = valued.count(name) != 0;
    if (!takes && alone.count(name) == 0) throw std::invalid_argument("unknown option " + name);
    if (takes && k + 1 >= count) throw std::invalid_argument(name + " needs a value");
    given_[name].emplace_back(takes ? words[++k] : "");
  }
  for (const auto& [name, other] : needs) {
    if (has(name) && !has(other)) throw std::invalid_argument(name + " needs " + other);
  }
}

std::vector<std::string> Arguments::list(const std::string& name) const {
  std::vector<std::string> all;
  if (!has(name)) return all;
  for (const std::string& one : given_.at(name)) {
    for (const std::string& part : hidwa_local_planner::split(one, ',')) {
      if (!part.empty()) all.push_back(part);
    }
  }
  return all;
}

long Arguments::whole(const std::string& name, long fallback, long least) const {
  if (!has(name)) return fallback;
  const std::string given = text(name);
  char* end = nullptr;
  const long value = std::strtol(given.c_str(), &end, 10);
  if (given.empty() || *end != '\0' || value < least) {
    throw std::invalid_argument(name + ": '" + given + "' is no whole number of at least " + std::to_string(least));
  }
  return value;
}

std::ofstream Arguments::trace() const {
  std::ofstream out;
  if (has("--trace")) out.open(text("--trace"));
  if (has("--trace") && !out) throw std::invalid_argument("cannot write " + text("--trace"));
  out.precision(9);
  return out;
}

void write_file(const std::string& path, const std::string& content) {
  std::ofstream out(path);
  out << content;
  if (!out.flush()) throw std::invalid_argument("cannot write " + path);
}

}  // namespace hidwa_ways
