// SPDX-License-Identifier: Apache-2.0
#include "record/identity.hpp"

#include <sys/random.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <random>

namespace swage::record {
namespace {

// Milliseconds and, in the twelve bits below, a count within each: later calls of this process are later in text order, too.
uint64_t next_moment() {
  static std::atomic<uint64_t> last{0};
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  const auto now = static_cast<uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since).count()) << 12;
  uint64_t before = last.load(), moment = 0;
  do moment = std::max(now, before + 1);
  while (!last.compare_exchange_weak(before, moment));
  return moment;
}

}  // namespace

std::string make_id() {
  uint64_t random[2] = {};
  if (getrandom(random, sizeof random, 0) != sizeof random) {
    std::random_device device;
    for (uint64_t& word : random) word = (uint64_t{device()} << 32) | device();
  }
  const uint64_t moment = next_moment();
  const uint64_t high = (moment >> 12 << 16) | 0x7000u | (moment & 0x0fffu);
  const uint64_t low = (random[1] >> 2) | 0x8000000000000000ull;
  char out[37];
  std::snprintf(
      out, sizeof out, "%08llx-%04llx-%04llx-%04llx-%012llx", static_cast<unsigned long long>(high >> 32),
      static_cast<unsigned long long>((high >> 16) & 0xffff), static_cast<unsigned long long>(high & 0xffff),
      static_cast<unsigned long long>(low >> 48), static_cast<unsigned long long>(low & 0xffffffffffffull));
  return out;
}

bool is_id(std::string_view text) {
  constexpr std::string_view kForm = "00000000-0000-0000-0000-000000000000";
  return std::equal(text.begin(), text.end(), kForm.begin(), kForm.end(), [](char c, char form) {
    return form == '-' ? c == '-' : (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
  });
}

std::string utc_now() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  tm utc{};
  gmtime_r(&now.tv_sec, &utc);
  char out[64];
  std::snprintf(out, sizeof out, "%04d-%02d-%02dT%02d:%02d:%02d.%03ldZ", utc.tm_year + 1900, utc.tm_mon + 1,
                utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec, now.tv_nsec / 1'000'000);
  return out;
}

std::string station() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 && name[0] != '\0' ? name : "unnamed";
}

std::string make_code() {
  constexpr char kLetters[] = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";  // Crockford's base 32
  std::random_device random;
  std::string out(5, '0');
  for (char& c : out) c = kLetters[random() % 32];
  return out;
}

}  // namespace swage::record
