// SPDX-License-Identifier: Apache-2.0
#include "host/rating_scales.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "host/sentences.hpp"
#include "host/units.hpp"

namespace swage::host {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& sentence) { throw std::runtime_error(sentence); }

const Json& at(const Json& from, const char* key, Json::value_t type, const std::string& where) {
  const auto found = from.find(key);
  if (found == from.end()) refuse(say::kNoKey(where, key));
  if (found->type() != type) refuse(say::kOtherKind(key, where, type == Json::value_t::string ? "text" : type == Json::value_t::object ? "an object" : "a list"));
  return *found;
}

std::string text(const Json& from, const char* key, const std::string& where) {
  const std::string out = at(from, key, Json::value_t::string, where);
  if (out.empty()) refuse(say::kEmptyKey(key, where));
  return out;
}

double number(const Json& from, const char* key, const std::string& where) {
  const auto found = from.find(key);
  if (found == from.end() || !found->is_number()) refuse(say::kNoNumberKey(where, key));
  return found->get<double>();
}

// refuses unknown keys: a mistyped one would be ignored silently
void expect_keys(const Json& from, std::initializer_list<const char*> known, const std::string& where) {
  if (!from.is_object()) refuse(say::kIsNoObject(where));
  for (const auto& [key, value] : from.items())
    if (std::find(known.begin(), known.end(), key) == known.end()) refuse(say::kUnknownKey(where, key));
}

// a text by language; English must be there, as it stands in for the others
judge::Words words(const Json& from, const char* key, const std::string& where) {
  const Json& by_language = at(from, key, Json::value_t::object, where);
  const std::string inside = "the " + std::string(key) + " of " + where;
  judge::Words out = {{"en", text(by_language, "en", inside)}};
  for (const auto& [code, said] : by_language.items())
    if (code != "en") out.emplace_back(code, text(by_language, code.c_str(), inside));
  return out;
}

// a text by language, or a single one for all of them
judge::Words words_or_text(const Json& from, const char* key, const std::string& where) {
  const auto found = from.find(key);
  if (found != from.end() && found->is_object()) return words(from, key, where);
  return {{"en", text(from, key, where)}};
}

// an optional key; false without it
bool flag(const Json& from, const char* key, const std::string& where) {
  const auto found = from.find(key);
  if (found == from.end()) return false;
  if (!found->is_boolean()) refuse(say::kIsNoFlag(key, where));
  return found->get<bool>();
}

// "30 deg", "3": to SI; `unit` is the SI symbol
double quantity(const std::string& given, const std::string& where, std::string& unit) {
  const std::size_t space = given.find(' ');
  const Unit* const found = find_unit(space == std::string::npos ? "1" : given.substr(space + 1));
  unit = found == nullptr ? "1" : found->si;
  double value = 0;
  std::string error;
  if (!parse_quantity(given, unit, where, value, error)) refuse(error);
  return value;
}

judge::RatedBy rated_by(const Json& from, const std::string& item) {
  judge::RatedBy out;
  out.metric = text(from, "id", "a metric of " + item);
  const std::string where = "metric \"" + out.metric + "\" of " + item;
  expect_keys(from, {"id", "best", "worst", "failed"}, where);
  out.of_failed = flag(from, "failed", where);
  std::string unit;
  out.best = quantity(text(from, "best", where), "\"best\" of " + where, out.unit);
  out.worst = quantity(text(from, "worst", where), "\"worst\" of " + where, unit);
  if (unit != out.unit) refuse(say::kUnlikeUnits(where));
  if (out.best == out.worst) refuse(say::kSameEnds(where));
  return out;
}

judge::RatingItem item(const Json& from) {
  judge::RatingItem out;
  out.id = text(from, "id", "an item");
  const std::string where = "item \"" + out.id + "\"";
  expect_keys(from, {"id", "title", "product", "metrics"}, where);
  out.title = words(from, "title", where);
  out.is_product = flag(from, "product", where);
  for (const Json& metric : at(from, "metrics", Json::value_t::array, where)) out.by.push_back(rated_by(metric, where));
  return out;
}

judge::RatingScale scale(const Json& from) {
  expect_keys(from, {"format", "id", "title", "source", "lowest_points", "highest_points", "needs", "items"}, "the scale");
  if (text(from, "format", "the scale") != "swage-scale/1") refuse(say::kScaleFormat("swage-scale/1"));
  judge::RatingScale out;
  out.id = text(from, "id", "the scale");
  out.title = words(from, "title", "the scale");
  out.source = words_or_text(from, "source", "the scale");
  out.lowest = number(from, "lowest_points", "the scale");
  out.highest = number(from, "highest_points", "the scale");
  if (!(out.lowest < out.highest)) refuse(say::kNotBelow());
  if (from.contains("needs")) {
    for (const Json& metric : at(from, "needs", Json::value_t::array, "the scale")) {
      if (!metric.is_string()) refuse(say::kNeedsIsNoList());
      out.needs.push_back(metric.get<std::string>());
    }
  }
  std::set<std::string> ids;
  for (const Json& one : at(from, "items", Json::value_t::array, "the scale")) {
    out.items.push_back(item(one));
    if (!ids.insert(out.items.back().id).second) refuse(say::kSameItem(out.items.back().id));
  }
  if (out.items.empty()) refuse(say::kNoItems());
  return out;
}

}  // namespace

bool read_rating_scale(const std::string& text, judge::RatingScale& out, std::string& error) {
  try {
    out = scale(Json::parse(text));
    return true;
  } catch (const std::exception& e) {
    error = e.what();
    return false;
  }
}

std::vector<judge::RatingScale> rating_scales(const std::string& folder, std::vector<std::string>& errors) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<judge::RatingScale> out;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    judge::RatingScale one;
    std::string error;
    if (read_rating_scale({std::istreambuf_iterator<char>(in), {}}, one, error))
      out.push_back(std::move(one));
    else
      errors.push_back(file.string() + ": " + error);
  }
  return out;
}

std::string own_scales_folder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data == '/') return std::string(data) + "/swage/scales";
  const char* home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? std::string(home) + "/.local/share/swage/scales" : "";
}

void add_own_scales(std::vector<judge::RatingScale>& scales, std::vector<std::string>& errors) {
  const std::string folder = own_scales_folder();
  if (folder.empty()) return;
  for (judge::RatingScale& own : rating_scales(folder, errors)) {
    const bool taken = std::any_of(scales.begin(), scales.end(), [&](const judge::RatingScale& other) { return other.id == own.id; });
    if (taken)
      errors.push_back(folder + ": " + say::kSameScale(own.id));
    else
      scales.push_back(std::move(own));
  }
}

}  // namespace swage::host
