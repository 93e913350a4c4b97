// SPDX-License-Identifier: Apache-2.0
#include "mutants.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "assembly/lesson_text.hpp"
#include "base/rng.hpp"

namespace swage::fuzz {
namespace {

namespace fs = std::filesystem;
using Pointer = Json::json_pointer;
using Random = base::Xoshiro256;

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

std::vector<Json> nasty() {
  std::vector<Json> list = {nullptr, true, false, 0, 1, -1, 2, 3, 0.5, 1e-9, -1e-9, 1e-300, 1e300, 1e308, -1e308, -0.0, 1e9,
                            4294967295u, 4294967296u, 18446744073709551615u, INT64_MIN, "", " ", "1", "0 mm", "-1 mm", "1 m",
                            "1e308 mm", "1e-300 m", "1 N", "90 deg", "nan", "inf m", "0x10", "needle", "holder", "hand", "lesson",
                            "swage", "tray", "swage.object.needle", "swage.coupling.contact", "swage.lesson.grasp", "..", "/", "/dev/zero",
                            "/dev/null", ".", "\n", "\u00e9", Json::array(), Json::object(), {0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0},
                            {"", ""}, {"needle", "needle"}, {1e9, 1e9, 1e9}, {1e-9, 1e9}, {1, -1}};
  list.push_back(std::string(9000, 'a'));
  list.push_back(Json{{"plugin", "swage.object.needle"}});
  list.push_back(Json{{"pose", "hand"}, {"closure", "hand"}});
  Json deep = Json::array();
  for (int i = 0; i < 25; ++i) deep = Json::array({deep});
  list.push_back(deep);
  list.push_back(Json(std::vector<int>(3000, 1)));
  return list;
}

// a hand's file is told by its place, which is that of the lesson
void make_absolute(Json& json, const fs::path& folder) {
  if (json.is_string()) {
    const std::string& text = json.get_ref<const std::string&>();
    std::error_code none;
    if (text.ends_with(".json") && fs::is_regular_file(folder / text, none))
      json = (folder / text).lexically_normal().string();
  }
  if (json.is_structured())
    for (Json& below : json) make_absolute(below, folder);
}

double at_bound(const host::Param& p, Random& random) {
  const double low = std::isfinite(p.min) ? p.min : -1e9, high = std::isfinite(p.max) ? p.max : 1e9;
  const bool whole = p.type == SWAGE_PARAM_INTEGER;
  switch (below(random, 4)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:  // anywhere between, by size where that makes a difference
      if (!whole && low > 0) return low * std::pow(high / low, static_cast<double>(below(random, 1000)) / 1000);
      [[fallthrough]];
    default: {
      const double x = low + (high - low) * static_cast<double>(below(random, 1000)) / 1000;
      return whole ? std::floor(x) : x;
    }
  }
}

Json value_at_bound(const host::Param& p, Random& random) {
  switch (p.type) {
    case SWAGE_PARAM_BOOL:
      return below(random, 2) == 0;
    case SWAGE_PARAM_CHOICE:
      return p.choices[below(random, p.choices.size())];
    case SWAGE_PARAM_VECTOR: {
      Json list = Json::array();
      for (uint32_t i = 0; i < p.dimension; ++i) list.push_back(at_bound(p, random));
      return list;
    }
    case SWAGE_PARAM_INTEGER:
      return static_cast<int64_t>(at_bound(p, random));
    default:
      return at_bound(p, random);
  }
}

}  // namespace

std::vector<Seed> shipped_lessons(const std::string& folder) {
  std::vector<Seed> seeds;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    assembly::LessonText whole;
    base::Problems problems;
    assembly::read_lesson_text(entry.path().string(), {}, whole, problems);
    make_absolute(whole.json, folder);
    seeds.push_back({entry.path().filename().string(), std::move(whole.json)});
  }
  std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.name < b.name; });
  return seeds;
}

Mutants::Mutants(std::vector<Seed> seeds, const host::Catalogue& catalogue)
    : seeds_(std::move(seeds)), nasty_(nasty()), of_seed_(seeds_.size()), bounds_of_(seeds_.size()) {
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    const Json& lesson = seeds_[i].lesson;
    collect(i, lesson, Pointer());
    for (const char* list : {"objects", "couplings", "devices"})
      for (std::size_t k = 0; lesson.contains(list) && k < lesson[list].size(); ++k)
        collect_bounds(i, lesson[list][k], Pointer() / list / k, catalogue);
    collect_bounds(i, lesson["lesson"], Pointer() / "lesson", catalogue);
  }
}

void Mutants::collect(std::size_t seed, const Json& at, const Pointer& pointer) {
  if (!pointer.empty()) {
    places_.push_back({seed, pointer});
    of_seed_[seed].push_back(pointer);
  }
  if (at.is_object())
    for (const auto& [key, value] : at.items()) collect(seed, value, pointer / key);
  if (at.is_array())
    for (std::size_t i = 0; i < at.size(); ++i) collect(seed, at[i], pointer / i);
}

void Mutants::collect_bounds(std::size_t seed, const Json& use, const Pointer& pointer,
                             const host::Catalogue& catalogue) {
  const host::PluginInfo* plugin = catalogue.find(use.value("plugin", ""));
  if (plugin == nullptr) return;
  for (const host::Param& p : plugin->params) {
    if (p.type == SWAGE_PARAM_TEXT || p.type == SWAGE_PARAM_FILE) continue;
    bounds_of_[seed].push_back(bounds_.size());
    bounds_.push_back({seed, pointer / "params", &p});
  }
}

Mutant Mutants::substitution(uint64_t number) const {
  const Place& place = places_[number / nasty_.size()];
  const Json& value = nasty_[number % nasty_.size()];
  Mutant out{seeds_[place.seed].name, place.pointer.to_string() + " = " + value.dump().substr(0, 60),
             seeds_[place.seed].lesson};
  out.lesson[place.pointer] = value;
  return out;
}

Mutant Mutants::at_bounds(uint64_t number) const {
  Random random(number);
  const std::size_t seed = below(random, seeds_.size());
  Mutant out{seeds_[seed].name, "", seeds_[seed].lesson};
  for (int i = 0; i < 2; ++i) {
    const Bound& bound = bounds_[bounds_of_[seed][below(random, bounds_of_[seed].size())]];
    const Json value = value_at_bound(*bound.param, random);
    out.lesson[bound.params][bound.param->id] = value;
    out.change += (bound.params / bound.param->id).to_string() + " = " + value.dump() + "; ";
  }
  return out;
}

Mutant Mutants::mixed(uint64_t number) const {
  Random random(number);
  const std::size_t seed = below(random, seeds_.size());
  Mutant out{seeds_[seed].name, "", seeds_[seed].lesson};
  for (std::size_t i = 0, n = 1 + below(random, 4); i < n; ++i) {
    const Pointer& at = of_seed_[seed][below(random, of_seed_[seed].size())];
    if (!out.lesson.contains(at)) continue;  // lost by an earlier change
    const Pointer parent = at.parent_pointer();
    switch (below(random, 5)) {
      case 0:
        out.change += at.to_string() + " lost; ";
        if (out.lesson[parent].is_object())
          out.lesson[parent].erase(at.back());
        else
          out.lesson[parent].erase(std::stoul(at.back()));
        break;
      case 1:
        if (!out.lesson[parent].is_array()) break;
        out.change += at.to_string() + " twice; ";
        out.lesson[parent].push_back(Json(out.lesson[at]));
        break;
      case 2: {
        const Place& other = places_[below(random, places_.size())];
        out.change += at.to_string() + " = that of " + seeds_[other.seed].name + other.pointer.to_string() + "; ";
        out.lesson[at] = seeds_[other.seed].lesson[other.pointer];
        break;
      }
      case 3: {  // to the same place in another lesson of the series: often a scene
        const std::size_t from = below(random, seeds_.size());
        if (!seeds_[from].lesson.contains(at)) break;
        out.change += at.to_string() + " as in " + seeds_[from].name + "; ";
        out.lesson[at] = seeds_[from].lesson[at];
        break;
      }
      default: {
        const Json& value = nasty_[below(random, nasty_.size())];
        out.change += at.to_string() + " = " + value.dump().substr(0, 60) + "; ";
        out.lesson[at] = value;
      }
    }
  }
  return out;
}

}  // namespace swage::fuzz
