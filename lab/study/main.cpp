// SPDX-License-Identifier: BSD-3-Clause
// hidwa_study: simulated people steer the simulated robot; hidwa_study --help.
#include <iostream>
#include <string>
#include <vector>

#include "study/program.hpp"

int main(int argc, char** argv) {
  return hidwa_local_planner::study::program(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
}
