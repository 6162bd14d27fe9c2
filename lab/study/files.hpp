// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hidwa_local_planner {
namespace study {

/// The path of one of the package's files, such as maps/office.yaml: where the package is installed, seen
/// from the program, or else where it was built from.
std::string share_file(const std::string& name);

/// What a file says; none where it cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// Of what a file says, so that another file of the same name is another study; "none" stays as it is.
std::string fingerprint_of_file(const std::string& path);

/// Of bytes (FNV-1a), in hexadecimal.
std::string fingerprint(const std::string& bytes);

}  // namespace study
}  // namespace hidwa_local_planner
