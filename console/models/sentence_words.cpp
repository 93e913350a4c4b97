// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/sentence_words.hpp"

#include <algorithm>

namespace swage::console {
namespace {

using Texts = std::vector<std::string_view>;

Texts pieces_of(std::string_view text) {
  Texts out;
  for (std::size_t at = text.find("{}"); at != text.npos; at = text.find("{}")) {
    out.push_back(text.substr(0, at));
    text.remove_prefix(at + 2);
  }
  out.push_back(text);
  return out;
}

/// The values of a message after the piece `from`, with every place tried at which a piece may be.
bool values_of(std::string_view rest, const Texts& pieces, std::size_t from, Texts& values) {
  const std::string_view piece = pieces[from];
  if (from + 1 == pieces.size()) {
    if (!rest.ends_with(piece)) return false;
    values.push_back(rest.substr(0, rest.size() - piece.size()));
    return true;
  }
  for (std::size_t at = rest.find(piece); at != rest.npos && at <= rest.size(); at = rest.find(piece, at + 1)) {
    values.push_back(rest.substr(0, at));
    if (values_of(rest.substr(at + piece.size()), pieces, from + 1, values)) return true;
    values.pop_back();
  }
  return false;
}

/// Where the first sentence of several ends, its space included; npos in one sentence.
std::size_t first_end(std::string_view message, std::size_t from) {
  for (std::size_t at = message.find(' ', from); at != message.npos; at = message.find(' ', at + 1))
    if (at > 0 && (message[at - 1] == '.' || message[at - 1] == '?')) return at;
  return message.npos;
}

}  // namespace

SentenceWords::SentenceWords(const host::Words& words) : words_(&words) {
  for (const auto& [key, translation] : words) {
    if (key.find("{}") == key.npos) continue;
    Pattern pattern{pieces_of(key), translation, 0};
    for (const std::string_view piece : pattern.pieces) pattern.letters += piece.size();
    if (pattern.letters > 0) patterns_.push_back(std::move(pattern));
  }
  std::stable_sort(patterns_.begin(), patterns_.end(), [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
}

const std::string* SentenceWords::whole(std::string_view message) const {
  const auto it = words_->find(message);
  return it == words_->end() ? nullptr : &it->second;
}

std::string SentenceWords::by_pattern(std::string_view message) const {
  for (const Pattern& pattern : patterns_) {
    Texts values;
    const std::string_view begin = pattern.pieces.front();
    if (!message.starts_with(begin) || !values_of(message.substr(begin.size()), pattern.pieces, 1, values)) continue;
    const Texts pieces = pieces_of(pattern.translation);
    std::string out(pieces.front());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool name = values[i].find(' ') == values[i].npos;  // a name or a number stays as it is
      const std::string value = name ? std::string() : of(values[i]);
      out.append(value.empty() ? values[i] : value).append(pieces[i + 1]);
    }
    return out;
  }
  return {};
}

std::string SentenceWords::one_by_one(std::string_view message) const {
  for (std::size_t end = first_end(message, 0); end != message.npos; end = first_end(message, end + 1)) {
    const std::string_view first = message.substr(0, end), gap = message.substr(end, 1), rest = message.substr(end + 1), spaced = message.substr(end);
    const std::string* known = whole(first);
    const std::string begin = known ? *known : by_pattern(first);
    // a sentence that is added to another may begin with the space between them
    std::string after = of(spaced);
    if (after.empty()) after = of(rest).empty() ? std::string() : std::string(gap) + of(rest);
    if (!begin.empty() || !after.empty()) return (begin.empty() ? std::string(first) : begin) + (after.empty() ? std::string(spaced) : after);
  }
  return {};
}

std::string SentenceWords::of(std::string_view message) const {
  if (!words_ || message.empty()) return {};
  if (const std::string* known = whole(message)) return *known;
  std::string out = by_pattern(message);
  return out.empty() ? one_by_one(message) : out;
}

}  // namespace swage::console
