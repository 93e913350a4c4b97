// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/end_signals.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <utility>

namespace swage::console {
namespace {

int ends[2] = {-1, -1};  // a pipe: a signal handler may do little more than write one byte

void on_signal(int number) {
  const char byte = 1;
  [[maybe_unused]] const auto n = write(ends[1], &byte, 1);
  signal(number, SIG_DFL);
}

constexpr int kSignals[] = {SIGTERM, SIGINT, SIGHUP};

}  // namespace

EndSignals::EndSignals(std::function<void()> asked) {
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return;
  notifier_ = std::make_unique<QSocketNotifier>(ends[0], QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, [this, asked = std::move(asked)] {
    notifier_->setEnabled(false);
    asked();
  });
  for (const int number : kSignals) signal(number, on_signal);
}

EndSignals::~EndSignals() {
  for (const int number : kSignals) signal(number, SIG_DFL);
  notifier_.reset();
  for (int& end : ends) {
    if (end >= 0) close(end);
    end = -1;
  }
}

}  // namespace swage::console
