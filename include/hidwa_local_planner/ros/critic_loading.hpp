// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <xmlrpcpp/XmlRpcValue.h>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"

namespace hidwa_local_planner {

/// The built-in critics and those that other packages export for pluginlib:
///   <export><hidwa_local_planner plugin="${prefix}/critics.xml"/></export>
/// A class `package/Name` is known by that name, by its C++ type and, where no other critic has it, as
/// `Name`. Classes are loaded when they are first made. The registry keeps the class loader alive.
CriticRegistry registry_with_plugins();

/// The parameters of a critic of another package, read once: `<planner>/<critic>/<key>`.
class StoredParameters : public ParameterSource {
 public:
  /// `content`: the critic's namespace as a struct, or an invalid value when there is none.
  StoredParameters(std::string critic, const XmlRpc::XmlRpcValue& content);
  double number(const std::string& key, double fallback) const override;
  bool flag(const std::string& key, bool fallback) const override;

 private:
  void complain(const std::string& key, const char* wanted) const;

  std::string critic_;
  std::map<std::string, std::variant<bool, double, std::string>> values_;
};

}  // namespace hidwa_local_planner
