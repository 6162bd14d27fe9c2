// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <rosbag/bag.h>

namespace hidwa_local_planner {
namespace replay {

/// A bag opened to be read. One that was cut short (a recorder that crashed, a copy that broke off) is copied to a
/// temporary folder, and what is intact of the copy is read; the file itself is never changed.
class RepairedBag {
 public:
  /// Throws UsageError where nothing of it can be read.
  explicit RepairedBag(const std::string& path);
  ~RepairedBag();
  RepairedBag(const RepairedBag&) = delete;
  RepairedBag& operator=(const RepairedBag&) = delete;

  rosbag::Bag& bag() { return bag_; }
  /// What is wrong with the file, in words; empty where nothing is.
  const std::string& fault() const { return fault_; }

 private:
  void open_copy(const std::string& path);

  rosbag::Bag bag_;
  std::string folder_;  // of the copy
  std::string fault_;
};

}  // namespace replay
}  // namespace hidwa_local_planner
