// SPDX-License-Identifier: BSD-3-Clause
#include "manifest.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace hidwa_local_planner {
namespace study {

std::string fingerprint_of_file(const std::string& path) {
  if (path == "none") return "none";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text.str()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  char digits[24];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

std::string json_of(const std::vector<Assignment>& sets) {
  std::string list;
  for (const Assignment& set : sets) list += (list.empty() ? "" : ", ") + quoted(set.name + "=" + set.value);
  return "[" + list + "]";
}

}  // namespace study
}  // namespace hidwa_local_planner
