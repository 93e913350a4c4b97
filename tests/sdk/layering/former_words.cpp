// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "layering.hpp"

namespace swage::test {
namespace {

namespace fs = std::filesystem;

struct FormerWords {
  std::vector<std::string> code, screen;
};

FormerWords read_words(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " cannot be read");
  FormerWords out;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("screen ")) {
      out.screen.push_back(line.substr(7));
    } else if (line.starts_with("code ")) {
      std::istringstream words(line.substr(5));
      for (std::string word; words >> word;) out.code.push_back(word);
    } else {
      throw std::runtime_error(file.string() + ": " + line);
    }
  }
  return out;
}

bool in_identifier(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool has_identifier(const std::string& line, const std::string& word) {
  for (size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const bool begins = at == 0 || !in_identifier(line[at - 1]), ends = at + word.size() == line.size() || !in_identifier(line[at + word.size()]);
    if (begins && ends) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> word_violations(const fs::path& root, const fs::path& words) {
  const FormerWords former = read_words(words);
  std::vector<std::string> out;
  for (const char* top : {"framework", "plugins", "devices", "lessons", "console"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const std::string kind = entry.path().extension(), path = fs::relative(entry.path(), root).generic_string();
      const bool code = kind == ".cpp" || kind == ".hpp" || kind == ".h" || kind == ".c";
      if (!entry.is_regular_file() || (!code && kind != ".json" && kind != ".ts")) continue;
      std::ifstream in(entry.path());
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        const auto at = path + ":" + std::to_string(number) + ": ";
        for (const std::string& word : former.code)
          if (code && has_identifier(line, word)) out.push_back(at + word);
        for (const std::string& word : former.screen)
          if (line.find(word) != std::string::npos) out.push_back(at + word);
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace swage::test
