// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/guide.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {
namespace {

// steps between two frames of the recorded path: 20 ms, in which an instrument moves some tenths of a millimetre
constexpr uint64_t kEvery = 20;
// nice value: the session's threads have precedence over the guide
constexpr int kNice = 10;

swage_vec3 metres(const QVector3D& mm) {
  return {static_cast<double>(mm.x()) / kMmPerM, static_cast<double>(mm.y()) / kMmPerM, static_cast<double>(mm.z()) / kMmPerM};
}

}  // namespace

std::vector<BodyPlace> instrument_places(const snapshot::SceneCard& card) {
  std::vector<BodyPlace> out;
  const SceneParts parts = make_parts(card);
  for (const auto& [object, tips] : parts.tips_of)
    for (const Spot& tip : tips) out.push_back({tip.body, metres(tip.p_B)});
  for (const ScenePart& part : parts.part) {
    if (part.role != Role::kTool || part.in_world()) continue;
    Bounds own;
    for (const Vertex& v : part.mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
    if (!own.empty()) out.push_back({part.body, metres(own.centre())});
  }
  return out;
}

Guide::Guide(std::unique_ptr<Player> expert)
    : expert_(std::move(expert)), card_(expert_->card()), path_(instrument_places(card_)), pace_(path_) {
  for (const BodyPlace& place : instrument_places(card_)) bodies_ = std::max(bodies_, place.body + 1);
  thread_ = std::thread([this] { run(); });
}

Guide::~Guide() {
  stop_ = true;
  thread_.join();
}

// [thread_]
void Guide::run() {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
  const auto now = std::make_unique<snapshot::Snapshot>();
  for (bool on = true; on && !stop_;) {
    on = expert_->toward(expert_->at() + kEvery, kEvery);
    expert_->fill(*now);
    const std::lock_guard guard(lock_);
    made_.push_back({now->time_s, now->phase, {now->X_WB, now->X_WB + std::min(now->n_body, bodies_)}});
  }
  failed_ = !stop_ && now->outcome != static_cast<uint32_t>(judge::Outcome::kPassed);
  done_ = true;
}

GuidePosition Guide::position() const {
  if (path_.empty()) return {};
  return {path_[pace_.progress()].way_m, pace_.shown_way_m()};
}

const std::vector<swage_pose>& Guide::beside(const snapshot::Snapshot& trainee) {
  std::vector<Made> fresh;
  {
    const std::lock_guard guard(lock_);
    fresh.swap(made_);
  }
  for (const Made& one : fresh) path_.add(one.time_s, one.phase, one.X_WB);
  shown_.clear();
  if (failed_) return shown_;
  pace_.follow(std::span(trainee.X_WB, trainee.n_body), trainee.phase, trainee.time_s - last_s_);
  last_s_ = trainee.time_s;
  pace_.pose(shown_);
  return shown_;
}

}  // namespace swage::console
