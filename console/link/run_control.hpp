// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The console's control of a session: opens it, sends commands, polls at display rate, emits events.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "console/link/snapshot_source.hpp"
#include "session/session.hpp"

namespace swage::console {

/// How sessions are opened: session::Session::open, or a test double.
using SessionOpener =
    std::function<std::unique_ptr<session::Session>(const session::Options&, std::vector<base::Problem>&)>;

/// One attempt at a time. GUI thread only; the session has its own threads.
class RunControl : public QObject {
  Q_OBJECT
 public:
  enum class State { kIdle, kRunning, kPaused, kFinished };

  explicit RunControl(SessionOpener opener, QObject* parent = nullptr);
  ~RunControl() override;

  State state() const { return state_; }
  bool running() const { return state_ == State::kRunning || state_ == State::kPaused; }
  /// The scene of a lesson at its start. nullptr with problems when the lesson does not load.
  std::unique_ptr<snapshot::SceneCard> preview(const session::Options& options,
                                               std::vector<base::Problem>& problems);

  const snapshot::SceneCard& card() const { return card_; }
  /// The interpolated snapshot of the view; nullptr before the first.
  const snapshot::Snapshot* shown();
  const snapshot::Snapshot* newest() const { return source_.newest(); }
  const session::Result& result() const { return result_; }
  /// Id of the running or ended attempt; "" when the attempt is not stored.
  const std::string& attempt_id() const { return attempt_id_; }
  const session::Options& options() const { return options_; }
  const SessionOpener& opener() const { return opener_; }

 public Q_SLOTS:
  bool start(const session::Options& options);
  void toggle_pause();
  void reset_work();  // returns the object that is worked on to its start
  void mark();
  void note(const std::string& text);  // stores a note at the present time of the attempt
  void stop();

 public:
  void pointer(const swage_pointer& input, qint64 due_ns);  // see session::Session
  /// New value of a live parameter. Returns "" when it was accepted, else the reason, as a sentence.
  QString change(const std::string& instance, const std::string& json);

 Q_SIGNALS:
  void state_changed();
  void opened();  // card() is new
  void told(const std::vector<swage::base::Problem>& problems);  // problems of an attempt that starts all the same
  void failed(const std::vector<swage::base::Problem>& problems);
  void frame();  // at display rate while running
  void happened(const swage::judge::Event& event);
  void marked(double time_s);
  void pulling(double bears_N, double load_N);  // its knot is being pulled, once the attempt has been passed
  void finished();                               // result() is complete

 private:
  void poll();
  bool pull_on();
  void set_state(State state);
  void finish();
  double wall_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }

  SessionOpener opener_;
  std::unique_ptr<session::Session> session_;
  session::Options options_;
  snapshot::SceneCard card_;
  session::Result result_;
  std::string attempt_id_;
  SnapshotSource source_;
  std::unique_ptr<snapshot::Snapshot> latest_;
  QTimer timer_;
  QElapsedTimer clock_;
  State state_ = State::kIdle;
};

}  // namespace swage::console
