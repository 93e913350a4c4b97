// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/status_strip.hpp"

#include <QHBoxLayout>
#include <cmath>

#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

/// A device's own status, if known: ", Pad: Battery 70 %".
QString told_by(const snapshot::Snapshot& s, const snapshot::SceneCard& card, const std::string& device) {
  QString out;
  for (uint32_t i = 0; i < s.n_signal && i < card.script.signals.size(); ++i) {
    const judge::Name& name = card.script.signals[i];
    if (name.owner != device || std::isnan(s.signal[i])) continue;
    const QString unit = QString::fromStdString(name.unit);
    const bool share = name.unit == "1";
    out += QStringLiteral(", %1 %2").arg(said_name(name, card.script.signals),
                                         quantity_text(s.signal[i], share ? QStringLiteral("%") : unit));
  }
  return out;
}

}  // namespace

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 4, 14, 6);
  row->setSpacing(22);
  const auto add = [&](const char* name) {
    auto* label = new QLabel(this);
    label->setObjectName(QString::fromLatin1(name));
    label->setProperty("muted", true);
    row->addWidget(label);
    return label;
  };
  loop_ = add("loop_health");
  device_ = add("device_health");
  recording_ = add("recording");
  row->addStretch(1);
  frames_ = add("frames");
  frames_->setToolTip(tr(
      "Time from picture to picture: half of them take no longer than the first number, 99 of 100 no longer "
      "than the second; how many pictures there were; and the time from a movement of mouse or key to the first picture "
      "that can show it, without the screen's own delay (F12 hides it)"));
  frames_->hide();
  graphics_ = add("graphics");
}

void StatusStrip::set_graphics(const QString& text) {
  picture_ = text;
  show_graphics();
}

void StatusStrip::show_graphics() {
  const bool late = behind_s_ > 0 && !idle_;
  graphics_->setText(late ? tr("▲ %1, %L2 s behind the hand").arg(picture_).arg(behind_s_, 0, 'f', 1) : picture_);
  graphics_->setToolTip(late ? tr("The picture comes so long after mouse and keys: move a little, and wait for it. Smaller windows and fewer insets are quicker.") : QString());
}

void StatusStrip::set_idle(const QString& text) {
  idle_ = true;
  show_graphics();
  loop_->setText(text);
  device_->clear();
  recording_->clear();
}

void StatusStrip::show_frames(const FrameTimes& frames, const FrameTimes& latency) {
  constexpr double kLate_s = 0.4;  // a hand led by the eye stops and waits from about here on; a picture drawn by a graphics card takes a tenth
  constexpr size_t kRecent = 5;    // movements
  const double behind_s = latency.recent(kRecent);
  behind_s_ = behind_s > kLate_s ? behind_s : 0;
  show_graphics();
  if (!frames_shown()) return;
  const double half = frames.share(0.5), worst = frames.share(0.99);
  if (frames.count() == 0) return frames_->setText(tr("No picture yet"));
  QString text = tr("%1 fps, p50 %L2 ms, p99 %L3 ms, picture %4")
                     .arg(1 / half, 0, 'f', 0)
                     .arg(1e3 * half, 0, 'f', 1)
                     .arg(1e3 * worst, 0, 'f', 1)
                     .arg(frames.total());
  if (latency.count() > 0)
    text += tr(", hand to picture p50 %1 ms, p99 %2 ms").arg(1e3 * latency.share(0.5), 0, 'f', 0).arg(1e3 * latency.share(0.99), 0, 'f', 0);
  frames_->setText(text);
}

void StatusStrip::show_health(const snapshot::Snapshot& s, const snapshot::SceneCard& card,
                              double steps_per_s, bool recording) {
  const snapshot::LoopHealth& h = s.health;
  idle_ = false;
  const bool on_time = h.late == 0 && h.dropped == 0;
  const bool fine = on_time && h.quarantined == 0 && h.solver.steps == 0 && h.visuals.faulty == 0;
  QString loop = tr("%1  %2 steps/s, worst %L3 ms, %4 late")
                     .arg(fine ? QStringLiteral("●") : QStringLiteral("▲"))
                     .arg(steps_per_s, 0, 'f', 0)
                     .arg(h.worst_step_s * 1e3, 0, 'f', 2)
                     .arg(h.late);
  if (h.solver.steps == 1) loop += tr(", solver short in 1 step");
  if (h.solver.steps > 1) loop += tr(", solver short in %1 steps").arg(h.solver.steps);
  if (h.visuals.faulty > 0) loop += tr(", not everything is drawn");
  loop_->setText(loop);
  QStringList hints;
  if (h.quarantined) hints += tr("%1 of the lesson's parts stopped.").arg(h.quarantined);
  if (!on_time) hints += tr("%1 steps were late. Forces may feel rough.").arg(h.late);
  if (h.solver.steps > 0)
    hints += tr("The solver fell short in %1 steps: %2.")
                 .arg(h.solver.steps)
                 .arg(QString::fromStdString(base::text(h.solver)));
  if (h.visuals.faulty > 0)
    hints += tr("What is drawn on %1 was left out %2 times; first for its primitive %3 (%4), member %5.")
                 .arg(h.visuals.object < card.objects.size() ? said_id(card.objects[h.visuals.object].name) : QString())
                 .arg(h.visuals.faulty)
                 .arg(h.visuals.index)
                 .arg(QLatin1String(base::visual_kind(h.visuals.kind)), QLatin1String(base::visual_member(h.visuals.member)));
  if (h.visuals.cut > 0) hints += tr("Of what is drawn the end was left out %1 times, for lack of room.").arg(h.visuals.cut);
  loop_->setToolTip(hints.isEmpty() ? tr("The force loop is on time.") : hints.join(QLatin1Char('\n')));
  QStringList devices;
  for (uint32_t i = 0; i < s.n_device && i < card.devices.size(); ++i) {
    const QString name = said_id(card.devices[i].name);
    devices += (s.device[i].stale ? tr("▲ %1: no reply").arg(name) : tr("● %1: OK").arg(name)) + told_by(s, card, card.devices[i].name);
  }
  device_->setText(devices.join(QStringLiteral("   ")));
  recording_->setText(recording ? tr("● Recording") : tr("○ Not recorded"));
}

QString StatusStrip::text() const {
  return loop_->text() + QLatin1Char(' ') + device_->text() + QLatin1Char(' ') + recording_->text();
}

}  // namespace swage::console
