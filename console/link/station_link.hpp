// SPDX-License-Identifier: LGPL-3.0-or-later
//
// This station among those of the school. A thread of its own talks to the server over a connection of its own, so that a slow server
// delays neither window nor lesson. The station's state is read twice a second, and only the newest one is kept.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QString>
#include <QThread>
#include <QTimer>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "record/stations.hpp"

namespace swage::console {

/// Connects to the stations of the school: record::Stations::open, or a test double. nullptr and `error` on failure.
using StationsOpener = std::function<std::unique_ptr<record::Stations>(std::string& error)>;

class StationWorker;

class StationLink : public QObject {
  Q_OBJECT
 public:
  using Kind = record::StationMessage::Kind;

  explicit StationLink(QObject* parent = nullptr) : QObject(parent) {}
  /// Takes this station out of the list; waits at most 3 s for the server's answer.
  ~StationLink() override;

  /// Starts the thread. Without an opener there is no server, and no signal is ever emitted.
  void start(StationsOpener opener, const QString& wanted_name);
  bool has_server() const { return worker_ != nullptr; }
  /// Source of this station's state; called in this thread.
  void set_voice(std::function<record::StationNow()> voice) { voice_ = std::move(voice); }
  /// Source of this station's picture; called in this thread when another station asks for one.
  void set_camera(std::function<QImage()> camera) { camera_ = std::move(camera); }
  /// Whether stations() is being watched.
  void watch(bool on);
  /// Reports a change at once, before the next regular report.
  void tell_now();

  /// Name by which other stations know this one, "" before the server has answered.
  const QString& name() const { return name_; }
  const std::vector<record::StationNow>& stations() const { return stations_; }
  /// s since stations() was read.
  double age_s() const { return read_.isValid() ? 1e-3 * static_cast<double>(read_.elapsed()) : 0; }
  const std::vector<record::StationMessage>& inbox() const { return inbox_; }
  const std::vector<record::StationMessage>& sent() const { return sent_; }
  /// Why the server cannot be reached, as a sentence; "" while it answers.
  const QString& problem() const { return problem_; }

  void send(const QString& to, Kind kind, const QString& body, const QString& title = {});
  void mark(const QString& station, const QString& words);
  void forget(const QString& station);
  void answer(const std::string& message_id, const QString& answer);

 Q_SIGNALS:
  void named();
  void stations_changed();
  void inbox_changed();
  void sent_changed();
  void problem_changed();
  void pictured(const QString& station, const QImage& picture, double age_s);
  /// A mark was set in the attempt's record at this time, s.
  void marked(const QString& station, double time_s);
  void refused(const QString& why);

 private:
  friend class StationWorker;
  void hear_voice();
  void photograph(const std::string& message_id);
  template <class Call>
  void ask(Call call);

  std::function<record::StationNow()> voice_;
  std::function<QImage()> camera_;
  StationWorker* worker_ = nullptr;  // of thread_
  QThread thread_;
  QTimer beat_;
  std::mutex mutex_;         // guards said_ between the two threads
  record::StationNow said_;  // newest state of this station
  QString name_, problem_;
  std::vector<record::StationNow> stations_;
  std::vector<record::StationMessage> inbox_, sent_;
  QElapsedTimer read_;
};

}  // namespace swage::console
