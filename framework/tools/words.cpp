// SPDX-License-Identifier: Apache-2.0
//
// swage words: the texts of a lesson and its plugins for people, and those without a translation.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "assembly/assemble.hpp"
#include "assembly/lesson_text.hpp"
#include "host/words.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The texts in order, and the folders with their translations.
struct Said {
  std::vector<std::string> words;
  std::set<std::string> folders;

  void add(const std::vector<std::string>& more) {
    for (const std::string& w : more)
      if (std::find(words.begin(), words.end(), w) == words.end()) words.push_back(w);
  }
  void add(const host::PluginInfo& plugin) {
    folders.insert(plugin.bundle_dir);
    add(host::words_of(plugin));
  }
};

void collect_plugins(const Json& value, std::set<std::string>& out) {
  if (value.is_object()) {
    const auto plugin = value.find("plugin");
    if (plugin != value.end() && plugin->is_string()) out.insert(plugin->get<std::string>());
  }
  if (value.is_structured())
    for (const Json& inside : value) collect_plugins(inside, out);
}

bool add_lesson(const std::string& path, const host::Catalogue& catalogue, Said& said, base::Problems& problems) {
  assembly::LessonText text;
  assembly::LessonFile file;
  if (!assembly::read_lesson_text(path, {}, text, problems) || !assembly::read_lesson_file(path, file, problems)) return false;
  const auto rig = assembly::assemble(file, catalogue, {}, problems);
  if (!rig) return false;
  // a lesson that is based on another one uses that one's translations, too
  for (const std::string& place : {path, text.beside}) said.folders.insert(fs::absolute(place).parent_path().string());
  said.add(host::words_of(text.json));
  std::set<std::string> plugins;
  collect_plugins(text.json, plugins);
  for (const std::string& id : plugins)
    if (const host::PluginInfo* info = catalogue.find(id)) said.add(*info);
  said.add(host::words_of(rig->card));
  return true;
}

}  // namespace

int words(const WordsOptions& o) {
  host::Catalogue::Options options;
  options.plugin_dirs = o.plugin_dirs;
  std::error_code ignored;
  for (const std::string& what : o.what)
    if (fs::is_directory(what, ignored)) options.plugin_dirs.insert(options.plugin_dirs.begin(), what);
  const host::Catalogue catalogue(options);
  Said said;
  base::Problems problems;
  bool good = true;
  for (const std::string& what : o.what) {
    if (what.ends_with(".json")) {
      good &= add_lesson(what, catalogue, said, problems);
      continue;
    }
    const auto mine = [&](const host::PluginInfo& p) { return p.id == what || fs::equivalent(p.bundle_dir, what, ignored); };
    const auto n = std::count_if(catalogue.plugins().begin(), catalogue.plugins().end(), mine);
    if (n == 0) problems.push_back({base::Severity::kError, what, say::kNeither()});
    good &= n > 0;
    for (const host::PluginInfo& p : catalogue.plugins())
      if (mine(p)) said.add(p);
  }
  host::Words known;
  for (const std::string& folder : said.folders)
    for (const std::string& file : host::word_files(folder, o.language)) host::read_words(file, o.language, known, problems);
  tell(problems);
  if (!good) return kProblem;

  Json out = {{"format", "swage-words/1"}, {"language", o.language}, {"words", Json::object()}};
  std::size_t left = 0;
  for (const std::string& w : said.words) {
    const auto it = known.find(w);
    left += it == known.end();
    if (o.all || it == known.end()) out["words"][w] = it == known.end() ? std::string() : it->second;
  }
  print(out);
  return left == 0 && problems.empty() ? kPassed : kNotPassed;
}

}  // namespace swage::tools
