// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

using Bytes = std::vector<std::uint8_t>;

/// Writes values as bytes, one behind the other, and ArchiveReader reads them back to the same bits. A class is
/// archived that names its members once, for both directions:
///
///   template <typename Self, typename Archive>
///   static void archive(Self& self, Archive& io) { io(self.a_, self.b_); }
///
/// Numbers are written as the machine has them; all that ROS 1 runs on are little-endian.
class ArchiveWriter {
 public:
  explicit ArchiveWriter(Bytes& bytes) : bytes_(bytes) {}
  template <typename... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

 private:
  void raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  void put_size(std::size_t size) { put(static_cast<std::uint32_t>(size)); }

  template <typename T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      bytes_.push_back(value ? 1 : 0);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof(value));
    } else {
      T::archive(value, *this);
    }
  }
  void put(const Twist2& u) { (*this)(u.v, u.omega); }
  void put(const Pose2& q) { (*this)(q.x, q.y, q.theta); }
  void put(const std::string& text) {
    put_size(text.size());
    raw(text.data(), text.size());
  }
  template <int Rows>
  void put(const Eigen::Matrix<double, Rows, 1>& vector) {
    raw(vector.data(), sizeof(double) * Rows);
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    put_size(values.size());
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      raw(values.data(), values.size());
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <typename T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }

  Bytes& bytes_;
};

/// Reads what ArchiveWriter wrote. Bytes that end too early, or hold an impossible length, give zeros and failed().
/// Nothing throws.
class ArchiveReader {
 public:
  ArchiveReader(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}
  explicit ArchiveReader(const Bytes& bytes) : ArchiveReader(bytes.data(), bytes.size()) {}
  template <typename... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  bool failed() const { return failed_; }
  /// Every byte was read, and none was missing.
  bool complete() const { return !failed_ && left_ == 0; }

 private:
  bool raw(void* data, std::size_t size) {
    failed_ = failed_ || size > left_;
    if (failed_) return false;
    if (size > 0) std::memcpy(data, at_, size);
    at_ += size;
    left_ -= size;
    return true;
  }
  std::size_t get_size(std::size_t each) {
    std::uint32_t size = 0;
    get(size);
    failed_ = failed_ || size > left_ / each;
    return failed_ ? 0 : size;
  }

  template <typename T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      raw(&byte, 1);
      value = byte != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      if (!raw(&value, sizeof(value))) value = T{};
    } else {
      T::archive(value, *this);
    }
  }
  void get(Twist2& u) { (*this)(u.v, u.omega); }
  void get(Pose2& q) { (*this)(q.x, q.y, q.theta); }
  void get(std::string& text) {
    text.resize(get_size(1));
    raw(text.data(), text.size());
  }
  template <int Rows>
  void get(Eigen::Matrix<double, Rows, 1>& vector) {
    if (!raw(vector.data(), sizeof(double) * Rows)) vector.setZero();
  }
  template <typename T>
  void get(std::vector<T>& values) {
    values.resize(get_size(1));  // each takes a byte at least
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      raw(values.data(), values.size());
    } else {
      for (T& value : values) get(value);
    }
  }
  template <typename T>
  void get(std::optional<T>& value) {
    bool there = false;
    get(there);
    value.reset();
    if (there) get(value.emplace());
  }

  const std::uint8_t* at_;
  std::size_t left_;
  bool failed_ = false;
};

}  // namespace hidwa_local_planner
