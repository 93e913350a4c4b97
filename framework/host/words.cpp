// SPDX-License-Identifier: Apache-2.0
#include "host/words.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "host/sentences.hpp"
#include "judge/host_events.hpp"

namespace swage::host {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kWordsFileFormat = "swage-words/1";
constexpr std::uintmax_t kMostBytes = 4u << 20;  // a hundred times the texts of the largest stock plugin

// The placeholders of a sentence, "{hold_time}", sorted.
std::vector<std::string> places(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) break;
    out.emplace_back(text.substr(open, close - open + 1));
  }
  std::sort(out.begin(), out.end());
  return out;
}

// "" or the fault of one translation
std::string fault(const std::string& key, const ordered_json& value) {
  if (!value.is_string() || value.get<std::string>().empty()) return say::kNoTranslation();
  if (places(key) != places(value.get<std::string>())) return say::kOtherPlaces();
  return "";
}

std::string text_of(const ordered_json& file, const char* key) {
  const auto it = file.is_object() ? file.find(key) : file.end();
  return it != file.end() && it->is_string() ? it->get<std::string>() : std::string();
}

/// Collects each text once, in order.
class List {
 public:
  void add(std::string_view text) {
    // numbers, fractions and signs are not translated
    const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    if (std::count_if(text.begin(), text.end(), letter) < 2 || !seen_.emplace(text).second) return;
    out_.emplace_back(text);
  }
  void add(const ordered_json& object, const char* key) {
    const auto it = object.is_object() ? object.find(key) : object.end();
    if (it != object.end() && it->is_string()) add(it->get<std::string>());
  }
  std::vector<std::string> take() { return std::move(out_); }

 private:
  std::set<std::string, std::less<>> seen_;
  std::vector<std::string> out_;
};

}  // namespace

std::vector<std::string> word_files(const std::string& folder, const std::string& language) {
  std::vector<std::string> out;
  const std::string end = "." + language + ".json";
  for (const fs::path& place : {fs::path(folder), fs::path(folder) / "words"}) {
    std::error_code code;
    for (fs::directory_iterator it(place, code), last; !code && it != last; it.increment(code)) {
      const std::string name = it->path().filename().string();
      const bool begins = name == "words" + end || name.starts_with("words_");
      if (begins && name.ends_with(end)) out.push_back(it->path().string());
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

void read_words(const std::string& path, const std::string& language, Words& out, base::Problems& problems) {
  std::error_code code;
  const std::uintmax_t bytes = fs::file_size(path, code);
  std::ifstream file(path, std::ios::binary);
  if (!code && bytes <= kMostBytes && file.is_open())
    return parse_words({std::istreambuf_iterator<char>(file), {}}, path, language, out, problems);
  problems.push_back({base::Severity::kWarning, path, std::string("These translations are not used: the file ") +
                                                          (bytes > kMostBytes && !code ? "is larger than 4 MB." : "cannot be read.")});
}

void parse_words(const std::string& text, const std::string& path, const std::string& language, Words& out,
                 base::Problems& problems) {
  const auto complain = [&](const std::string& place, const std::string& message) {
    problems.push_back({base::Severity::kWarning, path + place, message});
  };
  const ordered_json file = ordered_json::parse(text, nullptr, false, true);
  if (file.is_discarded()) return complain("", say::kWordsNoJson());
  if (text_of(file, "format") != kWordsFileFormat)
    return complain(" #/format", say::kWordsFormat(kWordsFileFormat));
  if (text_of(file, "language") != language)
    return complain(" #/language", say::kWordsLanguage(language));
  const auto words = file.find("words");
  if (words == file.end() || !words->is_object())
    return complain(" #/words", say::kWordsNone());
  for (const auto& [key, value] : words->items()) {
    if (const std::string wrong = fault(key, value); !wrong.empty())
      complain(" #/words", say::kTranslation(key, wrong));
    else
      out.emplace(key, value.get<std::string>());
  }
}

std::string_view without_value(std::string_view doc) { return doc.substr(0, doc.find("; value:")); }

std::vector<std::string> words_of(const PluginInfo& plugin) {
  List list;
  list.add(plugin.name);
  if (plugin.kind != SWAGE_KIND_LESSON) list.add(plugin.summary);  // a tip where parts of a lesson are chosen
  for (const Param& p : plugin.params) {
    if (p.hidden() || p.type == SWAGE_PARAM_TEXT || p.type == SWAGE_PARAM_FILE) continue;
    list.add(p.label.empty() ? p.id : p.label);
    list.add(p.doc);
    list.add(p.group);
    for (const std::string& choice : p.choices) list.add(choice);
  }
  for (const CriterionInfo& c : plugin.criteria) list.add(c.text);
  for (const MetricInfo& m : plugin.metrics) {
    list.add(m.title.empty() ? m.id : m.title);
    list.add(m.doc);
  }
  // a cue with a role is shown by its id's words; others are named by the console's themes
  for (const CueInfo& c : plugin.cues)
    if (c.role != SWAGE_CUE_NEUTRAL) list.add(c.id);
  return list.take();
}

std::vector<std::string> words_of(const snapshot::SceneCard& card) {
  List list;
  const judge::Script& script = card.script;
  for (const judge::Name& n : script.signals) list.add(n.id), list.add(n.doc);
  for (const judge::Name& n : script.events)
    if (n.owner != judge::kHostOwner) list.add(n.id), list.add(without_value(n.doc));
  for (const judge::Name& n : script.phases) list.add(n.doc.empty() ? n.id : n.doc);
  for (std::size_t i = 0; i < script.metrics.size(); ++i) {
    if (script.metrics[i].owner == judge::kHostOwner) continue;
    const bool titled = i < card.metrics.size() && !card.metrics[i].title.empty();
    if (!titled) list.add(script.metrics[i].id);
    list.add(script.metrics[i].doc);
  }
  return list.take();
}

std::vector<std::string> words_of(const ordered_json& lesson) {
  List list;
  for (const char* key : {"title", "summary", "goal"}) list.add(lesson, key);
  if (const auto reset = lesson.is_object() ? lesson.find("reset") : lesson.end(); reset != lesson.end())
    for (const char* key : {"label", "tip"}) list.add(*reset, key);
  for (const char* part : {"objects", "couplings", "devices"}) {
    const auto uses = lesson.is_object() ? lesson.find(part) : lesson.end();
    if (uses == lesson.end() || !uses->is_array()) continue;
    for (const ordered_json& use : *uses) {
      list.add(use, "name");
      if (part[0] != 'd') continue;
      list.add(use, "as");
      const auto others = use.is_object() ? use.find("or") : use.end();
      if (others == use.end() || !others->is_array()) continue;
      for (const ordered_json& other : *others) list.add(other, "as");
    }
  }
  return list.take();
}

}  // namespace swage::host
