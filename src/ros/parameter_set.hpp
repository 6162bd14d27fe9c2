// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include "hidwa_local_planner/core/critic_registry.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "ros/stored_parameters.hpp"

namespace hidwa_local_planner {

/// A set of parameters and, beside it, what the namespaces of other packages' critics held at that time:
/// whoever configures a planner with it talks to no parameter server.
struct ParameterSet {
  Parameters parameters;
  XmlRpc::XmlRpcValue content;  // of the planner's namespace; a struct, or invalid when it is empty

  /// Finds a critic's own parameters in `content`.
  std::unique_ptr<StoredParameters> source_for(const std::string& critic) const;
};

/// What the critics of other packages find in a set, as XML-RPC: empty where there is nothing. And a set with that
/// content and the default parameters; a text that is no XML-RPC gives one without content.
std::string foreign_content(const ParameterSet& set);
ParameterSet with_foreign_content(const std::string& text);

/// All that the parameter server holds below the handle's namespace.
XmlRpc::XmlRpcValue read_namespace(const ros::NodeHandle& handle);

/// How a set is judged.
struct Trial {
  std::vector<std::string> faults;    // any of them makes the set invalid
  std::vector<std::string> warnings;  // keys that a critic of another package does not know, with the likely right one
};
/// Judges a set by its values, its topics, and the critics that it names: each is made and configured, and those of
/// other packages are loaded.
Trial try_out(const ParameterSet& set, const CriticRegistry& registry);

}  // namespace hidwa_local_planner
