// SPDX-License-Identifier: Apache-2.0
//
// Tables and chart of an audit.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tools/audit.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/svg.hpp"

namespace swage::tools {
namespace {

using svg::escape;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}
std::string plain(double value) { return std::isfinite(value) ? format("%.9g", value) : ""; }

/// Remark on a ladder, beside the table of its levels.
std::string remark(const AuditLadder& ladder) {
  std::string out;
  const AuditLevel& own = ladder.level[ladder.own];
  if (!own.enough) out = say::kOwnNotEnough(own.why);
  for (std::size_t i = 0; i < ladder.chosen; ++i)
    if (ladder.level[i].enough)
      out += (out.empty() ? "" : "; ") +
             say::kWouldDo(ladder.level[i].run.level,
                           format("%.0f", 100 * (ladder.level[i].run.cpu_s / ladder.level[ladder.chosen].run.cpu_s - 1)));
  for (std::size_t i = ladder.reference + 1; i < ladder.level.size(); ++i)
    out += (out.empty() ? "" : "; ") + ladder.level[i].run.level + ": " + ladder.level[i].run.problem;
  return out;
}

std::string levels_in_short(const AuditLadder& ladder) {
  std::string out;
  for (const AuditLevel& level : ladder.level) {
    if (!level.run.problem.empty()) continue;
    out += (out.empty() ? "" : ", ") + level.run.level + format(" %.0f", 1e6 * level.run.cpu_s);
    if (!level.enough) out += std::isinf(level.worst) ? " (another verdict)" : format(" (%.1f)", level.worst);
  }
  return out;
}

/// One level of a model, over all lessons that have the model.
struct ModelRow {
  std::string model, level;
  std::size_t played = 0, enough = 0, own = 0;
  std::vector<double> cost = {};  // cost of a step over that at the finest level, one per lesson
  double worst = 0;               // the largest difference
  std::string where = "", why = "";  // of the largest difference: lesson, reason
};

/// "swage.object.needle" -> "needle.level", whatever name the lesson gives it; a ladder of the engine keeps its name.
std::string model_of(const AuditLadder& ladder) {
  if (ladder.plugin.empty()) return ladder.name;
  return ladder.plugin.substr(ladder.plugin.rfind('.') + 1) + ladder.name.substr(ladder.name.rfind('.'));
}

/// "twice (96)" -> "twice"
std::string kind_of_level(const std::string& level) { return level.substr(0, level.find(" (")); }

ModelRow& row_of(std::vector<ModelRow>& rows, const std::string& model, const std::string& level) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const ModelRow& r) { return r.model == model && r.level == level; });
  return found != rows.end() ? *found : rows.emplace_back(ModelRow{model, level});
}

std::vector<ModelRow> model_rows(const std::vector<AuditLesson>& lessons) {
  std::vector<ModelRow> rows;
  for (const AuditLesson& lesson : lessons)
    for (const AuditLadder& ladder : lesson.ladder)
      for (std::size_t i = 0; i < ladder.level.size(); ++i) {
        const AuditLevel& level = ladder.level[i];
        ModelRow& row = row_of(rows, model_of(ladder), kind_of_level(level.run.level));
        row.own += i == ladder.own;
        if (!level.run.problem.empty()) continue;
        ++row.played;
        row.enough += level.enough;
        row.cost.push_back(level.run.cpu_s / ladder.level[ladder.reference].run.cpu_s);
        if (level.worst > row.worst) row.worst = level.worst, row.where = lesson.title, row.why = level.why;
      }
  std::stable_sort(rows.begin(), rows.end(), [](const ModelRow& a, const ModelRow& b) { return a.model < b.model; });
  return rows;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

void model_table(const std::vector<AuditLesson>& lessons, std::ostringstream& o) {
  o << "## Models\n\nCost: processor time of a step over that with the finest level of the same lesson, the median of the lessons. "
       "Error: the largest difference in any lesson; one of 1 is as much as counts as equal.\n\n"
    << "| model | level | lessons that have it | played | enough in | cost | largest error | |\n"
       "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  std::string last;
  for (const ModelRow& row : model_rows(lessons)) {
    o << "| " << (row.model == last ? "" : row.model) << " | " << row.level << " | " << row.own << " | " << row.played << " | "
      << row.enough << " | " << (row.cost.empty() ? "-" : format("%.2f", median(row.cost))) << " | "
      << (std::isinf(row.worst) ? "another verdict" : format("%.2f", row.worst)) << " | "
      << (row.worst > 1 ? row.where + ": " + row.why : "") << " |\n";
    last = row.model;
  }
  o << "\n## Lessons\n\n";
}

void lesson_table(const AuditLesson& lesson, std::ostringstream& o) {
  o << "\n## " << lesson.title << " (`" << lesson.id << "`)\n\n"
    << "| ladder | level | verdict | score | us a step | difference | largest |\n| --- | --- | --- | --- | "
       "--- | --- "
       "| --- |\n";
  for (const AuditLadder& ladder : lesson.ladder)
    for (std::size_t i = 0; i < ladder.level.size(); ++i) {
      const AuditLevel& level = ladder.level[i];
      o << "| " << (i == 0 ? ladder.name : "") << " | " << level.run.level
        << (i == ladder.own ? " (the lesson's)" : "") << (i == ladder.chosen ? ", **enough**" : "");
      if (!level.run.problem.empty()) {
        o << " | not played | | | | " << level.run.problem << " |\n";
        continue;
      }
      o << " | " << level.run.outcome << (level.run.reason.empty() ? "" : " (" + level.run.reason + ")")
        << format(" | %.1f | %.1f | ", level.run.score, 1e6 * level.run.cpu_s);
      if (i == ladder.reference)
        o << "reference | |\n";
      else
        o << (std::isinf(level.worst) ? "-" : format("%.2f", level.worst)) << " | " << level.why
          << (level.untold.empty() ? "" : "; cannot tell " + level.untold.front()) << " |\n";
    }
}

constexpr double kWidth = 430, kHeight = 310, kLeft = 56, kRight = 20, kTop = 76, kBottom = 44;
constexpr std::size_t kColumns = 3;
constexpr double kLeast = 0.01, kMost = 100;  // range of differences; those beyond it are drawn on the frame

class Chart {
 public:
  explicit Chart(const std::vector<AuditLesson>& lessons) : lessons_(lessons) {
    for (const AuditLesson& lesson : lessons)
      for (const AuditLadder& ladder : lesson.ladder)
        for (const AuditLevel& level : ladder.level) {
          if (!level.run.problem.empty()) continue;
          cheapest_ = std::min(cheapest_, 1e6 * level.run.cpu_s);
          dearest_ = std::max(dearest_, 1e6 * level.run.cpu_s);
        }
    cheapest_ = std::pow(10, std::floor(std::log10(std::max(0.1, std::min(cheapest_, dearest_)))));
    dearest_ = std::pow(10, std::ceil(std::log10(std::max(10 * cheapest_, dearest_))));
  }

  std::string draw() {
    const std::size_t rows = (lessons_.size() + kColumns - 1) / kColumns;
    o_ << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 "
       << kWidth * static_cast<double>(std::min(kColumns, lessons_.size())) << ' '
       << 58 + kHeight * static_cast<double>(rows)
       << "' font-family='DejaVu Sans, Arial, sans-serif' font-size='11' fill='#222'>\n<rect width='100%' "
          "height='100%' fill='white'/>\n";
    text(16, 24, "Levels of detail: difference from the finest level against cost",
         "font-size='17' font-weight='bold'");
    text(
        16, 43,
        "Below the line a level is enough. Ringed: what the lesson has. On the upper frame: another verdict.",
        "fill='#666'");
    for (std::size_t i = 0; i < lessons_.size(); ++i) {
      o_ << format("<g transform='translate(%.0f %.0f)'>\n", kWidth * static_cast<double>(i % kColumns),
                   58 + kHeight * static_cast<double>(i / kColumns));
      panel(lessons_[i]);
      o_ << "</g>\n";
    }
    o_ << "</svg>\n";
    return o_.str();
  }

 private:
  struct Spot {
    double x, y;
  };

  double x(double us) const {
    return kLeft + std::log(us / cheapest_) / std::log(dearest_ / cheapest_) * (kWidth - kLeft - kRight);
  }
  static double y(double difference) {
    const double d = std::clamp(difference, kLeast, kMost);
    return kHeight - kBottom - std::log(d / kLeast) / std::log(kMost / kLeast) * (kHeight - kTop - kBottom);
  }
  void text(double x, double y, const std::string& s, const std::string& extra) {
    o_ << format("<text x='%.1f' y='%.1f' ", x, y) << extra << ">" << escape(s) << "</text>\n";
  }

  // ladders of one plugin have the same style in every panel
  std::size_t kind_of(const AuditLadder& ladder) {
    const std::string& kind = ladder.plugin.empty() ? ladder.name : ladder.plugin;
    const auto found = std::find(kinds_.begin(), kinds_.end(), kind);
    if (found == kinds_.end()) return kinds_.push_back(kind), kinds_.size() - 1;
    return static_cast<std::size_t>(found - kinds_.begin());
  }

  void panel(const AuditLesson& lesson) {
    placed_.clear();
    text(kLeft, 20, lesson.title, "font-size='13' font-weight='bold'");
    frame();
    double at = kLeft;
    for (std::size_t i = 0; i < lesson.ladder.size(); ++i) {
      const std::string& name = lesson.ladder[i].name;
      if (i == 3) at = kLeft;
      const double line = i < 3 ? 38 : 54;
      const std::size_t kind = kind_of(lesson.ladder[i]);
      o_ << format("<path transform='translate(%.1f %.1f) scale(0.7)' d='%s' fill='%s'/>\n", at + 4, line - 4,
                   svg::style(kind).path, svg::style(kind).colour);
      text(at + 12, line, name, "");
      at += 26 + 6.4 * static_cast<double>(name.size());
      ladder(lesson.ladder[i], kind);
    }
  }

  void frame() {
    for (double d = kLeast; d <= kMost * 1.001; d *= 10) {
      o_ << format("<path d='M%.1f %.1fH%.1f' stroke='%s'/>\n", kLeft, y(d), kWidth - kRight,
                   std::abs(d - 1) < 0.1 ? "#d33" : "#e3e3e3");
      text(kLeft - 6, y(d) + 4, format("%.3g", d), "text-anchor='end'");
    }
    for (double us = cheapest_; us <= dearest_ * 1.001; us *= 10) {
      o_ << format("<path d='M%.1f %.1fV%.1f' stroke='#e3e3e3'/>\n", x(us), kTop, kHeight - kBottom);
      text(x(us), kHeight - kBottom + 15, format("%.5g", us), "text-anchor='middle'");
    }
    text(0.5 * (kLeft + kWidth - kRight), kHeight - 12, "us a step (1000 us is real time)",
         "text-anchor='middle' fill='#666'");
    o_ << format("<g transform='translate(14 %.1f) rotate(-90)'>", 0.5 * (kTop + kHeight - kBottom));
    text(0, 0, "difference / tolerance", "text-anchor='middle' fill='#666'");
    o_ << "</g>\n";
  }

  void ladder(const AuditLadder& ladder, std::size_t style) {
    std::string path;
    for (const AuditLevel& level : ladder.level)
      if (level.run.problem.empty())
        path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x(1e6 * level.run.cpu_s), y(level.worst));
    o_ << format("<path d='%s' fill='none' stroke='%s' stroke-opacity='0.45'/>\n", path.c_str(),
                 svg::style(style).colour);
    for (std::size_t i = 0; i < ladder.level.size(); ++i) {
      const AuditLevel& level = ladder.level[i];
      if (!level.run.problem.empty()) continue;
      const Spot at{x(1e6 * level.run.cpu_s), y(level.worst)};
      o_ << format(
          "<path transform='translate(%.1f %.1f) scale(0.8)' d='%s' fill='%s' fill-opacity='0.8'/>\n", at.x,
          at.y, svg::style(style).path, svg::style(style).colour);
      if (i == ladder.own)
        o_ << format("<circle cx='%.1f' cy='%.1f' r='8' fill='none' stroke='%s'/>\n", at.x, at.y,
                     svg::style(style).colour);
      if (!ladder.plugin.empty()) label(at, level.run.level, svg::style(style).colour);
    }
  }

  // writes a name beside its point, moved up until it hides no other
  void label(Spot at, const std::string& name, const char* colour) {
    const double wide = 6.2 * static_cast<double>(name.size());
    const bool left = at.x + 10 + wide > kWidth - kRight;
    Spot to{left ? at.x - 10 : at.x + 10, at.y - 3};
    const auto taken = [&](const Spot& s) {
      return std::abs(s.x - to.x) < wide && std::abs(s.y - to.y) < 11;
    };
    while (std::any_of(placed_.begin(), placed_.end(), taken)) to.y -= 11;
    placed_.push_back(to);
    text(to.x, to.y, name, std::string(left ? "text-anchor='end' " : "") + "fill='" + colour + "'");
  }

  const std::vector<AuditLesson>& lessons_;
  double cheapest_ = 1e9, dearest_ = 0;  // us
  std::vector<Spot> placed_;
  std::vector<std::string> kinds_;  // plugins and engine's ladders, in the order of their styles
  std::ostringstream o_ = plain_stream();
};

}  // namespace

std::string audit_csv(const std::vector<AuditLesson>& lessons) {
  std::string out =
      "lesson,hand,ladder,level,of_the_lesson,reference,enough,chosen,outcome,reason,score,us_per_step,"
      "simulated_s,"
      "difference,largest,cannot_tell,problem\n";
  for (const AuditLesson& lesson : lessons)
    for (const AuditLadder& ladder : lesson.ladder)
      for (std::size_t i = 0; i < ladder.level.size(); ++i) {
        const AuditLevel& level = ladder.level[i];
        const AuditRun& run = level.run;
        std::string untold;
        for (const std::string& id : level.untold) untold += (untold.empty() ? "" : " ") + id;
        out += lesson.id + "," + lesson.device + "," + ladder.name + "," + run.level +
               format(",%d,%d,%d,%d,", i == ladder.own, i == ladder.reference, level.enough,
                      i == ladder.chosen) +
               run.outcome + "," + run.reason +
               format(",%.6g,%.4g,%.6g,", run.score, 1e6 * run.cpu_s, run.simulated_s) + plain(level.worst) +
               "," + quoted(level.why) + "," + untold + "," + quoted(run.problem) + "\n";
      }
  return out;
}

std::string audit_metrics_csv(const std::vector<AuditLesson>& lessons) {
  std::string out = "lesson,ladder,level,metric,unit,value,reference,allowed,difference\n";
  for (const AuditLesson& lesson : lessons)
    for (const AuditLadder& ladder : lesson.ladder)
      for (const AuditLevel& level : ladder.level)
        for (const AuditDifference& d : level.difference)
          out += lesson.id + "," + ladder.name + "," + level.run.level + "," + d.id + "," + d.unit + "," +
                 plain(d.value) + "," + plain(d.reference) + "," + plain(d.allowed) + "," + plain(d.size()) +
                 "\n";
  return out;
}

std::string audit_markdown(const std::vector<AuditLesson>& lessons, const AuditRule& rule) {
  std::ostringstream o = plain_stream();
  o << "# Which level of detail is enough\n\n"
    << format(
           "Each lesson played by its scripted %s at every level, one ladder at a time. A difference is the "
           "change of a "
           "metric over what counts as equal: %.3g %% of it, at least 20 um, 0.02 rad, 0.02 N, 0.1 s, (20 "
           "um)^2, 2 mN s, "
           "else 0.02; score and points lost 5 points. ",
           lessons.empty() ? "" : lessons.front().device.c_str(), 100 * rule.tolerance)
    << "A level is enough when its verdict is that of the finest that could be played and no difference "
       "exceeds 1. Named is the simplest of those that are enough and cost the least, to 10 %. "
       "Costs are processor time of a step; those of one lesson were measured in one run.\n\n";
  model_table(lessons, o);
  o << "| lesson | ladder | it has | enough | saves | us a step (differences above 1) | |\n"
       "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const AuditLesson& lesson : lessons)
    for (const AuditLadder& ladder : lesson.ladder)
      o << "| " << (&ladder == &lesson.ladder.front() ? lesson.title : "") << " | " << ladder.name << " | "
        << ladder.level[ladder.own].run.level << " | " << ladder.level[ladder.chosen].run.level << " | "
        << (ladder.saves == 0 ? "-"
                              : format("%.0f %% of %s", 100 * ladder.saves,
                                       ladder.level[ladder.reference].run.level.c_str()))
        << " | " << levels_in_short(ladder) << " | " << remark(ladder) << " |\n";
  for (const AuditLesson& lesson : lessons) lesson_table(lesson, o);
  return o.str();
}

std::string audit_svg(const std::vector<AuditLesson>& lessons) { return Chart(lessons).draw(); }

}  // namespace swage::tools
