// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Small building blocks that look alike everywhere.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "console/cues/cue_theme.hpp"

namespace swage::console {

/// A rounded box with a heading; add widgets to `body`.
struct Card {
  QFrame* frame;
  QVBoxLayout* body;
};
Card make_card(const QString& heading, QWidget* parent);
QLabel* make_heading(const QString& text, QWidget* parent);
QLabel* make_muted(const QString& text, QWidget* parent);
/// Rich text: a heading and a list below it; "" without lines.
QString list_text(const QString& heading, const QStringList& lines);
/// A key as people call it in their language: "Ctrl+N", "Strg+N".
QString key_text(const QString& shortcut);
/// A button that tells its shortcut, also to screen readers.
QPushButton* make_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent);

/// A button whose key stands behind or below its words only where there is room for it; its tip tells the key anyway.
class KeyedButton : public QPushButton {
 public:
  using QPushButton::QPushButton;
  QString words() const;  // without the key
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};
/// The same as make_button().
KeyedButton* make_keyed_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent);

/// Gives a button a shortcut, and its tip (its words where it has none) the name of the key. Main thread.
void give_key(QPushButton* button, const QString& shortcut);

/// A line to type words of a search into, with a button that clears it.
QLineEdit* make_search(const QString& what, const QString& name, QWidget* parent);

/// A table of which whole rows are chosen, one at a time, and nothing is edited. The keyboard leaves it with Tab, and Enter activates a row.
QTableView* make_row_table(QAbstractItemModel* model, const QString& title, const QString& name, QWidget* parent);

/// A frameless area that scrolls up and down where its content is taller than the room for it.
QScrollArea* make_scroll(QWidget* parent);

/// One line that ends in an ellipsis where it does not fit, and then says the whole as its tip.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// The signs of one cue fact, drawn as over the scene.
class CueBadge : public QWidget {
 public:
  explicit CueBadge(QWidget* parent = nullptr);
  void set_style(const CueStyle& style);
  QSize sizeHint() const override { return {22, 22}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  CueStyle style_;
};

/// Title in bold, summary below in grey, for lists.
class TwoLineDelegate : public QStyledItemDelegate {
 public:
  TwoLineDelegate(int summary_role, QObject* parent) : QStyledItemDelegate(parent), role_(summary_role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int role_;
};

}  // namespace swage::console
