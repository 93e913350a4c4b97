// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Maps meanings to display, text and sound. Lessons name meanings ("grasp.good"); a theme gives each
// a colour, a shape, a text and a sound, so that no state is told by colour alone.
#pragma once

#include <QColor>
#include <QHash>
#include <QString>
#include <QStringList>
#include <QVector>

class QPainter;
class QPointF;

namespace swage::console {

/// Force cue: a few short pulses on top of the scene's force. Defined here, rendered by force-feedback devices through
/// the session's force limiter.
struct CueForce {
  int pulses = 0;                                     // 0: no force
  double frequency_Hz = 0, peak_N = 0, length_s = 0;  // of one pulse; the pause between two is as long
};

/// The style of one meaning. `shape` is a row of signs: O o filled and hollow circle, V v ^ triangle, D d
/// diamond, N ring crossed through, H marked stretch, + x crosses, * tick, ! warning, ~ bend, - dash. `sound` is a name of tones.hpp or "".
struct CueStyle {
  QColor colour;
  QString shape, text, sound;
  CueForce force;
};

/// A cue of a lesson plugin. A theme without this meaning shows the cue by its role.
struct OwnCue {
  QString meaning, words;
  QString role;                    // "good", "warning", "bad", "target"; "" is neutral
  bool heard = true, felt = true;  // whether the cue may have sound and force
};

class CueTheme {
 public:
  /// Reads a theme file ("swage-cue-theme/1"). On failure returns an empty theme, with the reason in `error`.
  static CueTheme load(const QString& path, QString* error = nullptr);
  /// Names of the themes that come with the program: "thesis", "safe".
  static QStringList stock();
  static CueTheme stock(const QString& id);

  const QString& id() const { return id_; }
  const QString& title() const { return title_; }
  /// This theme plus a style for each cue that it does not have: colour, shape, sound and force of the cue's role, the cue's text.
  /// Of two cues with one meaning the first is used.
  CueTheme with(const QVector<OwnCue>& cues) const;
  /// The style of a role, without text; "" and unknown roles are neutral.
  CueStyle role(const QString& name) const;
  QStringList roles() const { return roles_.keys(); }
  /// The style of a meaning; an unknown one has a neutral diamond and its own name as the text.
  CueStyle style(const QString& meaning) const;
  /// The theme for a dark window: colours with too little contrast there are replaced ("colour_on_dark").
  CueTheme on_dark() const;
  bool knows(const QString& meaning) const { return styles_.contains(meaning); }
  const QStringList& meanings() const { return order_; }

 private:
  QString id_, title_;
  QStringList order_;
  QHash<QString, CueStyle> styles_;
  QHash<QString, QColor> on_dark_;  // of meanings with another colour on dark windows
  QHash<QString, CueStyle> roles_;
  QHash<QString, QColor> roles_on_dark_;
};

/// Draws the row of signs of a cue, one square of `size` px each, including a light outline. Returns the width
/// used.
double paint_cue_shape(QPainter& painter, const QPointF& top_left, double size, const CueStyle& style);

}  // namespace swage::console
