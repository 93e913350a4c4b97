// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The live picture: the 3D scene, and over it the scale, the cue at the grasp, the clock. Works without
// OpenGL, too: then it says so, and the rest of the window goes on.
//
// The picture has one panel, or two: a second view at right angles near the jaws, or the two eyes of a trainee.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"
#include "console/link/pointer_input.hpp"
#include "console/view3d/frame_times.hpp"
#include "console/view3d/needle_circle.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/scene_parts.hpp"
#include "console/view3d/stereo_look.hpp"
#include "console/view3d/wound_surface.hpp"
#include "record/display.hpp"

namespace swage::console {

class Overlay;

class SceneView : public QWidget {
  Q_OBJECT
 public:
  explicit SceneView(QWidget* parent = nullptr);
  /// For two eyes: nothing but the scene and its cues.
  void set_stereo(const StereoLook& look);
  /// A mark of a registration over the picture, mm from its middle, +y up; where the size of the screen is known.
  void set_station_mark(const std::optional<QPointF>& at_mm);
  /// How the scene is seen here, for the record of an attempt.
  record::Display display() const;
  ~SceneView() override;

  const GlProbe& gl() const { return gl_; }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_card(const snapshot::SceneCard& card, CameraPreset preset = CameraPreset::kOrbit);
  /// Copies what it needs; call at display rate.
  void show_snapshot(const snapshot::Snapshot& snapshot);
  void look(CameraPreset preset);
  OrbitCamera& camera() { return camera_; }
  /// Cues are hidden in Test mode, and by choice.
  void set_cues_shown(bool shown);
  bool cues_shown() const { return cues_shown_; }
  void set_forces_shown(bool shown);
  /// Colours a bending needle by its stress; for the instructor.
  void set_stress_shown(bool shown);
  /// Over the picture: the clock at the right, a banner in the middle ("" for none).
  void set_texts(const QString& clock, const QString& banner);
  /// The task, for a trainee's view, which shows it over the lower edge beside clock and verdict.
  void set_task(const QString& task);
  /// What an instructor says, for a trainee's view; "" for nothing.
  void set_message(const QString& words);
  const QString& message() const { return message_; }
  /// Over the lower edge: how the instrument is moved, for a person who has not done it yet. Each goes once it was used.
  void set_control_hints(bool drag, bool close, bool drive);
  /// Share of a hold that is done, drawn as a ring at the grasp; 0 for none.
  void set_hold(double share);
  /// A second view at right angles, near the jaws: it shows the depth to a person who has only a mouse.
  void set_second_shown(bool shown);
  /// A magnified view of the wound while there is one.
  void set_loupe_shown(bool shown);
  /// While true, mouse and keys drive the instrument and not the camera.
  void set_instrument(bool on);
  bool instrument() const { return instrument_; }
  /// Instruments of somebody else in this scene, seen through, with a name at their tips: until the next card, or without a card. The
  /// card is of the same lesson; bodies are its.
  void set_ghost(const snapshot::SceneCard* card, const QString& name = {});
  /// Where they are; none: they are not shown.
  void show_ghost(std::span<const swage_pose> X_WB);
  bool ghost_shown() const { return ghost_ && ghost_->shown; }
  /// A picture of the scene has arrived since the last card.
  bool ready() const { return !image_.isNull(); }
  QImage image() const;
  /// Nothing moves, and the last pictures were alike: what is seen is what there is, however slow the machine.
  bool resting() const { return to_draw_ == 0 && alike_ >= kAlike; }
  const FrameTimes& frames() const { return frames_; }
  /// From a movement of mouse or key to the first picture painted that can show it, as far as software sees.
  const FrameTimes& latency() const { return latency_; }
  /// Draws again although nothing moved.
  void redraw() { touch(); }

 Q_SIGNALS:
  void pointer(const swage_pointer& input);
  /// Comes before the pointer that drives the needle along it; nothing when there is no needle at the tips. World, as shown.
  void circle(const std::optional<NeedleCircle>& about);
  void ready_changed();
  /// By keys, a pedal that sends them, or the wheel.
  void microscope_zoomed(float zoom);
  /// The person has done what a hint told, or turned the view: "drag", "close", "drive", "view".
  void control_used(const QString& what);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  static constexpr int kAlike =
      3;  // pictures in a row; less, and a mesh that is still being loaded is missed
  enum class Inset { kNone, kDepth, kWound };
  /// A part of the widget in which the scene is seen by one eye.
  struct Panel {
    QRectF at;    // on the widget
    QSizeF size;  // it is painted as large as this and then pressed into `at`
    View view;    // and where it lies in the renderer's picture
    Inset inset = Inset::kNone;
  };
  struct Ghost {
    QString name;
    std::vector<std::pair<int, uint32_t>> part;  // of the renderer, and its body
    std::vector<std::vector<Spot>> tips;         // of each instrument
    std::vector<swage_pose> X_WB;
    bool shown = false;
  };
  void paint_ghost(Overlay& overlay, const Panel& panel) const;
  std::vector<Panel> panels() const;
  std::array<Eye, 2> eyes(const QSizeF& own) const;
  void lay_out();
  QSize canvas() const;  // the renderer's picture: all panels beside each other
  Panel panel_at(const QPointF& position) const;
  void move_second(double dt_s);
  QRectF corner_at(int corner, double shape) const;
  Panel loupe() const;
  void show_loupe();
  void choose_loupe_corner();
  void choose_corner(const QVector3D& tips, const QVector3D& aim);
  void look_from(const QPointF& position);
  swage_pointer moved(const QPointF& from, const QPointF& to);
  QVector3D place_of(const Spot& spot) const;
  QVector3D middle_of_tips() const;
  QVector3D aim_near(const QVector3D& tips) const;
  const Panel* drawn(const Panel& panel, size_t index) const;
  void paint_panel(QPainter& painter, const Panel& panel, size_t index);
  void paint_eyes(QPainter& painter, const std::vector<Panel>& all);
  void paint_frame(QPainter& painter, const Panel& inset) const;
  void paint_words(QPainter& painter);
  QString hint() const;
  void used(const char* what);
  void tick();
  void touch(int pictures = 3);
  void arrived(const QImage& image, const std::vector<Panel>& parts);
  bool read_signals(const snapshot::Snapshot& snapshot);  // true when the colour changes
  void place_parts();
  void place_thread(int part);
  void colour_parts();
  void look_near();
  void look_aside();
  void add_wounds();
  void colour_wounds();
  void place_soft();
  Surface surface_of(const ScenePart& part) const;
  QString cue_of(uint32_t object) const;
  bool moves_camera(const QMouseEvent& event) const;
  void wrap_pointer(const QPoint& global);
  QVector3D grasp_point(uint32_t object) const;
  void paint_background(QPainter& painter, const QRectF& at);
  void paint_placeholder(QPainter& painter);
  bool has_target() const;
  void tell(const swage_pointer& input);
  void tell_circle(const swage_pointer& input);
  void follow_led_tool();
  void paint_led(Overlay& overlay, const Panel& panel) const;
  void paint_station_mark(QPainter& painter, const Panel& panel) const;
  QSizeF screen_mm_per_pixel() const;
  float screen_scale() const;
  void zoom_microscope(int notches);
  /// Whether the lesson has looked at the scene yet: only then are its marks where it has drawn them.
  bool judged() const { return have_snapshot_ && snapshot_->step > 0; }
  void paint_marks(Overlay& overlay, const Panel& panel) const;
  void paint_forces(Overlay& overlay, const Panel& panel) const;
  void paint_cues(Overlay& overlay, const Panel& panel) const;
  double clear_px(uint32_t object, const Panel& panel) const;

  GlProbe gl_;
  std::unique_ptr<Renderer> renderer_;
  OrbitCamera camera_;
  UiTheme ui_;
  CueTheme cues_;
  snapshot::SceneCard card_;
  SceneParts parts_;
  std::set<int> dented_;          // parts that are not as they were at rest
  bool pierced_ = false;
  WoundPlace wound_;  // the greatest in the scene
  uint32_t wounded_object_ = 0;
  bool wounds_drawn_ = false;
  int wound_part_[3] = {-1, -1, -1};  // lip, flesh, depth
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  bool have_card_ = false, have_snapshot_ = false;
  bool cues_shown_ = true, forces_shown_ = false, instrument_ = false;
  bool stress_shown_ = false, second_shown_ = false;
  std::unique_ptr<Ghost> ghost_;
  std::optional<StereoLook> stereo_;
  std::optional<QPointF> station_mark_;
  Bounds second_;          // what the second view shows now
  bool dragging_ = false;  // a button moves the instrument: no view moves meanwhile
  Inset drags_in_ = Inset::kNone;
  int corner_ = 0;        // where the second view lies
  int loupe_corner_ = 1;  // and the loupe
  float loupe_mm_ = 0;    // radius of what the loupe shows, 0 for no loupe
  bool loupe_shown_ = true;
  double stress_ = 0;  // of first yield
  double hold_ = 0;
  QString clock_text_, banner_, task_, message_;
  bool hint_drag_ = false, hint_close_ = false, hint_drive_ = false;
  bool turned_view_ = false;  // a drag turned the view while no attempt took it
  QImage image_;                    // of all panels
  std::vector<Panel> image_parts_;  // as they were when it was drawn
  QPixmap background_;
  CameraPreset preset_ = CameraPreset::kOrbit;
  std::optional<QVector3D> near_;  // the mark looked at
  int to_draw_ = 0;                // pictures still wanted
  int alike_ = 0;                  // pictures in a row that were the same
  QElapsedTimer since_card_;
  FrameTimes frames_, latency_;
  qint64 moved_ns_ = -1;    // the oldest movement that no picture shows yet
  qint64 sampled_ns_ = -1;  // and that a snapshot since then may show
  qint64 drawn_ns_ = -1;    // and that the picture under way shows
  qint64 shows_ns_ = -1;    // and that the next paint brings to the screen
  bool skip_ = false;
  QTimer timer_;
  QElapsedTimer clock_;
  qint64 last_tick_ns_ = 0;
  PointerInput input_;
  uint32_t led_ = SWAGE_NONE;  // the tool that the mouse leads, of several
  bool drives_ = false;  // along the needle's circle
  QPointF last_mouse_;
};

}  // namespace swage::console
