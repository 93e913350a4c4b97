// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The attempt on the Review page: its recording, its player, its events with the notes of others; from the store or from a file. No widgets.
// GUI thread.
#pragma once

#include <memory>
#include <optional>

#include "console/link/player.hpp"
#include "console/link/school_desk.hpp"
#include "console/models/made_with.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"

namespace swage::console {

class ReviewedAttempt {
 public:
  ReviewedAttempt(RecordingReader reader, PlayerOpener opener) : reader_(std::move(reader)), opener_(std::move(opener)) {}
  ~ReviewedAttempt();
  ReviewedAttempt(const ReviewedAttempt&) = delete;
  ReviewedAttempt& operator=(const ReviewedAttempt&) = delete;

  /// Functions that open a file with an attempt, and read it.
  void set_file_services(FileOpener open, FileReader read);
  /// Reader of attempts for exports.
  void set_export(ExportReader reader) { exported_ = std::move(reader); }
  /// Direction and target of a metric in a lesson; without it metrics and worst moments have no limits.
  using MetricFinder = std::function<MetricSaid(const QString& lesson_id, const std::string& metric_id)>;
  void set_metric_finder(MetricFinder finder) { finder_ = std::move(finder); }
  /// The desk for notes and ratings; without it none can be made. It outlives the attempt.
  void set_desk(SchoolDesk* desk) { desk_ = desk; }

  /// Opens an attempt by its id or a unique prefix of it. Returns "" or the error. What was open is closed, also on failure.
  QString open(std::shared_ptr<record::Store> store, const QString& id);
  QString open_file(const QString& file);
  void close();
  bool is_open() const { return !review_.attempt.id.empty(); }
  /// Reads the events of the attempt, the notes and the ratings again.
  void read_moments();

  /// Both stay at their place for the life of this object.
  const Review& review() const { return review_; }
  const record::Recording& recording() const { return recording_; }
  const QVector<WorstMoment>& worst() const { return worst_; }
  Player* player() const { return player_.get(); }  // nullptr where the scene cannot be built
  /// Why there is no player, as the host says it; "" where there is one.
  const QString& why_no_player() const { return no_player_; }
  /// Its lesson reads the knot of a thread, so that a copy of it can be pulled.
  bool has_knot() const;

  bool from_store() const { return from_store_; }
  record::Store* store() const { return store_.get(); }
  /// Reads another attempt of the store. Returns "" or the error.
  QString read_other(const std::string& id, record::AttemptRow& row, record::Recording& recording) const;
  const PlayerOpener& opener() const { return opener_; }

  bool can_note() const { return from_store_ && desk_ && desk_->school(); }
  /// A note at a time of the attempt, s.
  bool add_note(const QString& text, double time_s);
  /// Sets an instructor's points for an item of a scale. False: desk_problem() has the reason.
  bool rate(const QString& item_id, std::optional<double> points);
  QString desk_problem() const { return desk_ ? desk_->problem() : QString(); }
  std::vector<record::Note> notes() const;
  /// Export data of the attempt; empty when it cannot be read.
  std::vector<record::Exported> exported() const;

 private:
  bool find(const std::string& id, record::AttemptRow& out) const;
  QString show(const QString& id, const RecordingReader& reader);

  RecordingReader reader_;
  PlayerOpener opener_;
  FileOpener open_file_;
  FileReader read_file_;
  ExportReader exported_;
  MetricFinder finder_;
  SchoolDesk* desk_ = nullptr;
  std::shared_ptr<record::Store> store_;
  std::string file_;         // of the attempt, "" for the store
  bool from_store_ = false;  // notes can be stored
  record::Recording recording_;
  Review review_;
  QVector<WorstMoment> worst_;
  std::unique_ptr<Player> player_;  // refers to the recording
  QString no_player_;
};

}  // namespace swage::console
