// SPDX-License-Identifier: Apache-2.0
#include "record/address.hpp"

#include <algorithm>
#include <cctype>

#include "record/sentences.hpp"

namespace swage::record {
namespace {

constexpr std::string_view kHidden = "***";
constexpr std::string_view kSeparator = "://";

struct Span {
  std::size_t first = std::string_view::npos, size = 0;
};

// Between the first colon after the scheme and the last @: a password that was not encoded may contain any character.
Span password_of_user(std::string_view where) {
  const std::size_t start = where.find(kSeparator) + kSeparator.size();
  const std::size_t at = where.rfind('@');
  if (at == std::string_view::npos || at < start) return {};
  const std::size_t colon = where.find(':', start);
  if (colon == std::string_view::npos || colon > at) return {};
  return {colon + 1, at - colon - 1};
}

// "?password=..."
Span password_of_query(std::string_view where) {
  constexpr std::string_view kKey = "password=";
  const std::size_t query = where.find('?');
  if (query == std::string_view::npos) return {};
  const std::size_t key = where.find(kKey, query);
  if (key == std::string_view::npos) return {};
  const std::size_t first = key + kKey.size();
  return {first, std::min(where.find('&', first), where.size()) - first};
}

// "mysql" of "mysql://...", "" for a path
std::string_view scheme(std::string_view where) {
  const std::size_t end = where.find(kSeparator);
  if (end == std::string_view::npos || end == 0) return {};
  const std::string_view name = where.substr(0, end);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
  });
  return plain ? name : std::string_view();
}

}  // namespace

bool is_postgres(std::string_view where) {
  return where.starts_with("postgresql://") || where.starts_with("postgres://");
}

std::string address_problem(std::string_view where) {
  if (where.empty())
    return "There is no place for the store: this user has no home folder. Name a file with --store, or set "
           "XDG_DATA_HOME.";
  if (where.find('\0') != std::string_view::npos) return "The name of the store holds a zero byte.";
  const std::string_view kind = scheme(where);
  if (kind.empty() || is_postgres(where)) return "";
  return say::kNoStoreKind(std::string(kind));
}

std::string shown(std::string_view where) {
  if (scheme(where).empty()) return std::string(where);
  std::string out(where);
  // the query first: it comes after the user, whose position then does not change
  for (const Span secret : {password_of_query(where), password_of_user(where)})
    if (secret.first != std::string_view::npos) out.replace(secret.first, secret.size, kHidden);
  return out;
}

std::string without_password(std::string said, std::string_view where) {
  for (auto at = said.find(where); at != std::string::npos && !where.empty(); at = said.find(where, at + 1))
    said.replace(at, where.size(), shown(where));
  if (scheme(where).empty()) return said;
  for (const Span secret : {password_of_query(where), password_of_user(where)}) {
    if (secret.first == std::string_view::npos || secret.size == 0) continue;
    const std::string_view word = where.substr(secret.first, secret.size);
    for (auto at = said.find(word); at != std::string::npos; at = said.find(word, at + kHidden.size()))
      said.replace(at, word.size(), kHidden);
  }
  return said;
}

}  // namespace swage::record
