// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/cues/cue_theme.hpp"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QPainterPath>

#include "console/cues/theme_words.hpp"
#include "console/cues/tones.hpp"

namespace swage::console {
namespace {

constexpr double kDiagonal = 0.7071;  // of a ring's radius along x and y, where a line at 45 degrees meets it

QPainterPath sign_path(QChar sign, const QRectF& r) {
  QPainterPath path;
  switch (sign.toLatin1()) {
    case 'O':
    case 'o':
      path.addEllipse(r);
      break;
    case 'N':  // the ring crossed through: not here
      path.addEllipse(r);
      path.moveTo(r.center() - QPointF(kDiagonal, kDiagonal) * 0.5 * r.width());
      path.lineTo(r.center() + QPointF(kDiagonal, kDiagonal) * 0.5 * r.width());
      break;
    case 'H':  // a stretch with a collar at either end, as a region is marked in the picture
      path.moveTo(r.left(), r.top());
      path.lineTo(r.left(), r.bottom());
      path.moveTo(r.right(), r.top());
      path.lineTo(r.right(), r.bottom());
      path.moveTo(r.left(), r.center().y());
      path.lineTo(r.right(), r.center().y());
      break;
    case 'V':
    case 'v':
      path.addPolygon(QPolygonF({r.topLeft(), r.topRight(), {r.center().x(), r.bottom()}, r.topLeft()}));
      break;
    case '^':
      path.addPolygon(QPolygonF({r.bottomLeft(), r.bottomRight(), {r.center().x(), r.top()}, r.bottomLeft()}));
      break;
    case '+':
      path.moveTo(r.center().x(), r.top());
      path.lineTo(r.center().x(), r.bottom());
      path.moveTo(r.left(), r.center().y());
      path.lineTo(r.right(), r.center().y());
      break;
    case 'x':
      path.moveTo(r.topLeft());
      path.lineTo(r.bottomRight());
      path.moveTo(r.topRight());
      path.lineTo(r.bottomLeft());
      break;
    case '-':
      path.moveTo(r.left(), r.center().y());
      path.lineTo(r.right(), r.center().y());
      break;
    case '~':
      path.moveTo(r.left(), r.center().y());
      path.cubicTo(r.left() + r.width() / 3, r.top(), r.right() - r.width() / 3, r.bottom(), r.right(),
                   r.center().y());
      break;
    case '*':
      path.moveTo(r.left(), r.center().y());
      path.lineTo(r.left() + 0.38 * r.width(), r.bottom());
      path.lineTo(r.topRight());
      break;
    case '!':
      path.moveTo(r.center().x(), r.top());
      path.lineTo(r.center().x(), r.top() + 0.62 * r.height());
      path.moveTo(r.center().x(), r.bottom() - 0.5);
      path.lineTo(r.center().x(), r.bottom());
      break;
    default:
      path.addPolygon(QPolygonF({{r.center().x(), r.top()},
                                 {r.right(), r.center().y()},
                                 {r.center().x(), r.bottom()},
                                 {r.left(), r.center().y()},
                                 {r.center().x(), r.top()}}));
  }
  return path;
}

// upper limits of a cue's force: more than half a newton on top of the scene's force would move the hand
constexpr double kMostPeak_N = 0.5, kMostFrequency_Hz = 300, kMostLength_s = 0.2;
constexpr int kMostPulses = 8;

// false when a number is missing or out of range
bool read_force(const QJsonObject& json, CueForce& out) {
  if (json.isEmpty()) return true;
  out = {json[QStringLiteral("pulses")].toInt(), json[QStringLiteral("frequency_hz")].toDouble(),
         json[QStringLiteral("peak_n")].toDouble(), json[QStringLiteral("length_s")].toDouble()};
  const auto within = [](double value, double most) { return value > 0 && value <= most; };
  return within(out.pulses, kMostPulses) && within(out.frequency_Hz, kMostFrequency_Hz) &&
         within(out.peak_N, kMostPeak_N) && within(out.length_s, kMostLength_s);
}

/// The styles that a row of a theme file describes.
struct Look {
  CueStyle style;
  QColor on_dark;  // not valid: the colour of light windows
  QString why;     // the error in its sound, force or second colour
  bool complete() const { return style.colour.isValid() && !style.shape.isEmpty(); }
};

Look read_look(const QJsonObject& row) {
  const QString text = row[QStringLiteral("text")].toString();
  Look out{{QColor(row[QStringLiteral("colour")].toString()),
            row[QStringLiteral("shape")].toString(),
            text.isEmpty() ? QString() : theme_word(text),
            row[QStringLiteral("sound")].toString(),
            {}},
           {},
           {}};
  if (!out.style.sound.isEmpty() && tone(out.style.sound).empty())
    out.why = QStringLiteral("no sound is called \"%1\"; there are: %2").arg(out.style.sound, tone_names().join(QStringLiteral("; ")));
  else if (!read_force(row[QStringLiteral("force")].toObject(), out.style.force))
    out.why = QStringLiteral("force needs pulses (1 to %1), frequency_hz (to %2), peak_n (to %3) and length_s (to %4)")
                  .arg(kMostPulses)
                  .arg(kMostFrequency_Hz)
                  .arg(kMostPeak_N)
                  .arg(kMostLength_s);
  if (!row.contains(QStringLiteral("colour_on_dark"))) return out;
  out.on_dark = QColor(row[QStringLiteral("colour_on_dark")].toString());
  if (!out.on_dark.isValid()) out.why = QStringLiteral("colour_on_dark is no colour");
  return out;
}

}  // namespace

double paint_cue_shape(QPainter& painter, const QPointF& top_left, double size, const CueStyle& style) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  double x = top_left.x();
  for (const QChar sign : style.shape) {
    const double inset = 0.16 * size;
    const QRectF r(x + inset, top_left.y() + inset, size - 2 * inset, size - 2 * inset);
    const QPainterPath path = sign_path(sign, r);
    const bool filled = sign == 'O' || sign == 'V' || sign == 'D';
    // a dark and a light outline: visible on any background
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 0.26 * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(QColor(255, 255, 255, 235), 0.18 * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(style.colour, 0.11 * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (filled) painter.setBrush(style.colour);
    painter.drawPath(path);
    x += size;
  }
  painter.restore();
  return x - top_left.x();
}

CueTheme CueTheme::load(const QString& path, QString* error) {
  const auto fail = [&](const QString& why) {
    if (error) *error = QStringLiteral("%1: %2").arg(path, why);
    return CueTheme();
  };
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return fail(file.errorString());
  QJsonParseError parse;
  const QJsonObject root = QJsonDocument::fromJson(file.readAll(), &parse).object();
  if (parse.error != QJsonParseError::NoError) return fail(parse.errorString());
  if (root[QStringLiteral("format")] != QStringLiteral("swage-cue-theme/1")) {
    return fail(QStringLiteral("not a cue theme: \"format\" must be \"swage-cue-theme/1\""));
  }
  CueTheme theme;
  theme.id_ = root[QStringLiteral("id")].toString();
  theme.title_ = theme_word(root[QStringLiteral("title")].toString());
  for (const QJsonValue value : root[QStringLiteral("cues")].toArray()) {
    const QJsonObject cue = value.toObject();
    const QString meaning = cue[QStringLiteral("meaning")].toString();
    const Look look = read_look(cue);
    if (meaning.isEmpty() || !look.complete() || look.style.text.isEmpty())
      return fail(QStringLiteral("cue \"%1\" needs meaning, colour, shape and text").arg(meaning));
    if (!look.why.isEmpty()) return fail(QStringLiteral("cue \"%1\": %2").arg(meaning, look.why));
    theme.order_.append(meaning);
    theme.styles_.insert(meaning, look.style);
    if (look.on_dark.isValid()) theme.on_dark_.insert(meaning, look.on_dark);
  }
  for (const QJsonValue value : root[QStringLiteral("roles")].toArray()) {
    const QJsonObject role = value.toObject();
    const QString name = role[QStringLiteral("role")].toString();
    const Look look = read_look(role);
    if (name.isEmpty() || !look.complete()) return fail(QStringLiteral("role \"%1\" needs role, colour and shape").arg(name));
    if (!look.why.isEmpty()) return fail(QStringLiteral("role \"%1\": %2").arg(name, look.why));
    theme.roles_.insert(name, look.style);
    if (look.on_dark.isValid()) theme.roles_on_dark_.insert(name, look.on_dark);
  }
  return theme;
}

QStringList CueTheme::stock() { return {QStringLiteral("thesis"), QStringLiteral("safe")}; }

CueTheme CueTheme::stock(const QString& id) {
  return load(QStringLiteral(":/themes/cues_%1.json").arg(stock().contains(id) ? id : stock().first()));
}

CueTheme CueTheme::on_dark() const {
  CueTheme out = *this;
  for (auto it = on_dark_.begin(); it != on_dark_.end(); ++it) out.styles_[it.key()].colour = it.value();
  for (auto it = roles_on_dark_.begin(); it != roles_on_dark_.end(); ++it) out.roles_[it.key()].colour = it.value();
  return out;
}

CueTheme CueTheme::with(const QVector<OwnCue>& cues) const {
  CueTheme out = *this;
  for (const OwnCue& cue : cues) {
    if (cue.meaning.isEmpty() || out.knows(cue.meaning)) continue;
    CueStyle style = role(cue.role);
    style.text = cue.words;
    if (!cue.heard) style.sound.clear();
    if (!cue.felt) style.force = {};
    out.order_.append(cue.meaning);
    out.styles_.insert(cue.meaning, style);
    if (const auto dark = roles_on_dark_.find(cue.role); dark != roles_on_dark_.end()) out.on_dark_.insert(cue.meaning, *dark);
  }
  return out;
}

CueStyle CueTheme::role(const QString& name) const {
  if (const auto it = roles_.find(name); it != roles_.end()) return *it;
  return {QColor(0x9a, 0xa4, 0xae), QStringLiteral("d"), {}, {}, {}};
}

CueStyle CueTheme::style(const QString& meaning) const {
  if (const auto it = styles_.find(meaning); it != styles_.end()) return *it;
  QString words = meaning;
  words.replace(QLatin1Char('.'), QLatin1Char(' ')).replace(QLatin1Char('_'), QLatin1Char(' '));
  CueStyle neutral = role({});
  neutral.text = words;
  return neutral;
}

}  // namespace swage::console
