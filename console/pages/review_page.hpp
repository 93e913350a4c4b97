// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Review page: playback of one attempt. Picture, traces and events follow one cursor.
#pragma once

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "console/link/player.hpp"
#include "console/link/school_desk.hpp"
#include "console/models/made_with.hpp"
#include "console/models/reading.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/cue_legend.hpp"
#include "console/widgets/timeline.hpp"
#include "console/widgets/track_plot.hpp"

namespace swage::console {

class Comparison;
class RatingPanel;

class ReviewPage : public QWidget {
  Q_OBJECT
 public:
  ReviewPage(RecordingReader reader, PlayerOpener opener, QWidget* parent = nullptr);
  ~ReviewPage() override;
  void set_themes(const UiTheme& ui, const CueTheme& cues);

  /// Shows an attempt of the store. On failure false, and the page shows the reason.
  bool open(std::shared_ptr<record::Store> store, const QString& attempt_id);
  /// Sets the functions that open a file with an attempt, and read it.
  void set_file_services(FileOpener open, FileReader read);
  /// Sets the reader of attempts for exports.
  void set_export(ExportReader reader) { exported_ = std::move(reader); }
  bool open_file(const QString& file);
  /// Writes the attempt in the format of the extension: .swage (everything), .csv (signals), or the summary. Returns "" or the error.
  QString write_swage(const QString& file);
  QString write_signals(const QString& file);
  QString write_summary(const QString& file);

  const Review& review() const { return review_; }
  Timeline* timeline() { return timeline_; }
  SceneView* view() { return view_; }
  const Player* player() const { return player_.get(); }
  bool playing() const { return playing_; }
  /// Sets the desk for notes; without it none can be made. It outlives the page.
  void set_desk(SchoolDesk* desk);
  /// Adds a note at the cursor.
  bool add_note(const QString& text);
  void go(double time_s);
  /// Direction and target of a metric in a lesson; without it worst moments have no limits.
  using MetricFinder = std::function<MetricSaid(const QString& lesson_id, const std::string& metric_id)>;
  void set_metric_finder(MetricFinder finder) { finder_ = std::move(finder); }
  const QVector<WorstMoment>& worst() const { return worst_moments_; }
  /// Shows another attempt of the store beside this one. On failure false, and the page shows the reason.
  bool compare(const QString& attempt_id);
  Comparison* comparison() { return other_; }
  bool comparing() const;
  /// Writes the printed report of the attempt. Returns "" or the error.
  QString write_report(const QString& file);

 public Q_SLOTS:
  void toggle_play();
  /// Switches the loop over a second before and after the cursor.
  void set_loop(bool on);
  void ask_note();
  void ask_compare();
  void end_comparison();
  /// Moves the cursor to the worst moment, then to the next.
  void to_next_worst();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 Q_SIGNALS:
  void back();
  /// A saved attempt is to be opened.
  void ask_file();

 private:
  QWidget* make_empty();
  QWidget* make_head();
  QWidget* make_view();
  QWidget* make_transport();
  QWidget* make_cameras(QWidget* box);
  void add_exports(QHBoxLayout* row, QWidget* box);
  void add_keys();
  void set_exports_enabled(bool on);
  bool find_attempt(const std::string& id, record::AttemptRow& out);
  QWidget* make_side();
  void make_tables(QWidget* tabs);
  void show_review(const base::Problems& problems);
  void fill_side();
  void fill_metrics();
  void rate(const QString& item_id, std::optional<double> points);
  void fill_worst();
  void to_worst(int row);
  void loop_worst(int row);
  void show_comparison();
  void set_ghost();
  void move_ghost();
  void fill_traces();
  void show_traces();
  void show_problem(const QString& text);
  void save(const QString& title, const QString& ending, QString (ReviewPage::*write)(const QString&));
  void tick();
  void show_player();
  void step_by(double seconds) { go(timeline_->cursor() + seconds); }

  void read_moments();

  RecordingReader reader_;
  SchoolDesk* desk_ = nullptr;
  PlayerOpener opener_;
  bool show_attempt(const QString& attempt_id, const RecordingReader& reader);

  std::vector<record::Exported> exported() const;  // export data of the shown attempt; empty when it cannot be read

  ExportReader exported_;
  std::string file_;  // file of the attempt, "" for the store
  FileOpener open_file_;
  FileReader read_file_;
  std::shared_ptr<record::Store> store_;
  record::Recording recording_;
  Review review_;
  std::unique_ptr<Player> player_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  Reader reading_;

  QLabel *headline_ = nullptr, *verdict_ = nullptr, *note_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QLabel* problem_ = nullptr;
  SceneView* view_ = nullptr;
  Timeline* timeline_ = nullptr;
  CueLegend* legend_ = nullptr;
  QTableWidget *metrics_ = nullptr, *moments_ = nullptr, *worst_ = nullptr;
  RatingPanel* ratings_ = nullptr;
  QVector<WorstMoment> worst_moments_;
  bool worst_shown_ = false;  // a worst moment was visited since the attempt was opened
  MetricFinder finder_;
  QHBoxLayout* pictures_ = nullptr;
  QBoxLayout* transport_ = nullptr;  // playback and views: one row, or two on a narrow page
  QVector<QAction*> exports_;
  Comparison* other_ = nullptr;  // made on first use
  QListWidget* traces_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  TrackPlot* track_ = nullptr;
  QPushButton* play_ = nullptr;
  QComboBox* speed_ = nullptr;
  QDoubleSpinBox* time_ = nullptr;
  UiTheme ui_;
  CueTheme cues_;
  QTimer timer_;
  QElapsedTimer clock_;
  double wanted_s_ = 0, loop_from_s_ = 0, loop_to_s_ = 0;
  QPushButton *report_ = nullptr, *export_ = nullptr, *loop_ = nullptr, *note_button_ = nullptr, *compare_ = nullptr;
  bool playing_ = false, technical_ = false;
  bool from_store_ = false;  // notes can be stored
};

}  // namespace swage::console
