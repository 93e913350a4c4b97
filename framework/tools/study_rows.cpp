// SPDX-License-Identifier: Apache-2.0
#include "tools/study_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "assembly/lesson_text.hpp"
#include "toolkit/read_file.hpp"
#include "tools/print.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRowsFormat = "swage-study-rows/1";
constexpr std::size_t kMostRowsBytes = std::size_t{1} << 30;  // a million attempts of a thousand bytes

// FNV-1a of 64 bits: for comparing names, no protection against an attack.
class Hash {
 public:
  void add(const std::string& text) {
    for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    value_ = (value_ ^ 0xff) * 0x100000001b3ull;  // separates texts
  }
  std::string hex() const { return format("%016llx", static_cast<unsigned long long>(value_)); }

 private:
  uint64_t value_ = 0xcbf29ce484222325ull;
};

nlohmann::json to_json(uint64_t number, const StudyRow& row) {
  nlohmann::json metrics = nlohmann::json::object();
  for (const auto& [id, value] : row.metric) metrics[id] = std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
  return {{"row", number},       {"level", {row.level[0], row.level[1]}}, {"hand", row.hand},     {"seed", row.seed},
          {"passed", row.passed}, {"reason", row.reason},                  {"score", row.score}, {"metric", metrics}};
}

bool from_json(const nlohmann::json& json, uint64_t& number, StudyRow& row) {
  try {
    number = json.at("row");
    row.level[0] = json.at("level").at(0);
    row.level[1] = json.at("level").at(1);
    row.hand = json.at("hand");
    row.seed = json.at("seed");
    row.passed = json.at("passed");
    row.reason = json.at("reason");
    row.score = json.at("score");
    for (const auto& [id, value] : json.at("metric").items()) row.metric[id] = value.is_null() ? NAN : value.get<double>();
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

std::vector<std::string> row_files(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("rows-") && name.ends_with(".jsonl")) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

// Reads whole lines; the first names the study. False for the file of another study, or without a file.
bool read_lines(const std::string& path, const std::string& name, std::vector<nlohmann::json>& lines, std::size_t& whole_bytes) {
  std::string text, why;
  whole_bytes = 0;
  if (!toolkit::read_file(path, kMostRowsBytes, text, why)) return false;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    nlohmann::json line = nlohmann::json::parse(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    if (!line.is_object()) break;
    if (at == 0 && (line.value("format", "") != kRowsFormat || line.value("study", "") != name)) return false;
    lines.push_back(std::move(line));
    whole_bytes = end + 1;
  }
  return !lines.empty();
}

}  // namespace

bool read_shard(const std::string& text, Shard& out) {
  const char* const end = text.data() + text.size();
  const auto [slash, bad] = std::from_chars(text.data(), end, out.index);
  if (bad != std::errc() || slash == end || *slash != '/') return false;
  const auto [rest, worse] = std::from_chars(slash + 1, end, out.count);
  return worse == std::errc() && rest == end && out.index >= 1 && out.index <= out.count;
}

std::string study_name(const Study& study, const std::string& file_text, const std::vector<std::string>& settings) {
  Hash hash;
  hash.add(SWAGE_VERSION);
  hash.add(file_text);
  for (const std::string& s : settings) hash.add(s);
  std::set<std::string> lessons = {study.lesson};
  for (const StudyFactor& factor : study.factors)
    for (const StudyLevel& level : factor.levels) lessons.insert(level.lesson);
  for (const std::string& path : lessons) {
    assembly::LessonText text;
    base::Problems ignored;  // reported when the lesson is run
    if (!path.empty() && assembly::read_lesson_text(path, {}, text, ignored)) hash.add(text.text);
  }
  return hash.hex();
}

StudyRows read_rows(const std::string& folder, const std::string& name) {
  StudyRows out;
  for (const std::string& path : row_files(folder)) {
    std::vector<nlohmann::json> lines;
    std::size_t bytes = 0;
    if (!read_lines(path, name, lines, bytes)) continue;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      uint64_t number = 0;
      StudyRow row;
      if (from_json(lines[i], number, row)) out[number] = std::move(row);
    }
  }
  return out;
}

void remove_rows(const std::string& folder, const std::string& name) {
  for (const std::string& path : row_files(folder)) {
    std::vector<nlohmann::json> lines;
    std::size_t bytes = 0;
    std::error_code none;
    if (read_lines(path, name, lines, bytes)) fs::remove(path, none);
  }
}

RowWriter::RowWriter(const std::string& folder, const Shard& shard, const std::string& name)
    : path_(folder + format("/rows-%llu-of-%llu.jsonl", static_cast<unsigned long long>(shard.index),
                            static_cast<unsigned long long>(shard.count))) {
  std::vector<nlohmann::json> lines;
  std::size_t bytes = 0;
  const bool goes_on = read_lines(path_, name, lines, bytes);
  std::error_code none;
  if (goes_on) fs::resize_file(path_, bytes, none);
  file_.open(path_, std::ios::binary | (goes_on ? std::ios::app : std::ios::trunc));
  if (!goes_on) file_ << nlohmann::json{{"format", kRowsFormat}, {"study", name}}.dump() << '\n' << std::flush;
}

bool RowWriter::add(uint64_t number, const StudyRow& row) {
  file_ << to_json(number, row).dump() << '\n' << std::flush;
  return file_.good();
}

}  // namespace swage::tools
