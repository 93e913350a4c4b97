// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The live picture: the 3D scene, and over it the scale, the cue at the grasp, the clock. Works without
// OpenGL, too: then it says so, and the rest of the window goes on.
//
// The widget passes on what happens. Each job has a class of its own: what is in the scene (SceneState), from where it is looked at
// (ViewPoint), its panels (PanelLayout), its parts in the renderer (SceneMeshes, SoftMeshes, GhostTools), what is painted over the picture
// (SceneMarks, ScenePainter), mouse and keys (SceneInput), when a picture is drawn (PicturePace).
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
  /// For two eyes: nothing but the scene and its cues.
  void set_stereo(const StereoLook& look);
  /// Takes the pictures of both eyes, at display rate, while they are shown in turn (StereoLayout::kShutter); the view shows the left one.
  using EyesSink = std::function<void(const QImage& left, const QImage& right)>;
  void set_eyes_sink(EyesSink sink) { eyes_sink_ = std::move(sink); }
  /// A mark of a registration over the picture, mm from its middle, +y up; where the size of the screen is known.
  void set_station_mark(const std::optional<QPointF>& at_mm);
  /// How the scene is seen here, for the record of an attempt.
  record::Display display() const { return point_.display(); }
  ~SceneView() override;

  const GlProbe& gl() const { return gl_; }
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_card(const snapshot::SceneCard& card, CameraPreset preset = CameraPreset::kOrbit);
  /// Copies what it needs; call at display rate.
  void show_snapshot(const snapshot::Snapshot& snapshot);
  void look(CameraPreset preset);
  OrbitCamera& camera() { return point_.camera; }
  /// Cues are hidden in Test mode, and by choice.
  void set_cues_shown(bool shown);
  bool cues_shown() const { return shown_.cues_shown; }
  void set_forces_shown(bool shown);
  /// Colours a bending needle by its stress; for the instructor.
  void set_stress_shown(bool shown);
  /// Over the picture: the clock at the right, a banner in the middle ("" for none).
  void set_texts(const QString& clock, const QString& banner);
  /// The task, for a trainee's view, which shows it over the lower edge beside clock and verdict.
  void set_task(const QString& task);
  /// What an instructor says, for a trainee's view; "" for nothing.
  void set_message(const QString& words);
  const QString& message() const { return words_.message; }
  const ViewWords& words() const { return words_; }
  /// Over the lower edge: how the instrument is moved, for a person who has not done it yet. Each goes once it was used.
  void set_control_hints(const ControlHints& hints);
  const ControlHints& control_hints() const { return input_->hints(); }
  /// Share of a hold that is done, drawn as a ring at the grasp; 0 for none.
  void set_hold(double share);
  /// A second view at right angles, near the jaws: it shows the depth to a person who has only a mouse.
  void set_second_shown(bool shown);
  /// A magnified view of the wound while there is one.
  void set_loupe_shown(bool shown);
  /// While true, mouse and keys drive the instrument and not the camera.
  void set_instrument(bool on);
  bool instrument() const { return input_->instrument(); }
  /// Instruments of somebody else in this scene, seen through, with a name at their tips: until the next card, or without a card. The
  /// card is of the same lesson; bodies are its.
  void set_ghost(const snapshot::SceneCard* card, const QString& name = {});
  /// Where they are; none: they are not shown.
  void show_ghost(std::span<const swage_pose> X_WB);
  bool ghost_shown() const { return ghost_.shown(); }
  /// A picture of the scene has arrived since the last card.
  bool ready() const { return !picture_.image.isNull(); }
  QImage image() const;
  /// Nothing moves, and the last pictures were alike: what is seen is what there is, however slow the machine.
  bool resting() const { return pace_.resting(); }
  const FrameTimes& frames() const { return pace_.frames(); }
  /// Pictures drawn since the start.
  uint64_t drawn() const { return pace_.count(); }
  /// From a movement of mouse or key to the first picture painted that can show it, as far as software sees.
  const FrameTimes& latency() const { return pace_.latency(); }
  /// Draws again although nothing moved.
  void redraw() { touch(); }

 Q_SIGNALS:
  void pointer(const swage_pointer& input);
  /// Comes before the pointer that drives the needle along it; nothing when there is no needle at the tips. World, as shown.
  void circle(const std::optional<NeedleCircle>& about);
  void ready_changed();
  /// By keys, a pedal that sends them, or the wheel.
  void microscope_zoomed(float zoom);
  /// The person has done what a hint told: "drag", "close", "drive", "open".
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
  void arrived(const QImage& image, const std::vector<Panel>& panels);
  void set_wound();
  void send_eyes();
  Canvas canvas() const;
  void colour();
  std::vector<Panel> panels() const { return panels_.panels(); }

  GlProbe gl_;
  std::unique_ptr<Renderer> renderer_;  // none without OpenGL
  Shown shown_;
  SceneState scene_;
  ViewPoint point_{scene_};
  PanelLayout panels_{scene_, point_};
  GhostTools ghost_;
  std::unique_ptr<SceneMeshes> meshes_;  // with a renderer
  SceneMarks marks_{scene_, shown_, ghost_};
  ScenePainter painter_{scene_, shown_, point_, marks_};
  SceneInput* input_;
  PicturePace pace_;
  ViewWords words_;
  Picture picture_;
  EyesSink eyes_sink_;
  QElapsedTimer since_card_, clock_;
  qint64 last_tick_ns_ = 0;
  QTimer timer_;
};

}  // namespace swage::console
