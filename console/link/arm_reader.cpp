// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/arm_reader.hpp"

#include <swage/abi/device.h>

#include <cmath>
#include <utility>

#include "console/models/said.hpp"

namespace swage::console {
namespace {

constexpr int kPoll_ms = 16;
constexpr std::size_t kStill = 20;  // positions: a third of a second at kPoll_ms
constexpr double kStill_m = 1e-3;   // a resting hand shakes by some tenths of a millimetre

}  // namespace

ArmReader::ArmReader(SessionOpener opener, session::Options options, QObject* parent)
    : QObject(parent), opener_(std::move(opener)), options_(std::move(options)), now_(std::make_unique<snapshot::Snapshot>()) {
  options_.store_path = ":none:";
  options_.mode = "practice";
  timer_.setInterval(kPoll_ms);
  connect(&timer_, &QTimer::timeout, this, &ArmReader::poll);
}

ArmReader::~ArmReader() { stop(); }

QString ArmReader::start() {
  stop();
  base::Problems problems;
  session_ = opener_(options_, problems);
  if (!session_) {
    for (const base::Problem& p : problems)
      if (p.severity == base::Severity::kError) return said_message(p.message);
    return tr("The instrument cannot be opened.");
  }
  session_->start();
  timer_.start();
  return {};
}

void ArmReader::stop() {
  timer_.stop();
  last_.clear();
  if (session_) session_->stop();
  session_.reset();
}

// Restarts a lesson that has ended: only the position of the arm is wanted.
void ArmReader::poll() {
  if (!session_) return;
  if (session_->finished() && !start().isEmpty()) return stop();
  if (!session_->latest(*now_) || now_->n_device == 0) return;
  if ((now_->device[0].valid & SWAGE_VALID_POSE) == 0 || now_->device[0].stale != 0)
    last_.clear();
  else
    last_.push_back(now_->device[0].X_WD.p);
  if (last_.size() > kStill) last_.pop_front();
  Q_EMIT moved();
}

std::optional<swage_vec3> ArmReader::newest() const {
  return last_.empty() ? std::nullopt : std::optional(last_.back());
}

std::optional<swage_vec3> ArmReader::still() const {
  if (last_.size() < kStill) return {};
  swage_vec3 mean{};
  const double share = 1.0 / static_cast<double>(last_.size());
  for (const swage_vec3& p : last_) mean = {mean.x + share * p.x, mean.y + share * p.y, mean.z + share * p.z};
  for (const swage_vec3& p : last_)
    if (std::hypot(p.x - mean.x, p.y - mean.y, p.z - mean.z) > kStill_m) return {};
  return mean;
}

}  // namespace swage::console
