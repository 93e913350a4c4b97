// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Output to the loudspeaker. Calls never block: a thread of its own writes the samples. Without a sound device ok() is false
// and sounds are dropped.
#pragma once

#include <QString>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "console/cues/tones.hpp"

namespace swage::console {

/// play(), set_volume() and why_silent() are for the GUI thread. The device is opened with the first sound.
class Speaker {
 public:
  /// `device`: an ALSA name; "default" uses PulseAudio or PipeWire where they run; "null" discards all samples.
  explicit Speaker(const char* device = "default") : device_(device) {}
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void play(Pcm pcm);             // mixed with the sounds being played
  void set_volume(double share);  // 0 to 1
  double volume() const { return volume_; }
  QString why_silent();  // reason for silence, "" while there is none
  uint64_t written();    // samples that the device has taken

 private:
  void run();
  bool mix(std::vector<int16_t>& out);

  const char* device_;
  double volume_ = 0.7;
  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  Pcm waiting_;  // mixed, not yet written
  std::string problem_;
  uint64_t written_ = 0;
  bool end_ = false, failed_ = false;
  std::thread thread_;
};

}  // namespace swage::console
