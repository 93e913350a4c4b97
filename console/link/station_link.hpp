// SPDX-License-Identifier: LGPL-3.0-or-later
//
// This station among those of the school. A thread of its own talks to the server, with a connection of its own: however long that
// takes, the window and the lesson go on. What this station does is asked of it twice a second and only its newest word is kept.
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

/// How the stations of the school are reached: record::Stations::open, or a test double. nullptr and `error` on failure.
using StationsOpener = std::function<std::unique_ptr<record::Stations>(std::string& error)>;

class StationWorker;

class StationLink : public QObject {
  Q_OBJECT
 public:
  using Kind = record::StationMessage::Kind;

  explicit StationLink(QObject* parent = nullptr) : QObject(parent) {}
  /// Takes this station out of the list; a server that does not answer is waited for 3 s at most.
  ~StationLink() override;

  /// Begins. No opener: there is no server, and nothing ever happens.
  void start(StationsOpener opener, const QString& wanted_name);
  bool has_server() const { return worker_ != nullptr; }
  /// What this station does; asked in this thread.
  void set_voice(std::function<record::StationNow()> voice) { voice_ = std::move(voice); }
  /// What is seen at this station; asked in this thread when somebody wants a picture.
  void set_camera(std::function<QImage()> camera) { camera_ = std::move(camera); }
  /// Whether anybody looks at stations().
  void watch(bool on);
  /// Something has changed that others should see before the next beat.
  void tell_now();

  /// Under which this station is known, "" before the server has answered.
  const QString& name() const { return name_; }
  const std::vector<record::StationNow>& stations() const { return stations_; }
  /// s since stations() was read.
  double age_s() const { return read_.isValid() ? 1e-3 * static_cast<double>(read_.elapsed()) : 0; }
  const std::vector<record::StationMessage>& inbox() const { return inbox_; }
  const std::vector<record::StationMessage>& sent() const { return sent_; }
  /// Why the server is not there, as a sentence; "" while it answers.
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
  /// A mark was set at that time of the attempt, s.
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
  std::mutex mutex_;         // of said_, between the two threads
  record::StationNow said_;  // the newest
  QString name_, problem_;
  std::vector<record::StationNow> stations_;
  std::vector<record::StationMessage> inbox_, sent_;
  QElapsedTimer read_;
};

}  // namespace swage::console
