// SPDX-License-Identifier: Apache-2.0
#include "handshake.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>

#include "sentences.hpp"

namespace swage::inverse3 {
namespace {

constexpr std::size_t kBlock = 64;  // bytes of a block of SHA-1

uint32_t word(const unsigned char* p) { return uint32_t{p[0]} << 24 | uint32_t{p[1]} << 16 | uint32_t{p[2]} << 8 | p[3]; }

void digest(const unsigned char* block, std::array<uint32_t, 5>& h) {
  uint32_t w[80];
  for (std::size_t i = 0; i < 16; ++i) w[i] = word(block + 4 * i);
  for (std::size_t i = 16; i < 80; ++i) w[i] = std::rotl(w[i - 3] ^ w[i - 8] ^ w[i - 14] ^ w[i - 16], 1);
  auto [a, b, c, d, e] = h;
  for (std::size_t i = 0; i < 80; ++i) {
    const uint32_t f = i < 20 ? (b & c) | (~b & d) : i < 40 || i >= 60 ? b ^ c ^ d : (b & c) | (b & d) | (c & d);
    const uint32_t k = i < 20 ? 0x5A827999 : i < 40 ? 0x6ED9EBA1 : i < 60 ? 0x8F1BBCDC : 0xCA62C1D6;
    const uint32_t next = std::rotl(a, 5) + f + e + k + w[i];
    e = d, d = c, c = std::rotl(b, 30), b = a, a = next;
  }
  h[0] += a, h[1] += b, h[2] += c, h[3] += d, h[4] += e;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// value of a header field, "" where it is absent; field names are case-insensitive
std::string_view field(std::string_view header, std::string_view name) {
  for (std::size_t at = header.find("\r\n"); at != std::string_view::npos;) {
    const std::size_t begin = at + 2, end = std::min(header.find("\r\n", begin), header.size());
    const std::string_view line = header.substr(begin, end - begin);
    const std::size_t colon = line.find(':');
    if (colon != std::string_view::npos && lower(line.substr(0, colon)) == lower(name)) return trimmed(line.substr(colon + 1));
    at = end < header.size() ? end : std::string_view::npos;
  }
  return {};
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string sha1(std::string_view bytes) {
  std::array<uint32_t, 5> h = {0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
  std::string padded(bytes);
  padded += '\x80';
  while (padded.size() % kBlock != kBlock - 8) padded += '\0';
  const uint64_t bits = 8 * uint64_t{bytes.size()};
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 255);
  for (std::size_t at = 0; at < padded.size(); at += kBlock) digest(reinterpret_cast<const unsigned char*>(padded.data()) + at, h);
  std::string out;
  for (const uint32_t x : h)
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(x >> shift & 255);
  return out;
}

std::string accept_for(std::string_view key) { return base64(sha1(std::string(key) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11")); }

std::string request_text(const std::string& host, int port, const std::string& path, const std::string& key) {
  return "GET " + path + " HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + key + "\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

std::string check_answer(std::string_view answer, std::string_view key) {
  const std::string_view status = answer.substr(0, answer.find("\r\n"));
  if (!status.starts_with("HTTP/1.1 101"))
    return say::kNoWebSocket(status.substr(0, 60));
  const bool upgraded = lower(field(answer, "Upgrade")) == "websocket" && lower(field(answer, "Connection")).find("upgrade") != std::string::npos;
  if (!upgraded || field(answer, "Sec-WebSocket-Accept") != accept_for(key)) return say::kOtherAnswer();
  if (!field(answer, "Sec-WebSocket-Extensions").empty()) return say::kExtension();
  return "";
}

}  // namespace swage::inverse3
