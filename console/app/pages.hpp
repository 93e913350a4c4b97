// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pages of the window. add() gives a new page its button, its key and its place in the tab order.
#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QUndoGroup>
#include <QVector>
#include <functional>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {

class SceneView;

/// One page. Members without a value are ignored.
struct Page {
  QString id;                   // "people": in the command line, settings and object names
  QString title;                // on its button
  QString tip;                  // the question it answers
  QWidget* widget = nullptr;
  bool scrolls = true;               // the page is put in a scroll area; false: it scrolls its own content
  std::function<void()> shown = {};  // called when the page has come to the front
  std::function<void(const UiTheme&, const CueTheme&)> themed = {};
  SceneView* view = nullptr;    // its 3D view
  QUndoStack* edits = nullptr;  // commands that Ctrl+Z undoes while the page is in front
};

class Pages : public QWidget {
  Q_OBJECT
 public:
  explicit Pages(QWidget* parent = nullptr);
  /// Appends the page; its key is Ctrl and its number.
  void add(const Page& page);
  /// Brings a page to the front; false for an unknown id.
  bool go(const QString& id);
  const Page& current() const { return pages_[stack_->currentIndex()]; }
  const QVector<Page>& all() const { return pages_; }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// The bar of buttons; the window can append more.
  QHBoxLayout* bar() { return bar_; }
  QWidget* bar_widget() { return bar_frame_; }
  QUndoGroup* edits() { return &edits_; }

 Q_SIGNALS:
  /// Another page, or the same one again, has come to the front.
  void gone_to(const QString& id);

 private:
  QFrame* bar_frame_;
  QHBoxLayout* bar_;
  QStackedWidget* stack_;
  QVector<Page> pages_;
  QVector<QPushButton*> buttons_;
  QUndoGroup edits_;
};

}  // namespace swage::console
