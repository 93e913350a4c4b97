// SPDX-License-Identifier: Apache-2.0
#include "assembly/source_map.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace swage::assembly {

namespace {

// traverses JSON that a parser has already accepted, so it only looks at the characters that separate
// values
class Mapper {
 public:
  Mapper(const std::string& text, SourceMap& out) : text_(text), out_(out) {}

  void value(const std::string& pointer) {
    skip_space();
    if (++out_.values > kMostValues) return cut();
    out_.line_of.emplace(pointer, line_);
    if (peek() == '{') {
      object(pointer);
    } else if (peek() == '[') {
      array(pointer);
    } else if (peek() == '"') {
      string();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos)
        ++at_;
    }
  }

 private:
  void cut() {
    out_.cut = true;
    at_ = text_.size();
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_space() {
    for (; at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos;
         ++at_)
      if (text_[at_] == '\n') ++line_;
  }
  // valid JSON has no raw newline inside a string
  std::string string() {
    const std::size_t begin = at_++;
    for (; peek() != '"' && at_ < text_.size(); ++at_)
      if (peek() == '\\') ++at_;
    ++at_;
    const auto key = nlohmann::json::parse(text_.substr(begin, at_ - begin), nullptr, false);
    return key.is_string() ? key.get<std::string>() : "";
  }
  void object(const std::string& pointer) {
    std::set<std::string> keys;
    ++at_;
    for (skip_space(); peek() != '}' && at_ < text_.size(); skip_space()) {
      if (peek() == ',') {
        ++at_;
        continue;
      }
      const uint32_t line = line_;
      const std::string key = string();
      if (key.size() > kMostKey) return cut();
      const std::string below = pointer + "/" + pointer_step(key);
      if (!keys.insert(key).second) out_.double_keys.emplace_back(pointer, key);
      out_.line_of.insert_or_assign(below, line);
      skip_space();
      ++at_;  // the colon
      value(below);
    }
    ++at_;
  }
  void array(const std::string& pointer) {
    ++at_;
    std::size_t i = 0;
    for (skip_space(); peek() != ']' && at_ < text_.size(); skip_space()) {
      if (peek() == ',') {
        ++at_;
      } else {
        value(pointer + "/" + std::to_string(i++));
      }
    }
    ++at_;
  }

  const std::string& text_;
  SourceMap& out_;
  std::size_t at_ = 0;
  uint32_t line_ = 1;
};

}  // namespace

uint32_t nesting(const std::string& text) {
  uint32_t depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '{' || c == '[') deepest = std::max(deepest, ++depth);
    if ((c == '}' || c == ']') && depth > 0) --depth;
  }
  return deepest;
}

SourceMap map_source(const std::string& json_text) {
  SourceMap out;
  Mapper(json_text, out).value("");
  return out;
}

std::string pointer_step(const std::string& key) {
  std::string out;
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

}  // namespace swage::assembly
