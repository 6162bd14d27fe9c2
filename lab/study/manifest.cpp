// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.hpp"

#include <fstream>
#include <sstream>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {

std::string fingerprint_of_file(const std::string& path) {
  if (path == "none") return "none";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text.str()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return format("%016llx", static_cast<unsigned long long>(hash));
}

nlohmann::json json_of(const std::vector<Assignment>& sets) {
  nlohmann::json list = nlohmann::json::array();
  for (const Assignment& set : sets) list.push_back(set.name + "=" + set.value);
  return list;
}

}  // namespace study
}  // namespace hidwa_local_planner
