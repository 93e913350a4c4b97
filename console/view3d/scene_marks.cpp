// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_marks.hpp"

#include <swage/abi/lesson.h>

#include <QtMath>
#include <algorithm>
#include <cmath>

#include "console/models/said.hpp"
#include "console/view3d/jaw_angle.hpp"
#include "console/view3d/needle_circle.hpp"
#include "console/view3d/sight.hpp"

namespace swage::console {
namespace {

constexpr double kBesideWound_px = 9;  // from its edge to the ring of its cue
constexpr double kAboutMark_px = 3;    // room around a circle, for words
constexpr double kAboutWork_px = 14;   // room around tips and ends, for words
constexpr double kAboutNeedle_px = 6;  // beside a needle, for words
constexpr double kOnePlace_m = 1e-9;   // marks that are moved together differ by rounding only
constexpr double kForceScale_px = 60;  // arrow of 1 N
constexpr float kJawLine_mm = 0.7F;    // half of the line along the jaws' faces: as wide as the jaws at their base

/// The sign of a turn as it is seen, and its key.
std::pair<QChar, QString> turn_words(int key) {
  switch (key) {
    case Qt::Key_Z:
      return {u'↺', QStringLiteral("Z")};
    case Qt::Key_X:
      return {u'↻', QStringLiteral("X")};
    case Qt::Key_Left:
      return {u'◁', QStringLiteral("←")};
    case Qt::Key_Right:
      return {u'▷', QStringLiteral("→")};
    case Qt::Key_Up:
      return {u'△', QStringLiteral("↑")};
    default:
      return {u'▽', QStringLiteral("↓")};
  }
}

}  // namespace

Together at_one_place(const judge::Script& script, const snapshot::Snapshot& now, uint32_t mark) {
  const auto near = [&](uint32_t a, uint32_t b) {
    const swage_vec3 &p = now.mark_p_W[a], &q = now.mark_p_W[b];
    return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < kOnePlace_m;
  };
  bool first = false;
  for (uint32_t m = 0; m < now.n_mark && m < script.marks.size(); ++m) {
    if (m == mark || script.marks[m].mark.kind != SWAGE_MARK_POINT || !near(m, mark)) continue;
    if (m < mark) return Together::kLater;
    first = true;
  }
  return first ? Together::kFirst : Together::kAlone;
}

void SceneMarks::paint(Overlay& overlay, const Panel& panel, bool leads) const {
  if (!scene_.have_snapshot()) return;
  if (panel.inset != Inset::kWound) paint_targets(overlay, panel);
  paint_forces(overlay, panel);
  if (leads && panel.inset != Inset::kWound) paint_jaws(overlay, panel);
  if (panel.inset != Inset::kNone) return;
  paint_cues(overlay, panel);
  if (leads) paint_led(overlay, panel);
  ghost_.paint(overlay, panel.view.eye, panel.size);
}

QVector3D SceneMarks::grasp_point(uint32_t object) const {
  if (wound_.there() && object == wounded_object_) return wound_.middle;
  const snapshot::Snapshot& now = scene_.now();
  // where the forces of contact act, which are greatest in the jaws; else the object itself
  QVector3D sum;
  double weight = 0;
  for (uint32_t i = 0; i < now.n_contact; ++i) {
    const swage_vec3& f = now.contact[i].f_W;
    const double w = f.x * f.x + f.y * f.y + f.z * f.z;
    sum += static_cast<float>(w) * to_mm(now.contact[i].p_W);
    weight += w;
  }
  if (weight > 0) return sum / static_cast<float>(weight);
  const SceneParts& parts = scene_.parts();
  if (scene_.watched() && role_of(scene_.card(), object) == Role::kWork)
    return scene_.place_of({static_cast<uint32_t>(parts.watched), parts.watched_on});
  const uint32_t body = scene_.card().objects[object].first_body;
  return to_mm(body < now.n_body ? now.X_WB[body].p : swage_vec3{});
}

// The place of an object's cue. Two instruments that hold one thread have the middle of their grasps in the air between them: its cue belongs
// to the nearest point of the thread; that of a tissue to the tissue, and where it is tied to its edge there. Of several tools the cue of each
// belongs to its own tips.
QVector3D SceneMarks::cue_point(uint32_t object) const {
  const SceneParts& parts = scene_.parts();
  const auto tool = parts.tips_of.find(object);
  if (parts.tips_of.size() > 1 && tool != parts.tips_of.end() && !tool->second.empty()) {
    QVector3D sum;
    for (const Spot& tip : tool->second) sum += scene_.place_of(tip);
    return sum / static_cast<float>(tool->second.size());
  }
  const QVector3D at = grasp_point(object);
  const snapshot::Snapshot& now = scene_.now();
  for (const ThreadLine& thread : parts.threads) {
    if (thread.object != object || thread.first + thread.vertices() > now.n_particle) continue;
    const std::span<const double> line(now.particle_p_W + 3 * static_cast<size_t>(thread.first), thread.start.size());
    const Vec near = nearest_on(line, Vec{at.x(), at.y(), at.z()} * (1 / kMmPerM));
    return to_mm({near.x, near.y, near.z});
  }
  return on_tissue(parts, scene_.X_WB(), object, scene_.tied_at(object).value_or(at));
}

// Points that a lesson shows in the world. Where to go is the task and is seen in a test, too; that one is near is a cue.
// All circles come before all words: where two points are close, the circle of one would run through the word of the other.
void SceneMarks::paint_targets(Overlay& overlay, const Panel& panel) const {
  struct Word {
    QPointF at;
    double radius;
    CueStyle style;
  };
  std::vector<Word> words;
  const Eye& eye = panel.view.eye;
  const double h = panel.size.height();
  const judge::Script& script = scene_.card().script;
  const snapshot::Snapshot& now = scene_.now();
  for (uint32_t m = 0; scene_.judged() && m < now.n_mark && m < script.marks.size(); ++m) {
    const auto& mark = script.marks[m];
    const Together together = at_one_place(script, now, m);
    if (mark.mark.kind != SWAGE_MARK_POINT || together == Together::kLater) continue;
    const uint32_t cue = shown_.cues_shown ? now.mark_cue[m] : SWAGE_NONE;
    if (cue == SWAGE_NONE && scene_.pierced()) continue;  // the wound is there now, and is to be seen
    const std::string meaning = cue < script.cues.size() ? script.cues[cue].id : mark.meaning;
    const QPointF at = eye.project(to_mm(now.mark_p_W[m]), panel.size);
    const double radius = mark.mark.number[0] * kMmPerM / eye.mm_per_pixel(h);
    const CueStyle style = shown_.cues.style(QString::fromStdString(meaning));
    overlay.target(at, radius, style);
    const double clear = std::max(radius, kLeastMark_px) + kAboutMark_px;
    overlay.keep_clear({at.x() - clear, at.y() - clear, 2 * clear, 2 * clear});
    // where to bring it, and how much thread is to be left, is said while it is held: before that the word lies over what is to be taken
    const bool later = (meaning == "target.point" || meaning == "tail.point") && scene_.taken() == false;
    if (!later && together == Together::kAlone) words.push_back({at, radius, style});
    if (shown_.cues_shown && hold_ > 0) overlay.ring(at, hold_, std::max(radius, kLeastMark_px) + 7);
  }
  if (panel.inset != Inset::kNone) return;
  keep_work_clear(overlay, panel);
  for (const Word& w : words) overlay.target_word(w.at, w.radius, w.style);
}

// no word lies over the tips, over a needle, or over an end or the middle of what is worked on
void SceneMarks::keep_work_clear(Overlay& overlay, const Panel& panel) const {
  const SceneParts& parts = scene_.parts();
  std::vector<Spot> places = parts.tips;
  places.insert(places.end(), parts.ends.begin(), parts.ends.end());
  if (parts.watched >= 0) places.push_back({static_cast<uint32_t>(parts.watched), parts.watched_on});
  for (const Spot& place : places) {
    const QPointF at = panel.view.eye.project(scene_.place_of(place), panel.size);
    overlay.keep_clear({at.x() - kAboutWork_px, at.y() - kAboutWork_px, 2 * kAboutWork_px, 2 * kAboutWork_px});
  }
  if (overlay.two_eyes()) return;
  for (const auto& line : wire_lines(scene_.card(), parts, scene_.X_WB()))
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      const QRectF piece = QRectF(panel.view.eye.project(line[i], panel.size), panel.view.eye.project(line[i + 1], panel.size)).normalized();
      overlay.keep_clear(piece.adjusted(-kAboutNeedle_px, -kAboutNeedle_px, kAboutNeedle_px, kAboutNeedle_px));
    }
}

void SceneMarks::paint_forces(Overlay& overlay, const Panel& panel) const {
  const Eye& eye = panel.view.eye;
  const snapshot::Snapshot& now = scene_.now();
  for (uint32_t c = 0; shown_.forces && c < now.n_contact; ++c) {
    const QVector3D p = to_mm(now.contact[c].p_W);
    const swage_vec3& f = now.contact[c].f_W;
    const auto mm = static_cast<float>(kForceScale_px * eye.mm_per_pixel(panel.size.height()));
    const QVector3D arrow(static_cast<float>(f.x), static_cast<float>(f.y), static_cast<float>(f.z));
    overlay.force(eye.project(p, panel.size), eye.project(p + mm * arrow, panel.size));
  }
}

// a cue stands beside a wound, never on it
double SceneMarks::clear_px(uint32_t object, const Panel& panel) const {
  if (!wound_.there() || object != wounded_object_) return 0;
  const double mm = panel.view.eye.mm_per_pixel(panel.size.height(), wound_.middle);
  return static_cast<double>(wound_.radius) / mm + kBesideWound_px;
}

void SceneMarks::paint_cues(Overlay& overlay, const Panel& panel) const {
  int slot = 0;
  bool ringed = false;
  QStringList told;  // both edges of a wound say one thing: it is told once
  for (uint32_t o = 0; o < scene_.card().objects.size(); ++o) {
    const QString cue = cue_of(scene_, shown_, o);
    if (cue.isEmpty()) continue;
    const QPointF at = panel.view.eye.project(cue_point(o), panel.size);
    if (!ringed && hold_ > 0 && !scene_.has_target()) overlay.ring(at, hold_), ringed = true;
    // the tool's own cue (too much force) goes to the left, that of the work to the right
    const bool tool = role_of(scene_.card(), o) == Role::kTool;
    if (!tool && told.contains(cue)) continue;
    told += cue;
    overlay.cue(at, shown_.cues.style(cue), tool ? 1 : slot++ == 0 ? 0 : 2, clear_px(o, panel));
  }
}

// How the open jaws that mouse and keys lead stand to the wire at their tips: an answer, and not shown in a test.
void SceneMarks::paint_jaws(Overlay& overlay, const Panel& panel) const {
  if (!shown_.cues_shown) return;
  const SceneParts& parts = scene_.parts();
  const auto jaws = jaw_angle(scene_.card(), parts, scene_.X_WB(), parts.tips);
  if (!jaws) return;
  const Eye& eye = panel.view.eye;
  const auto project = [&](const QVector3D& p) { return eye.project(p, panel.size); };
  const auto turn = jaw_turn(*jaws, eye.q_WC());
  overlay.jaw_line(project(jaws->at - kJawLine_mm * jaws->faces), project(jaws->at + kJawLine_mm * jaws->faces), !turn);
  if (panel.inset != Inset::kNone) return;
  const double radius = kJawLine_mm / eye.mm_per_pixel(panel.size.height(), jaws->at);
  if (!turn) return overlay.jaw_word(project(jaws->at), radius, QChar(u'✓'), tr("Across the wire"));
  const auto [sign, key] = turn_words(turn->key);
  overlay.jaw_word(project(jaws->at), radius, sign, tr("Oblique by %1°: hold %2").arg(qRadiansToDegrees(turn->angle), 0, 'f', 0).arg(key));
}

// Of two tools the one that the mouse leads has a sign at its tips.
void SceneMarks::paint_led(Overlay& overlay, const Panel& panel) const {
  if (scene_.led() == SWAGE_NONE) return;
  const std::string& name = scene_.card().objects[scene_.led()].name;
  overlay.led(panel.view.eye.project(scene_.middle_of_tips(), panel.size), said_id(name));
}

}  // namespace swage::console
