// SPDX-License-Identifier: Apache-2.0
#include "assembly/places.hpp"

#include <utility>

namespace swage::assembly {
namespace {

template <class Value>
void erase_below(std::map<std::string, Value>& map, const std::string& pointer) {
  // '0' is the character after '/': every key between them is below the pointer
  map.erase(map.lower_bound(pointer + "/"), map.lower_bound(pointer + "0"));
  map.erase(pointer);
}

}  // namespace

Places::Places(std::string path, std::string file, std::map<std::string, uint32_t> line_of)
    : path_(std::move(path)), file_(std::move(file)), line_of_(std::move(line_of)) {}

void Places::move(const std::string& pointer, const std::string& place) {
  erase_below(line_of_, pointer);
  erase_below(moved_, pointer);
  moved_[pointer] = place;
}

void Places::close_gap(const std::string& list, std::size_t at, std::size_t count) {
  const auto element = [&](std::size_t i) { return list + "/" + std::to_string(i); };
  move(element(at), "");
  moved_.erase(element(at));
  for (std::size_t i = at + 1; i < count; ++i) {
    const std::string from = element(i), to = element(i - 1);
    std::map<std::string, std::string> places = below(from);
    move(from, "");
    moved_.erase(from);
    for (const auto& [pointer, place] : places) moved_[to + pointer.substr(from.size())] = place;
  }
}

std::map<std::string, std::string> Places::below(const std::string& pointer) const {
  std::map<std::string, std::string> places{{pointer, where(pointer)}};
  for (auto it = line_of_.lower_bound(pointer + "/"); it != line_of_.lower_bound(pointer + "0"); ++it) places[it->first] = where(it->first);
  for (auto it = moved_.lower_bound(pointer + "/"); it != moved_.lower_bound(pointer + "0"); ++it) places[it->first] = it->second;
  return places;
}

std::string Places::where(const std::string& pointer) const {
  const std::string path = path_.empty() ? "lesson" : path_;
  if (pointer.empty()) return path;
  // a missing value is reported at the line of the object that should have it
  for (std::string known = pointer;; known.erase(known.rfind('/'))) {
    if (const auto moved = moved_.find(known); moved != moved_.end()) return moved->second;
    if (const auto line = line_of_.find(known); line != line_of_.end())
      return (file_.empty() ? path : file_) + ":" + std::to_string(line->second) + " #" + pointer;
    if (known.empty()) return path + " #" + pointer;
  }
}

}  // namespace swage::assembly
