// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_view.hpp"

#include <QPainter>
#include <QPointer>
#include <QScreen>
#include <algorithm>

#include "console/view3d/led_tool.hpp"

namespace swage::console {
namespace {

constexpr int kTick_ms = 16;
constexpr int kSamples = 4, kMostViews = 3;
constexpr int kFirstPictures = 16;  // pictures drawn at least: shaders and meshes load in the background, and the first pictures are empty
constexpr float kMostRoom = 1.6F;  // times the usual distance: from further away a needle is too small to be judged
constexpr qint64 kPatience_ms = 30000;  // so long an empty picture is taken for one that is still loading

// true when the image has one colour only
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
    : QWidget(parent),
      gl_(probe_gl()),
      renderer_(gl_.ok ? make_qt3d_renderer(kSamples, kMostViews) : nullptr),
      ghost_(renderer_.get()),
      input_(new SceneInput(this, scene_, point_, panels_)) {
  setObjectName(QStringLiteral("scene_view"));
  setAccessibleName(tr("Live view of the scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(320, 240);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(input_, &SceneInput::pointer, this, [this](const swage_pointer& input, qint64 due_ns) {
    pace_.moved(clock_.nsecsElapsed());
    Q_EMIT pointer(input, due_ns);
  });
  connect(input_, &SceneInput::circle, this, &SceneView::circle);
  connect(input_, &SceneInput::control_used, this, &SceneView::control_used);
  connect(input_, &SceneInput::microscope_zoomed, this, &SceneView::microscope_zoomed);
  connect(input_, &SceneInput::looked, this, [this] { touch(); });
  connect(input_, &SceneInput::words_changed, this, qOverload<>(&QWidget::update));
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SceneView::tick);
  clock_.start();
  if (!renderer_) return;
  meshes_ = std::make_unique<SceneMeshes>(*renderer_, scene_, shown_);
  timer_.start(kTick_ms);
}

SceneView::~SceneView() = default;

void SceneView::touch(int pictures) { pace_.want(pictures); }

void SceneView::measure() {
  panels_.set_area(size(), devicePixelRatioF());
  point_.set_screen(screen() ? screen()->size() : size());
}

// To be called when the size of the widget, its insets or its eyes changed.
void SceneView::lay_out() {
  measure();
  if (whole_shape_ > 0) point_.camera.set_room(std::clamp(whole_shape_ / shape_of(size()), 1.F, kMostRoom));
  if (renderer_) renderer_->resize(panels_.canvas());
  touch(4);
  update();
}

void SceneView::set_whole_width(float shape) {
  whole_shape_ = shape;
  lay_out();
}

void SceneView::apply(PanelLayout::Change change) {
  if (change == PanelLayout::Change::kLaidOut) lay_out();
  if (change == PanelLayout::Change::kMoved) touch();
}

void SceneView::colour() {
  if (scene_.have_card() && meshes_) meshes_->colour();
}

void SceneView::set_themes(const UiTheme& ui, const CueTheme& cues) {
  shown_.ui = ui;
  shown_.cues = cues;
  painter_.forget_background();
  colour();
  ghost_.colour(ui);
  touch();
  update();
}

void SceneView::set_card(const snapshot::SceneCard& card, CameraPreset preset) {
  scene_.set_card(card);
  painter_.forget_background();
  picture_ = {};
  panels_.clear();
  ghost_.forget();
  since_card_.start();
  point_.frame(preset);
  if (!meshes_) return update();
  meshes_->build(panels_.mm_per_pixel());
  set_wound();
  touch(kFirstPictures);
}

void SceneView::set_wound() {
  marks_.set_wound(meshes_->soft().wound(), meshes_->soft().wounded_object());
  apply(panels_.set_wound(meshes_->soft().wound()));
}

void SceneView::show_snapshot(const snapshot::Snapshot& snapshot) {
  const SceneState::Change change = scene_.take(snapshot, shown_.stress);
  if (!change.same) pace_.sampled();
  if (change.led) update();
  if (point_.look_near() && change.first) point_.camera.jump();
  if (!meshes_) return;
  if (change.colours) meshes_->colour();
  if (change.same) return;
  meshes_->place(panels_.mm_per_pixel());
  set_wound();
  // during a drag the camera stands still, so that the tool stays under the pointer
  if (!panels_.held()) follow();
  touch();
}

// Keeps the watched object and the tips in the picture; not through a microscope, whose field is too small for both.
void SceneView::follow() {
  const auto watched = scene_.watched();
  if (!watched) return;
  if (point_.microscope() || scene_.parts().tips.empty()) return point_.camera.follow(*watched);
  point_.camera.follow_both(*watched, scene_.beside_watched(), shape_of(panels().front().size));
}

void SceneView::look(CameraPreset preset, float notches) {
  point_.look(preset);
  point_.camera.zoom(notches);
  touch();
}

void SceneView::look_close() {
  point_.look_close();
  touch();
}

bool SceneView::look_at_knot() {
  constexpr float kBelow = 0.18F;  // of the picture's height
  if (!scene_.ties() && !scene_.has_knot()) return false;
  scene_.ties() ? look(CameraPreset::kNear) : look_close();
  if (scene_.ties()) point_.camera.pan(0, -kBelow);
  point_.camera.jump();
  return true;
}

void SceneView::set_stereo(const StereoLook& look) {
  point_.set_stereo(look);
  lay_out();
}

void SceneView::set_station_mark(const std::optional<QPointF>& at_mm) {
  painter_.set_station_mark(at_mm);
  update();
}

void SceneView::set_second_shown(bool shown) { apply(panels_.show_second(shown)); }
void SceneView::set_loupe_shown(bool shown) { apply(panels_.show_loupe(shown)); }
void SceneView::set_instrument(bool on) { input_->set_instrument(on); }
void SceneView::set_control_hints(const ControlHints& hints) { input_->set_hints(hints); }

void SceneView::set_stress_shown(bool shown) {
  shown_.stress = shown;
  scene_.read_stress(shown);
  colour();
  touch();
}

void SceneView::set_cues_shown(bool shown) {
  shown_.cues_shown = shown;
  colour();
  touch();
  update();
}

void SceneView::set_forces_shown(bool shown) {
  shown_.forces = shown;
  update();
}

void SceneView::set_hold(double share) {
  if (marks_.set_hold(share)) update();
}

void SceneView::set_texts(const QString& clock, const QString& banner) {
  if (clock == words_.clock && banner == words_.banner) return;
  words_.clock = clock;
  words_.banner = banner;
  update();
}

void SceneView::set_task(const QString& task) {
  if (task == words_.task) return;
  words_.task = task;
  if (point_.stereo()) update();
}

void SceneView::set_message(const QString& words) {
  if (words == words_.message) return;
  words_.message = words;
  if (point_.stereo()) update();
}

void SceneView::set_ghost(const snapshot::SceneCard* card, const QString& name) {
  card ? ghost_.set(*card, name, shown_.ui) : ghost_.drop();
  touch();
  update();
}

void SceneView::show_ghost(std::span<const swage_pose> X_WB) {
  if (ghost_.show(X_WB)) touch();
}

void SceneView::tick() {
  const qint64 now = clock_.nsecsElapsed();
  const double dt = std::min(0.1, static_cast<double>(now - last_tick_ns_) * 1e-9);
  last_tick_ns_ = now;
  if (!isVisible() || !scene_.have_card()) return;
  measure();
  if (point_.camera.advance(dt)) {
    meshes_->place_threads(panels_.mm_per_pixel());
    touch();
  }
  apply(panels_.advance(dt));
  send_eyes();
  if (!pace_.due(gl_.software)) return;
  std::vector<View> views;
  const std::vector<Panel> parts = panels();
  for (const Panel& panel : parts) views.push_back(panel.view);
  renderer_->set_views(views);
  renderer_->set_clear_sight(point_.clear_sight());
  renderer_->set_lens(point_.lens(views.front().part.size(), views.front().eye));
  QPointer<SceneView> self(this);
  renderer_->draw([self, parts, moment = scene_.moment()](const QImage& image) {
    if (self) self->arrived({image, parts, moment});
  });
}

// Requests pictures until they no longer change: loading takes longer on a slow machine.
void SceneView::arrived(Picture&& picture) {
  const QImage& image = picture.image;
  const bool empty = image.isNull() || (image.pixelColor(0, 0).alpha() == 0 && is_plain(image));
  if (empty && since_card_.elapsed() < kPatience_ms) return pace_.empty();
  const bool first = !ready();
  pace_.arrived(clock_.nsecsElapsed(), image == picture_.image);
  picture_ = std::move(picture);
  update();
  if (first) Q_EMIT ready_changed();
}

// Texts change without a new picture, and the display needs both eyes all the time.
void SceneView::send_eyes() {
  if (!eyes_sink_ || !ready() || point_.stereo()->layout != StereoLayout::kShutter) return;
  const SceneState::At shown(scene_, picture_.moment);
  const std::vector<QImage> eye = painter_.eyes(canvas(), panels(), picture_, words_, instrument());
  if (eye.size() == 2) eyes_sink_(eye[0], eye[1]);
}

Canvas SceneView::canvas() const {
  const double ratio = devicePixelRatioF();
  return {size(), ratio, (QPointF(mapToGlobal(QPoint())) * ratio).toPoint(), font(), hasFocus()};
}

QImage SceneView::image() const {
  return picture_.panels.size() < 2 ? picture_.image : picture_.image.copy(picture_.panels.front().view.part);
}

void SceneView::paintEvent(QPaintEvent*) {
  pace_.painted(clock_.nsecsElapsed());
  QPainter painter(this);
  if (!renderer_) return painter_.paint_placeholder(painter, canvas(), gl_.why);
  measure();
  words_.hint = input_->hint(hasFocus(), scene_.led() != SWAGE_NONE, !words_.banner.isEmpty());
  const SceneState::At shown(scene_, picture_.moment);  // marks and words belong to what the picture shows
  painter_.paint(painter, canvas(), panels(), picture_, words_, input_->instrument());
}

void SceneView::resizeEvent(QResizeEvent*) {
  painter_.forget_background();
  lay_out();
}

void SceneView::mousePressEvent(QMouseEvent* event) { input_->press(event); }
void SceneView::mouseMoveEvent(QMouseEvent* event) { input_->move(event); }
void SceneView::mouseReleaseEvent(QMouseEvent* event) { input_->release(event); }
void SceneView::wheelEvent(QWheelEvent* event) { input_->wheel(event); }

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (instrument()) return mousePressEvent(event);
  look(CameraPreset::kOrbit);
}

// Tab switches to the other instrument where the mouse drives two; else it moves the focus, as everywhere.
bool SceneView::focusNextPrevChild(bool next) {
  if (instrument() && mouse_hands(scene_.card()) > 1) return false;
  return QWidget::focusNextPrevChild(next);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (!input_->key_down(event)) QWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (!input_->key_up(event)) QWidget::keyReleaseEvent(event);
}

void SceneView::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  input_->focus_lost();
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace swage::console
