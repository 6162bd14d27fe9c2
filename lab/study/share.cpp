// SPDX-License-Identifier: BSD-3-Clause
#include "share.hpp"

#include <filesystem>

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

}  // namespace study
}  // namespace hidwa_local_planner
