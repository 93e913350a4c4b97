// SPDX-License-Identifier: Apache-2.0
#include "assembly/lesson_text.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "assembly/parts.hpp"
#include "assembly/sentences.hpp"
#include "assembly/source_map.hpp"
#include "base/text.hpp"
#include "toolkit/read_file.hpp"

namespace swage::assembly {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxBytes = std::size_t{4}
                                  << 20;  // a lesson has some kilobytes; a mesh is a separate file
constexpr uint32_t kMaxNesting = 32;
constexpr std::size_t kMostText = 10'000;  // bytes of one text: a page of summary has some thousand
constexpr std::size_t kMostBases = 8;  // a longer chain could not be followed by a person

// Keys that a lesson based on another has itself; all else is taken from the base.
constexpr const char* kOwn[] = {"format",  "based_on", "set",  "id",           "title",
                                "summary", "goal",     "seed", "rate_hz",      "gravity",
                                "mirror",  "mode",     "cues", "scene_length", "max_time", "tips_only", "view",
                                "environment", "reset", "pull"};

// position of a parser error, as line and column
std::pair<uint32_t, uint32_t> place(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto line =
      static_cast<uint32_t>(1 + std::count(text.begin(), text.begin() + static_cast<long>(end), '\n'));
  const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return {line, static_cast<uint32_t>(start == std::string::npos ? end + 1 : end - start)};
}

/// One file of the "based_on" chain.
struct Link {
  std::string path, text;
  Json json;
  Places places;
  std::map<std::string, uint32_t> line_of;
  bool readable = false;

  bool based() const { return json.is_object() && json.contains("based_on"); }
};

/// Reports texts with control characters, which would move a terminal's cursor, and overlong ones.
bool sound_texts(const Json& json, const std::string& pointer, const Link& link, base::Problems& problems) {
  const auto sound = [&](const std::string& text, const std::string& at) {
    const bool control = base::has_control(text);
    if (!control && text.size() <= kMostText) return true;
    problems.push_back({base::Severity::kError, link.places.where(at),
                        control ? say::kControl(base::printable(base::shortened(text, 40))) : say::kLongText()});
    return false;
  };
  if (json.is_string()) return sound(json.get_ref<const std::string&>(), pointer);
  bool good = true;
  if (json.is_object())
    for (const auto& [key, value] : json.items()) {
      const std::string below = pointer + "/" + pointer_step(key);
      good = sound(key, below) && sound_texts(value, below, link, problems) && good;
    }
  if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i)
      good = sound_texts(json[i], pointer + "/" + std::to_string(i), link, problems) && good;
  return good;
}

/// Parses JSON of at most 4 MiB, nested at most 32 deep. False and problems otherwise; also for a duplicate key or a text with control
/// characters, where the link is still readable.
bool parse(Link& link, base::Problems& problems) {
  const std::string file = link.path.empty() ? "lesson" : link.path;
  const auto error = [&](const std::string& where, const std::string& message) {
    problems.push_back({base::Severity::kError, where, message});
    return false;
  };
  if (link.text.size() > kMaxBytes) return error(file, say::kTooLarge());
  if (link.text.find_first_not_of(" \t\r\n") == std::string::npos)
    return error(file, say::kEmpty());
  if (nesting(link.text) > kMaxNesting) return error(file, say::kTooDeep());
  try {
    link.json = Json::parse(link.text);
  } catch (const Json::parse_error& e) {
    const auto [line, column] = place(link.text, e.byte);
    return error(file + ":" + std::to_string(line),
                 say::kNotJson(column));
  } catch (const Json::exception&) {
    return error(file, say::kLargeNumber());
  }
  SourceMap map = map_source(link.text);
  if (map.cut)
    return error(file, say::kTooMuch());
  link.readable = true;
  link.line_of = map.line_of;
  link.places = Places(link.path, link.path, std::move(map.line_of));
  for (const auto& [pointer, key] : map.double_keys)
    error(link.places.where(pointer + "/" + pointer_step(key)), say::kTwice(key));
  return sound_texts(link.json, "", link, problems) && map.double_keys.empty();
}

bool give(Link& link, LessonText& out) {
  out.text = std::move(link.text);
  out.json = std::move(link.json);
  out.readable = link.readable;
  out.beside = link.path;
  out.places = std::move(link.places);
  return true;
}

class Chain {
 public:
  explicit Chain(base::Problems& problems) : problems_(problems) {}

  /// Opens the file and all files that it is based on; false where one of them does not exist.
  bool follow(const std::string& path) {
    if (!open(path)) return false;
    while (links_.back().based()) {
      const Link& link = links_.back();
      const Json& base = link.json["based_on"];
      if (!base.is_string() || base.get<std::string>().empty())
        return error(link, "/based_on", say::kBaseIsNoText());
      const std::string next = (fs::path(link.path).parent_path() / base.get<std::string>()).string();
      std::error_code none;
      for (const Link& before : links_)
        if (fs::equivalent(before.path, next, none))
          return error(link, "/based_on", say::kBaseIsItself(next));
      if (links_.size() > kMostBases)
        return error(link, "/based_on", say::kTooManyBases());
      const std::string why = toolkit::file_refusal(next, kMaxBytes);
      if (why == "There is no such file.")
        return error(link, "/based_on", say::kNoBase(next));
      if (!why.empty())
        return error(link, "/based_on", say::kBadBase(next, why));
      if (!open(next)) return false;
    }
    return true;
  }

  bool apply(std::span<const Setting> settings, LessonText& out) {
    Link& whole = links_.back();
    out.made = links_.size() > 1 || !settings.empty();
    if (!out.made) return give(whole, out);
    if (!whole.json.is_object())
      return error(whole, "", say::kNothingToSetIn());
    // the lesson's path is that of the first file; unmodified values are in the last one
    whole.places = Places(links_.front().path, whole.path, whole.line_of);
    bool good = true;
    for (std::size_t i = links_.size() - 1; i-- > 0;) good = lay_over(links_[i], whole) && good;
    for (const Setting& setting : settings) good = set(whole, setting, "") && good;
    if (good) whole.text = whole.json.dump(2, ' ', false, Json::error_handler_t::replace);
    give(whole, out);
    return good;
  }

  /// The readable part of a broken chain: a file that is based on no other.
  bool broken_here(LessonText& out) {
    if (links_.size() == 1 && !links_[0].based()) give(links_[0], out);
    return false;
  }

 private:
  bool error(const Link& link, const std::string& pointer, const std::string& message) {
    problems_.push_back({base::Severity::kError, link.places.where(pointer), message});
    return false;
  }

  bool open(const std::string& path) {
    std::string text, why;
    if (toolkit::read_file(path, kMaxBytes, text, why)) {
      links_.push_back({path, std::move(text), {}, {}, {}, false});
      return parse(links_.back(), problems_);
    }
    if (why == "There is no such file.") why = say::kNoFile();
    problems_.push_back({base::Severity::kError, path, why});
    return false;
  }

  /// Sets one value, reports at `place` if it cannot be set, and records `place` as its place; "" for settings from outside of all files.
  bool set(Link& whole, const Setting& setting, const std::string& place) {
    std::vector<std::string> pointers;
    const std::string& path = links_.front().path;
    const bool good = set_in(whole.json, setting, place.empty() ? path : place, problems_, pointers);
    for (const std::string& p : pointers) whole.places.move(p, place.empty() ? path + " #" + p : place);
    return good;
  }

  /// Applies the changes of a file, and its own keys, to its base.
  bool lay_over(const Link& link, Link& whole) {
    bool good = true;
    for (const char* key : {"id", "title"})
      if (!link.json.contains(key))
        good =
            error(link, "",
                  say::kNotOwn(key));
    // added parts can be set, also in place of removed ones
    if (link.json.contains("remove")) good = remove_parts({link.json["remove"], link.places, "/remove"}, whole.json, whole.places, problems_) && good;
    if (link.json.contains("add")) good = add_parts({link.json["add"], link.places, "/add"}, whole.json, whole.places, problems_) && good;
    for (const auto& [key, value] : link.json.items()) {
      const std::string pointer = "/" + pointer_step(key);
      if (key == "remove" || key == "add") continue;
      if (key == "set")
        good = set_all(link, value, whole) && good;
      else if (key.starts_with("x-") || std::find(std::begin(kOwn), std::end(kOwn), key) != std::end(kOwn)) {
        whole.json[key] = value;
        whole.places.move(pointer, link.places.where(pointer));
      } else {
        good =
            error(link, pointer,
                  say::kFromBase(key));
      }
    }
    whole.json.erase("based_on");
    return good;
  }

  bool set_all(const Link& link, const Json& settings, Link& whole) {
    if (!settings.is_object())
      return error(link, "/set", say::kSetIsNoObject());
    bool good = true;
    for (const auto& [what, value] : settings.items()) {
      const std::string pointer = "/set/" + pointer_step(what);
      if (what.find('.') == std::string::npos || what.front() == '.')
        good = error(link, pointer, say::kNoPart(what));
      else
        good = set(whole, {what, value.dump()}, link.places.where(pointer)) && good;
    }
    return good;
  }

  base::Problems& problems_;
  std::vector<Link> links_;
};

}  // namespace

bool read_lesson_text(const std::string& path, std::span<const Setting> settings, LessonText& out,
                      base::Problems& problems) {
  out = {};
  Chain chain(problems);
  return chain.follow(path) ? chain.apply(settings, out) : chain.broken_here(out);
}

bool parse_lesson_text(const std::string& text, const std::string& path, LessonText& out,
                       base::Problems& problems) {
  out = {};
  Link link{path, text, {}, {}, {}, false};
  const bool good = parse(link, problems);
  give(link, out);
  return good;
}

}  // namespace swage::assembly
