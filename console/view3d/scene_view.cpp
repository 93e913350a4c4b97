// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_view.hpp"

#include <swage/abi/lesson.h>

#include <QLinearGradient>
#include <QPainter>
#include <QPointer>
#include <algorithm>
#include <cmath>

#include "console/view3d/overlay.hpp"

namespace swage::console {
namespace {

constexpr int kTick_ms = 16;
constexpr int kFirstPictures = 16;  // shaders and meshes load in the background: the first pictures are empty
constexpr double kThreadRadius_m = 15e-6;  // 10-0 suture
constexpr float kLift_mm = 0.004F;     // the grid lies so far above its stage, so that it does not flicker
constexpr float kRoom = 1.35F;         // space around what is framed
constexpr double kForceScale_px = 60;  // arrow of 1 N

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent), gl_(probe_gl()), snapshot_(std::make_unique<snapshot::Snapshot>()) {
  setObjectName(QStringLiteral("scene_view"));
  setAccessibleName(tr("Live view of the scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  setAttribute(Qt::WA_OpaquePaintEvent);
  if (gl_.ok) renderer_ = make_qt3d_renderer(4);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SceneView::tick);
  clock_.start();
  if (renderer_) timer_.start(kTick_ms);
}

SceneView::~SceneView() = default;

void SceneView::touch(int pictures) { to_draw_ = std::max(to_draw_, pictures); }

void SceneView::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_ = ui;
  cues_ = cues;
  background_ = {};
  if (have_card_) colour_parts();
  touch();
  update();
}

void SceneView::set_card(const snapshot::SceneCard& card, CameraPreset preset) {
  card_ = card;
  parts_ = make_parts(card);
  have_card_ = true;
  have_snapshot_ = false;
  image_ = {};
  camera_.frame(parts_.focus.centre(), kRoom * std::max(parts_.focus.radius(), 0.3F));
  camera_.look(preset);
  camera_.jump();
  if (!renderer_) return update();
  renderer_->clear();
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    const ScenePart& part = parts_.part[i];
    const bool carries = parts_.ground.on_stage && i == parts_.ground.part;
    renderer_->add_part(part.mesh, surface_of(part), part.role != Role::kMark && !carries);
  }
  thread_part_.assign(card_.objects.size(), -1);
  for (size_t i = 0; i < card_.objects.size(); ++i) {
    if (card_.objects[i].n_particle > 1)
      thread_part_[i] = renderer_->add_part({}, {ui_["thread"], 0, 30}, true);
  }
  colour_parts();
  place_parts();
  touch(kFirstPictures);
}

Surface SceneView::surface_of(const ScenePart& part) const {
  switch (part.role) {
    case Role::kTool:
      return {ui_["tool"], 0.7F, 60};
    case Role::kStage:
      return {ui_["stage"], 0, 12};
    case Role::kMark: {
      const judge::Script::Mark& mark = card_.script.marks[part.mark];
      return {cues_.style(QString::fromStdString(mark.meaning)).colour, 0, 30};
    }
    case Role::kWork:
    case Role::kOther:
      break;
  }
  return part.wire ? Surface{ui_["steel"], 0.7F, 40} : Surface{ui_["other"], 0, 20};
}

QString SceneView::cue_of(uint32_t object) const {
  if (!cues_shown_ || !have_snapshot_ || object >= snapshot_->n_object) return {};
  const uint32_t cue = snapshot_->object_cue[object];
  return cue < card_.script.cues.size() ? QString::fromStdString(card_.script.cues[cue].id) : QString();
}

void SceneView::colour_parts() {
  if (!renderer_) return;
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    const ScenePart& part = parts_.part[i];
    Surface surface = surface_of(part);
    const QString cue = cue_of(part.object);
    if (part.role != Role::kMark && !cue.isEmpty()) surface = {cues_.style(cue).colour, 0.25F, 40};
    renderer_->set_surface(static_cast<int>(i), surface);
  }
  const Ground& ground = parts_.ground;
  const float size = std::max(parts_.focus.radius(), 0.5F);
  Floor floor;
  floor.shown = have_card_;
  floor.z = ground.z + (ground.on_stage ? kLift_mm : 0);
  floor.centre = ground.centre;
  floor.radius = 8 * size;
  floor.reach = size;
  if (ground.on_stage) {
    floor.half_x = ground.half_x;
    floor.half_y = ground.half_y;
    floor.radius = 4 * std::max(ground.half_x, ground.half_y);
    floor.fill = 0;
  }
  floor.colour = ui_["floor"];
  floor.line = ui_["floor_line"];
  renderer_->set_floor(floor);
}

void SceneView::place_parts() {
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    const uint32_t body = parts_.part[i].body;
    const swage_pose& X =
        have_snapshot_ && body < snapshot_->n_body ? snapshot_->X_WB[body] : card_.start[body];
    QMatrix4x4 m;
    m.translate(to_mm(X.p));
    m.rotate(to_qt(X.q));
    renderer_->set_pose(static_cast<int>(i), m);
  }
  if (!have_snapshot_) return;
  for (size_t i = 0; i < thread_part_.size(); ++i) {
    if (thread_part_[i] < 0) continue;
    Mesh mesh;
    const snapshot::CardObject& object = card_.objects[i];
    append_thread(snapshot_->particle_p_W + 3 * object.first_particle, object.n_particle, kThreadRadius_m,
                  mesh);
    renderer_->set_mesh(thread_part_[i], mesh);
  }
}

void SceneView::show_snapshot(const snapshot::Snapshot& snapshot) {
  const bool recolour =
      !have_snapshot_ ||
      !std::equal(snapshot.object_cue, snapshot.object_cue + snapshot.n_object, snapshot_->object_cue);
  const bool same =
      have_snapshot_ && snapshot.step == snapshot_->step && snapshot.time_s == snapshot_->time_s;
  *snapshot_ = snapshot;
  have_snapshot_ = true;
  if (!renderer_) return;
  if (recolour) colour_parts();
  if (same) return;
  place_parts();
  if (parts_.watched >= 0 && static_cast<uint32_t>(parts_.watched) < snapshot.n_body) {
    const swage_pose& X = snapshot.X_WB[parts_.watched];
    camera_.follow(to_mm(X.p) + to_qt(X.q).rotatedVector(parts_.watched_middle));
  }
  touch();
}

void SceneView::look(CameraPreset preset) {
  camera_.look(preset);
  touch();
}

void SceneView::set_cues_shown(bool shown) {
  cues_shown_ = shown;
  if (have_card_) colour_parts();
  touch();
  update();
}

void SceneView::set_forces_shown(bool shown) {
  forces_shown_ = shown;
  update();
}

void SceneView::set_hold(double share) {
  if (hold_ == share) return;
  hold_ = share;
  update();
}

void SceneView::set_texts(const QString& clock, const QString& banner) {
  if (clock == clock_text_ && banner == banner_) return;
  clock_text_ = clock;
  banner_ = banner;
  update();
}

void SceneView::tick() {
  const qint64 now = clock_.nsecsElapsed();
  const double dt = std::min(0.1, static_cast<double>(now - last_tick_ns_) * 1e-9);
  last_tick_ns_ = now;
  if (!isVisible() || !have_card_) return;
  if (camera_.advance(dt)) touch();
  if (to_draw_ <= 0) return;
  // a processor that draws has less left for the session: every other picture is enough
  skip_ = gl_.software && !skip_;
  if (skip_) return;
  --to_draw_;
  renderer_->set_camera(camera_);
  QPointer<SceneView> self(this);
  renderer_->draw([self](const QImage& image) {
    if (!self) return;
    const bool first = self->image_.isNull();
    self->image_ = image;
    self->update();
    if (first) Q_EMIT self->ready_changed();
  });
}

void SceneView::resizeEvent(QResizeEvent*) {
  background_ = {};
  if (!renderer_) return;
  renderer_->resize((QSizeF(size()) * devicePixelRatioF()).toSize());
  touch(4);
}

QVector3D SceneView::grasp_point(uint32_t object) const {
  // the middle of the contacts when there are some, else the object itself
  if (snapshot_->n_contact > 0) {
    QVector3D sum;
    for (uint32_t i = 0; i < snapshot_->n_contact; ++i) sum += to_mm(snapshot_->contact[i].p_W);
    return sum / static_cast<float>(snapshot_->n_contact);
  }
  const uint32_t body = card_.objects[object].first_body;
  return to_mm(body < snapshot_->n_body ? snapshot_->X_WB[body].p : swage_vec3{});
}

void SceneView::paint_placeholder(QPainter& painter) {
  painter.setPen(ui_["view_text"]);
  painter.drawText(
      rect().adjusted(40, 0, -40, 0), Qt::AlignCenter | Qt::TextWordWrap,
      tr("The 3D view needs OpenGL 3.3 (%1).\nEverything else works: lessons run and are recorded.")
          .arg(gl_.why));
}

void SceneView::paint_background(QPainter& painter) {
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  if (background_.size() != pixels) {
    background_ = QPixmap(pixels);
    background_.setDevicePixelRatio(devicePixelRatioF());
    QPainter p(&background_);
    QLinearGradient gradient(0, 0, 0, height());
    gradient.setColorAt(0, ui_["view_top"]);
    gradient.setColorAt(1, ui_["view_bottom"]);
    p.fillRect(rect(), gradient);
  }
  painter.drawPixmap(0, 0, background_);
}

// points that a lesson shows in the world
void SceneView::paint_marks(Overlay& overlay) const {
  for (uint32_t m = 0; cues_shown_ && m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    const auto& mark = card_.script.marks[m];
    if (mark.mark.kind != SWAGE_MARK_POINT) continue;
    const uint32_t cue = snapshot_->mark_cue[m];
    const std::string meaning = cue < card_.script.cues.size() ? card_.script.cues[cue].id : mark.meaning;
    overlay.target(camera_.project(to_mm(snapshot_->mark_p_W[m]), size()),
                   mark.mark.number[0] * kMmPerM / camera_.mm_per_pixel(height()),
                   cues_.style(QString::fromStdString(meaning)));
  }
}

void SceneView::paint_forces(Overlay& overlay) const {
  for (uint32_t c = 0; forces_shown_ && c < snapshot_->n_contact; ++c) {
    const QVector3D p = to_mm(snapshot_->contact[c].p_W);
    const swage_vec3& f = snapshot_->contact[c].f_W;
    const auto mm = static_cast<float>(kForceScale_px * camera_.mm_per_pixel(height()));
    const QVector3D arrow(static_cast<float>(f.x), static_cast<float>(f.y), static_cast<float>(f.z));
    overlay.force(camera_.project(p, size()), camera_.project(p + mm * arrow, size()));
  }
}

void SceneView::paint_cues(Overlay& overlay) const {
  int slot = 0;
  for (uint32_t o = 0; o < card_.objects.size(); ++o) {
    const QString cue = cue_of(o);
    if (cue.isEmpty()) continue;
    const QPointF at = camera_.project(grasp_point(o), size());
    if (slot == 0 && hold_ > 0) overlay.ring(at, hold_);
    // the tool's own cue (too much force) goes to the left, that of the work to the right
    const bool tool = role_of(card_, o) == Role::kTool;
    overlay.cue(at, cues_.style(cue), tool ? 1 : 0);
    ++slot;
  }
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_background(painter);
  if (!renderer_) return paint_placeholder(painter);
  if (!image_.isNull()) {
    // during a resize the last picture is stretched
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != background_.size());
    painter.drawImage(rect(), image_);
  }
  Overlay overlay(painter, rect(), ui_);
  if (have_card_) overlay.scale_bar(camera_.mm_per_pixel(height()));
  if (have_snapshot_) {
    paint_marks(overlay);
    paint_forces(overlay);
    paint_cues(overlay);
  }
  if (!clock_text_.isEmpty()) overlay.clock(clock_text_);
  if (!banner_.isEmpty()) overlay.banner(banner_);
  if (instrument_ && !hasFocus()) overlay.hint(tr("Click here: then mouse and keys move the instrument"));
  if (hasFocus()) {
    painter.setPen(QPen(ui_["accent"], 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
}

}  // namespace swage::console
