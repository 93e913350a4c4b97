// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_state.hpp"

#include <swage/abi/lesson.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "console/view3d/led_tool.hpp"

namespace swage::console {

SceneState::SceneState() : snapshot_(std::make_unique<snapshot::Snapshot>()) {}

void SceneState::set_card(const snapshot::SceneCard& card) {
  card_ = card;
  parts_ = make_parts(card);
  have_card_ = true;
  have_snapshot_ = false;
  led_ = SWAGE_NONE;
  pierced_ = false;
  taken_.reset();
  stress_ = 0;
}

std::shared_ptr<snapshot::Snapshot> SceneState::moment() const { return have_snapshot_ ? std::make_shared<snapshot::Snapshot>(*snapshot_) : nullptr; }

SceneState::At::At(SceneState& scene, const std::shared_ptr<snapshot::Snapshot>& moment) : scene_(scene), newest_(scene.snapshot_) {
  if (moment) scene_.snapshot_ = moment;
}

SceneState::At::~At() { scene_.snapshot_ = newest_; }

SceneState::Change SceneState::take(const snapshot::Snapshot& snapshot, bool with_stress) {
  Change change;
  change.same = have_snapshot_ && snapshot.step == snapshot_->step && snapshot.time_s == snapshot_->time_s;
  change.colours = !have_snapshot_ || !std::equal(snapshot.object_cue, snapshot.object_cue + snapshot.n_object, snapshot_->object_cue);
  *snapshot_ = snapshot;
  change.first = !std::exchange(have_snapshot_, true);
  change.colours |= read_stress(with_stress);
  change.led = follow_led_tool();
  return change;
}

// Reads grasp, tissue and stress from the signals. Stress is rounded to 1/16 of first yield, so that its colour changes seldom.
bool SceneState::read_stress(bool with_stress) {
  double stress = 0;
  pierced_ = false;
  taken_.reset();
  for (uint32_t i = 0; have_snapshot_ && i < snapshot_->n_signal && i < card_.script.signals.size(); ++i) {
    const std::string& id = card_.script.signals[i].id;
    if (id == "pierce.state") pierced_ |= snapshot_->signal[i] > 1.5;  // 2: in the tissue
    if (id.ends_with("grasp.held")) taken_ = taken_.value_or(false) || snapshot_->signal[i] > 0.5;
    if (with_stress && id == "needle.stress") stress = std::max(stress, snapshot_->signal[i]);
  }
  const double rounded = std::round(16 * std::min(stress, 2.0)) / 16;
  return std::exchange(stress_, rounded) != rounded;
}

// Updates the places near the tips, and those dragged or driven with them, for the active tool.
bool SceneState::follow_led_tool() {
  const uint32_t now = led_tool(card_, *snapshot_);
  if (now == led_) return false;
  led_ = now;
  if (const auto tips = parts_.tips_of.find(now); tips != parts_.tips_of.end()) parts_.tips = tips->second;
  return true;
}

bool SceneState::judged() const { return have_snapshot_ && snapshot_->step > 0; }

std::span<const swage_pose> SceneState::X_WB() const {
  return have_snapshot_ ? std::span<const swage_pose>(snapshot_->X_WB, snapshot_->n_body) : std::span<const swage_pose>(card_.start);
}

const swage_pose& SceneState::pose(uint32_t body) const {
  return have_snapshot_ && body < snapshot_->n_body ? snapshot_->X_WB[body] : card_.start[body];
}

QVector3D SceneState::place_of(const Spot& spot) const {
  const swage_pose& X = pose(spot.body);
  return to_mm(X.p) + to_qt(X.q).rotatedVector(spot.p_B);
}

QVector3D SceneState::middle_of_tips() const {
  QVector3D sum;
  for (const Spot& s : parts_.tips) sum += place_of(s);
  return parts_.tips.empty() ? sum : sum / static_cast<float>(parts_.tips.size());
}

std::optional<uint32_t> SceneState::active_tool() const {
  if (parts_.tips_of.empty()) return {};
  return parts_.tips_of.contains(led_) ? led_ : parts_.tips_of.begin()->first;
}

QVector3D SceneState::aim_near(const QVector3D& tips, float reach) const {
  QVector3D aim = tips;
  float least = 1e30F;
  for (const Spot& s : parts_.aim) {
    const QVector3D p = place_of(s);
    if ((p - tips).length() >= least) continue;
    least = (p - tips).length();
    aim = p;
  }
  if ((aim - tips).length() > reach) return aim;
  return first_point().value_or(aim);
}

std::optional<QVector3D> SceneState::first_point() const {
  if (!judged()) return {};
  for (uint32_t m = 0; m < snapshot_->n_mark && m < card_.script.marks.size(); ++m)
    if (card_.script.marks[m].mark.kind == SWAGE_MARK_POINT) return to_mm(snapshot_->mark_p_W[m]);
  return {};
}

std::optional<QVector3D> SceneState::subject() const {
  if (ties()) return parts_.stitch;
  const auto point = first_point();
  return !point && has_knot() ? parts_.knot : point;
}

bool SceneState::thread_alone() const {
  return std::any_of(parts_.threads.begin(), parts_.threads.end(),
                     [&](const ThreadLine& t) { return parts_.watched < 0 || t.body == static_cast<uint32_t>(parts_.watched); });
}

bool SceneState::ties() const { return parts_.stitch && thread_alone(); }

std::optional<QVector3D> SceneState::tied_at(uint32_t object) const {
  const bool tissue = std::any_of(parts_.part.begin(), parts_.part.end(), [&](const ScenePart& p) { return p.object == object && p.soft; });
  return tissue && ties() ? parts_.stitch : std::nullopt;
}

bool SceneState::has_knot() const { return parts_.knot && thread_alone() && !has_target(); }

std::vector<QVector3D> SceneState::points() const {
  std::vector<QVector3D> out;
  for (uint32_t m = 0; judged() && m < snapshot_->n_mark && m < card_.script.marks.size(); ++m)
    if (card_.script.marks[m].mark.kind == SWAGE_MARK_POINT) out.push_back(to_mm(snapshot_->mark_p_W[m]));
  return out;
}

bool SceneState::has_target() const {
  return std::any_of(card_.script.marks.begin(), card_.script.marks.end(),
                     [](const judge::Script::Mark& m) { return m.mark.kind == SWAGE_MARK_POINT; });
}

QVector3D SceneState::beside_watched() const {
  constexpr float kHeld_mm = 8;  // from the middle of a needle to the jaws that hold it: more than the longest needle is across
  const QVector3D tips = middle_of_tips();
  const auto needle = watched(), mark = first_point();
  const bool sews = taken_.value_or(false) && !parts_.threads.empty() && parts_.watched >= 0 &&
                    parts_.threads.front().body != static_cast<uint32_t>(parts_.watched);
  return sews && needle && mark && (tips - *needle).length() < kHeld_mm ? *mark : tips;
}

std::optional<QVector3D> SceneState::watched() const {
  if (parts_.watched < 0 || !have_snapshot_ || static_cast<uint32_t>(parts_.watched) >= snapshot_->n_body) return {};
  return place_of({static_cast<uint32_t>(parts_.watched), parts_.watched_middle});
}

}  // namespace swage::console
