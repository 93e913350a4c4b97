// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <fcntl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

namespace {

constexpr double kRetry = 0.25;  // s between two attempts to open a port that was unplugged

// Time on the host's monotonic clock, which stamps the samples of devices that are not LOCKSTEP.
double now_s() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

bool @NAME@::connect() {
  tried_s_ = now_s();
  n_heard_ = 0;
  file_ = ::open(params().port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) return false;
  termios how{};
  if (tcgetattr(file_, &how) != 0) {
    close();
    errno = ENOTTY;
    return false;
  }
  cfmakeraw(&how);
  cfsetspeed(&how, B115200);
  tcsetattr(file_, TCSANOW, &how);
  return true;
}

// [main] Opens the hardware; refuse() says what is missing and what to do about it.
void @NAME@::open() {
  if (!connect()) refuse("The port " + params().port + " cannot be opened: " + std::strerror(errno) + ". Set \"port\" to the tracker's.");
}

void @NAME@::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

// [io] Reads what has arrived and never waits. Without a new measurement `sample` stays as it is; the host knows its age.
void @NAME@::exchange(const swage_command&, swage_sample& sample) {
  if (file_ < 0 && (now_s() - tried_s_ < kRetry || !connect())) return;
  if (!hear(sample)) return;
  sample.sequence += 1;
  sample.time_s = now_s();
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;  // what was measured, nothing else
}

// Reads what has arrived into `sample`; true when a whole measurement came. The newest counts.
bool @NAME@::hear(swage_sample& sample) {
  bool any = false;
  for (;;) {
    const ssize_t n = ::read(file_, heard_.data() + n_heard_, heard_.size() - n_heard_);
    if (n < 0 && (errno == EAGAIN || errno == EINTR)) return any;
    if (n <= 0) {  // unplugged: exchange() tries again
      close();
      return any;
    }
    n_heard_ += static_cast<std::size_t>(n);
    char* begin = heard_.data();
    char* const end = begin + n_heard_;
    for (char* eol = std::find(begin, end, '\n'); eol != end; eol = std::find(begin, end, '\n')) {
      any = take(begin, eol, sample) || any;
      begin = eol + 1;
    }
    n_heard_ = static_cast<std::size_t>(std::copy(begin, end, heard_.data()) - heard_.data());
    if (n_heard_ == heard_.size()) n_heard_ = 0;  // no line is that long: noise
  }
}

// Parses a line; a malformed one leaves `sample` unchanged. Device frame: +x right, +y up, +z towards the user, metres.
bool @NAME@::take(const char* begin, const char* end, swage_sample& sample) const {
  std::array<double, 4> value{};
  for (double& v : value) {
    while (begin != end && *begin == ' ') ++begin;
    const auto [rest, error] = std::from_chars(begin, end, v);  // independent of the locale
    if (error != std::errc{} || !std::isfinite(v)) return false;
    begin = rest;
  }
  sample.pose = swage::at(1e-3 * value[0], 1e-3 * value[1], 1e-3 * value[2]);
  sample.closure = std::clamp(value[3], 0.0, 1.0);
  return true;
}

SWAGE_EXPORT(@NAME@)
