// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QGridLayout>
#include <QLabel>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// What the cues of this lesson mean: colour, shape and word of each. What is on now is framed and bold.
class CueLegend : public QFrame {
  Q_OBJECT
 public:
  explicit CueLegend(QWidget* parent = nullptr);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_meanings(const QStringList& meanings);
  void set_active(const QStringList& meanings);
  /// Whether the picture shows the cues; if not, a line says that only this strip does.
  void set_in_picture(bool shown);
  /// Whether the words of some row do not fit one line: then all are written smaller, so that they have one size.
  bool has_long_words() const;
  /// Words that do not fit even then, and are cut short: their tip has them whole.
  QStringList cut_words() const;

  const QStringList& meanings() const { return meanings_; }
  const QStringList& active() const { return active_; }

 private:
  class Row;
  void fill();
  bool fit(double scale) const;  // all words at this size
  double scale() const;          // of the words' usual size
  void add_column(const QStringList& meanings, int column, bool low);
  CueTheme cues_;
  UiTheme ui_;
  QStringList meanings_, active_;
  bool has_lesson_ = false;  // without one nothing is said of its cues
  QVector<Row*> rows_;
  mutable double scale_ = 0;  // 0: to be found anew
  QLabel *heading_, *empty_;
  QGridLayout* grid_;
};

}  // namespace swage::console
