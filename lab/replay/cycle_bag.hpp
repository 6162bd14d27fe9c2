// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "hidwa_local_planner/Cycle.h"
#include "repaired_bag.hpp"

namespace hidwa_local_planner {
namespace replay {

/// The cycle messages of a bag.
class CycleBag {
 public:
  /// `topic` empty: the only one that carries cycles. Throws UsageError where it is not there, or not alone.
  CycleBag(const std::string& path, const std::string& topic);
  const std::string& topic() const { return topic_; }
  /// What is wrong with the file, in words; empty where nothing is.
  const std::string& fault() const { return fault_; }
  /// Calls for every message in their order, until it returns false. What ends the file too early goes to fault().
  void for_each(const std::function<bool(const Cycle&)>& call);

 private:
  RepairedBag file_;
  std::string topic_;
  std::string fault_;
};

}  // namespace replay
}  // namespace hidwa_local_planner
