// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the window fits its screen.
#include <QScreen>
#include <QShowEvent>
#include <QTimer>
#include <utility>

#include "console/app/main_window.hpp"

namespace swage::console {

// Nothing lies outside the screen, at the first start and on a smaller screen than the last time.
void MainWindow::fit_screen() {
  const QRect all = screen()->availableGeometry();
  const QSize frame = frameGeometry().size() - size();
  resize(size().boundedTo(all.size() - frame));
  if (!all.contains(frameGeometry())) move(all.topLeft());
}

// The frame is known a little after the window is seen, and takes its room, too.
void MainWindow::showEvent(QShowEvent* event) {
  constexpr int kFramed_ms = 300;
  QMainWindow::showEvent(event);
  if (std::exchange(fits_, false)) QTimer::singleShot(kFramed_ms, this, &MainWindow::fit_screen);
}

}  // namespace swage::console
