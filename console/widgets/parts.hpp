// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Small widgets with a common appearance.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
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
/// Rich text: a heading and a list; "" without lines.
QString list_text(const QString& heading, const QStringList& lines);
/// The name of a key in the language of the window: "Ctrl+N", "Strg+N".
QString key_text(const QString& shortcut);
/// A button that shows its shortcut, also to screen readers.
QPushButton* make_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent);

/// A button that shows its key behind or below its text where there is room for it; its tooltip always has the key.
class KeyedButton : public QPushButton {
 public:
  using QPushButton::QPushButton;
  QString words() const;  // without the key
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};
/// As make_button().
KeyedButton* make_keyed_button(const QString& text, const QString& shortcut, const QString& name, QWidget* parent);

/// Gives a button a shortcut, and appends the key's name to its tooltip (or its text if it has none). Main thread.
void give_key(QPushButton* button, const QString& shortcut);

/// A search field with a clear button.
QLineEdit* make_search(const QString& what, const QString& name, QWidget* parent);

/// A read-only table in which one whole row is selected at a time. Tab leaves it, Enter activates a row.
QTableView* make_row_table(QAbstractItemModel* model, const QString& title, const QString& name, QWidget* parent);

/// A frameless area that scrolls vertically where its content is taller than the area.
QScrollArea* make_scroll(QWidget* parent);
/// From now on the stack asks for the height of the page that it shows; by itself it asks for that of its highest page.
void size_as_shown(QStackedWidget* stack);

/// A line of text, elided where it does not fit, with the whole text as its tooltip.
class ElidedLabel : public QLabel {
 public:
  /// `most`: lines over which a longer text is spread before it is elided.
  explicit ElidedLabel(QWidget* parent = nullptr, int most = 1);
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }
  bool hasHeightForWidth() const override { return most_ > 1; }
  int heightForWidth(int width) const override;
  /// The text as it is shown, line by line.
  QStringList lines(int width) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const int most_;
};

/// The signs of one cue fact, drawn as in the picture.
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

/// Draws the title in bold, the summary below in grey, for lists.
class TwoLineDelegate : public QStyledItemDelegate {
 public:
  TwoLineDelegate(int summary_role, QObject* parent) : QStyledItemDelegate(parent), role_(summary_role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int role_;
};

}  // namespace swage::console
