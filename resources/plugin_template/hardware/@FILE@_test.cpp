// SPDX-License-Identifier: Apache-2.0
//
// Tests the driver against a fake of its hardware: the other end of a pseudo terminal.
#include "@FILE@.hpp"

#include <swage/testbed.hpp>

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

int failures = 0;

void check(bool good, const char* what) {
  if (good) return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

class FakeTracker {
 public:
  FakeTracker() {
    grantpt(end_);
    unlockpt(end_);
  }
  ~FakeTracker() { unplug(); }
  std::string port() const { return ptsname(end_); }
  void says(const std::string& text) const { check(write(end_, text.data(), text.size()) == static_cast<ssize_t>(text.size()), "written"); }
  void unplug() {
    if (end_ >= 0) ::close(end_);
    end_ = -1;
  }

 private:
  int end_ = posix_openpt(O_RDWR | O_NOCTTY);
};

int main() {
  FakeTracker tracker;
  swage::testbed::DeviceBench<@NAME@> bench;
  bench.set_text("port", tracker.port());
  check(bench.start(), "it starts");

  bench.exchange(0);
  check(bench.sample.sequence == 0 && bench.sample.valid == 0, "silence is no sample");

  tracker.says("1 2 3 0.25\n4 5 -6.5 0.5\n7 8");
  bench.exchange(0);
  check(bench.sample.sequence == 1, "the newest whole line is a sample");
  check(std::abs(bench.sample.pose.p.z + 6.5e-3) < 1e-15 && bench.sample.closure == 0.5, "in metres");
  check(bench.sample.valid == (SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE), "with what was measured");

  tracker.says(" 9 1\nnan 0 0 0\n1e999 0 0 0\nrubbish\n\n" + std::string(3000, 'x') + "\n");
  for (int i = 0; i < 3; ++i) bench.exchange(0);
  check(bench.sample.sequence == 2 && std::abs(bench.sample.pose.p.x - 7e-3) < 1e-15, "a line in two parts; noise changes nothing");

  tracker.unplug();
  for (int i = 0; i < 3; ++i) bench.exchange(0);
  check(bench.sample.sequence == 2, "an unplugged tracker is silent");
  check(bench.content(), "nothing was reported");
  return failures == 0 ? 0 : 1;
}
