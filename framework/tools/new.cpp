// SPDX-License-Identifier: Apache-2.0
//
// swage new: creates a plugin or lesson from a template.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "host/nearest.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;
using Tokens = std::vector<std::pair<std::string, std::string>>;

// "org.example.fine_clip": words of lower-case letters, digits and _, at least two
bool is_id(const std::string& id) {
  std::istringstream words(id);
  std::string word;
  int count = 0;
  for (; std::getline(words, word, '.'); ++count) {
    if (word.empty() || std::islower(static_cast<unsigned char>(word[0])) == 0) return false;
    for (const char c : word)
      if (std::islower(static_cast<unsigned char>(c)) == 0 &&
          std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '_')
        return false;
  }
  return count >= 2 && id.back() != '.';
}

// true for a name that can follow "class"
bool is_class_name(const std::string& name) {
  return !name.empty() && std::isupper(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

// "fine_clip" -> "FineClip"
std::string camel(const std::string& word) {
  std::string out;
  bool start = true;
  for (const char c : word) {
    if (c != '_') out += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    start = c == '_';
  }
  return out;
}

// "FineClip" -> "Fine clip", as people read it
std::string title(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool begins = !out.empty() && std::isupper(static_cast<unsigned char>(c)) != 0;
    if (begins) out += ' ';
    out += begins ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : c;
  }
  return out;
}

std::string replaced(std::string text, const Tokens& tokens) {
  for (const auto& [token, value] : tokens)
    for (auto at = text.find(token); at != std::string::npos; at = text.find(token, at + value.size()))
      text.replace(at, token.size(), value);
  return text;
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// copies every file of the template, with the tokens replaced in its name and its text
bool copy(const fs::path& from, const fs::path& to, const Tokens& tokens, std::vector<std::string>& made) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const fs::path target = to / replaced(file.lexically_relative(from).string(), tokens);
    std::error_code code;
    fs::create_directories(target.parent_path(), code);
    std::ofstream out(target, std::ios::binary);
    out << replaced(read(file), tokens);
    out.flush();
    made.push_back(target.string());
    if (!out) return false;
    fs::permissions(target, fs::status(file).permissions(), code);
  }
  return true;
}

/// The guide's page of a kind, "" where there is no guide.
std::string guide_page(const std::string& kind) {
  std::vector<std::string> searched;
  std::string folder = data_folder("guide", searched);
  if (folder.empty()) folder = data_folder("framework/sdk/guide", searched);
  const std::string name = kind == "flexible" ? kind : (kind == "hardware" ? "device" : kind) + "s";
  const fs::path page = fs::path(folder) / (name + ".md");
  std::error_code ignored;
  return fs::exists(page, ignored) ? page.string() : "";
}

}  // namespace

int make_new(const NewOptions& o) {
  static const std::vector<std::string> kKinds = {"object", "flexible", "coupling", "device", "hardware", "lesson"};
  if (std::find(kKinds.begin(), kKinds.end(), o.kind) == kKinds.end())
    return problem(say::kNoTemplate(o.kind, host::join(kKinds), host::did_you_mean(o.kind, kKinds)));
  if (!is_id(o.id))
    return problem(say::kNoId(o.id));
  if (o.id.starts_with("swage."))
    return problem(say::kOwnDomain(o.id.substr(o.id.rfind('.') + 1)));
  if (!o.name.empty() && !is_class_name(o.name))
    return problem(say::kNoClass(o.name));

  std::vector<std::string> searched;
  const std::string templates = template_folder(searched);
  const fs::path from = fs::path(templates) / o.kind;
  std::error_code ignored;
  if (templates.empty() || !fs::is_directory(from, ignored))
    return problem(say::kTemplateGone(o.kind, templates.empty() ? host::join(searched) : from.string()));

  const std::string file = o.id.substr(o.id.rfind('.') + 1);
  const fs::path to = o.dir.empty() ? fs::path(file) : fs::path(o.dir);
  if (fs::exists(to, ignored) && (!fs::is_directory(to, ignored) || !fs::is_empty(to, ignored)))
    return problem(say::kNotEmpty(to.string()));
  const std::string name = o.name.empty() ? camel(file) : o.name;
  const Tokens tokens = {{"@ID@", o.id}, {"@NAME@", name}, {"@TITLE@", title(name)}, {"@FILE@", file}};
  std::vector<std::string> made;
  if (!copy(from, to, tokens, made))
    return problem(say::kNoPlace(made.back()));

  for (const std::string& path : made) std::printf("%s\n", path.c_str());
  std::printf("Next: read %s\n", (to / "README.md").string().c_str());
  if (const std::string page = guide_page(o.kind); !page.empty()) std::printf("Guide: %s\n", page.c_str());
  return kPassed;
}

}  // namespace swage::tools
