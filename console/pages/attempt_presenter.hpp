// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shows an attempt: each frame and event goes to the pictures, to the panels that are read beside them, to the list of what happened, to
// the loudspeaker and to the status strip. In a test a trainee's views and panels show no answers. It starts and ends nothing but the
// expert's ghost, which goes along with the pictures. [main]
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
  /// What it reads and writes to; all outlive it.
  struct Parts {
    RunControl* control;            // whose attempt is shown
    const SetupPanel* setup;        // lesson and mode
    const AttemptOptions* options;  // catalogue of plugins
    ViewBar* bar;                   // what the pictures are to show
    EventLog* events;
    StatusStrip* strip;
  };
  explicit AttemptPresenter(const Parts& parts, QObject* parent = nullptr);

  /// A picture of the attempt, until it is destroyed. The first is the page's own, others show what it shows.
  void add_view(SceneView* view);
  enum class For { kTrainee, kInstructor };  // whether a test hides its answers
  /// Readings and cues beside the pictures, from now on; they outlive the presenter. The first are the page's own, others show the scene
  /// that is there already.
  void add_panels(NowPanel* now, CueLegend* legend, For reader);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  const UiTheme& ui_theme() const { return ui_theme_; }
  const CueTheme& cue_theme() const { return cue_theme_; }
  /// A camera preset, now and for every scene shown from now on.
  void look(CameraPreset preset);
  /// For the next scene only; the pictures stay as they are.
  void set_next_look(CameraPreset preset) { preset_ = preset; }

  /// The scene of the chosen lesson, or of the attempt that begins; `asked`: what the lesson asks for.
  void show_card(const snapshot::SceneCard& card, const Criteria& asked);
  /// A lesson that cannot run shows its title and task, and nothing of the lesson before.
  void show_no_scene(const QString& title, const Criteria& asked);
  /// Clears list, clock and hold of the last attempt.
  void forget();
  /// Before an attempt: clears the list of events, advice and sounds.
  void clear();
  /// The attempt is about to begin: the guide is opened where one is wanted. `like`: the lesson as it is played, with its seed.
  /// Returns how the trainee sees the scene, for the head of the record.
  record::Display begin(const session::Options& like, bool guide_wanted);
  /// The attempt is over, `banner` is its outcome.
  void end(double simulated_s, const QString& banner);

  /// After every change of the run's state: runs, pauses, rests.
  void update_state();
  /// After every change of mode or of what the cues' button says.
  void update_cues();
  void update_insets();
  void update_frame();

  /// How the trainee sees the scene: in the view that was added last and is open, else in the first.
  record::Display display() const;
  bool is_test() const { return parts_.setup->mode() == QLatin1String("test"); }
  GuideControl& guide() { return guide_; }
  const GuideControl& guide() const { return guide_; }
  /// In the middle of an attempt; nothing between two.
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
  record::Display seen_;  // while an attempt runs: as it was when last told to its record
  QElapsedTimer rate_clock_;
  uint64_t rate_steps_ = 0;  // step at which that clock was started
};

}  // namespace swage::console
