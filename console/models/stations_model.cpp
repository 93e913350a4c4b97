// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/stations_model.hpp"

#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "console/models/words.hpp"

namespace swage::console {
namespace {

using record::StationNow;
using record::StationState;

QString silence_text(double s) {
  constexpr double kMinute_s = 60, kHour_s = 3600;
  const auto whole = [](double v) { return QString::number(static_cast<qint64>(v)); };
  if (s < kMinute_s) return QObject::tr("%1 s").arg(whole(s));
  if (s < kHour_s) return QObject::tr("%1 min").arg(whole(s / kMinute_s));
  return QObject::tr("%1 h").arg(whole(s / kHour_s));
}

bool in_attempt(const StationNow& n) { return n.state != StationState::kIdle && n.state != StationState::kClosed; }

}  // namespace

QString station_state_text(const StationNow& n) {
  if (n.lost()) return QObject::tr("▲ lost for %1").arg(silence_text(n.silent_s));
  switch (n.state) {
    case StationState::kRunning:
      return QObject::tr("● runs");
    case StationState::kPaused:
      return QObject::tr("‖ paused");
    case StationState::kFinished:
      return QObject::tr("■ finished");
    case StationState::kClosed:
      return QObject::tr("– closed");
    default:
      return QObject::tr("○ ready");
  }
}

QString station_health_text(const StationNow& n) {
  if (!in_attempt(n)) return {};
  QStringList wrong;
  const auto count = [&](uint64_t number, const QString& text) {
    if (number > 0) wrong += text.arg(QLocale().toString(static_cast<qulonglong>(number)));
  };
  count(n.stopped, QObject::tr("parts stopped: %1"));
  count(n.silent_devices, QObject::tr("devices silent: %1"));
  count(n.dropped, QObject::tr("steps lost: %1"));
  count(n.late, QObject::tr("steps late: %1"));
  count(n.solver, QObject::tr("solver short: %1"));
  if (!n.recorded) wrong += QObject::tr("not recorded");
  return wrong.isEmpty() ? QObject::tr("● in order") : QStringLiteral("▲ ") + wrong.join(QStringLiteral(", "));
}

QString sent_text(const record::StationMessage& m) {
  using Kind = record::StationMessage::Kind;
  const QString what = m.kind == Kind::kLesson ? QObject::tr("lesson “%1”").arg(said(m.title)) : qt(m.body);
  QString receipt = m.shown ? QObject::tr("● on the screen") : QObject::tr("○ sent");
  if (m.answer == "read") receipt = QObject::tr("✓ read");
  if (m.answer == "taken") receipt = QObject::tr("✓ taken");
  if (m.answer == "declined") receipt = QObject::tr("– not now");
  if (m.answer == "missing") receipt = QObject::tr("▲ that station does not have it");
  return QStringLiteral("%1   %2   %3").arg(qt(m.to), what, receipt);
}

void StationsModel::set_stations(const std::vector<StationNow>& stations, const QString& own_name) {
  const bool same = std::equal(stations.begin(), stations.end(), stations_.begin(), stations_.end(),
                               [](const StationNow& a, const StationNow& b) { return a.station == b.station; });
  own_ = own_name;
  if (!same) beginResetModel();
  stations_ = stations;
  if (!same) return endResetModel();
  if (!stations_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void StationsModel::set_cue_words(std::function<QString(const QString&)> words) {
  cue_words_ = std::move(words);
  if (!stations_.empty()) Q_EMIT dataChanged(index(0, kCues), index(rowCount() - 1, kCues));
}

int StationsModel::row_of(const QString& name) const {
  const auto at = std::find_if(stations_.begin(), stations_.end(), [&](const StationNow& n) { return qt(n.station) == name; });
  return at == stations_.end() ? -1 : static_cast<int>(at - stations_.begin());
}

int StationsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(stations_.size()); }
int StationsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QString StationsModel::text(const StationNow& n, int column) const {
  const bool attempt = in_attempt(n);
  switch (column) {
    case kStation:
      return qt(n.station) == own_ ? tr("%1 (here)").arg(own_) : qt(n.station);
    case kWho:
      return person_text(qt(n.person));
    case kLesson:
      return said(n.lesson_title);
    case kState:
      return station_state_text(n);
    case kPhase:
      return attempt ? said(n.phase) : QString();
    case kTime:
      return attempt ? clock_text(n.time_s) : QString();
    case kForce:
      return attempt && std::isfinite(n.force_N) ? quantity_text(n.force_N, QStringLiteral("N")) : QString();
    case kScore:
      return attempt && std::isfinite(n.score) ? QLocale().toString(n.score, 'f', 0) : QString();
    case kHealth:
      return station_health_text(n);
    case kCues: {
      QStringList words;
      for (const std::string& c : n.cues) words += cue_words_ ? cue_words_(qt(c)) : qt(c);
      return attempt ? words.join(QStringLiteral(", ")) : QString();
    }
    default:
      return {};
  }
}

QVariant StationsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const StationNow& n = at(index.row());
  if (role == kName) return qt(n.station);
  if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return text(n, index.column());
  const bool number = index.column() == kTime || index.column() == kForce || index.column() == kScore;
  if (role == Qt::TextAlignmentRole && number) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant StationsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString heads[] = {tr("Station"), tr("Trainee"),   tr("Lesson"), tr("State"), tr("Phase"),
                           tr("Time"),    tr("Force"), tr("Cues"),   tr("Score"), tr("Health")};
  return section >= 0 && section < kColumns ? heads[section] : QString();
}

}  // namespace swage::console
