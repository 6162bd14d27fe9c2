// SPDX-License-Identifier: BSD-3-Clause
// Parameters that went: what a file that sets them means today.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <xmlrpcpp/XmlRpcValue.h>

namespace hidwa_local_planner {

/// The planner's namespace in the words of today.
struct PresentContent {
  XmlRpc::XmlRpcValue content;        // with what former parameters became beside them
  std::set<std::string> former;       // keys that count no more, nested ones as "PathAlign/scale"
  std::vector<std::string> faults;    // what cannot be said in today's words
  std::vector<std::string> warnings;  // a line for each that says something: what it is taken as, and what to write
};

/// Takes former parameters, flat or in DWB's nested layout. One that says what holds anyway is no matter. `content`
/// must be a struct.
PresentContent in_present_words(const XmlRpc::XmlRpcValue& content);

}  // namespace hidwa_local_planner
