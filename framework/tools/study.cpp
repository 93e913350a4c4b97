// SPDX-License-Identifier: Apache-2.0
//
// swage study: runs a lesson over a matrix of variants and hands, as fast as possible; or reaction laws over one recorded hand.
#include "tools/study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "session/session.hpp"
#include "toolkit/read_file.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/study_laws.hpp"
#include "tools/study_rows.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Reads a study file; reports faults with their place in the file.
class Reader {
 public:
  Reader(std::string path, base::Problems& problems) : path_(std::move(path)), problems_(problems) {}

  void read(const Json& file, Study& out) {
    if (!file.is_object() || file.value("format", "") != "swage-study/1")
      return error("/format", say::kNeedsFormat("swage-study/1"));
    for (const auto& item : file.items())
      only(item.key(), "",
           {"format", "title", "doc", "lesson", "repeats", "seed", "factors", "hands", "figures"});
    out.title = text(file, "title", "");
    if (file.contains("lesson")) out.lesson = beside(text(file, "lesson", ""));
    out.repeats = whole(file, "repeats", 1);
    out.seed = whole(file, "seed", 1);
    each(file, "factors",
         [&](const Json& f, const std::string& at) { out.factors.push_back(factor(f, at)); });
    each(file, "hands", [&](const Json& h, const std::string& at) {
      out.hands.push_back(
          {text(h, "name", at), text(h, "device", at), h.contains("params") ? h["params"].dump() : ""});
    });
    each(file, "figures", [&](const Json& f, const std::string& at) {
      out.figures.push_back({text(f, "metric", at), text(f, "title", at), f.value("unit", ""),
                             text(f, "file", at), f.value("scale", 1.0)});
    });
    if (out.factors.empty() || out.factors.size() > 2)
      error("/factors", say::kNeedsFactors());
    if (out.lesson.empty() && !all_have_lessons(out)) error("/lesson", say::kNeedsText());
    if (out.hands.empty()) error("/hands", say::kNeedsHand());
  }

 private:
  std::string beside(const std::string& path) const {
    return (std::filesystem::path(path_).parent_path() / path).lexically_normal();
  }
  /// Whether the levels of one factor name lessons of their own.
  static bool all_have_lessons(const Study& study) {
    return std::any_of(study.factors.begin(), study.factors.end(), [](const StudyFactor& factor) {
      return std::all_of(factor.levels.begin(), factor.levels.end(),
                         [](const StudyLevel& level) { return !level.lesson.empty(); });
    });
  }
  void error(const std::string& pointer, const std::string& message) {
    problems_.push_back({base::Severity::kError, path_ + " #" + pointer, message});
  }
  void only(const std::string& key, const std::string& at, std::initializer_list<const char*> known) {
    for (const char* k : known)
      if (key == k) return;
    error(at + "/" + key, say::kUnknown());
  }
  std::string text(const Json& from, const char* key, const std::string& at) {
    if (from.is_object() && from.contains(key) && from[key].is_string()) return from[key];
    error(at + "/" + key, say::kNeedsText());
    return "";
  }
  uint64_t whole(const Json& from, const char* key, uint64_t usual) {
    if (!from.contains(key)) return usual;
    if (from[key].is_number_unsigned() && from[key] > 0) return from[key];
    error(std::string("/") + key, say::kNeedsNumber());
    return usual;
  }
  template <class Do>
  void each(const Json& from, const char* key, Do&& what) {
    if (!from.contains(key)) return;
    if (!from[key].is_array()) return error(std::string("/") + key, say::kNeedsList());
    for (std::size_t i = 0; i < from[key].size(); ++i)
      what(from[key][i], std::string("/") + key + "/" + std::to_string(i));
  }
  StudyFactor factor(const Json& from, const std::string& at) {
    StudyFactor out;
    out.name = text(from, "name", at);
    if (!from.is_object() || !from.contains("levels") || !from["levels"].is_array() ||
        from["levels"].empty()) {
      error(at + "/levels", say::kNeedsLevels());
      return out;
    }
    for (const Json& l : from["levels"]) {
      StudyLevel level{text(l, "name", at + "/levels"), {}, ""};
      if (l.is_object() && l.contains("lesson")) level.lesson = beside(text(l, "lesson", at + "/levels"));
      if (l.is_object() && l.contains("set"))
        for (const auto& item : l["set"].items())
          level.settings.push_back(item.key() + "=" + item.value().dump());
      out.levels.push_back(std::move(level));
    }
    return out;
  }

  std::string path_;
  base::Problems& problems_;
};

bool run_one(const Study& study, const StudyOptions& o, StudyRow& row, base::Problems& problems) {
  session::Options options;
  options.lesson_path = study.lesson;
  options.plugin_dirs = o.plugin_dirs;
  options.pull_lesson = pull_lesson();
  options.device = study.hands[row.hand].device;
  options.device_params = study.hands[row.hand].params;
  options.person = study.hands[row.hand].name;
  options.store_path = o.store;
  options.mode = "test";
  options.pace = session::Pace::kFastest;
  options.settings = o.settings;
  const std::size_t skipped = 2 - study.factors.size();
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    const StudyLevel& level = study.factors[i].levels[row.level[skipped + i]];
    if (!level.lesson.empty()) options.lesson_path = level.lesson;
    options.settings.insert(options.settings.end(), level.settings.begin(), level.settings.end());
  }
  options.settings.push_back("seed=" + std::to_string(row.seed));

  const std::unique_ptr<session::Session> session = session::Session::open(options, problems);
  if (!session || base::failed(problems)) return false;
  session->start();
  session->wait();
  const session::Result result = session->result();
  row.passed = result.outcome == judge::Outcome::kPassed;
  row.reason = result.reason;
  row.score = result.score;
  for (const auto& metric : result.metrics) row.metric[metric.id] = metric.value;
  row.metric["score"] = result.score;
  return true;
}

void print_figure(const Study& study, const StudyFigure& figure, const std::vector<StudyRow>& rows) {
  std::printf("\n%s%s\n%-28s", figure.title.c_str(),
              figure.unit.empty() ? "" : (" (" + figure.unit + ")").c_str(), "");
  for (const StudyHand& hand : study.hands) std::printf(" %30s", hand.name.c_str());
  std::printf("\n");
  const std::size_t outer = study.factors.size() > 1 ? study.factors[0].levels.size() : 1;
  const std::vector<StudyLevel>& inner = study.factors.back().levels;
  for (std::size_t a = 0; a < outer; ++a) {
    for (std::size_t b = 0; b < inner.size(); ++b) {
      const std::string before = study.factors.size() > 1 ? study.factors[0].levels[a].name + ", " : "";
      std::printf("%-28s", (before + inner[b].name).c_str());
      for (std::size_t hand = 0; hand < study.hands.size(); ++hand) {
        const Cell cell = cell_of(rows, a, b, hand, figure.metric);
        std::printf(" %8.4g [%.4g, %.4g] (%zu of %zu)", figure.scale * cell.mean, figure.scale * cell.least,
                    figure.scale * cell.most, cell.passed, cell.of);
      }
      std::printf("\n");
    }
  }
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file.good();
}

}  // namespace

bool read_study(const std::string& path, Study& out, base::Problems& problems) {
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) {
    problems.push_back({base::Severity::kError, path, why});
    return false;
  }
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded())
    problems.push_back({base::Severity::kError, path, say::kNotJson()});
  else
    Reader(path, problems).read(json, out);
  return !base::failed(problems);
}

namespace {

uint64_t count_rows(const Study& study) {
  const std::size_t outer = study.factors.size() > 1 ? study.factors[0].levels.size() : 1;
  return outer * study.factors.back().levels.size() * study.hands.size() * study.repeats;
}

StudyRow planned_row(const Study& study, uint64_t i) {
  const std::size_t inner = study.factors.back().levels.size();
  StudyRow row;
  row.seed = study.seed + i % study.repeats;
  row.hand = i / study.repeats % study.hands.size();
  row.level[1] = i / (study.repeats * study.hands.size()) % inner;
  row.level[0] = i / (study.repeats * study.hands.size() * inner);
  return row;
}

/// Runs the rows of the shard that are not done yet. False with the problems printed.
bool run_rows(const Study& study, const StudyOptions& o, const Shard& shard, const std::string& name, StudyRows& done) {
  const uint64_t all = count_rows(study);
  std::unique_ptr<RowWriter> writer;
  if (!o.out.empty()) {
    std::error_code ignored;
    std::filesystem::create_directories(o.out, ignored);
    done = read_rows(o.out, name);
    writer = std::make_unique<RowWriter>(o.out, shard, name);
  }
  for (uint64_t i = 0; i < all; ++i) {
    if (!shard.has(i) || done.count(i) > 0) continue;
    progress(format("%llu of %llu", static_cast<unsigned long long>(i + 1), static_cast<unsigned long long>(all)));
    StudyRow row = planned_row(study, i);
    base::Problems problems;
    if (!run_one(study, o, row, problems)) {
      progress("");
      return tell(problems), false;
    }
    if (writer && !writer->add(i, row)) {
      progress("");
      problem(say::kNotWritten(writer->path()));
      return false;
    }
    done[i] = std::move(row);
  }
  progress("");
  return true;
}

int show(const Study& study, const StudyOptions& o, const StudyRows& done, const std::string& name) {
  std::vector<StudyRow> rows;
  for (const auto& [number, row] : done) rows.push_back(row);
  std::printf("%s\nmean over attempts [least, greatest] (passed of all)\n", study.title.c_str());
  for (const StudyFigure& figure : study.figures) print_figure(study, figure, rows);
  if (o.out.empty()) return kPassed;
  const std::string folder = o.out + "/";
  bool written = write(folder + "attempts.csv", study_csv(study, rows));
  for (const StudyFigure& figure : study.figures)
    written = write(folder + figure.file, study_svg(study, figure, rows)) && written;
  if (!written) return problem(say::kNotWritten(o.out));
  remove_rows(o.out, name);  // the table contains all rows
  return kPassed;
}

// runs a study of reaction laws over one recorded hand
int study_laws(const StudyOptions& o) {
  if (!o.shard.empty() || o.merge || !o.settings.empty())
    return problem(say::kOneAttempt());
  base::Problems problems;
  LawsPlan plan;
  LawsResult result;
  if (!read_laws(o.file, plan, problems) || !run_laws(plan, o.plugin_dirs, result, problems)) return tell(problems), kProblem;
  tell(problems);
  std::printf("%s\n%-28s %10s %10s %10s %10s %10s %12s\n", printable(plan.title).c_str(), "", "peak N", "N s", "N/s", "silent %", "cut %", "off first N");
  for (std::size_t k = 0; k < plan.laws.size(); ++k) {
    const LawRun& run = result.laws[k];
    std::printf("%-28s %10.3f %10.4f %10.1f %10.1f %10.1f %12.4f\n", printable(plan.laws[k].name).c_str(), run.peak, run.impulse, run.steepest,
                100 * run.silent, 100 * run.cut, run.off);
  }
  if (o.out.empty()) return kPassed;
  std::error_code ignored;
  std::filesystem::create_directories(o.out, ignored);
  const std::string csv = std::filesystem::path(plan.file).stem().string() + ".csv";
  if (!write(o.out + "/" + plan.file, laws_svg(plan, result)) || !write(o.out + "/" + csv, laws_csv(plan, result)))
    return problem(say::kNotWritten(o.out));
  return kPassed;
}

}  // namespace

int study(const StudyOptions& o) {
  base::Problems problems;
  Study study;
  Shard shard;
  std::string text, why;
  if (toolkit::read_file(o.file, toolkit::kMostFileBytes, text, why) && is_laws_plan(text)) return study_laws(o);
  if (!read_study(o.file, study, problems)) return tell(problems), kProblem;
  if (!o.shard.empty() && !read_shard(o.shard, shard))
    return problem(say::kNoShard(o.shard));
  if (o.out.empty() && (o.merge || !o.shard.empty())) return problem(say::kNeedsOut());

  const std::string name = study_name(study, text, o.settings);
  StudyRows done;
  const auto count = [](uint64_t n) { return format("%llu", static_cast<unsigned long long>(n)); };
  if (o.merge) {
    done = read_rows(o.out, name);
  } else {
    if (!run_rows(study, o, shard, name, done)) return kProblem;
    if (shard.count > 1) {
      std::printf("shard %s of %s is done; --merge puts them together\n", count(shard.index).c_str(), count(shard.count).c_str());
      return kPassed;
    }
  }
  if (const uint64_t all = count_rows(study); done.size() < all)
    return problem(say::kHolds(o.out, done.size(), all));
  return show(study, o, done, name);
}

}  // namespace swage::tools
