// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The way to the loudspeaker. Never waits: samples go to a thread of its own, and where no sound device answers nothing
// happens but that ok() says so.
#pragma once

#include <QString>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "console/cues/tones.hpp"

namespace swage::console {

/// play(), set_volume() and why_silent() from the GUI thread. The device is opened with the first sound.
class Speaker {
 public:
  /// `device`: a name of ALSA, "default" goes through PulseAudio or PipeWire where they run; "null" swallows everything.
  explicit Speaker(const char* device = "default") : device_(device) {}
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void play(Pcm pcm);             // mixed with what sounds already
  void set_volume(double share);  // 0 to 1
  double volume() const { return volume_; }
  QString why_silent();  // "" while nothing is wrong
  uint64_t written();    // samples that the device has taken

 private:
  void run();
  bool mix(std::vector<int16_t>& out);

  const char* device_;
  double volume_ = 0.7;
  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  Pcm waiting_;  // mixed, not yet written
  std::string problem_;
  uint64_t written_ = 0;
  bool end_ = false, failed_ = false;
  std::thread thread_;
};

}  // namespace swage::console
