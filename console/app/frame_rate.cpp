// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/frame_rate.hpp"

namespace swage::console {

FrameRate::FrameRate(StatusStrip* strip, const WindowPages* pages, Settings& settings)
    : strip_(strip), pages_(pages), settings_(settings) {
  constexpr int kRead_ms = 1000;  // once a second is often enough to read a number
  strip_->set_frames_shown(settings.text("frames") == QLatin1String("true"));
  connect(&timer_, &QTimer::timeout, this, &FrameRate::show);
  timer_.start(kRead_ms);
}

void FrameRate::toggle() {
  strip_->set_frames_shown(!strip_->frames_shown());
  settings_.set("frames", strip_->frames_shown());
  show();
}

void FrameRate::show() {
  const SceneView* view = pages_->shown_view();
  strip_->show_frames(view->frames(), view->latency());
}

}  // namespace swage::console
