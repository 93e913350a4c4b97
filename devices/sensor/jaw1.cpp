// SPDX-License-Identifier: Apache-2.0
#include "sensor/jaw1.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace swage::sensor {

namespace {

constexpr std::size_t kPayload = 10;  // type, sequence number, clock 2, value 3, status, check 2

uint8_t byte(char c) { return static_cast<uint8_t>(c); }

// returns the field before the next comma; the rest stays in `text`
std::string_view field(std::string_view& text) {
  const std::size_t at = text.find(',');
  const std::string_view out = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
  return out;
}

template <class Number>
bool number(std::string_view text, Number& out, int base = 10) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out, base);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

std::string with_check(const std::string& body) {
  char check[8];
  std::snprintf(check, sizeof check, "*%02X\n", crc8(body));
  return "$" + body + check;
}

// Consistent overhead byte stuffing of a payload below 254 bytes: the result has no zero
std::string stuffed(std::string_view payload) {
  std::string out(1, '\0');
  std::size_t code = 0;
  for (const char c : payload) {
    if (c != 0) {
      out += c;
      continue;
    }
    out[code] = static_cast<char>(out.size() - code);
    code = out.size();
    out += '\0';
  }
  out[code] = static_cast<char>(out.size() - code);
  return out;
}

// false where the input is not valid COBS, or has another length
bool unstuffed(std::string_view in, std::array<char, kPayload>& out) {
  std::size_t n = 0, at = 0;
  while (at < in.size()) {
    const std::size_t code = byte(in[at]);
    if (code == 0 || at + code > in.size()) return false;
    for (std::size_t i = 1; i < code; ++i) {
      if (n == kPayload) return false;
      out[n++] = in[at + i];
    }
    at += code;
    if (at < in.size()) {
      if (n == kPayload) return false;
      out[n++] = 0;
    }
  }
  return n == kPayload;
}

}  // namespace

uint8_t crc8(std::string_view bytes) {
  uint8_t crc = 0;
  for (const char c : bytes) {
    crc = static_cast<uint8_t>(crc ^ byte(c));
    for (int i = 0; i < 8; ++i) crc = static_cast<uint8_t>((crc << 1) ^ ((crc & 0x80) != 0 ? 0x07 : 0));
  }
  return crc;
}

uint16_t crc16(std::string_view bytes) {
  uint16_t crc = 0xFFFF;
  for (const char c : bytes) {
    crc = static_cast<uint16_t>(crc ^ (byte(c) << 8));
    for (int i = 0; i < 8; ++i) crc = static_cast<uint16_t>((crc << 1) ^ ((crc & 0x8000) != 0 ? 0x1021 : 0));
  }
  return crc;
}

std::string line(const Reading& r) {
  if (r.kind == Reading::kInfo) return with_check("INF," + r.key + "," + r.text);
  char body[80];
  std::snprintf(body, sizeof body, "%s,%u,%u,%d,%02X", r.kind == Reading::kGrip ? "GRP" : "JAW", r.sequence,
                r.clock_us, r.value, r.status);
  return with_check(body);
}

std::string frame(const Reading& r) {
  const auto value = static_cast<uint32_t>(std::clamp(r.value, -8388608, 8388607));
  std::string payload;
  for (const uint32_t b : {uint32_t{r.kind}, r.sequence, r.clock_us, r.clock_us >> 8, value, value >> 8, value >> 16,
                           uint32_t{r.status}})
    payload += static_cast<char>(b & 0xFF);
  const uint16_t check = crc16(payload);
  payload += static_cast<char>(check & 0xFF);
  payload += static_cast<char>(check >> 8);
  return stuffed(payload) + '\0';
}

Reading parse_line(std::string_view text) {
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  const std::size_t star = text.rfind('*');
  uint8_t check = 0;
  if (text.empty() || text[0] != '$' || star == std::string_view::npos || text.size() - star != 3 ||
      !number(text.substr(star + 1), check, 16) || check != crc8(text.substr(1, star - 1)))
    return {};
  text = text.substr(1, star - 1);
  Reading out;
  const std::string_view kind = field(text);
  if (kind == "INF") {
    out.kind = Reading::kInfo;
    out.key = field(text);
    out.text = text;
    return out;
  }
  const bool whole = number(field(text), out.sequence) && number(field(text), out.clock_us) &&
                     number(field(text), out.value) && number(field(text), out.status, 16) && text.empty();
  if (whole && kind == "JAW") out.kind = Reading::kJaw;
  if (whole && kind == "GRP") out.kind = Reading::kGrip;
  return out.kind == Reading::kNone ? Reading{} : out;
}

Reading parse_frame(std::string_view text) {
  std::array<char, kPayload> p{};
  if (!unstuffed(text, p)) return {};
  const auto at = [&](std::size_t i) { return uint32_t{byte(p[i])}; };
  if ((at(8) | at(9) << 8) != crc16({p.data(), 8}) || (at(0) != Reading::kJaw && at(0) != Reading::kGrip)) return {};
  Reading out;
  out.kind = at(0) == Reading::kJaw ? Reading::kJaw : Reading::kGrip;
  out.sequence = at(1);
  out.clock_us = at(2) | at(3) << 8;
  const uint32_t value = at(4) | at(5) << 8 | at(6) << 16;
  out.value = static_cast<int32_t>(value ^ 0x800000) - 0x800000;  // sign extension from 24 bits
  out.status = byte(p[7]);
  return out;
}

Reading Decoder::take(char c) {
  if (c != (binary_ ? '\0' : '\n')) {
    if (length_ < kLongest)
      buffer_[length_++] = c;
    else
      overlong_ = true;
    if (length_ == kLongest && !overlong_) overlong_ = true, ++bad_;
    return {};
  }
  const std::string_view text(buffer_, length_);
  Reading out = binary_ ? parse_frame(text) : parse_line(text);
  const bool empty = length_ == 0 || (!binary_ && text == "\r");
  if (out.kind == Reading::kNone && !overlong_ && !empty) ++bad_;
  length_ = 0;
  overlong_ = false;
  return out;
}

}  // namespace swage::sensor
