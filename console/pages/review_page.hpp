// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Review page: playback of one attempt. Picture, traces and events follow one cursor.
//
// The page puts its parts together. Each job has a class of its own: the attempt and its files (ReviewedAttempt, AttemptExports), the cursor
// (Playback), the pictures of one or two attempts (ReviewPictures, Comparison), the row of controls (ReviewTransport), the tables
// (ReviewSide), the choice of another attempt (AttemptChooser).
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QWidget>
#include <optional>

#include "console/link/playback.hpp"
#include "console/link/reviewed_attempt.hpp"
#include "console/pages/attempt_exports.hpp"
#include "console/pages/review_pictures.hpp"
#include "console/pages/review_side.hpp"
#include "console/pages/review_transport.hpp"
#include "console/widgets/timeline.hpp"

namespace swage::console {

class ReviewPage : public QWidget {
  Q_OBJECT
 public:
  ReviewPage(RecordingReader reader, PlayerOpener opener, QWidget* parent = nullptr);
  ~ReviewPage() override;
  void set_themes(const UiTheme& ui, const CueTheme& cues);

  /// Shows an attempt of the store. On failure false, and the page shows the reason.
  bool open(std::shared_ptr<record::Store> store, const QString& attempt_id);
  bool open_file(const QString& file);
  /// The attempt, with the functions that read it from files and for exports.
  ReviewedAttempt& attempt() { return attempt_; }
  AttemptExports* exports() { return exports_; }

  const Review& review() const { return attempt_.review(); }
  Timeline* timeline() { return timeline_; }
  SceneView* view() { return pictures_->view(); }
  /// Another view of the attempt, a trainee's: nothing without a player.
  void add_view(SceneView* view) { pictures_->add_view(view); }
  void remove_view(SceneView* view) { pictures_->remove_view(view); }
  const Player* player() const { return attempt_.player(); }
  bool playing() const { return playback_.playing(); }
  /// The picture is on its way to the cursor, or plays.
  bool moving() const { return playback_.moving(); }
  /// Sets the desk for notes; without it none can be made. It outlives the page.
  void set_desk(SchoolDesk* desk);
  /// Adds a note at the cursor.
  bool add_note(const QString& text) { return attempt_.add_note(text, playback_.wanted_s()); }
  void go(double time_s) { playback_.go(time_s); }
  const QVector<WorstMoment>& worst() const { return attempt_.worst(); }
  /// Shows another attempt of the store beside this one. On failure false, and the page shows the reason.
  bool compare(const QString& attempt_id);
  Comparison* comparison() { return pictures_->other(); }
  bool comparing() const { return pictures_->comparing(); }

 public Q_SLOTS:
  void toggle_play() { playback_.toggle(); }
  void ask_note();
  void ask_compare();
  void ask_pull();
  void end_comparison() { pictures_->end_comparison(); }

 protected:
  void focusInEvent(QFocusEvent* event) override;

 Q_SIGNALS:
  void back();
  /// Another attempt was opened, or could not be.
  void opened();
  /// A saved attempt is to be opened.
  void ask_file();

 private:
  QWidget* make_empty();
  QWidget* make_head();
  QWidget* make_view();
  void connect_parts();
  void add_keys();
  void leave();
  bool show_opened(const QString& problem);
  void show_problem(const QString& text);
  void show_note(const QString& text);
  /// A note about the moment at the cursor, until the cursor leaves it.
  void show_note_here(const QString& text);
  void forget_moment(double time_s);
  void pull_if_asked();
  void show_review();
  void show_other();
  void show_compared();
  void fill_side();
  void show_metrics();
  void rate(const QString& item_id, std::optional<double> points);
  void loop_here();

  ReviewedAttempt attempt_;
  Playback playback_;
  std::optional<double> note_at_s_, pull_at_s_;  // moment of the note that is shown; where the knot is pulled once the picture is there
  QLabel *headline_ = nullptr, *verdict_ = nullptr, *note_ = nullptr, *problem_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  ReviewPictures* pictures_ = nullptr;
  ReviewTransport* transport_ = nullptr;
  ReviewSide* side_ = nullptr;
  Timeline* timeline_ = nullptr;
  AttemptExports* exports_ = nullptr;
  QPushButton *note_button_ = nullptr, *compare_ = nullptr, *pull_ = nullptr;
};

}  // namespace swage::console
