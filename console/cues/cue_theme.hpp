// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From meanings to what is seen, read and heard. Lessons speak in meanings ("grasp.good"); a theme gives each
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

/// What a hand is to feel: a few short pulses on top of the scene's force. Mapped here, played by devices that have forces
/// through the session's guard.
struct CueForce {
  int pulses = 0;                                     // 0: nothing
  double frequency_Hz = 0, peak_N = 0, length_s = 0;  // of one pulse; the pause between two is as long
};

/// The look of one meaning. `shape` is a row of signs: O o filled and hollow circle, V v triangle, D d
/// diamond, + x crosses, * tick, ! warning, ~ bend, - dash. `sound` is a name of tones.hpp or "".
struct CueStyle {
  QColor colour;
  QString shape, text, sound;
  CueForce force;
};

/// A cue of a lesson plugin. A theme that does not know the meaning shows it by its role.
struct OwnCue {
  QString meaning, words;
  QString role;                    // "good", "warning", "bad", "target"; "" is neutral
  bool heard = true, felt = true;  // whether sound and force suit it
};

class CueTheme {
 public:
  /// Reads a theme file ("swage-cue-theme/1"). On failure an empty theme, and why in `error`.
  static CueTheme load(const QString& path, QString* error = nullptr);
  /// The themes that come with the program: "thesis", "safe".
  static QStringList stock();
  static CueTheme stock(const QString& id);

  const QString& id() const { return id_; }
  const QString& title() const { return title_; }
  /// The same theme with a style for each cue that it does not know: colour, shape, sound and force of its role, its own words.
  /// Of two cues of one meaning the first stays.
  CueTheme with(const QVector<OwnCue>& cues) const;
  /// The look of a role, without words; that of "" and of an unknown role is neutral.
  CueStyle role(const QString& name) const;
  QStringList roles() const { return roles_.keys(); }
  /// Every meaning has a style: unknown ones get a neutral diamond and their own name as the text.
  CueStyle style(const QString& meaning) const;
  /// The same theme for a dark window: colours that a dark background would swallow are replaced ("colour_on_dark").
  CueTheme on_dark() const;
  bool knows(const QString& meaning) const { return styles_.contains(meaning); }
  const QStringList& meanings() const { return order_; }

 private:
  QString id_, title_;
  QStringList order_;
  QHash<QString, CueStyle> styles_;
  QHash<QString, QColor> on_dark_;  // of meanings that have another colour there
  QHash<QString, CueStyle> roles_;
  QHash<QString, QColor> roles_on_dark_;
};

/// Draws the row of signs of a cue, one square of `size` px each, light outline included. Returns the width
/// used.
double paint_cue_shape(QPainter& painter, const QPointF& top_left, double size, const CueStyle& style);

}  // namespace swage::console
