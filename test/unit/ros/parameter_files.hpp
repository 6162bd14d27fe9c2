// SPDX-License-Identifier: BSD-3-Clause
// Contents of parameter files, and what is said of them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <XmlRpcValue.h>

namespace hidwa_local_planner {

inline XmlRpc::XmlRpcValue file_of(const std::vector<std::pair<std::string, XmlRpc::XmlRpcValue>>& all) {
  XmlRpc::XmlRpcValue content;
  for (const auto& [key, value] : all) content[key] = value;
  return content;
}

template <typename T>
XmlRpc::XmlRpcValue list_of(const std::vector<T>& elements) {
  XmlRpc::XmlRpcValue value;
  value.setSize(static_cast<int>(elements.size()));
  for (int i = 0; i < value.size(); ++i) value[i] = XmlRpc::XmlRpcValue(elements[static_cast<std::size_t>(i)]);
  return value;
}

inline bool contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&part](const std::string& text) { return text.find(part) != std::string::npos; });
}

}  // namespace hidwa_local_planner
