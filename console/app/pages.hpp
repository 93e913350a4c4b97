// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pages of the window. To add one, add() it: its button, its key and its place in the tab order follow from that.
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

/// One page. What is not given is not called.
struct Page {
  QString id;                   // "people": on the command line, in settings and in object names
  QString title;                // on its button
  QString tip;                  // the question it answers
  QWidget* widget = nullptr;
  bool scrolls = true;               // where the window is smaller than the page; false: the page sees to that itself
  std::function<void()> shown = {};  // it has come to the front
  std::function<void(const UiTheme&, const CueTheme&)> themed = {};
  SceneView* view = nullptr;    // its picture
  QUndoStack* edits = nullptr;  // what Ctrl+Z takes back while it is in front
};

class Pages : public QWidget {
  Q_OBJECT
 public:
  explicit Pages(QWidget* parent = nullptr);
  /// The page goes behind those that are there; its key is Ctrl and its number.
  void add(const Page& page);
  /// False where there is none of that id.
  bool go(const QString& id);
  const Page& current() const { return pages_[stack_->currentIndex()]; }
  const QVector<Page>& all() const { return pages_; }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// The bar of buttons; more can be added behind them.
  QHBoxLayout* bar() { return bar_; }
  QWidget* bar_widget() { return bar_frame_; }
  QUndoGroup* edits() { return &edits_; }

 private:
  QFrame* bar_frame_;
  QHBoxLayout* bar_;
  QStackedWidget* stack_;
  QVector<Page> pages_;
  QVector<QPushButton*> buttons_;
  QUndoGroup edits_;
};

}  // namespace swage::console
