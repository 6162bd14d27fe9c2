// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <xmlrpcpp/XmlRpcValue.h>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// The parameters of a critic of another package, read once: `<planner>/<critic>/<key>`. Remembers what was asked for.
class StoredParameters : public ParameterSource {
 public:
  /// `content`: the namespace `critic` as a struct, or an invalid value when there is none.
  StoredParameters(std::string critic, const XmlRpc::XmlRpcValue& content);
  double number(const std::string& key, double fallback) const override;
  bool flag(const std::string& key, bool fallback) const override;
  std::string word(const std::string& key, const std::string& fallback) const override;
  std::vector<double> numbers(const std::string& key, const std::vector<double>& fallback) const override;
  std::vector<std::string> words(const std::string& key, const std::vector<std::string>& fallback) const override;
  std::vector<std::string> faults() const override { return faults_; }

  const std::string& name_space() const { return critic_; }
  /// Every key that was asked for, whether there is a value or not.
  const std::set<std::string>& asked() const { return asked_; }
  /// The keys of values that nobody asked for.
  std::vector<std::string> unasked() const;

 private:
  template <typename T, typename Convert>
  T value_of(const std::string& key, const T& fallback, const char* expected, const Convert& convert) const;

  std::string critic_;
  std::map<std::string, XmlRpc::XmlRpcValue> values_;
  mutable std::set<std::string> asked_;
  mutable std::vector<std::string> faults_;
};

}  // namespace hidwa_local_planner
