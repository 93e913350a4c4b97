// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Another attempt beside the one under review, on the same clock: its picture, and by how much it is shifted.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <memory>
#include <span>

#include "console/link/player.hpp"
#include "console/models/review.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

/// An event that both attempts have, and when it came first in each.
struct CommonEvent {
  QString id, what;
  double first_s = 0, other_s = 0;
};
QVector<CommonEvent> common_events(const Review& first, const Review& other);

class Comparison : public QWidget {
  Q_OBJECT
 public:
  explicit Comparison(QWidget* parent = nullptr);
  ~Comparison() override;
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// Takes the recording. Without a player traces are compared and the picture says why there is none.
  void set_attempt(const Review& first, const record::AttemptRow& row, record::Recording recording,
                   const std::vector<record::EventRow>& events, const PlayerOpener& opener);
  const Review& review() const { return review_; }
  const record::Recording& recording() const { return recording_; }
  SceneView* view() { return view_; }
  const Player* player() const { return player_.get(); }
  /// What is at t in the first attempt is at t + later_s() in this one.
  double later_s() const;
  /// Whether its instruments are wanted in the picture of the first attempt, whose they are, and where they are now.
  bool ghost_wanted() const { return player_ && ghost_->isChecked(); }
  QString person() const { return QString::fromStdString(review_.attempt.person_name); }
  std::span<const swage_pose> X_WB() const { return {snapshot_->X_WB, snapshot_->n_body}; }
  void toggle_ghost() { ghost_->toggle(); }
  /// Towards the time beside a time of the first attempt, with at most `most` steps of work; true when there.
  bool toward(double first_s, uint64_t most);

 Q_SIGNALS:
  void aligned();
  void ghost_changed();
  void closed();

 private:
  void fill_events(const Review& first);

  record::Recording recording_;  // outlives the player
  Review review_;
  std::unique_ptr<Player> player_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  QLabel *title_ = nullptr, *problem_ = nullptr;
  QComboBox* align_ = nullptr;
  QCheckBox* ghost_ = nullptr;
  SceneView* view_ = nullptr;
};

}  // namespace swage::console
