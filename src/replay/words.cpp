// SPDX-License-Identifier: BSD-3-Clause
#include "words.hpp"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace hidwa_local_planner {
namespace replay {

std::string format(const char* text, ...) {
  char line[1024];
  va_list arguments;
  va_start(arguments, text);
  std::vsnprintf(line, sizeof(line), text, arguments);
  va_end(arguments);
  return line;
}

std::string in_words(const Twist2& u) { return format("(%.4f m/s, %.4f rad/s)", u.v, u.omega); }

std::string in_words(const record::Verdict& verdict) {
  return format("%-5s %s", to_string(verdict.outcome), in_words(verdict.command).c_str());
}

std::string json(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20) {
      quoted += format("\\u%04x", code);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string json(double number) { return std::isfinite(number) ? format("%.17g", number) : "null"; }

}  // namespace replay
}  // namespace hidwa_local_planner
