// SPDX-License-Identifier: BSD-3-Clause
#include "ros/stored_parameters.hpp"

#include <optional>
#include <utility>

#include "ros/parameter_loading.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

std::optional<double> as_number(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<const int&>(value);
  if (value.getType() == XmlRpcValue::TypeDouble) return static_cast<const double&>(value);
  return std::nullopt;
}

std::optional<bool> as_flag(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeBoolean) return static_cast<const bool&>(value);
  return std::nullopt;
}

std::optional<std::string> as_word(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeString) return static_cast<const std::string&>(value);
  return std::nullopt;
}

std::string remedy_for(const std::string& expected, const XmlRpcValue& value) {
  if (expected == "a number" && value.getType() == XmlRpcValue::TypeString) return kNumberIsText;
  if (expected == "a word" && value.getType() == XmlRpcValue::TypeBoolean) {
    return " (YAML reads on, off, yes and no as true and false: write it in quotes)";
  }
  return "";
}

template <typename Element>
auto as_list(const XmlRpcValue& value, const Element& as_element)
    -> std::optional<std::vector<typename decltype(as_element(value))::value_type>> {
  if (value.getType() != XmlRpcValue::TypeArray) return std::nullopt;
  std::vector<typename decltype(as_element(value))::value_type> list;
  for (int i = 0; i < value.size(); ++i) {
    const auto element = as_element(value[i]);
    if (!element) return std::nullopt;
    list.push_back(*element);
  }
  return list;
}

}  // namespace

StoredParameters::StoredParameters(std::string critic, const XmlRpcValue& content) : critic_(std::move(critic)) {
  if (!content.valid() || content.getType() != XmlRpcValue::TypeStruct) return;
  for (const auto& [key, value] : content) values_[key] = value;
}

template <typename T, typename Convert>
T StoredParameters::value_of(const std::string& key, const T& fallback, const char* expected,
                             const Convert& convert) const {
  asked_.insert(key);
  const auto found = values_.find(key);
  if (found == values_.end()) return fallback;
  if (const std::optional<T> value = convert(found->second)) return *value;
  faults_.push_back(critic_ + "/" + key + ": expected " + expected + ", found " + as_text(found->second) +
                    remedy_for(expected, found->second));
  return fallback;
}

double StoredParameters::number(const std::string& key, double fallback) const {
  return value_of(key, fallback, "a number", as_number);
}

bool StoredParameters::flag(const std::string& key, bool fallback) const {
  return value_of(key, fallback, "true or false", as_flag);
}

std::string StoredParameters::word(const std::string& key, const std::string& fallback) const {
  return value_of(key, fallback, "a word", as_word);
}

std::vector<double> StoredParameters::numbers(const std::string& key, const std::vector<double>& fallback) const {
  return value_of(key, fallback, "a list of numbers",
                  [](const XmlRpcValue& value) { return as_list(value, as_number); });
}

std::vector<std::string> StoredParameters::words(const std::string& key,
                                                 const std::vector<std::string>& fallback) const {
  return value_of(key, fallback, "a list of words", [](const XmlRpcValue& value) { return as_list(value, as_word); });
}

std::vector<std::string> StoredParameters::unasked() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : values_) {
    if (asked_.count(key) == 0) keys.push_back(key);
  }
  return keys;
}

}  // namespace hidwa_local_planner
