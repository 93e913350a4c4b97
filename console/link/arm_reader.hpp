// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The position of an arm's tip in the arm's own frame, read from a session without a store and without forces. For the registration of a
// station. GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <memory>
#include <optional>

#include "console/link/run_control.hpp"

namespace swage::console {

class ArmReader : public QObject {
  Q_OBJECT
 public:
  /// `options`: lesson, device, and settings that put the arm's base at the origin and switch its forces off.
  ArmReader(SessionOpener opener, session::Options options, QObject* parent = nullptr);
  ~ArmReader() override;

  /// Returns "", or why the device cannot be read, as a sentence.
  QString start();
  void stop();
  /// Mean position of the last third of a second, m; no value without valid positions or while the tip still moves by more than 1 mm.
  std::optional<swage_vec3> still() const;
  /// The newest valid position, m.
  std::optional<swage_vec3> newest() const;

 Q_SIGNALS:
  void moved();

 private:
  void poll();

  SessionOpener opener_;
  session::Options options_;
  std::unique_ptr<session::Session> session_;
  std::unique_ptr<snapshot::Snapshot> now_;
  std::deque<swage_vec3> last_;  // one for each kPoll_ms
  QTimer timer_;
};

}  // namespace swage::console
