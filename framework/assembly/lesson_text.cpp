// SPDX-License-Identifier: Apache-2.0
#include "assembly/lesson_text.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "assembly/source_map.hpp"
#include "toolkit/read_file.hpp"

namespace swage::assembly {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxBytes = std::size_t{4}
                                  << 20;  // a lesson has some kilobytes; a mesh is a file of its own
constexpr uint32_t kMaxNesting = 32;
constexpr std::size_t kMostBases = 8;  // more is a tangle that nobody follows

// What a lesson that is based on another says for itself; all else it has from there.
constexpr const char* kOwn[] = {"format",  "based_on", "set",  "id",           "title",
                                "summary", "goal",     "seed", "rate_hz",      "gravity",
                                "mirror",  "mode",     "cues", "scene_length", "max_time"};

// where a parser stopped, as line and column
std::pair<uint32_t, uint32_t> place(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto line =
      static_cast<uint32_t>(1 + std::count(text.begin(), text.begin() + static_cast<long>(end), '\n'));
  const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return {line, static_cast<uint32_t>(start == std::string::npos ? end + 1 : end - start)};
}

/// One file on the way to the whole text.
struct Link {
  std::string path, text;
  Json json;
  std::map<std::string, uint32_t> line_of;

  bool based() const { return json.is_object() && json.contains("based_on"); }
};

class Chain {
 public:
  explicit Chain(base::Problems& problems) : problems_(problems) {}

  /// The file and all that it is based on; false where one of them leads nowhere.
  bool follow(const std::string& path) {
    if (!open(path)) return false;
    while (links_.back().based()) {
      const Link& link = links_.back();
      const Json& base = link.json["based_on"];
      if (!base.is_string() || base.get<std::string>().empty())
        return error(link, "/based_on", "\"based_on\" is the lesson file that this one is another of.");
      const std::string next = (fs::path(link.path).parent_path() / base.get<std::string>()).string();
      for (const Link& before : links_) {
        std::error_code none;
        if (fs::equivalent(before.path, next, none))
          return error(link, "/based_on", "It is based on itself, by way of \"" + next + "\".");
      }
      if (links_.size() > kMostBases)
        return error(link, "/based_on", "More than eight lessons are based on one another.");
      std::error_code none;
      if (!fs::is_regular_file(next, none))
        return error(link, "/based_on", "There is no lesson file \"" + next + "\" to be based on.");
      if (!open(next)) return false;
    }
    return true;
  }

  bool apply(std::span<const Setting> settings, LessonText& out) {
    Link& whole = links_.back();
    out.beside = whole.path;
    out.text = whole.text;
    out.made = links_.size() > 1 || !settings.empty();
    if (!out.made) return true;
    if (!whole.json.is_object())
      return error(whole, "", "It is not a JSON object, so nothing can be set in it.");
    bool good = true;
    for (std::size_t i = links_.size() - 1; i-- > 0;) good = lay_over(links_[i], whole.json) && good;
    for (const Setting& setting : settings)
      good = set_in(whole.json, setting, links_.front().path, problems_) && good;
    if (good) out.text = whole.json.dump(2, ' ', false, Json::error_handler_t::replace);
    return good;
  }

  /// What can be gone on with where the chain is broken.
  bool broken_here(LessonText& out) const {
    if (links_.size() == 1 && !links_[0].based()) out.text = links_[0].text, out.beside = links_[0].path;
    return false;
  }

 private:
  bool error(const Link& link, const std::string& pointer, const std::string& message) {
    problems_.push_back({base::Severity::kError, place_in(link.path, link.line_of, pointer), message});
    return false;
  }

  bool open(const std::string& path) {
    std::string text, why;
    if (!toolkit::read_file(path, kMaxBytes, text, why)) {
      std::error_code ignored;
      if (!fs::exists(path, ignored)) why = "There is no such lesson file.";
      problems_.push_back({base::Severity::kError, path, why});
      return false;
    }
    links_.push_back({path, std::move(text), {}, {}});
    // what is wrong with a file that is based on nothing is told when it is read as a lesson
    base::Problems found;
    Link& link = links_.back();
    const bool good = parse_json(link.text, path, link.json, link.line_of, found);
    if (links_.size() > 1 || link.based()) problems_.insert(problems_.end(), found.begin(), found.end());
    return good;
  }

  /// What a file sets, and says for itself, into the one below it.
  bool lay_over(const Link& link, Json& whole) {
    bool good = true;
    for (const char* key : {"id", "title"})
      if (!link.json.contains(key))
        good =
            error(link, "",
                  std::string("\"") + key + "\" is missing: a lesson has its own, whatever it is based on.");
    for (const auto& [key, value] : link.json.items()) {
      const std::string pointer = "/" + pointer_step(key);
      if (key == "set")
        good = set_all(link, value, whole) && good;
      else if (key.starts_with("x-") || std::find(std::begin(kOwn), std::end(kOwn), key) != std::end(kOwn))
        whole[key] = value;
      else
        good =
            error(link, pointer,
                  "\"" + key +
                      "\" is what it has from the lesson it is based on. To change a value write \"set\": { "
                      "\"needle.arc\": \"2/8\" }; to add or to leave out something write the lesson whole.");
    }
    whole.erase("based_on");
    return good;
  }

  bool set_all(const Link& link, const Json& settings, Json& whole) {
    if (!settings.is_object())
      return error(link, "/set", "\"set\" is an object { \"needle.arc\": \"2/8\", ... }.");
    bool good = true;
    for (const auto& [what, value] : settings.items()) {
      const std::string pointer = "/set/" + pointer_step(what);
      if (what.find('.') == std::string::npos || what.front() == '.')
        good = error(link, pointer, "\"" + what + "\" is no value of a part; it looks like \"needle.arc\".");
      else
        good = set_in(whole, {what, value.dump()}, place_in(link.path, link.line_of, pointer), problems_) &&
               good;
    }
    return good;
  }

  base::Problems& problems_;
  std::vector<Link> links_;
};

}  // namespace

std::string place_in(const std::string& path, const std::map<std::string, uint32_t>& line_of,
                     const std::string& pointer) {
  // what is missing is told at the line of the object that should have it
  std::string known = pointer;
  while (!known.empty() && !line_of.contains(known)) known.erase(known.rfind('/'));
  const auto line = line_of.find(known);
  const std::string number =
      line == line_of.end() || pointer.empty() ? "" : ":" + std::to_string(line->second);
  return (path.empty() ? "lesson" : path) + number + (pointer.empty() ? "" : " #" + pointer);
}

bool parse_json(const std::string& text, const std::string& path, Json& json,
                std::map<std::string, uint32_t>& line_of, base::Problems& problems) {
  const auto error = [&](const std::string& where, const std::string& message) {
    problems.push_back({base::Severity::kError, where, message});
    return false;
  };
  const std::string file = place_in(path, {}, "");
  if (text.size() > kMaxBytes) return error(file, "It is larger than 4 MiB; that is no lesson.");
  if (nesting(text) > kMaxNesting) return error(file, "Its brackets are nested deeper than 32.");
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto [line, column] = place(text, e.byte);
    return error(file + ":" + std::to_string(line),
                 "This is not valid JSON at column " + std::to_string(column) +
                     ": a comma, colon, quotation mark or bracket is missing or too many.");
  } catch (const Json::exception&) {
    return error(file, "It holds a number that is too large.");
  }
  SourceMap map = map_source(text);
  line_of = std::move(map.line_of);
  for (const auto& [pointer, key] : map.double_keys)
    error(place_in(path, line_of, pointer + "/" + pointer_step(key)), "\"" + key + "\" is there twice.");
  return map.double_keys.empty();
}

bool read_lesson_text(const std::string& path, std::span<const Setting> settings, LessonText& out,
                      base::Problems& problems) {
  out = {};
  Chain chain(problems);
  return chain.follow(path) ? chain.apply(settings, out) : chain.broken_here(out);
}

}  // namespace swage::assembly
