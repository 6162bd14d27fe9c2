// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace hidwa_local_planner {
namespace study {

/// What the user asked for makes no sense; the text names what and the remedy.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace study
}  // namespace hidwa_local_planner
