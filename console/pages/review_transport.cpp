// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The row below the Review page's picture: play, speed, loop, time, views.
#include <QHBoxLayout>

#include "console/pages/comparison.hpp"
#include "console/pages/review_page.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr double kFrame_s = 0.01;  // step of the frame buttons and keys

}  // namespace

QWidget* ReviewPage::make_transport() {
  auto* box = new QWidget(this);
  // one row must not limit the width of the window: on a narrow one there are two rows
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  transport_ = new QBoxLayout(QBoxLayout::LeftToRight, box);
  transport_->setContentsMargins(0, 0, 0, 0);
  transport_->setSpacing(6);
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto call) {
    auto* button = make_button(text, {}, QString::fromLatin1(name), box);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
    return button;
  };
  add(tr("Start"), "to_start", tr("To the start (Home)"), [this] { go(0); });
  add(QStringLiteral("−10 ms"), "step_back", tr("10 ms back (←; with Shift 1 ms, with Ctrl 1 s)"), [this] { step_by(-kFrame_s); });
  play_ = add(tr("Play"), "play", tr("Play, pause (Space)"), [this] { toggle_play(); });
  play_->setMinimumWidth(90);
  add(QStringLiteral("+10 ms"), "step_on", tr("10 ms on (→; with Shift 1 ms, with Ctrl 1 s)"), [this] { step_by(kFrame_s); });
  loop_ = add(tr("Loop"), "review_loop", tr("Play a second before and after the cursor again and again (L)"), [] {});
  loop_->setCheckable(true);
  connect(loop_, &QPushButton::toggled, this, &ReviewPage::set_loop);
  speed_ = new QComboBox(box);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setAccessibleName(tr("Speed"));
  for (const double s : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) speed_->addItem(QStringLiteral("%L1×").arg(s), s);
  speed_->setCurrentIndex(3);
  row->addWidget(speed_);
  time_ = new QDoubleSpinBox(box);
  time_->setObjectName(QStringLiteral("review_time"));
  time_->setAccessibleName(tr("Time"));
  time_->setDecimals(3);
  time_->setSingleStep(kFrame_s);
  time_->setSuffix(tr(" s"));
  time_->setButtonSymbols(QAbstractSpinBox::NoButtons);  // the buttons beside it do the stepping
  time_->setKeyboardTracking(false);
  connect(time_, &QDoubleSpinBox::valueChanged, this, &ReviewPage::go);
  row->addWidget(time_);
  row->addStretch(1);
  transport_->addLayout(row, 1);
  transport_->addWidget(make_cameras(box));
  return box;
}

QWidget* ReviewPage::make_cameras(QWidget* parent) {
  auto* box = new QWidget(parent);
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
    connect(button, &QPushButton::clicked, this, [this, preset = p.preset] {
      view_->look(preset);
      if (comparing()) other_->view()->look(preset);
    });
    row->addWidget(button);
  }
  auto* forces = make_button(tr("Forces"), {}, QStringLiteral("review_forces"), box);
  forces->setCheckable(true);
  forces->setToolTip(tr("Show contact forces in the picture"));
  connect(forces, &QPushButton::toggled, this, [this](bool on) { view_->set_forces_shown(on); });
  row->addWidget(forces);
  row->addStretch(1);
  return box;
}

}  // namespace swage::console
