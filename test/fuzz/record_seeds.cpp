// SPDX-License-Identifier: BSD-3-Clause
// Writes the first files of corpus/record: three cycles of random drives each, as the planner records them now.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

#include "support/recorded_drive.hpp"

int main(int argc, char** argv) {
  using namespace hidwa_local_planner;
  if (argc != 2) {
    std::fprintf(stderr, "hidwa_record_seeds FOLDER\n");
    return 2;
  }
  for (int seed = 0; seed < 6; ++seed) {
    test::RecordedDrive drive(static_cast<std::uint64_t>(seed), static_cast<OperatorMode>(seed % 4));
    std::ofstream file(std::string(argv[1]) + "/drive_" + std::to_string(seed), std::ios::binary);
    for (const test::RecordedDrive::Cycle& cycle : drive.run(3)) {
      const std::size_t size = cycle.record.size();
      file.put(static_cast<char>(size & 0xffU));
      file.put(static_cast<char>(size >> 8U));
      file.write(reinterpret_cast<const char*>(cycle.record.data()), static_cast<std::streamsize>(size));
    }
  }
  return 0;
}
