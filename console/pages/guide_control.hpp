// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Live help on the Run page: a ghost of an expert's instruments in all views, which waits for the trainee. Never in a test. [main]
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
  /// `views`: the list of views that show the attempt, which may change.
  explicit GuideControl(const QList<SceneView*>& views, QObject* parent = nullptr) : QObject(parent), views_(views) {}
  /// Sets the opener of experts; without one there is no guide.
  void set_expert(ExpertOpener open) { expert_ = std::move(open); }
  bool possible() const { return static_cast<bool>(expert_); }
  /// To be called before the attempt, so that its record has the initial state. `like`: options of the attempt, with its seed; `wanted`: a
  /// guide is requested and allowed.
  void begin(const session::Options& like, bool wanted);
  void end();
  /// Switches the guide during an attempt.
  void toggle(bool wanted, const snapshot::Snapshot* shown);
  /// Adds the ghost to all views, or removes it.
  void show();
  void show_in(SceneView* view) const;
  /// Moves the ghost to match the snapshot in the views.
  void move(const snapshot::Snapshot* shown);
  const Guide* guide() const { return guide_.get(); }
  /// A ghost is shown, and its expert has not failed.
  bool guides() const { return guide_ && !guide_->failed(); }

 Q_SIGNALS:
  /// No guide is available, and why: a note for the attempt.
  void noted(double time_s, const QString& what, const QString& means);

 private:
  const QList<SceneView*>& views_;
  ExpertOpener expert_;
  std::unique_ptr<Guide> guide_;
  session::Options like_;  // options of the attempt, for a guide requested during it
  bool told_ = false;      // the guide's failure has been reported
};

}  // namespace swage::console
