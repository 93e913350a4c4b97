// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/window_place.hpp"

#include <QEvent>
#include <QScreen>
#include <QSplitter>
#include <QTimer>
#include <utility>

namespace swage::console {
namespace {

constexpr QSize kFirst_px{1440, 900};  // at the first start, on a screen that has room
constexpr int kFramed_ms = 300;        // after which a window manager has given a window its frame

QByteArray layout_key(const QSplitter& splitter) { return "layout/" + splitter.objectName().toUtf8(); }

}  // namespace

WindowPlace::WindowPlace(QWidget* window, Settings& settings) : window_(window), settings_(settings) {
  window->installEventFilter(this);
}

void WindowPlace::restore(const QSize& given) {
  window_->resize(given.isValid() ? given : kFirst_px);
  if (given.isValid()) return;
  window_->restoreGeometry(settings_.bytes("geometry"));
  fit_screen();
  fits_ = true;
}

void WindowPlace::restore_splitters() {
  for (QSplitter* splitter : window_->findChildren<QSplitter*>()) splitter->restoreState(settings_.bytes(layout_key(*splitter)));
}

void WindowPlace::remember() const {
  settings_.set("geometry", window_->saveGeometry());
  for (const QSplitter* splitter : window_->findChildren<QSplitter*>()) settings_.set(layout_key(*splitter), splitter->saveState());
}

// At the first start, and on a screen that is smaller than the last one.
void WindowPlace::fit_screen() {
  const QRect all = window_->screen()->availableGeometry();
  const QSize frame = window_->frameGeometry().size() - window_->size();
  window_->resize(window_->size().boundedTo(all.size() - frame));
  if (!all.contains(window_->frameGeometry())) window_->move(all.topLeft());
}

// The frame is known a little after the window is seen, and takes room, too.
bool WindowPlace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && std::exchange(fits_, false)) QTimer::singleShot(kFramed_ms, this, &WindowPlace::fit_screen);
  return QObject::eventFilter(watched, event);
}

}  // namespace swage::console
