// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QGridLayout>
#include <QLabel>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// The meanings of this lesson's cues: colour, shape and text of each. Active ones are framed and bold.
class CueLegend : public QFrame {
  Q_OBJECT
 public:
  explicit CueLegend(QWidget* parent = nullptr);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_meanings(const QStringList& meanings);
  void set_active(const QStringList& meanings);
  /// Whether the picture shows the cues; if not, a line says that only this legend does.
  void set_in_picture(bool shown);
  /// Whether the text of some row exceeds one line: then all rows use one smaller size.
  bool has_long_words() const;
  /// Texts that are elided even at the smallest size; their tooltips are complete.
  QStringList cut_words() const;

  const QStringList& meanings() const { return meanings_; }
  const QStringList& active() const { return active_; }

 private:
  class Row;
  void fill();
  bool fit(double scale) const;  // all texts fit at this size
  double scale() const;          // of the texts, in units of the usual size
  void add_column(const QStringList& meanings, int column, bool low);
  CueTheme cues_;
  UiTheme ui_;
  QStringList meanings_, active_;
  bool has_lesson_ = false;  // without a lesson its cues are not mentioned
  QVector<Row*> rows_;
  mutable double scale_ = 0;  // 0: to be computed again
  QLabel *heading_, *empty_;
  QGridLayout* grid_;
};

}  // namespace swage::console
