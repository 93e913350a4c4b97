// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/sound_control.hpp"

#include <QHBoxLayout>
#include <cmath>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kSlider_px = 60;

}  // namespace

SoundControl::SoundControl(QWidget* parent)
    : QWidget(parent), button_(make_button(tr("Sound"), {}, QStringLiteral("sound"), this)), volume_(new QSlider(Qt::Horizontal, this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  button_->setCheckable(true);
  button_->setChecked(true);
  button_->setToolTip(tr("Let the cues be heard"));
  volume_->setObjectName(QStringLiteral("volume"));
  volume_->setAccessibleName(tr("Volume"));
  volume_->setToolTip(tr("Volume of the cues"));
  volume_->setRange(0, 100);
  volume_->setFixedWidth(kSlider_px);
  volume_->setValue(static_cast<int>(100 * speaker_.volume()));
  connect(button_, &QPushButton::toggled, volume_, &QSlider::setEnabled);
  connect(volume_, &QSlider::valueChanged, this, [this](int v) { speaker_.set_volume(v / 100.0); });
  // plays a sample at the new volume
  connect(volume_, &QSlider::sliderReleased, this, [this] { speaker_.play(tone(QStringLiteral("high, two knocks"))); });
  row->addWidget(button_);
  row->addWidget(volume_);
}

void SoundControl::set(bool on, double volume) {
  button_->setChecked(on);
  volume_->setValue(static_cast<int>(std::lround(100 * volume)));
}

void SoundControl::hear(const QStringList& meanings, double time_s, const CueTheme& theme, bool audible) {
  for (const QString& name : sounds_.hear(meanings, time_s, theme)) {
    if (audible && on()) speaker_.play(tone(name));
  }
  const QString silent = speaker_.why_silent();
  if (!silent.isEmpty()) button_->setToolTip(tr("No sound device answers (%1). Cues are seen, not heard.").arg(silent));
}

}  // namespace swage::console
