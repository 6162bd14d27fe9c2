// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <xmlrpcpp/XmlRpcValue.h>

#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// What a namespace of the parameter server says.
struct LoadedParameters {
  Parameters parameters;              // defaults where nothing valid was found
  std::vector<std::string> found;     // "max_vel_x: 0.5" for every value that came from the namespace
  std::vector<std::string> faults;    // each names the parameter and the remedy; any of them makes the set invalid
  std::vector<std::string> warnings;  // unknown keys, with the likely right one
  std::vector<std::string> aliases;   // nested and former keys taken over, "PathAlign/scale"
};

/// Reads the content of the planner's namespace (a struct, or an invalid value for an empty namespace).
/// Takes YAML as people write it: `critics` and `wheel_joints` as list or text, whole numbers for real ones, DWB's
/// nested `PathAlign: {scale: 32}` for PathAlign_scale (it wins over the flat key), and the word `off`, which YAML
/// reads as false; and parameters that went (former_parameters.hpp). Namespaces of critics of other packages, listed in
/// `critics`, are theirs. `completed`, where given, adds what is known of the robot besides before the set is
/// validated. Throws nothing of its own.
LoadedParameters load_parameters(const XmlRpc::XmlRpcValue& content,
                                 const std::function<Parameters(const Parameters&)>& completed = {});

/// Parameters of the planner that lie in its host's namespace `host` (content as above) in place of its own, where
/// nobody reads them: their names.
std::vector<std::string> misplaced_parameters(const XmlRpc::XmlRpcValue& host);

/// A value as the parameter server has it.
std::string as_text(const XmlRpc::XmlRpcValue& value);

/// What to do about a text where a number is expected.
inline constexpr const char* kNumberIsText =
    " (YAML takes it for a text: write numbers like 0.001 or 1.0e-3, without quotes)";

/// The name that is most like a misspelt one; empty when none is near.
std::string nearest_name(const std::string& misspelt, const std::vector<std::string>& names);

/// The namespace of a critic's own parameters: the last part of a name like `package/Class` or
/// `package::Class`.
std::string short_name(const std::string& critic);

/// The known parameter that an unknown key most likely means: its name in another planner, or a misspelling. Empty when
/// no name is similar.
std::string suggestion_for(const std::string& key);
/// What to do with another planner's parameter that has no counterpart here, as a clause; empty for any other key.
std::string remark_on(const std::string& key);

}  // namespace hidwa_local_planner
