// SPDX-License-Identifier: Apache-2.0
//
// The sentences of a folder's sentences.hpp, read from its source: tests ask whether each has a translation.
#pragma once

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "test_places.hpp"

namespace swage::test {

/// A constant of a catalogue with its text in UTF-8, and the comment above its group.
struct CatalogueSentence {
  std::string section, name, text;
};

/// Raw strings are left out. `folder`: below the source folder, such as "framework/host". Empty where there is no such file.
inline std::vector<CatalogueSentence> sentence_catalogue(const std::string& folder) {
  std::ifstream file(SWAGE_SOURCE_DIR "/" + folder + "/sentences.hpp");
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const std::string source = bytes.str();
  const std::regex entry(R"re(// (.+)|constexpr auto (k\w+) =\s*((?:"(?:[^"\\]|\\.)*"\s*)+)_sentence)re"), letters(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<CatalogueSentence> out;
  std::string section;
  for (std::sregex_iterator it(source.begin(), source.end(), entry), end; it != end; ++it) {
    if (!(*it)[2].matched) {
      // a comment that follows a constant belongs to it, and is no heading
      if (it->position() == 0 || source[static_cast<std::size_t>(it->position()) - 1] == '\n') section = (*it)[1];
      continue;
    }
    const std::string parts = (*it)[3];
    std::string text;
    for (std::sregex_iterator part(parts.begin(), parts.end(), letters); part != end; ++part) text += (*part)[1];
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '\\') {
        plain += text[i];
      } else if (text[++i] == 'u') {
        const auto code = static_cast<unsigned>(std::stoul(text.substr(i + 1, 4), nullptr, 16));
        i += 4;
        if (code >= 0x800) plain += static_cast<char>(0xE0 | (code >> 12));
        if (code >= 0x80) plain += static_cast<char>((code >= 0x800 ? 0x80 : 0xC0) | ((code >> 6) & (code >= 0x800 ? 0x3F : 0x1F)));
        plain += static_cast<char>(code >= 0x80 ? 0x80 | (code & 0x3F) : code);
      } else {
        plain += text[i];
      }
    }
    out.push_back({section, (*it)[2], plain});
  }
  return out;
}

}  // namespace swage::test
