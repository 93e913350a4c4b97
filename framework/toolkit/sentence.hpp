// SPDX-License-Identifier: Apache-2.0
//
// Sentences for people, in one catalogue per room or bundle: the code that writes one and the tests that expect it use the same
// constant, so that its words can be changed in one place.
//
//   inline constexpr auto kTaken = "\"{}\" is taken."_sentence;
//   kTaken(name)     // "\"needle\" is taken."
//   kTaken.words(1)  // "\" is taken.": for a test that does not know the value
//
// A wrong number of values does not compile. [main]
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace swage::toolkit {

/// The letters of a sentence, as a template takes them.
template <std::size_t n>
struct Letters {
  char text[n];
  consteval Letters(const char (&letters)[n]) { std::copy_n(letters, n, text); }  // NOLINT: from a literal
  constexpr std::string_view view() const { return {text, n - 1}; }
};

/// A sentence with a {} for each value.
template <Letters letters>
struct Sentence {
  static constexpr std::string_view kText = letters.view();
  static constexpr std::size_t kValues = [] {
    std::size_t count = 0;
    for (std::size_t at = kText.find("{}"); at != kText.npos; at = kText.find("{}", at + 2)) ++count;
    return count;
  }();

  template <class... Values>
  std::string operator()(const Values&... value) const {
    static_assert(sizeof...(Values) == kValues, "a sentence needs a value for each {}");
    std::string out;
    std::string_view rest = kText;
    (fill(out, rest, word(value)), ...);
    return out.append(rest);
  }

  /// The text between two values: 0 before the first, kValues after the last.
  static std::string words(std::size_t i) {
    std::string_view rest = kText;
    for (; i > 0; --i) rest.remove_prefix(rest.find("{}") + 2);
    return std::string(rest.substr(0, rest.find("{}")));
  }

 private:
  static void fill(std::string& out, std::string_view& rest, std::string_view value) {
    const std::size_t at = rest.find("{}");
    out.append(rest.substr(0, at)).append(value);
    rest.remove_prefix(at + 2);
  }
  static std::string word(std::integral auto value) { return std::to_string(value); }
  static std::string word(std::string_view value) { return std::string(value); }
};

template <Letters letters>
constexpr Sentence<letters> operator""_sentence() {
  return {};
}

}  // namespace swage::toolkit
