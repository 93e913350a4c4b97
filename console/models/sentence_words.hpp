// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Translations of sentences with values in them, as the host puts them together (base/sentence.hpp): "There is no \"{}\"." finds
// "There is no \"needle\"." and keeps the value, which is translated too where it is itself a sentence. Any thread, once filled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/words.hpp"

namespace swage::console {

class SentenceWords {
 public:
  /// Takes the translations with a {} in them; values keep their order. `words` outlives this.
  explicit SentenceWords(const host::Words& words);
  SentenceWords() = default;

  /// The message in the other language; "" where no sentence fits. Of several that fit, the one with most letters of its own is used. A message
  /// of several sentences is translated one by one; what nobody has translated stays.
  std::string of(std::string_view message) const;

 private:
  struct Pattern {
    std::vector<std::string_view> pieces;  // between the values
    std::string_view translation;
    std::size_t letters = 0;
  };
  const std::string* whole(std::string_view message) const;
  std::string by_pattern(std::string_view message) const;
  std::string one_by_one(std::string_view message) const;

  const host::Words* words_ = nullptr;
  std::vector<Pattern> patterns_;  // the ones with most letters first
};

}  // namespace swage::console
