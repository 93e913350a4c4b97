// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shows an attempt: distributes each frame and event to the pictures, the panels beside them, the list of events, the
// loudspeaker and the status strip. In a test a trainee's views and panels show no answers. It starts and ends nothing except the
// expert's ghost, which is shown in the pictures. [main]
#pragma once

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <optional>
#include <string>

#include "console/link/run_control.hpp"
#include "console/models/event_log.hpp"
#include "console/models/lesson_facts.hpp"
#include "console/models/reading.hpp"
#include "console/pages/attempt_advice.hpp"
#include "console/pages/attempt_options.hpp"
#include "console/pages/guide_control.hpp"
#include "console/pages/now_panel.hpp"
#include "console/pages/pointer_hand.hpp"
#include "console/pages/setup_panel.hpp"
#include "console/pages/status_strip.hpp"
#include "console/pages/view_bar.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/cue_legend.hpp"

namespace swage::console {

class AttemptPresenter : public QObject {
  Q_OBJECT
 public:
  /// Sources and sinks; all outlive the presenter.
  struct Parts {
    RunControl* control;            // control of the shown attempt
    const SetupPanel* setup;        // lesson and mode
    const AttemptOptions* options;  // catalogue of plugins
    ViewBar* bar;                   // display options of the pictures
    EventLog* events;
    StatusStrip* strip;
  };
  explicit AttemptPresenter(const Parts& parts, QObject* parent = nullptr);

  /// Adds a picture of the attempt, until the view is destroyed. The first is the page's own, further ones show the same scene.
  void add_view(SceneView* view);
  /// Gives up a picture that was added, for something else to be shown in it. Not for the first one.
  void remove_view(SceneView* view);
  enum class For { kTrainee, kInstructor };  // a test hides answers from the trainee only
  /// Adds readings and cues beside the pictures; they outlive the presenter. The first are the page's own, further ones are set to the
  /// present scene.
  void add_panels(NowPanel* now, CueLegend* legend, For reader);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  const UiTheme& ui_theme() const { return ui_theme_; }
  const CueTheme& cue_theme() const { return cue_theme_; }
  /// Sets the camera preset of all present and future scenes.
  void look(CameraPreset preset);
  /// Goes on from view to view, in the order of their buttons.
  void look_next();
  /// Sets the preset of the next scene; the present pictures are not changed.
  void set_next_look(CameraPreset preset);

  /// Shows the scene of the chosen lesson, or of the attempt that begins; `asked`: the lesson's criteria.
  void show_card(const snapshot::SceneCard& card, const Criteria& asked);
  /// For a lesson that cannot run: shows its title and task, and removes the previous scene.
  void show_no_scene(const QString& title, const Criteria& asked);
  /// Clears list, clock and hold of the last attempt.
  void forget();
  /// Before an attempt: clears the list of events, advice and sounds.
  void clear();
  /// To be called when an attempt begins: opens the guide if it is wanted. `like`: options of the attempt, with its seed.
  /// Returns how the trainee sees the scene, for the head of the record.
  record::Display begin(const session::Options& like, bool guide_wanted);
  /// To be called when the attempt has ended; `banner`: its outcome.
  void end(double simulated_s, const QString& banner);
  /// The attempt is over, and the program pulls a copy of its knot.
  void show_pulling(double bears_N, double load_N);

  /// To be called after every change of the run's state: running, paused, idle.
  void update_state();
  /// To be called after every change of mode or of the cues button.
  void update_cues();
  void update_insets();
  void update_frame();

  /// How the trainee sees the scene: in the open view that was added last, else in the first.
  record::Display display() const;
  /// The picture that the trainee looks at: the open one that was added last, else the first.
  const SceneView* trainees_view() const;
  bool is_test() const { return parts_.setup->mode() == QLatin1String("test"); }
  GuideControl& guide() { return guide_; }
  const GuideControl& guide() const { return guide_; }
  /// Switches the guide during an attempt; without one no effect.
  void toggle_guide(bool on);
  /// Controls that the person has used before: their hints are not shown again.
  void set_used_controls(const QString& used);
  const QString& used_controls() const { return advice_.used(); }

 private:
  struct Panels {
    NowPanel* now;
    CueLegend* legend;
    For reader;
  };
  void set_scene(const Panels& p);
  void set_texts(const QString& clock, const QString& banner);
  void show_reading(const Reading& reading, double time_s);
  void show_health(const snapshot::Snapshot& newest);
  void change(const QString& instance, const QString& json, const QString& words);
  void hear(const judge::Event& event);
  void tell_display();
  void update_hidden();
  void update_hints();

  Parts parts_;
  RunControl* control_;
  QList<SceneView*> views_;  // the page's own first
  QList<Panels> panels_;
  GuideControl guide_{views_};
  PointerHand hand_;
  AttemptAdvice advice_;
  UiTheme ui_theme_;
  CueTheme cue_theme_;
  CameraPreset preset_ = CameraPreset::kOrbit;
  snapshot::SceneCard card_;  // of the chosen lesson, or of the attempt
  Criteria asked_;
  bool have_card_ = false;
  Reader reader_;
  record::Display seen_;  // during an attempt: the view as last recorded
  QElapsedTimer rate_clock_;
  uint64_t rate_steps_ = 0;  // step at the start of the rate measurement
};

}  // namespace swage::console
