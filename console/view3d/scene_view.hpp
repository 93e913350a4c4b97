// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The live picture: the 3D scene, with scale, cue at the grasp and clock painted over it. Without OpenGL
// it shows why, and the rest of the window works.
//
// The widget distributes events and data. Each job has a class of its own: state of the scene (SceneState), viewpoint
// (ViewPoint), panels (PanelLayout), parts in the renderer (SceneMeshes, SoftMeshes, GhostTools), what is painted over the picture
// (SceneMarks, ScenePainter), mouse and keys (SceneInput), the time of each picture (PicturePace).
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "console/view3d/ghost_tools.hpp"
#include "console/view3d/panels.hpp"
#include "console/view3d/picture_pace.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/scene_input.hpp"
#include "console/view3d/scene_meshes.hpp"
#include "console/view3d/scene_painter.hpp"

namespace swage::console {

class SceneView : public QWidget {
  Q_OBJECT
 public:
  explicit SceneView(QWidget* parent = nullptr);
  /// The view for two eyes: only the scene and its cues.
  void set_stereo(const StereoLook& look);
  /// Receives the pictures of both eyes, at display rate, while they are shown in turn (StereoLayout::kShutter); the view shows the left.
  using EyesSink = std::function<void(const QImage& left, const QImage& right)>;
  void set_eyes_sink(EyesSink sink) { eyes_sink_ = std::move(sink); }
  /// A mark of a registration over the picture, mm from its middle, +y up; needs the size of the screen.
  void set_station_mark(const std::optional<QPointF>& at_mm);
  /// The display settings of this view, for the record of an attempt.
  record::Display display() const { return point_.display(); }
  ~SceneView() override;

  const GlProbe& gl() const { return gl_; }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_card(const snapshot::SceneCard& card, CameraPreset preset = CameraPreset::kOrbit);
  /// Copies the data that it needs; to be called at display rate.
  void show_snapshot(const snapshot::Snapshot& snapshot);
  void look(CameraPreset preset, float notches = 0);  // notches of the wheel by which it is nearer
  /// The view near, without the hands where there is a knot (view_point.hpp).
  void look_close();
  /// Looks at the knot that is tied, which is below the middle of the picture as hands work above it, or at the one that is there; false where
  /// there is none.
  bool look_at_knot();
  OrbitCamera& camera() { return point_.camera; }
  /// False in Test mode, and by choice.
  void set_cues_shown(bool shown);
  bool cues_shown() const { return shown_.cues_shown; }
  void set_forces_shown(bool shown);
  /// A picture narrower than this shape (width over height), such as one of two that are compared, shows as much across as one of this shape.
  void set_whole_width(float shape);
  /// Colours a bending needle by its stress, for the instructor.
  void set_stress_shown(bool shown);
  /// Texts over the picture: the clock at the right, a banner in the middle ("" for none).
  void set_texts(const QString& clock, const QString& banner);
  /// The task, shown in a trainee's view over the lower edge beside clock and verdict.
  void set_task(const QString& task);
  /// An instructor's message in a trainee's view; "" for none.
  void set_message(const QString& words);
  const QString& message() const { return words_.message; }
  const ViewWords& words() const { return words_; }
  /// Control hints over the lower edge, for a new user. Each disappears after its control was used.
  void set_control_hints(const ControlHints& hints);
  const ControlHints& control_hints() const { return input_->hints(); }
  /// Completed share of a hold, drawn as a ring at the grasp; 0 for none.
  void set_hold(double share);
  /// A second view at right angles, near the jaws: it shows the depth to a person with a mouse only.
  void set_second_shown(bool shown);
  /// A magnified view of the wound, if there is one.
  void set_loupe_shown(bool shown);
  /// True: mouse and keys drive the instrument instead of the camera.
  void set_instrument(bool on);
  bool instrument() const { return input_->instrument(); }
  /// Translucent instruments of another attempt, with a name at their tips; removed by the next card or by nullptr. The
  /// card is of the same lesson, and the indices of show_ghost() are its bodies.
  void set_ghost(const snapshot::SceneCard* card, const QString& name = {});
  /// Sets the poses of these instruments; empty: hides them.
  void show_ghost(std::span<const swage_pose> X_WB);
  bool ghost_shown() const { return ghost_.shown(); }
  /// True when a picture of the scene has arrived since the last card.
  bool ready() const { return !picture_.image.isNull(); }
  QImage image() const;
  /// No motion, and the last pictures were equal: the picture is complete, however slow the machine.
  bool resting() const { return pace_.resting(); }
  const FrameTimes& frames() const { return pace_.frames(); }
  /// Pictures drawn since the start.
  uint64_t drawn() const { return pace_.count(); }
  /// From a mouse or key event to the first painted picture that can show it, as far as software can measure.
  const FrameTimes& latency() const { return pace_.latency(); }
  /// Draws again although nothing changed.
  void redraw() { touch(); }

 Q_SIGNALS:
  /// `due_ns`: time of base::wall_ns() at which it takes effect; 0: at once.
  void pointer(const swage_pointer& input, qint64 due_ns);
  /// Emitted before pointer() when the needle is driven along its circle; no value without a needle at the tips. World frame, as shown.
  void circle(const std::optional<NeedleCircle>& about);
  void ready_changed();
  /// The zoom was changed by keys, a pedal that sends them, or the wheel.
  void microscope_zoomed(float zoom);
  /// The person has used a control of the hints: "drag", "close", "drive", "open".
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
  void measure();
  void lay_out();
  void apply(PanelLayout::Change change);
  void touch(int pictures = 3);
  void follow();
  void tick();
  void arrived(Picture&& picture);
  void set_wound();
  void send_eyes();
  Canvas canvas() const;
  void colour();
  std::vector<Panel> panels() const { return panels_.panels(); }

  GlProbe gl_;
  std::unique_ptr<Renderer> renderer_;  // nullptr without OpenGL
  Shown shown_;
  SceneState scene_;
  ViewPoint point_{scene_};
  PanelLayout panels_{scene_, point_};
  GhostTools ghost_;
  std::unique_ptr<SceneMeshes> meshes_;  // nullptr without a renderer
  SceneMarks marks_{scene_, shown_, ghost_};
  ScenePainter painter_{scene_, shown_, point_, marks_};
  SceneInput* input_;
  PicturePace pace_;
  ViewWords words_;
  Picture picture_;
  EyesSink eyes_sink_;
  QElapsedTimer since_card_, clock_;
  qint64 last_tick_ns_ = 0;
  float whole_shape_ = 0;  // width over height; 0: a narrow picture is cut at its sides
  QTimer timer_;
};

}  // namespace swage::console
