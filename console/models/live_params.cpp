// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/live_params.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "assembly/lesson_file.hpp"
#include "console/models/environment_params.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostLeastWords = 28;  // letters that a field has room for; longer words are left to the tooltip

struct Use {
  std::string name, plugin;
  std::string params;  // JSON object
};

assembly::LessonFile read(const std::string& path) {
  assembly::LessonFile lesson;
  base::Problems ignored;  // these problems are reported when the lesson is opened; `lesson` has what could be read of a faulty one
  assembly::read_lesson_file(path, lesson, ignored);
  return lesson;
}

std::vector<Use> objects_of(const assembly::LessonFile& lesson) {
  std::vector<Use> out;
  for (const assembly::LessonObject& o : lesson.objects) out.push_back({o.name, o.plugin, o.params});
  return out;
}

// The lesson comes first: its criteria are changed more often than the shape of a jaw.
std::vector<Use> uses(const assembly::LessonFile& lesson, const std::vector<Use>& objects) {
  std::vector<Use> out;
  out.push_back({"lesson", lesson.lesson.plugin, lesson.lesson.params});
  out.insert(out.end(), objects.begin(), objects.end());
  for (const assembly::LessonCoupling& c : lesson.couplings) out.push_back({c.name, c.plugin, c.params});
  return out;
}

// The value of "3/8"; no value for other words, and none for a division by zero.
std::optional<double> fraction(const std::string& words) {
  static const QRegularExpression form(QStringLiteral("^(\\d+)/(\\d+)$"));
  const QRegularExpressionMatch m = form.match(QString::fromStdString(words));
  if (!m.hasMatch() || m.captured(2).toInt() == 0) return std::nullopt;
  return m.captured(1).toDouble() / m.captured(2).toDouble();
}

double nice(double value) {
  if (!(value > 0)) return 1;
  const double ten = std::pow(10, std::floor(std::log10(value)));
  const double m = value / ten;
  return (m < 1.5 ? 1 : m < 3.5 ? 2 : m < 7.5 ? 5 : 10) * ten;
}

}  // namespace

// the table's own formatting of a value knows the display unit
double LiveParam::factor() const {
  if (param.type == SWAGE_PARAM_BOOL || param.type == SWAGE_PARAM_CHOICE) return 1;
  host::Param one = param;
  one.type = SWAGE_PARAM_REAL;
  one.dimension = 1;
  swage_value value{};
  value.number[0] = 1;
  const Json said = Json::parse(host::value_text(one, value), nullptr, false);
  if (said.is_number()) return said.get<double>();
  if (!said.is_string()) return 1;
  const double shown =
      QString::fromStdString(said.get<std::string>()).section(QLatin1Char(' '), 0, 0).toDouble();
  return shown > 0 ? shown : 1;
}

QString LiveParam::unit() const {
  return unit_text(param.display_unit.empty() ? param.unit : param.display_unit);
}

double LiveParam::step() const {
  if (param.type == SWAGE_PARAM_INTEGER) return 1;
  const double range = (param.max - param.min) * factor() / 100, value = std::abs(start[0]) * factor() / 20;
  const bool wide = !(range > 0) || range > value;
  return nice(wide && value > 0 ? value : range);
}

int LiveParam::decimals() const {
  if (param.type == SWAGE_PARAM_INTEGER) return 0;
  return std::clamp(static_cast<int>(std::ceil(1 - std::log10(step()))), 0, 6);
}

QString LiveParam::least_text() const {
  if (!least_words.empty()) return said(least_words, folder);
  // "0: never." or "0 for none." of a parameter from 0 on; "Below 0: as the suture says." of one from a negative value on
  static const QRegularExpression form(QStringLiteral("(?:^|[.;] )(\\p{L}+ )?0(?:: | for | für )([^.;]+)"));
  const QRegularExpressionMatch m = form.match(said(param.doc, folder));
  const bool least_is_meant = param.min == 0 || (param.min < 0 && m.hasCaptured(1) && !m.captured(1).isEmpty());
  if (!m.hasMatch() || !least_is_meant || param.type == SWAGE_PARAM_VECTOR) return {};
  return m.captured(2).size() <= kMostLeastWords ? m.captured(2) : QString();
}

bool LiveParam::is_range() const {
  return param.type == SWAGE_PARAM_VECTOR && param.dimension == 2 && (param.flags & SWAGE_PARAM_INTERVAL) != 0;
}

bool LiveParam::is_size() const { return param.type == SWAGE_PARAM_VECTOR && param.dimension == 2 && !is_range(); }

QVector<LiveParam::Entry> LiveParam::entries() const {
  QVector<Entry> out;
  std::vector<std::optional<double>> values;  // of the entries that are fractions
  for (size_t i = 0; i < param.choices.size(); ++i) {
    const std::optional<double> value = fraction(param.choices[i]);
    const auto same = value ? std::find(values.begin(), values.end(), value) : values.end();
    if (same != values.end()) {
      Entry& entry = out[same - values.begin()];
      entry.words += QStringLiteral(" = %1").arg(said(param.choices[i], folder));
      entry.choices += static_cast<int>(i);
      continue;
    }
    values.push_back(value);
    out += {said(param.choices[i], folder), {static_cast<int>(i)}};
  }
  return out;
}

std::string LiveParam::json(const std::array<double, 4>& v) const {
  swage_value value{};
  std::copy(v.begin(), v.end(), value.number);
  return "{" + Json(param.id).dump() + ": " + host::value_text(param, value) + "}";
}

namespace {

// the parameters that the lesson gives to an object or device of the session; a device chosen otherwise gets none of another's
std::string params_of(const assembly::LessonFile& lesson, const std::string& name, const std::string& plugin) {
  for (const assembly::LessonObject& o : lesson.objects)
    if (o.name == name && o.plugin == plugin) return o.params;
  for (const assembly::LessonDevice& d : lesson.devices)
    for (const assembly::DeviceChoice& choice : d.choices)
      if (d.name == name && choice.plugin == plugin) return choice.params;
  return "{}";
}

template <class Part>
std::vector<Use> in_session(const assembly::LessonFile& lesson, const std::vector<Part>& parts) {
  std::vector<Use> out;
  for (const Part& p : parts) out.push_back({p.name, p.plugin, params_of(lesson, p.name, p.plugin)});
  return out;
}

template <class Wanted>
QVector<LiveParam> collect(const assembly::LessonFile& lesson, const std::vector<Use>& uses, const host::Catalogue& catalogue, Wanted wanted) {
  QVector<LiveParam> out;
  for (const Use& use : uses) {
    const host::PluginInfo* plugin = catalogue.find(use.plugin);
    if (!plugin) continue;
    host::ParamSource source;
    source.plugin_id = plugin->id;
    source.folder = lesson.folder();
    source.bundle_folder = plugin->bundle_dir;
    source.where = [](const std::string& pointer) { return pointer; };
    host::ParamValues values;
    base::Problems problems;
    if (!host::check_params(use.params, plugin->params, source, values, problems))
      values = host::default_values(plugin->params, plugin->bundle_dir);
    for (size_t i = 0; i < plugin->params.size(); ++i) {
      const host::Param& p = plugin->params[i];
      if (p.type == SWAGE_PARAM_TEXT || p.type == SWAGE_PARAM_FILE || !wanted(p)) continue;
      LiveParam live{use.name, p, {}, plugin->bundle_dir};
      std::copy_n(values.value[i].number, 4, live.start.begin());
      out.append(live);
    }
  }
  return out;
}

}  // namespace

QVector<LiveParam> live_params(const std::string& lesson_path, const snapshot::SceneCard& card,
                               const host::Catalogue& catalogue) {
  const assembly::LessonFile lesson = read(lesson_path);
  std::vector<Use> all = uses(lesson, in_session(lesson, card.objects));
  for (const Use& device : in_session(lesson, card.devices)) all.push_back(device);
  return collect(lesson, all, catalogue, [](const host::Param& p) { return p.live() && !p.hidden(); });
}

QVector<LiveParam> lesson_params(const std::string& lesson_path, const host::Catalogue& catalogue) {
  const assembly::LessonFile lesson = read(lesson_path);
  const QVector<LiveParam> out = collect(lesson, uses(lesson, objects_of(lesson)), catalogue, [](const host::Param&) { return true; });
  // after the lesson's criteria, as the environment is a property of the lesson
  const auto objects = std::find_if(out.begin(), out.end(), [](const LiveParam& p) { return p.instance != "lesson"; });
  const auto lessons = objects - out.begin();
  return out.first(lessons) + environment_params(lesson.environment_text) + out.sliced(lessons);
}

}  // namespace swage::console
