// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where the tip of an arm is, in its own frame: read from a session that keeps nothing and pushes nobody. For the registration of a
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
  /// `options`: lesson, device, and settings that put it at the origin with forces off.
  ArmReader(SessionOpener opener, session::Options options, QObject* parent = nullptr);
  ~ArmReader() override;

  /// "" or why the device cannot be read, as a sentence.
  QString start();
  void stop();
  /// Mean of the last third of a second, m; nothing while no valid place comes or the tip still moves by more than a millimetre.
  std::optional<swage_vec3> still() const;
  /// The newest valid place, m.
  std::optional<swage_vec3> newest() const;

 Q_SIGNALS:
  void moved();

 private:
  void poll();

  SessionOpener opener_;
  session::Options options_;
  std::unique_ptr<session::Session> session_;
  std::unique_ptr<snapshot::Snapshot> now_;
  std::deque<swage_vec3> last_;  // one each kPoll_ms
  QTimer timer_;
};

}  // namespace swage::console
