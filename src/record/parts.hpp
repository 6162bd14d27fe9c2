// SPDX-License-Identifier: BSD-3-Clause
// A record's container: named parts, one behind another.
//
//   name (u32 length, characters) | critical (1 byte) | length (u32) | that many bytes      ... and so on to the end
//
// A part never changes what its bytes mean: what is new comes as a new part. Readers find parts by name, in any order,
// and pass over those that they do not know. `critical`: without this part the cycle may not be repeated the same, so a
// reader that passes over it must say so.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace record {

/// Writes parts. The same calls on a PartReader read them.
class PartWriter {
 public:
  explicit PartWriter(Bytes& bytes) : bytes_(bytes), write_(bytes) {}

  /// What the cycle was decided from: critical.
  template <typename T>
  void input(const char* name, const T& value) {
    put(name, true, value);
  }
  /// A part that is there only where the value is.
  template <typename T>
  void input(const char* name, const std::optional<T>& value) {
    if (value) put(name, true, *value);
  }
  /// What the cycle came to: not critical.
  template <typename T>
  void result(const char* name, const T& value) {
    put(name, false, value);
  }

 private:
  template <typename T>
  void put(const std::string& name, bool critical, const T& value) {
    write_(name, critical, std::uint32_t{0});
    const std::size_t begin = bytes_.size();
    write_(value);
    const auto length = static_cast<std::uint32_t>(bytes_.size() - begin);
    std::memcpy(bytes_.data() + begin - sizeof(length), &length, sizeof(length));
  }

  Bytes& bytes_;
  ArchiveWriter write_;
};

/// Reads parts. A part that is missing, cut, there twice or of another layout is a fault() that names it.
class PartReader {
 public:
  PartReader(const std::uint8_t* data, std::size_t size);

  template <typename T>
  void input(const char* name, T& value) {
    const Part* part = take(name);
    if (part == nullptr) return blame(std::string("the record has no part '") + name + "'");
    read(*part, value);
  }
  template <typename T>
  void input(const char* name, std::optional<T>& value) {
    value.reset();
    const Part* part = take(name);
    if (part != nullptr) read(*part, value.emplace());
  }
  template <typename T>
  void result(const char* name, T& value) {
    input(name, value);
  }

  /// The first fault, in words; empty where there is none.
  const std::string& fault() const { return fault_; }
  /// The critical parts that nobody asked for.
  std::vector<std::string> unknown() const;

 private:
  struct Part {
    std::string name;
    bool critical = false;
    Bytes bytes;
    bool taken = false;
  };
  const Part* take(const std::string& name);
  void blame(const std::string& fault) {
    if (fault_.empty()) fault_ = fault;
  }
  template <typename T>
  void read(const Part& part, T& value) {
    ArchiveReader archive(part.bytes);
    archive(value);
    if (!archive.complete()) blame("the record is damaged: its part '" + part.name + "'");
  }

  std::vector<Part> parts_;
  std::string fault_;
};

}  // namespace record
}  // namespace hidwa_local_planner
