// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace hidwa_local_planner {

/// Hands the newest value from one thread to another. Neither thread waits for the other.
template <typename T>
class Handover {
 public:
  Handover() = default;
  ~Handover() { take(); }
  Handover(const Handover&) = delete;
  Handover& operator=(const Handover&) = delete;

  /// Replaces a value that was not taken.
  void put(T value) {
    const std::unique_ptr<T> replaced(value_.exchange(std::make_unique<T>(std::move(value)).release()));
  }
  /// Something was put that was not taken.
  bool waits() const { return value_.load() != nullptr; }
  /// Null where nothing new was put.
  std::unique_ptr<T> take() { return std::unique_ptr<T>(value_.exchange(nullptr)); }

 private:
  std::atomic<T*> value_{nullptr};
};

}  // namespace hidwa_local_planner
