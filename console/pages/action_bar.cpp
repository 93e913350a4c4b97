// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/action_bar.hpp"

#include <QHBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {

ActionBar::ActionBar(RunControl* control, QWidget* parent)
    : QWidget(parent),
      pause_(make_keyed_button(tr("Pause"), QStringLiteral("F6"), QStringLiteral("pause"), this)),
      reset_(make_keyed_button({}, QStringLiteral("F7"), QStringLiteral("reset"), this)),
      mark_(make_keyed_button(tr("Mark"), QStringLiteral("F8"), QStringLiteral("mark"), this)),
      stop_(make_keyed_button(tr("Stop"), QStringLiteral("Shift+F5"), QStringLiteral("stop"), this)),
      guide_(make_keyed_button(tr("Guide"), QStringLiteral("F4"), QStringLiteral("guide"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  set_reset({}, {});
  mark_->setToolTip(tr("Remember the moment two seconds ago (F8)"));
  guide_->setCheckable(true);
  guide_->setToolTip(tr("An expert's instruments, seen through, show what comes next and wait for you; not in a test (F4)"));
  for (QPushButton* b : {pause_, reset_, mark_, stop_, guide_}) row->addWidget(b, 1);
  connect(pause_, &QPushButton::clicked, control, &RunControl::toggle_pause);
  connect(reset_, &QPushButton::clicked, control, &RunControl::reset_work);
  connect(mark_, &QPushButton::clicked, control, &RunControl::mark);
  connect(stop_, &QPushButton::clicked, control, &RunControl::stop);
  connect(guide_, &QPushButton::toggled, this, &ActionBar::guide_toggled);
}

void ActionBar::set_running(bool running, bool paused) {
  for (QPushButton* b : {pause_, reset_, mark_, stop_}) b->setEnabled(running);
  pause_->setText(paused ? tr("Resume   F6") : tr("Pause   F6"));
  place_keys();
}

void ActionBar::set_reset(const QString& label, const QString& tip) {
  const QString words = label.isEmpty() ? tr("Put back") : label;
  reset_->setText(words + QStringLiteral("   F7"));
  reset_->setAccessibleName(words);
  const QString own = tip.isEmpty() ? words : tip;
  reset_->setToolTip(QStringLiteral("%1 (F7)").arg(label.isEmpty() ? tr("Put what the lesson works on back to where it started") : own));
  place_keys();
}

void ActionBar::set_narrow(bool narrow) {
  narrow_ = narrow;
  place_keys();
}

void ActionBar::place_keys() {
  const QString beside = QStringLiteral("   "), below = QStringLiteral("\n");
  for (QPushButton* b : {pause_, reset_, mark_, stop_, guide_}) {
    QString text = b->text();
    b->setText(narrow_ ? text.replace(beside, below) : text.replace(below, beside));
  }
}

}  // namespace swage::console
