// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace hidwa_ways {

/// A campaign's command line. All throw std::invalid_argument, which names what is wrong.
class Arguments {
 public:
  /// Options that take a value, and others that stand alone; `needs`: some make sense only with another one.
  Arguments(int count, char** words, const std::set<std::string>& valued, const std::set<std::string>& alone,
            const std::map<std::string, std::string>& needs);

  bool has(const std::string& name) const { return given_.count(name) != 0; }
  /// The last one given; "" where there is none.
  std::string text(const std::string& name) const { return has(name) ? given_.at(name).back() : ""; }
  /// All that were given, each a list "a,b".
  std::vector<std::string> list(const std::string& name) const;
  long whole(const std::string& name, long fallback, long least) const;
  std::uint64_t seed(const std::string& name) const { return static_cast<std::uint64_t>(whole(name, 1, 0)); }
  /// For a CSV file; closed where none was given.
  std::ofstream trace() const;

 private:
  std::map<std::string, std::vector<std::string>> given_;
};

/// Throws std::invalid_argument where it cannot be written.
void write_file(const std::string& path, const std::string& content);

}  // namespace hidwa_ways
