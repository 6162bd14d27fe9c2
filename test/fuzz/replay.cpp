// SPDX-License-Identifier: BSD-3-Clause
// Instead of libFuzzer, where there is none: gives every file of the folders named to the target, then as many
// mutations of it as --mutations says, the same in every run. Exit status 0: no fault; 2: nothing was found to give.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;
using hidwa_local_planner::test::Random;

Bytes read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

// A handful of bytes changed, dropped or doubled.
Bytes mutated(Bytes bytes, Random& random) {
  for (int k = random.integer(1, 8); k > 0; --k) {
    const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), 1000000));
    if (size == 0) bytes.push_back(static_cast<std::uint8_t>(random.bits()));
    const auto at = bytes.begin() + (size > 0 ? random.integer(0, size - 1) : 0);
    switch (random.integer(0, 3)) {
      case 0:
        bytes.erase(at);
        break;
      case 1:
        bytes.insert(at, static_cast<std::uint8_t>(random.bits()));
        break;
      default:
        *at = static_cast<std::uint8_t>(random.bits());
    }
    if (bytes.empty()) break;
  }
  return bytes;
}

std::vector<std::filesystem::path> files_of(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  int mutations = 0;
  long given = 0;
  Random random(1);
  for (int k = 1; k < argc; ++k) {
    if (std::strncmp(argv[k], "--mutations=", 12) == 0) {
      mutations = std::atoi(argv[k] + 12);
      continue;
    }
    for (const std::filesystem::path& path : files_of(argv[k])) {
      const Bytes bytes = read_file(path);
      std::fprintf(stderr, "%s\n", path.c_str());  // the last line names the culprit
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      ++given;
      for (int m = 0; m < mutations; ++m, ++given) {
        const Bytes other = mutated(bytes, random);
        LLVMFuzzerTestOneInput(other.data(), other.size());
      }
    }
  }
  std::printf("%ld inputs\n", given);
  return given > 0 ? 0 : 2;
}
