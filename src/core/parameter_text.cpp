// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/parameter_text.hpp"

#include <cmath>
#include <optional>
#include <sstream>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace {

struct Writer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return std::to_string(value); }
  std::string operator()(double value) const { return shortest(value); }
  std::string operator()(const std::string& value) const { return value; }
};

// A text on one line, and back.
std::string escaped(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return line;
}

std::string unescaped(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escape = line[i] == '\\' && i + 1 < line.size();
    if (escape) ++i;
    text += escape && line[i] == 'n' ? '\n' : line[i];
  }
  return text;
}

}  // namespace

std::string to_text(const ParameterValue& value) { return std::visit(Writer(), value); }

std::string set_parameter_text(Parameters& parameters, const std::string& name, const std::string& text) {
  const ParameterInfo* info = find_parameter(name);
  if (info == nullptr) return "there is no parameter '" + name + "'";
  ParameterValue value = text;
  const std::optional<double> number = number_in(text);
  if (info->type == "bool") {
    if (text != "true" && text != "false") return name + " is true or false, not '" + text + "'";
    value = text == "true";
  } else if (info->type == "int") {
    if (!number || *number != std::floor(*number) || std::abs(*number) > 1e9) {
      return name + " needs a whole number, not '" + text + "'";
    }
    value = static_cast<int>(*number);
  } else if (info->type == "double") {
    if (!number) return name + " needs a number, not '" + text + "'";
    value = *number;
  }
  return set_parameter(parameters, name, value);
}

std::string to_lines(const Parameters& parameters) {
  std::string lines;
  for (const ParameterInfo& info : parameter_table()) {
    lines += info.name + '=' + escaped(to_text(info.get(parameters))) + '\n';
  }
  return lines;
}

std::vector<std::string> set_lines(Parameters& parameters, const std::string& lines) {
  std::vector<std::string> faults;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t equals = line.find('=');
    const std::string fault = equals == std::string::npos ? "'" + line + "' is not of the form name=value"
                                                          : set_parameter_text(parameters, line.substr(0, equals),
                                                                               unescaped(line.substr(equals + 1)));
    if (!fault.empty()) faults.push_back(fault);
  }
  return faults;
}

}  // namespace hidwa_local_planner
