// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/ratings.hpp"

#include <QDir>
#include <QFile>
#include <QLocale>
#include <QObject>

#include "console/models/metric_titles.hpp"
#include "host/rating_scales.hpp"

namespace swage::console {
namespace {

const std::vector<judge::RatingScale>& scales() {
  static const std::vector<judge::RatingScale> all = [] {
    std::vector<judge::RatingScale> read;
    const QDir folder(QStringLiteral(":/scales"));
    for (const QString& name : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
      QFile file(folder.filePath(name));
      judge::RatingScale scale;
      std::string error;
      if (file.open(QIODevice::ReadOnly) && host::read_rating_scale(file.readAll().toStdString(), scale, error))
        read.push_back(std::move(scale));
      else
        qWarning("%s: %s", qPrintable(name), error.c_str());
    }
    std::vector<std::string> errors;
    host::add_own_scales(read, errors);
    for (const std::string& error : errors) qWarning("%s", error.c_str());
    return read;
  }();
  return all;
}

QString in_words(const judge::Words& words) {
  return QString::fromStdString(judge::said_in(words, QLocale().name().section(QLatin1Char('_'), 0, 0).toStdString()));
}

QString points_text(double points, const judge::RatingScale& scale) {
  return QObject::tr("%L1 of %L2").arg(points, 0, 'f', 1).arg(scale.highest, 0, 'f', 0);
}

QString decided_by(const judge::RatingItem& item) {
  QStringList names;
  if (item.by.empty()) return QObject::tr("No metric decides it: it is left to an observer.");
  for (const judge::RatedBy& by : item.by) names += metric_title(QString::fromStdString(by.metric));
  return QObject::tr("Decided by what was measured of: %1.").arg(names.join(QStringLiteral(", ")));
}

RatingLine line(const judge::RatingScale& scale, double points) {
  RatingLine out;
  out.points = points;
  out.lowest = scale.lowest;
  out.highest = scale.highest;
  out.value = points_text(points, scale);
  return out;
}

}  // namespace

QVector<RatingLine> rating_lines(const std::string& outcome, judge::Metrics metrics) {
  QVector<RatingLine> out;
  if (outcome != "passed" && outcome != "failed") return out;
  for (const judge::RatingScale& scale : scales()) {
    const judge::Rating rating = judge::rate(scale, metrics, outcome == "passed");
    if (rating.decided == 0) continue;
    RatingLine mean = line(scale, rating.mean);
    mean.id = scale.id;
    mean.mean = true;
    const QString of = outcome == "passed" ? QObject::tr("%1, computed (%2 of %3 items)")
                                           : QObject::tr("%1, computed of a failed attempt (%2 of %3 items)");
    mean.name = of.arg(in_words(scale.title)).arg(rating.decided).arg(scale.items.size());
    mean.doc = QObject::tr("Computed from metrics; %1 of %2 items. Items not decided by the program are not counted. Source: %3")
                   .arg(rating.decided)
                   .arg(scale.items.size())
                   .arg(in_words(scale.source));
    out += mean;
    for (size_t i = 0; i < scale.items.size(); ++i) {
      if (!rating.item[i]) continue;
      RatingLine one = line(scale, *rating.item[i]);
      one.id = scale.id + "." + scale.items[i].id;
      one.name = QObject::tr("%1: %2").arg(in_words(scale.title), in_words(scale.items[i].title));
      one.doc = decided_by(scale.items[i]);
      out += one;
    }
  }
  return out;
}

QString RatedScale::points_words(double points) const {
  return QObject::tr("%L1 of %L2").arg(points, 0, 'f', 1).arg(highest, 0, 'f', 0);
}

QString RatedScale::computed_words() const {
  if (decided == 0) return QObject::tr("The metrics of this attempt decide no item.");
  const QString words = QObject::tr("Computed from metrics: %1, the mean of %2 of %3 items; items not decided by the program are not counted.");
  const QString not_passed =
      QObject::tr("Not passed, and no mark of the whole: what a failed attempt lost is not counted in points. Computed from metrics: %1, "
                  "the mean of %2 of %3 items.");
  return (failed ? not_passed : words)
      .arg(points_words(computed_mean))
      .arg(decided)
      .arg(items.size());
}

QString RatedScale::given_words() const {
  if (given == 0) return {};
  return QObject::tr("Instructor's rating: %1, the mean of %2 of %3 items.").arg(points_words(given_mean)).arg(given).arg(items.size());
}

QVector<RatedScale> rated_scales(const std::string& outcome, judge::Metrics metrics, const std::vector<std::pair<std::string, double>>& given) {
  QVector<RatedScale> out;
  const bool ended = outcome == "passed" || outcome == "failed";
  for (const judge::RatingScale& scale : scales()) {
    const judge::Rating rating = ended ? judge::rate(scale, metrics, outcome == "passed") : judge::Rating{};
    RatedScale one;
    one.id = scale.id;
    one.title = in_words(scale.title);
    one.source = in_words(scale.source);
    one.lowest = scale.lowest;
    one.highest = scale.highest;
    one.failed = outcome == "failed";
    one.decided = static_cast<int>(rating.decided);
    one.computed_mean = rating.mean;
    for (size_t i = 0; i < scale.items.size(); ++i) {
      RatedItem item;
      item.id = scale.id + "." + scale.items[i].id;
      item.title = in_words(scale.items[i].title);
      item.doc = decided_by(scale.items[i]);
      if (i < rating.item.size()) item.computed = rating.item[i];
      for (const auto& [id, points] : given)
        if (id == item.id) item.given = points;
      if (item.given) ++one.given, one.given_mean += *item.given;
      one.items += item;
    }
    if (one.given > 0) one.given_mean /= one.given;
    out += one;
  }
  return out;
}

}  // namespace swage::console
