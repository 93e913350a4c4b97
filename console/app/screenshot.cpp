// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/screenshot.hpp"

#include <QCoreApplication>
#include <QPixmap>
#include <QTextStream>

#include "console/app/main_window.hpp"

namespace swage::console {
namespace {

constexpr int kSettle = 12;  // looks between the moment and the picture: the view is a few pictures behind
constexpr int kPatience_ms = 20000;  // beyond the moment itself

}  // namespace

Screenshot::Screenshot(MainWindow* window, const QString& file, double at_s, bool of_run)
    : QObject(window), window_(window), file_(file), at_s_(at_s), of_run_(of_run) {
  connect(&timer_, &QTimer::timeout, this, &Screenshot::look);
  timer_.start(16);
  since_.start();
}

void Screenshot::look() {
  RunControl* control = window_->run_page()->control();
  SceneView* view = window_->trainee() ? window_->trainee()->view() : window_->run_page()->view();
  const double wall = static_cast<double>(since_.elapsed()) * 1e-3;
  const bool late = since_.elapsed() > kPatience_ms + static_cast<qint64>(2000 * at_s_);
  // the steps up to the moment under review are computed first, at their own speed
  const bool reviewed = window_->review_page()->isVisible();
  const bool there = of_run_ ? control->newest() && control->newest()->time_s >= at_s_ : reviewed || wall >= at_s_;
  const bool over = of_run_ && control->state() == RunControl::State::kFinished;
  const bool pictured = !view->gl().ok || !view->isVisible() || view->ready();
  const bool replayed = !reviewed || !window_->review_page()->moving();
  if (!late && !((there || over) && pictured && replayed)) return;
  if (!late && ++settled_ < (of_run_ ? 2 : kSettle)) return;
  timer_.stop();
  QWidget* pictured_window = window_->trainee() ? static_cast<QWidget*>(window_->trainee()) : window_;
  const bool written = pictured_window->grab().save(file_);
  if (!written) QTextStream(stderr) << "swage-console: cannot write " << file_ << '\n';
  if (late)
    QTextStream(stderr) << "swage-console: the moment did not come; the picture shows what there was\n";
  QCoreApplication::exit(written && !late ? 0 : 1);
}

}  // namespace swage::console
