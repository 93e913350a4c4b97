// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/cues/speaker.hpp"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr size_t kBlock = kSoundRate_Hz / 100;  // 10 ms: the longest delay of a new sound before it is mixed
constexpr unsigned kLatency_us = 40000;         // of the device; with less, sound is interrupted on a loaded machine
constexpr size_t kMost = 2 * kSoundRate_Hz;     // longest queue, 2 s; older sounds would no longer match the scene

// suppresses ALSA's own messages; the reason is in why_silent()
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

snd_pcm_t* open_device(const char* name, std::string& problem) {
  snd_lib_error_set_handler(&say_nothing);
  snd_pcm_t* pcm = nullptr;
  int error = snd_pcm_open(&pcm, name, SND_PCM_STREAM_PLAYBACK, 0);
  if (error >= 0)
    error = snd_pcm_set_params(pcm, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 1, kSoundRate_Hz, 1,
                               kLatency_us);
  if (error >= 0) return pcm;
  if (pcm) snd_pcm_close(pcm);
  problem = snd_strerror(error);
  return nullptr;
}

}  // namespace

Speaker::~Speaker() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Speaker::set_volume(double share) { volume_ = std::clamp(share, 0.0, 1.0); }

void Speaker::play(Pcm pcm) {
  if (pcm.empty() || volume_ <= 0) return;
  // perceived loudness is a power of the amplitude: half the slider sounds half as loud
  const auto gain = static_cast<float>(std::pow(volume_, 2));
  const std::lock_guard lock(mutex_);
  if (failed_ || pcm.size() > kMost) return;
  if (waiting_.size() < pcm.size()) waiting_.resize(pcm.size(), 0.F);
  for (size_t i = 0; i < pcm.size(); ++i) waiting_[i] += gain * pcm[i];
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  wake_.notify_one();
}

QString Speaker::why_silent() {
  const std::lock_guard lock(mutex_);
  return QString::fromStdString(problem_);
}

uint64_t Speaker::written() {
  const std::lock_guard lock(mutex_);
  return written_;
}

// writes the next block; false at the end of the program
bool Speaker::mix(std::vector<int16_t>& out) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return end_ || !waiting_.empty(); });
  if (end_) return false;
  const size_t n = std::min(kBlock, waiting_.size());
  out.assign(kBlock, 0);
  for (size_t i = 0; i < n; ++i)
    out[i] = static_cast<int16_t>(std::lround(32767.F * std::clamp(waiting_[i], -1.F, 1.F)));
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(n));
  return true;
}

void Speaker::run() {
  std::string problem;
  snd_pcm_t* pcm = open_device(device_, problem);
  std::vector<int16_t> block;
  while (pcm && mix(block)) {
    snd_pcm_sframes_t n = snd_pcm_writei(pcm, block.data(), block.size());
    // an underrun after a pause is no error
    if (n < 0)
      n = snd_pcm_recover(pcm, static_cast<int>(n), 1) < 0 ? n
                                                           : snd_pcm_writei(pcm, block.data(), block.size());
    const std::lock_guard lock(mutex_);
    if (n > 0) written_ += static_cast<uint64_t>(n);
    if (n >= 0) continue;
    problem = snd_strerror(static_cast<int>(n));
    break;
  }
  if (pcm) snd_pcm_close(pcm);
  const std::lock_guard lock(mutex_);
  if (end_) return;
  failed_ = true;
  problem_ = problem;
  waiting_.clear();
}

}  // namespace swage::console
