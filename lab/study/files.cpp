// SPDX-License-Identifier: BSD-3-Clause
#include "files.hpp"

#include <cstdint>
#include <fstream>
#include <sstream>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {

std::string share_file(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  // PREFIX/lib/hidwa_local_planner/hidwa_study and PREFIX/share/hidwa_local_planner
  const fs::path installed = program.parent_path().parent_path().parent_path() / "share" / "hidwa_local_planner" / name;
  if (fs::exists(installed, error)) return installed.string();
  return std::string(HIDWA_SOURCE_DIR) + "/" + name;
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string fingerprint_of_file(const std::string& path) {
  return path == "none" ? path : fingerprint(read_file(path).value_or(""));
}

std::string fingerprint(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return format("%016llx", static_cast<unsigned long long>(hash));
}

}  // namespace study
}  // namespace hidwa_local_planner
