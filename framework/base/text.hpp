// SPDX-License-Identifier: Apache-2.0
//
// Texts from outside, made safe for display: no control characters for a terminal, no endless line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace swage::base {

/// Length of the control character at `at`, else 0: C0 except tabulator and new line, DEL, and C1 in UTF-8.
inline std::size_t control_at(std::string_view text, std::size_t at) {
  const auto c = static_cast<unsigned char>(text[at]);
  if ((c < 0x20 && c != '\t' && c != '\n') || c == 0x7F) return 1;
  if (c != 0xC2 || at + 1 >= text.size()) return 0;
  const auto next = static_cast<unsigned char>(text[at + 1]);
  return next >= 0x80 && next < 0xA0 ? 2 : 0;
}

inline bool has_control(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (control_at(text, i) > 0) return true;
  return false;
}

/// The text with each control character written out as "\x1b".
inline std::string printable(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t control = control_at(text, i);
    i += control > 1 ? 1 : 0;
    const auto c = static_cast<unsigned char>(text[i]);
    if (control == 0)
      out += text[i];
    else
      (out += "\\x") += std::string{kDigits[c >> 4], kDigits[c & 15]};
  }
  return out;
}

/// At most `most` bytes and "...", cut between characters (UTF-8).
inline std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return std::string(text.substr(0, most)) + "...";
}

}  // namespace swage::base
