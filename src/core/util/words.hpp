// SPDX-License-Identifier: BSD-3-Clause
// How this package writes and reads numbers and lists. Data takes shortest(), which loses nothing; sentences take
// worded(); columns of a table take fixed(); sentences with several numbers take format().
#pragma once

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace hidwa_local_planner {

/// printf into a string of any length.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
inline std::string
format(const char* form, ...) {
  va_list values, again;
  va_start(values, form);
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, form, values);
  va_end(values);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  std::vsnprintf(text.data(), text.size() + 1, form, again);
  va_end(again);
  return text;
}

/// A number as data: the fewest digits, from six on, that read back to the same bits.
inline std::string shortest(double number) {
  std::string text;
  for (int digits = 6; digits <= 17; ++digits) {  // 17 always suffice
    text = format("%.*g", digits, number);
    if (std::strtod(text.c_str(), nullptr) == number) break;
  }
  return text;
}

/// The number that a text is, all of it and finite; nothing where it is none.
inline std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// A number as people write it: at most so many digits, no trailing zeros.
inline std::string worded(double number, int digits = 4) { return format("%.*g", digits, number); }

/// A number with so many decimals; "-0.00" is 0.00.
inline std::string fixed(double number, int decimals) {
  const std::string text = format("%.*f", decimals, number);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

/// "first, second, third"
inline std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

/// The parts between separators: one more than there are separators, empty ones included.
inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace hidwa_local_planner
