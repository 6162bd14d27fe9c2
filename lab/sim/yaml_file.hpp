// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include <yaml-cpp/yaml.h>

namespace hidwa_local_planner {
namespace sim {

/// A YAML file whose faults are told with the file's name.
class YamlFile {
 public:
  explicit YamlFile(const std::string& path) : path_(path) {
    try {
      root_ = YAML::LoadFile(path);
    } catch (const YAML::BadFile&) {
      fail("cannot be opened");
    } catch (const YAML::Exception& e) {
      fail(std::string("is not valid YAML: ") + e.what());
    }
  }

  const YAML::Node& root() const { return root_; }

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error("'" + path_ + "': " + what); }

  /// `node` as a T; `name` says which one where it cannot be.
  template <typename T>
  T as(const YAML::Node& node, const std::string& name) const {
    if (!node) fail("'" + name + "' is missing");
    try {
      return node.as<T>();
    } catch (const YAML::Exception&) {
      fail("'" + name + "' has not the expected form");
    }
  }

 private:
  std::string path_;
  YAML::Node root_;
};

}  // namespace sim
}  // namespace hidwa_local_planner
