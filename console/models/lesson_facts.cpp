// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/lesson_facts.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "assembly/lesson_file.hpp"
#include "base/quantity.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "host/params.hpp"
#include "judge/pull_rule.hpp"

namespace swage::console {

namespace {

class LessonWords {
  Q_DECLARE_TR_FUNCTIONS(lesson_facts)
};

/// The lesson plugin of a lesson file with the checked values of its parameters, defaults included.
struct Judged {
  const host::PluginInfo* plugin = nullptr;  // nullptr: the file or the plugin cannot be read
  host::ParamValues values;
  judge::PullRule pull;  // of its knot, by the program

  /// nullptr where the plugin has no such parameter.
  const host::Param* find(const std::string& id, const swage_value** value) const {
    for (size_t i = 0; plugin && i < plugin->params.size(); ++i) {
      if (plugin->params[i].id != id) continue;
      *value = &values.value[i];
      return &plugin->params[i];
    }
    return nullptr;
  }

  /// The text of a value that find() returned, for parameters with text.
  const std::string& text_of(const swage_value* value) const { return values.text[static_cast<size_t>(value - values.value.data())]; }
};

Judged read_judged(const std::string& lesson_path, const host::Catalogue& catalogue) {
  assembly::LessonFile lesson;
  base::Problems problems;
  assembly::read_lesson_file(lesson_path, lesson, problems);  // a faulty file is read as far as possible
  const host::PluginInfo* plugin = catalogue.find(lesson.lesson.plugin);
  if (!plugin) return {};

  host::ParamSource source;
  source.plugin_id = plugin->id;
  source.folder = lesson.folder();
  source.bundle_folder = plugin->bundle_dir;
  source.where = [](const std::string& pointer) { return pointer; };
  Judged out;
  if (!host::check_params(lesson.lesson.params, plugin->params, source, out.values, problems)) return {};
  out.plugin = plugin;
  out.pull = lesson.pull;
  return out;
}

// A value with its unit as people write it: 3 s, 50 %, 0.3 mm, 0.1 mN.
QString number_words(const host::Param& p, double value) {
  const std::string& unit = p.display_unit == "%" ? p.display_unit : p.unit;
  const base::Shown as = base::shown_unit(value, unit);
  const double shown = value * as.factor;
  const int digits = std::abs(shown) < 1e4 ? 4 : 15;  // four digits of a whole number beyond would be shown with an exponent
  return with_unit(QLocale().toString(shown, 'g', digits), as.unit);
}

// A text, or names of objects: each is translated by the lesson's own words.
QString text_words(const std::string& text) {
  const QString plain = QString::fromStdString(text);
  if (const QString whole = said(text); whole != plain) return whole;
  QStringList out;
  for (const QString& part : plain.split(QLatin1Char(','))) {
    const QString name = part.trimmed(), words = said(name);
    out += words != name ? words : QString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
  }
  return out.join(QStringLiteral(", "));
}

QString value_words(const host::Param& p, const swage_value& value, const std::string& text) {
  const auto number = [&](size_t i) { return number_words(p, value.number[i]); };
  switch (p.type) {
    case SWAGE_PARAM_BOOL:
      return value.number[0] != 0 ? LessonWords::tr("yes") : LessonWords::tr("no");
    case SWAGE_PARAM_CHOICE:
      return said(p.choices[static_cast<size_t>(value.number[0])]);
    case SWAGE_PARAM_TEXT:
    case SWAGE_PARAM_FILE:
      return text_words(text);
    default:
      break;
  }
  if (p.dimension == 2) return LessonWords::tr("%1 to %2").arg(number(0), number(1));
  QStringList all;
  for (uint32_t i = 0; i < std::max(1u, p.dimension); ++i) all += number(i);
  return all.join(QStringLiteral(", "));
}

bool holds(const Judged& lesson, const std::string& when) {
  if (when.empty()) return true;
  const bool not_so = when.front() == '!';
  const size_t equals = when.find('=');
  const swage_value* value = nullptr;
  const host::Param* p = lesson.find(when.substr(not_so, equals == std::string::npos ? equals : equals - not_so), &value);
  if (!p) return false;
  const bool text = p->type == SWAGE_PARAM_TEXT || p->type == SWAGE_PARAM_FILE;
  if (text) return !lesson.text_of(value).empty() != not_so;
  if (equals == std::string::npos) return (value->number[0] != 0) != not_so;
  return (p->type == SWAGE_PARAM_CHOICE && p->choices[static_cast<size_t>(value->number[0])] == when.substr(equals + 1)) != not_so;
}

/// The value of a parameter used as a limit: of an interval its `end`, 0 or 1. None where that parameter switches its criterion off, as a tilt
/// of 0 that stands for any.
std::optional<double> limit(const Judged& lesson, const std::string& id, size_t end) {
  const swage_value* value = nullptr;
  const host::Param* p = id.empty() ? nullptr : lesson.find(id, &value);
  if (!p) return {};
  for (const host::CriterionInfo& c : lesson.plugin->criteria)
    if (c.when == id && !holds(lesson, c.when)) return {};
  return value->number[p->dimension == 2 ? end : 0];
}

/// The sentence with its parameters' values filled in.
QString sentence(const Judged& lesson, const std::string& text) {
  const QString form = said(text, lesson.plugin->bundle_dir);
  QString out;
  qsizetype at = 0;
  for (qsizetype open = form.indexOf(QLatin1Char('{')); open >= 0; open = form.indexOf(QLatin1Char('{'), at)) {
    const qsizetype close = form.indexOf(QLatin1Char('}'), open);
    if (close < 0) break;
    const swage_value* value = nullptr;
    const host::Param* p = lesson.find(form.mid(open + 1, close - open - 1).toStdString(), &value);
    out += form.mid(at, open - at);
    if (p) out += value_words(*p, *value, lesson.text_of(value));
    at = close + 1;
  }
  return out + form.mid(at);
}

/// What the program's pull of the knot asks for.
QString pull_sentence(const judge::PullRule& pull) {
  const QString load = with_unit(QLocale().toString(1e3 * pull.load, 'g', 4), "mN");
  if (pull.points == 0) return LessonWords::tr("At the end the program pulls a copy of the knot, up to %1, and tells what it bears.").arg(load);
  return LessonWords::tr("At the end the program pulls a copy of the knot, up to %1: what it does not bear of that costs up to %L2 points.").arg(load).arg(pull.points);
}

const std::string kPullBears = judge::kPullMetrics[judge::kPullBears].id;

}  // namespace

std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue) {
  const Judged lesson = read_judged(lesson_path, catalogue);
  const swage_value* value = nullptr;
  const host::Param* p = lesson.find("force", &value);
  if (p && p->unit == "N" && p->dimension == 2) return ForceBand{value->number[0], value->number[1]};
  p = lesson.find("max_force", &value);
  if (p && p->unit == "N" && p->dimension <= 1) return ForceBand{0, value->number[0]};
  return {};
}

MetricTarget metric_target(const std::string& lesson_path, const std::string& metric_id,
                           const host::Catalogue& catalogue) {
  const Judged lesson = read_judged(lesson_path, catalogue);
  if (!lesson.plugin) return {};
  if (metric_id == kPullBears && lesson.pull.load > 0) return {lesson.pull.load, {}};
  for (const host::MetricInfo& m : lesson.plugin->metrics)
    if (m.id == metric_id) return {limit(lesson, m.least, 0), limit(lesson, m.most, 1)};
  return {};
}

std::map<std::string, MetricTarget> metric_targets(const std::string& lesson_path, const host::Catalogue& catalogue) {
  const Judged lesson = read_judged(lesson_path, catalogue);
  std::map<std::string, MetricTarget> out;
  if (!lesson.plugin) return out;
  for (const host::MetricInfo& m : lesson.plugin->metrics)
    if (const MetricTarget target{limit(lesson, m.least, 0), limit(lesson, m.most, 1)}; target != MetricTarget()) out[m.id] = target;
  if (lesson.pull.load > 0) out[kPullBears] = {lesson.pull.load, {}};
  return out;
}

std::vector<host::MetricInfo> lesson_metrics(const std::string& lesson_path, const host::Catalogue& catalogue) {
  const Judged lesson = read_judged(lesson_path, catalogue);
  if (!lesson.plugin) return {};
  std::vector<host::MetricInfo> all = lesson.plugin->metrics;
  if (lesson.pull.load > 0) all.insert(all.end(), host::pull_metrics().begin(), host::pull_metrics().end());
  return all;
}

Criteria read_criteria(const std::string& lesson_path, const host::Catalogue& catalogue) {
  const Judged lesson = read_judged(lesson_path, catalogue);
  Criteria out;
  if (!lesson.plugin) return out;
  for (const host::CriterionInfo& c : lesson.plugin->criteria) {
    if (!holds(lesson, c.when)) continue;
    const QString text = sentence(lesson, c.text);
    if (c.kind == SWAGE_CRITERION_PASS) out.pass += text;
    if (c.kind == SWAGE_CRITERION_LIMIT) out.limits += text;
    if (c.kind == SWAGE_CRITERION_ENDS) out.ends += text;
    if (c.kind == SWAGE_CRITERION_POINTS) out.points += text;
    if (c.kind == SWAGE_CRITERION_SHOW) out.show = true, out.pass += text;
  }
  if (lesson.pull.load > 0) out.points += pull_sentence(lesson.pull);
  const swage_value* value = nullptr;
  const host::Param* p = lesson.find("max_time", &value);
  if (p && p->unit == "s") out.max_time_s = value->number[0];
  p = lesson.find("tension", &value);
  if (p && p->unit == "N" && p->dimension <= 1) out.max_tension_N = value->number[0];
  return out;
}

}  // namespace swage::console
