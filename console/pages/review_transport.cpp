// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_transport.hpp"

#include <QHBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr double kFrame_s = 0.01;  // step of the frame buttons and keys

}  // namespace

ReviewTransport::ReviewTransport(QWidget* parent) : QWidget(parent) {
  // one row must not limit the width of the window: on a narrow one there are two rows
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  rows_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(6);
  rows_->addLayout(make_playback(), 1);
  rows_->addWidget(make_views());
}

QLayout* ReviewTransport::make_playback() {
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto call) {
    auto* button = make_button(text, {}, QString::fromLatin1(name), this);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
    return button;
  };
  add(tr("Start"), "to_start", tr("To the start (Home)"), [this] { Q_EMIT gone_to(0); });
  add(QStringLiteral("−10 ms"), "step_back", tr("10 ms back (←; with Shift 1 ms, with Ctrl 1 s)"), [this] { Q_EMIT stepped(-kFrame_s); });
  play_ = add(tr("Play"), "play", tr("Play, pause (Space)"), [this] { Q_EMIT play_pressed(); });
  play_->setMinimumWidth(90);
  add(QStringLiteral("+10 ms"), "step_on", tr("10 ms on (→; with Shift 1 ms, with Ctrl 1 s)"), [this] { Q_EMIT stepped(kFrame_s); });
  loop_ = add(tr("Loop"), "review_loop", tr("Play a second before and after the cursor again and again (L)"), [] {});
  loop_->setCheckable(true);
  connect(loop_, &QPushButton::toggled, this, &ReviewTransport::looped);
  speed_ = new QComboBox(this);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setAccessibleName(tr("Speed"));
  for (const double s : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) speed_->addItem(QStringLiteral("%L1×").arg(s), s);
  speed_->setCurrentIndex(3);
  connect(speed_, &QComboBox::currentIndexChanged, this, [this] { Q_EMIT speed_chosen(speed_->currentData().toDouble()); });
  row->addWidget(speed_);
  time_ = new QDoubleSpinBox(this);
  time_->setObjectName(QStringLiteral("review_time"));
  time_->setAccessibleName(tr("Time"));
  time_->setDecimals(3);
  time_->setSingleStep(kFrame_s);
  time_->setSuffix(tr(" s"));
  time_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the buttons beside it do the stepping
  time_->setKeyboardTracking(false);
  connect(time_, &QDoubleSpinBox::valueChanged, this, &ReviewTransport::gone_to);
  row->addWidget(time_);
  row->addStretch(1);
  return row;
}

QWidget* ReviewTransport::make_views() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  const struct {
    QString text;
    const char* name;
    CameraPreset preset;
  } presets[] = {{tr("Orbit"), "review_orbit", CameraPreset::kOrbit},
                 {tr("Side"), "review_side", CameraPreset::kSide},
                 {tr("Top"), "review_top", CameraPreset::kTop},
                 {tr("Near"), "review_near", CameraPreset::kNear}};
  for (const auto& p : presets) {
    auto* button = make_button(p.text, {}, QString::fromLatin1(p.name), box);
    button->setToolTip(tr("%1 view").arg(p.text));
    connect(button, &QPushButton::clicked, this, [this, preset = p.preset] { Q_EMIT looked(preset); });
    row->addWidget(button);
  }
  auto* forces = make_button(tr("Forces"), {}, QStringLiteral("review_forces"), box);
  forces->setCheckable(true);
  forces->setToolTip(tr("Show contact forces in the picture"));
  connect(forces, &QPushButton::toggled, this, &ReviewTransport::forces_shown);
  row->addWidget(forces);
  row->addStretch(1);
  return box;
}

// The views go below play and speed where one row does not fit: the width is that of the picture, whatever stands beside it.
void ReviewTransport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int one_row = rows_->itemAt(0)->sizeHint().width() + rows_->spacing() + rows_->itemAt(1)->sizeHint().width();
  rows_->setDirection(one_row > width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void ReviewTransport::set_length(double length_s) {
  const QSignalBlocker quiet(time_);
  time_->setRange(0, length_s);
}

void ReviewTransport::set_time(double time_s) {
  const QSignalBlocker quiet(time_);
  time_->setValue(time_s);
}

void ReviewTransport::set_playing(bool playing) { play_->setText(playing ? tr("Pause") : tr("Play")); }

}  // namespace swage::console
