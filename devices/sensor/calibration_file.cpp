// SPDX-License-Identifier: Apache-2.0
#include "sensor/calibration_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "sensor/sentences.hpp"
#include "toolkit/read_file.hpp"

namespace swage::sensor {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "swage-calibration/1";

// exception: the fault found while reading
struct Wrong {
  std::string text;
};

double number(const Json& in, const std::string& place, const char* key) {
  const auto it = in.find(key);
  if (it == in.end() || !it->is_number() || !std::isfinite(it->get<double>())) throw Wrong{say::kNumber(place, key)};
  return it->get<double>();
}

std::string text(const Json& in, const char* key) {
  const auto it = in.find(key);
  if (it == in.end()) return "";
  if (!it->is_string()) throw Wrong{say::kText(key)};
  return it->get<std::string>();
}

// an object that may have these keys only: a misspelt key would be ignored silently
const Json* part(const Json& in, const char* key, std::initializer_list<const char*> known) {
  const auto it = in.find(key);
  if (it == in.end()) return nullptr;
  if (!it->is_object()) throw Wrong{say::kObject(key)};
  for (const auto& [name, value] : it->items())
    if (std::none_of(known.begin(), known.end(), [&n = name](const char* k) { return n == k; }))
      throw Wrong{say::kUnknown(std::string(key) + "/" + name)};
  return &*it;
}

void rows(const Json& in, const std::string& place, std::size_t columns, const std::function<void(const Json&)>& take) {
  if (!in.is_array()) throw Wrong{say::kList(place)};
  for (const Json& row : in) {
    const bool whole = row.is_array() && row.size() == columns &&
                       std::all_of(row.begin(), row.end(), [](const Json& x) { return x.is_number() || x.is_boolean(); });
    if (!whole) throw Wrong{say::kRows(place, columns)};
    take(row);
  }
}

void read_displacement(const Json& in, Displacement& out) {
  const Json* d = part(in, "displacement", {"slope", "offset", "worst", "rms", "points"});
  if (d == nullptr) throw Wrong{say::kMissing()};
  out.slope = number(*d, "displacement/", "slope");
  out.offset = number(*d, "displacement/", "offset");
  out.worst = number(*d, "displacement/", "worst");
  out.rms = number(*d, "displacement/", "rms");
  if (out.slope == 0) throw Wrong{say::kNoSlope()};
  if (!d->contains("points")) return;
  rows(d->at("points"), "displacement/points", 4, [&](const Json& r) {
    out.points.push_back({r[0].get<double>(), r[1].get<double>(), r[2].get<double>(), r[3].get<bool>()});
  });
}

void read(const Json& in, Calibration& out) {
  static const std::vector<std::string> kKeys = {"format", "serial",       "name",  "date",     "by",
                                                 "expires", "displacement", "force", "tip", "check", "geometry", "poses", "gauge_zero"};
  if (!in.is_object() || text(in, "format") != kFormat) throw Wrong{say::kFormatIs(kFormat)};
  for (const auto& [key, value] : in.items())
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) throw Wrong{say::kUnknown(key)};
  out.serial = text(in, "serial"), out.name = text(in, "name");
  out.date = text(in, "date"), out.by = text(in, "by"), out.expires = text(in, "expires");
  for (const std::string* date : {&out.date, &out.expires})
    if (!date->empty() && days_after(*date, 0) != *date) throw Wrong{say::kNoDate(*date)};
  read_displacement(in, out.displacement);
  for (const auto& [key, curve] : {std::pair{"force", &out.force}, {"tip", &out.tip}}) {
    if (!in.contains(key)) continue;
    std::vector<MonotoneCurve::Point> points;
    rows(in[key], key, 2, [&, p = &points](const Json& r) { p->push_back({r[0].get<double>(), r[1].get<double>()}); });
    if (std::string wrong = curve->set(points); !wrong.empty()) throw Wrong{say::kInPart(key, wrong)};
  }
  if (in.contains("gauge_zero")) out.gauge_zero = number(in, "", "gauge_zero");
  if (const Json* c = part(in, "check", {"wanted", "measured", "date"}))
    out.check = {number(*c, "check/", "wanted"), number(*c, "check/", "measured"), text(*c, "date")};
  if (const Json* g = part(in, "geometry", {"a", "b", "gap"}))
    out.geometry = {number(*g, "geometry/", "a"), number(*g, "geometry/", "b"), number(*g, "geometry/", "gap")};
  if (const Json* p = part(in, "poses", {"open", "closed", "squeezed", "date", "zero_date"})) {
    out.poses = {number(*p, "poses/", "open"), number(*p, "poses/", "closed"), number(*p, "poses/", "squeezed")};
    out.poses_date = text(*p, "date"), out.zero_date = text(*p, "zero_date");
    if (std::string wrong = check_poses(out.poses, {}); !wrong.empty()) throw Wrong{say::kInPart("poses", wrong)};
    if (std::string wrong = check_geometry(out.geometry, out.poses); !wrong.empty()) throw Wrong{say::kInPart("geometry", wrong)};
  }
}

Json written(const Calibration& c) {
  Json out = {{"format", kFormat}, {"serial", c.serial}, {"name", c.name}, {"date", c.date}, {"by", c.by}, {"expires", c.expires}};
  const Displacement& d = c.displacement;
  out["displacement"] = {{"slope", d.slope}, {"offset", d.offset}, {"worst", d.worst}, {"rms", d.rms}, {"points", Json::array()}};
  for (const BenchPoint& p : d.points)
    out["displacement"]["points"].push_back(Json::array({p.volts, p.length_m, p.residual_m, p.used}));
  for (const auto& p : c.force.points()) out["force"].push_back(Json::array({p.x, p.y}));
  for (const auto& p : c.tip.points()) out["tip"].push_back(Json::array({p.x, p.y}));
  if (c.check.known()) out["check"] = {{"wanted", c.check.wanted}, {"measured", c.check.measured}, {"date", c.check.date}};
  if (c.geometry.known()) out["geometry"] = {{"a", c.geometry.a}, {"b", c.geometry.b}, {"gap", c.geometry.gap}};
  if (c.poses.known())
    out["poses"] = {{"open", c.poses.open}, {"closed", c.poses.closed}, {"squeezed", c.poses.squeezed}, {"date", c.poses_date}};
  if (c.gauge_zero != 0) out["gauge_zero"] = c.gauge_zero;
  if (c.poses.known() && !c.zero_date.empty()) out["poses"]["zero_date"] = c.zero_date;
  return out;
}

}  // namespace

std::string calibration_folder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != '\0') return std::string(data) + "/swage/calibrations";
  const char* home = std::getenv("HOME");
  return std::string(home != nullptr ? home : "") + "/.local/share/swage/calibrations";
}

std::string calibration_path(const std::string& serial) {
  const bool plain = !serial.empty() && serial.size() <= 64 && serial[0] != '.' &&
                     std::all_of(serial.begin(), serial.end(), [](unsigned char c) {
                       return c < 128 && (std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.');
                     });
  return plain ? calibration_folder() + "/" + serial + ".json" : "";
}

std::vector<std::string> calibration_files() {
  std::vector<std::string> out;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(calibration_folder(), ignored))
    if (entry.path().extension() == ".json") out.push_back(entry.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

std::string load_calibration(const std::string& path, Calibration& out) {
  std::string bytes, why;
  if (!toolkit::read_file(path, std::size_t{1} << 20, bytes, why)) return path + ": " + why;
  const Json json = Json::parse(bytes, nullptr, false);
  if (json.is_discarded()) return path + ": " + say::kNoJson();
  Calibration found;
  try {
    read(json, found);
  } catch (const Wrong& wrong) {
    return path + ": " + wrong.text;
  }
  out = std::move(found);
  return "";
}

std::string calibration_text(const Calibration& calibration) { return written(calibration).dump(2) + "\n"; }

std::string save_calibration(const std::string& path, const Calibration& calibration) {
  std::error_code code;
  fs::create_directories(fs::path(path).parent_path(), code);
  const std::string beside = path + ".new", bytes = calibration_text(calibration);
  std::FILE* file = std::fopen(beside.c_str(), "wbe");
  bool good = file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  good = file != nullptr && std::fflush(file) == 0 && fsync(fileno(file)) == 0 && good;
  if (file != nullptr) good = std::fclose(file) == 0 && good;
  if (good && std::rename(beside.c_str(), path.c_str()) == 0) return "";
  const std::string why = std::strerror(errno);
  std::remove(beside.c_str());
  return say::kNotWritten(path, why);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
  return text;
}

int days_between(const std::string& from, const std::string& to) {
  std::tm a{}, b{};
  if (strptime(from.c_str(), "%Y-%m-%d", &a) == nullptr || strptime(to.c_str(), "%Y-%m-%d", &b) == nullptr) return 0;
  return static_cast<int>((timegm(&b) - timegm(&a)) / 86400);
}

std::string days_after(const std::string& date, int days) {
  std::tm parts{};
  const char* end = strptime(date.c_str(), "%Y-%m-%d", &parts);
  if (end == nullptr || *end != '\0') return "";
  parts.tm_mday += days;
  parts.tm_hour = 12;
  const std::time_t then = timegm(&parts);
  gmtime_r(&then, &parts);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
  return text;
}

}  // namespace swage::sensor
