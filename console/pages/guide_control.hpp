// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Live help on the Run page: a ghost of an expert's instruments in all its views, which waits for the trainee. Never in a test. [main]
#pragma once

#include <QList>
#include <QObject>
#include <memory>

#include "console/link/guide.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

class GuideControl : public QObject {
  Q_OBJECT
 public:
  /// `views`: those that show the attempt, now and later.
  explicit GuideControl(const QList<SceneView*>& views, QObject* parent = nullptr) : QObject(parent), views_(views) {}
  /// Who plays a lesson for a guide; without one there is none.
  void set_expert(ExpertOpener open) { expert_ = std::move(open); }
  bool possible() const { return static_cast<bool>(expert_); }
  /// Before the attempt, so that its record says how it began. `like`: the lesson as it is played, with its seed; `wanted`: a guide is
  /// asked for, and allowed.
  void begin(const session::Options& like, bool wanted);
  void end();
  /// In the middle of an attempt.
  void toggle(bool wanted, const snapshot::Snapshot* shown);
  /// The ghost enters all views, or leaves them.
  void show();
  void show_in(SceneView* view) const;
  /// Beside what the views show now.
  void move(const snapshot::Snapshot* shown);
  const Guide* guide() const { return guide_.get(); }
  /// A ghost goes along that does not lead astray.
  bool guides() const { return guide_ && !guide_->failed(); }

 Q_SIGNALS:
  /// There is no guide, and why: a note of the attempt.
  void noted(double time_s, const QString& what, const QString& means);

 private:
  const QList<SceneView*>& views_;
  ExpertOpener expert_;
  std::unique_ptr<Guide> guide_;
  session::Options like_;  // of the attempt, for a guide that is asked for in the middle of it
  bool told_ = false;      // that it is gone
};

}  // namespace swage::console
