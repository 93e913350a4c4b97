// SPDX-License-Identifier: Apache-2.0
#include "sensor/foreign.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace swage::sensor {

namespace {

constexpr std::size_t kLongest = 120;  // bytes of one message

std::size_t width(ForeignTable::Format format) {
  return format == ForeignTable::kText ? 0 : format == ForeignTable::kI24BigEnd ? 3 : 2;
}

// The n-th number of a text. Digits after a letter belong to a name, as in CH1.
bool nth_number(const std::string& text, int n, double& out) {
  const char* const end = text.data() + text.size();
  bool in_word = false;
  for (const char* c = text.data(); c < end;) {
    const char* begin = c + (*c == '+' ? 1 : 0);
    const auto [after, error] = std::from_chars(begin, end, out);
    const bool digits = *c == '+' || *c == '-' || *c == '.' || std::isdigit(static_cast<unsigned char>(*c)) != 0;
    if (!in_word && digits && after != begin) {
      if (n-- == 0) return error == std::errc();
      c = after;
      continue;
    }
    in_word = std::isalnum(static_cast<unsigned char>(*c)) != 0;
    ++c;
  }
  return false;
}

uint32_t byte(char c) { return static_cast<uint8_t>(c); }

}  // namespace

std::string check_table(const ForeignTable& t) {
  if (!std::isfinite(t.scale) || t.scale == 0 || !std::isfinite(t.offset)) return "The scale is a number other than 0.";
  if (t.format == ForeignTable::kText) return t.end.empty() ? "A message of text needs an end, \\r for one." : t.at < 0 ? "Numbers are counted from 0." : "";
  const std::size_t needed = static_cast<std::size_t>(std::max(0, t.at)) + width(t.format) + t.end.size();
  if (t.at < 0 || t.length < 0 || static_cast<std::size_t>(t.length) < needed || static_cast<std::size_t>(t.length) > kLongest)
    return "A message with such a number has " + std::to_string(needed) + " to " + std::to_string(kLongest) + " bytes.";
  if (t.poll.empty() && t.end.empty())
    return "A message of bytes that nobody asks for needs an end: its beginning could not be known.";
  return "";
}

std::string unescaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
      continue;
    }
    const char c = text[++i];
    int code = 0;
    if (c == 'x' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3) {
      out += static_cast<char>(code);
      i += 2;
      continue;
    }
    out += c == 'r' ? '\r' : c == 'n' ? '\n' : c == 't' ? '\t' : c == '0' ? '\0' : c;
  }
  return out;
}

bool ForeignDecoder::value(double& volts) const {
  double raw = 0;
  if (table_.format == ForeignTable::kText) {
    if (!nth_number(buffer_, table_.at, raw)) return false;
  } else {
    const char* b = buffer_.data() + table_.at;
    switch (table_.format) {
      case ForeignTable::kU16BigEnd: raw = static_cast<double>(byte(b[0]) << 8 | byte(b[1])); break;
      case ForeignTable::kU16LittleEnd: raw = static_cast<double>(byte(b[1]) << 8 | byte(b[0])); break;
      case ForeignTable::kI16BigEnd: raw = static_cast<int16_t>(byte(b[0]) << 8 | byte(b[1])); break;
      case ForeignTable::kI16LittleEnd: raw = static_cast<int16_t>(byte(b[1]) << 8 | byte(b[0])); break;
      default: raw = static_cast<int32_t>((byte(b[0]) << 16 | byte(b[1]) << 8 | byte(b[2])) ^ 0x800000) - 0x800000;
    }
  }
  volts = table_.scale * raw + table_.offset;
  return std::isfinite(volts);
}

bool ForeignDecoder::take(char c, double& volts) {
  buffer_ += c;
  const bool text = table_.format == ForeignTable::kText;
  const bool ends = buffer_.ends_with(table_.end);
  const bool full = text ? ends : buffer_.size() == static_cast<std::size_t>(table_.length);
  if (!full) {
    if (buffer_.size() > kLongest) ++bad_, restart();
    return false;
  }
  // bytes out of step: drops the oldest, until the end marker is in its place
  if (!text && !ends) {
    buffer_.erase(0, 1);
    ++bad_;
    return false;
  }
  const bool good = value(volts);
  bad_ += good ? 0 : 1;
  restart();
  return good;
}

}  // namespace swage::sensor
