// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A second attempt beside the reviewed one, on a shifted clock: its picture, and the shift.
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

/// Least width of either of two pictures: both and the tables beside them fit a screen of 1024 pixels. Alone a picture is 320 wide at least.
inline constexpr int kLeastPair_px = 270;

/// An event of both attempts, and the time of its first occurrence in each.
struct CommonEvent {
  QString id, what;
  double first_s = 0, other_s = 0;
};
QVector<CommonEvent> common_events(const Review& first, const Review& other);

/// Shape (width over height) of a single picture on the Review page; two that are compared are narrower and show as much across, so that the
/// instrument is not cut off.
inline constexpr float kWholeShape = 1.7F;

class Comparison : public QWidget {
  Q_OBJECT
 public:
  explicit Comparison(QWidget* parent = nullptr);
  ~Comparison() override;
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// Takes the recording. Without a player the traces are compared, and the picture shows why there is none.
  void set_attempt(const Review& first, const record::AttemptRow& row, record::Recording recording,
                   const std::vector<record::EventRow>& events, const PlayerOpener& opener);
  const Review& review() const { return review_; }
  const record::Recording& recording() const { return recording_; }
  SceneView* view() { return view_; }
  /// Whose attempt it is, alignment and ghost: a row for the place above both pictures, so that both have one height.
  QWidget* head() { return head_; }
  const Player* player() const { return player_.get(); }
  /// Time t of the first attempt corresponds to t + later_s() of this one.
  double later_s() const;
  /// Whether its instruments are to be drawn in the first attempt's picture, whose they are, and their present poses.
  bool ghost_wanted() const { return player_ && ghost_->isChecked(); }
  /// What tells the ghost from the first attempt: the recorded hand, or another person, or that it is the other attempt.
  QString ghost_name() const { return ghost_name_; }
  QString title() const { return title_->text(); }
  std::span<const swage_pose> X_WB() const { return {snapshot_->X_WB, snapshot_->n_body}; }
  void toggle_ghost() { ghost_->toggle(); }
  /// Plays towards the time that corresponds to `first_s`, by at most `most` steps; true when it is reached.
  bool toward(double first_s, uint64_t most);

 Q_SIGNALS:
  void aligned();
  void ghost_changed();
  void closed();

 private:
  void make_head();
  void fill_events(const Review& first);

  record::Recording recording_;  // outlives the player
  Review review_;
  QString ghost_name_;
  std::unique_ptr<Player> player_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  QWidget* head_ = nullptr;
  QLabel *title_ = nullptr, *problem_ = nullptr;
  QComboBox* align_ = nullptr;
  QCheckBox* ghost_ = nullptr;
  SceneView* view_ = nullptr;
};

}  // namespace swage::console
