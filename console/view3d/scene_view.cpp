// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_view.hpp"

#include <swage/abi/lesson.h>

#include <QPointer>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "console/view3d/overlay.hpp"

namespace swage::console {
namespace {

constexpr int kTick_ms = 16;
constexpr int kFirstPictures = 16;  // shaders and meshes load in the background: the first pictures are empty
constexpr qint64 kPatience_ms =
    30000;  // so long an empty picture is taken for one that is still being loaded
constexpr double kLeastThread_px = 2.2;  // a 10-0 suture has one pixel where the picture shows 15 mm: it would come and go
constexpr float kLift_mm = 0.004F;  // the grid lies so far above its stage, so that it does not flicker
constexpr float kRoom = 1.2F;        // space around what is framed

// steel while it only springs, orange where it begins to stay bent, red at one and a half times that
QColor stressed(const QColor& steel, double share) {
  const QColor yields(0xff, 0x8c, 0x1a), ruined(0xd4, 0x07, 0x06);
  const auto mix = [](const QColor& a, const QColor& b, double u) {
    const auto f = static_cast<float>(std::clamp(u, 0.0, 1.0));
    return QColor::fromRgbF(a.redF() + f * (b.redF() - a.redF()), a.greenF() + f * (b.greenF() - a.greenF()),
                            a.blueF() + f * (b.blueF() - a.blueF()));
  };
  return share <= 1 ? mix(steel, yields, 2 * share - 1) : mix(yields, ruined, 2 * share - 2);
}

// the top of the tissue: shadows alone, which tell how far a point still is from it
Floor shelf_of(const Ground& level) {
  Floor floor;
  floor.shown = level.on_stage;
  floor.z = level.z + kLift_mm;
  floor.centre = level.centre;
  floor.half_x = level.half_x;
  floor.half_y = level.half_y;
  floor.radius = 4 * std::max(level.half_x, level.half_y);
  floor.reach = 2;
  return floor;
}

// one colour only
bool is_plain(const QImage& image) {
  for (int y = 0; y < image.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
    const QRgb first = reinterpret_cast<const QRgb*>(image.constScanLine(0))[0];
    if (std::any_of(line, line + image.width(), [&](QRgb p) { return p != first; })) return false;
  }
  return true;
}

}  // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent), gl_(probe_gl()), snapshot_(std::make_unique<snapshot::Snapshot>()) {
  setObjectName(QStringLiteral("scene_view"));
  setAccessibleName(tr("Live view of the scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  setAttribute(Qt::WA_OpaquePaintEvent);
  if (gl_.ok) renderer_ = make_qt3d_renderer(4, 3);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SceneView::tick);
  clock_.start();
  if (renderer_) timer_.start(kTick_ms);
}

SceneView::~SceneView() = default;

void SceneView::touch(int pictures) {
  to_draw_ = std::max(to_draw_, pictures);
  alike_ = 0;
}

void SceneView::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_ = ui;
  cues_ = cues;
  background_ = {};
  if (have_card_) colour_parts();
  for (size_t i = 0; ghost_ && i < ghost_->part.size(); ++i) renderer_->set_surface(ghost_->part[i].first, {ui_["ghost"], 0, 0, Finish::kGhost});
  touch();
  update();
}

void SceneView::set_card(const snapshot::SceneCard& card, CameraPreset preset) {
  card_ = card;
  parts_ = make_parts(card);
  have_card_ = true;
  have_snapshot_ = false;
  led_ = SWAGE_NONE;
  image_ = {};
  image_parts_.clear();
  second_ = {};
  ghost_.reset();
  since_card_.start();
  camera_.frame(parts_.focus.centre(), kRoom * std::max(parts_.focus.radius(), 0.3F));
  near_ = {};
  camera_.look(preset_ = preset);
  look_aside();
  camera_.jump();
  if (!renderer_) return update();
  renderer_->clear();
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    const ScenePart& part = parts_.part[i];
    const bool carries = parts_.ground.on_stage && i == parts_.ground.part;
    const bool casts = part.role != Role::kMark && !carries;
    const bool moves = casts && !part.soft && part.role != Role::kStage;
    renderer_->add_part(part.mesh, surface_of(part), {casts, moves});
  }
  add_wounds();
  dented_.clear();
  wound_ = {};
  wounds_drawn_ = false;
  loupe_mm_ = 0;
  colour_parts();
  place_parts();
  touch(kFirstPictures);
}

Surface SceneView::surface_of(const ScenePart& part) const {
  if (part.soft) return {ui_["tissue"], 0, 60, Finish::kMoist};
  switch (part.role) {
    case Role::kTool:
      return {ui_["tool"], 0.7F, 60, Finish::kBrushed};
    case Role::kStage:
      return {ui_["stage"], 0, 12};
    case Role::kMark: {
      if (part.collar) return {Qt::white, 0, 30};
      const judge::Script::Mark& mark = card_.script.marks[part.mark];
      return {cues_.style(QString::fromStdString(mark.meaning)).colour, 0, 30};
    }
    case Role::kWork:
    case Role::kOther:
      break;
  }
  if (part.thread >= 0) return {ui_["thread"], 0.1F, 60};
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
    if (part.role == Role::kWork && part.chain >= 0 && stress_shown_)
      surface.colour = stressed(surface.colour, stress_);
    // a wound is seen on tissue in its own colour only
    if (part.role != Role::kMark && !part.soft && !cue.isEmpty())
      surface = {cues_.style(cue).colour, 0.25F, 40, surface.finish};
    renderer_->set_surface(static_cast<int>(i), surface);
  }
  colour_wounds();
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
  renderer_->set_shelf(shelf_of(parts_.shelf));
}

void SceneView::place_parts() {
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    if (parts_.part[i].thread >= 0) {
      place_thread(static_cast<int>(i));
      continue;
    }
    if (parts_.part[i].chain >= 0) {
      if (have_snapshot_)
        renderer_->set_mesh(static_cast<int>(i), chain_mesh(parts_, parts_.part[i],
                                                            std::span(snapshot_->X_WB, snapshot_->n_body)));
      continue;
    }
    const uint32_t body = parts_.part[i].body;
    const swage_pose& X =
        have_snapshot_ && body < snapshot_->n_body ? snapshot_->X_WB[body] : card_.start[body];
    QMatrix4x4 m;
    m.translate(to_mm(X.p));
    m.rotate(to_qt(X.q));
    renderer_->set_pose(static_cast<int>(i), m);
  }
  if (!have_snapshot_) return;
  place_soft();
}

// Of its true thickness, but where that could not be seen.
void SceneView::place_thread(int part) {
  const ScenePart& of = parts_.part[static_cast<size_t>(part)];
  const ThreadLine& thread = parts_.threads[static_cast<size_t>(of.thread)];
  const uint32_t last = thread.first + thread.vertices();
  const std::span<const double> p_W = have_snapshot_ && last <= snapshot_->n_particle
                                          ? std::span(snapshot_->particle_p_W + 3 * thread.first, thread.start.size())
                                          : std::span(thread.start);
  const Panel first = panels().front();
  const double mm_per_px = first.view.eye.mm_per_pixel(first.size.height());
  renderer_->set_mesh(part, thread_mesh(parts_, of, p_W, 0.5 * kLeastThread_px * mm_per_px / kMmPerM));
}

// in sixteenths of first yield: a colour that changes with every step would be sent to the renderer with every step
bool SceneView::read_signals(const snapshot::Snapshot& snapshot) {
  double stress = 0;
  pierced_ = false;
  for (uint32_t i = 0; i < snapshot.n_signal && i < card_.script.signals.size(); ++i) {
    const std::string& id = card_.script.signals[i].id;
    if (id == "pierce.state") pierced_ |= snapshot.signal[i] > 1.5;  // 2: in the tissue
    if (stress_shown_ && id == "needle.stress") stress = std::max(stress, snapshot.signal[i]);
  }
  const double rounded = std::round(16 * std::min(stress, 2.0)) / 16;
  return std::exchange(stress_, rounded) != rounded;
}

void SceneView::set_stress_shown(bool shown) {
  stress_shown_ = shown;
  if (have_snapshot_) read_signals(*snapshot_);
  if (have_card_) colour_parts();
  touch();
}

void SceneView::show_snapshot(const snapshot::Snapshot& snapshot) {
  const bool recolour =
      read_signals(snapshot) || !have_snapshot_ ||
      !std::equal(snapshot.object_cue, snapshot.object_cue + snapshot.n_object, snapshot_->object_cue);
  const bool same =
      have_snapshot_ && snapshot.step == snapshot_->step && snapshot.time_s == snapshot_->time_s;
  *snapshot_ = snapshot;
  if (moved_ns_ >= 0 && sampled_ns_ < 0 && !same) sampled_ns_ = moved_ns_;
  follow_led_tool();
  const bool first = !std::exchange(have_snapshot_, true);
  look_near();
  if (first && near_) camera_.jump();
  if (!renderer_) return;
  if (recolour) colour_parts();
  if (same) return;
  place_parts();
  // under a drag the picture stands still: what is dragged stays under the pointer
  if (!dragging_ && parts_.watched >= 0 && static_cast<uint32_t>(parts_.watched) < snapshot.n_body) {
    const swage_pose& X = snapshot.X_WB[parts_.watched];
    camera_.follow(to_mm(X.p) + to_qt(X.q).rotatedVector(parts_.watched_middle));
  }
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

void SceneView::set_task(const QString& task) {
  if (task == task_) return;
  task_ = task;
  if (stereo_) update();
}

void SceneView::set_message(const QString& words) {
  if (words == message_) return;
  message_ = words;
  if (stereo_) update();
}

void SceneView::tick() {
  const qint64 now = clock_.nsecsElapsed();
  const double dt = std::min(0.1, static_cast<double>(now - last_tick_ns_) * 1e-9);
  last_tick_ns_ = now;
  if (!isVisible() || !have_card_) return;
  if (camera_.advance(dt)) {
    for (size_t i = 0; i < parts_.part.size(); ++i)
      if (parts_.part[i].thread >= 0 && renderer_) place_thread(static_cast<int>(i));
    touch();
  }
  move_second(dt);
  if (resting()) {
    moved_ns_ = sampled_ns_ = drawn_ns_ = -1;
    return frames_.rest();
  }
  // a processor that draws has less left for the session: every other picture is enough
  skip_ = gl_.software && !skip_;
  if (skip_) return;
  to_draw_ = std::max(0, to_draw_ - 1);
  std::vector<View> views;
  const std::vector<Panel> parts = panels();
  for (const Panel& panel : parts) views.push_back(panel.view);
  renderer_->set_views(views);
  if (sampled_ns_ >= 0 && drawn_ns_ < 0) drawn_ns_ = sampled_ns_;
  QPointer<SceneView> self(this);
  renderer_->draw([self, parts](const QImage& image) {
    if (self) self->arrived(image, parts);
  });
}

// Goes on drawing until the picture stands still: a slow machine is still loading when a fast one has long finished.
void SceneView::arrived(const QImage& image, const std::vector<Panel>& parts) {
  const bool empty = image.isNull() || (image.pixelColor(0, 0).alpha() == 0 && is_plain(image));
  if (empty && since_card_.elapsed() < kPatience_ms) {
    alike_ = 0;
    return;
  }
  const bool first = image_.isNull();
  alike_ = image == image_ ? alike_ + 1 : 0;
  image_ = image;
  frames_.add(clock_.nsecsElapsed());
  if (drawn_ns_ >= 0) {
    shows_ns_ = drawn_ns_;
    moved_ns_ = sampled_ns_ = drawn_ns_ = -1;
  }
  image_parts_ = parts;
  update();
  if (first) Q_EMIT ready_changed();
}

void SceneView::resizeEvent(QResizeEvent*) {
  background_ = {};
  lay_out();
}

}  // namespace swage::console
