// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is in the scene now: its card, and the last snapshot of it. World frame; places in mm. Free of Qt3D. [main]
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

class SceneState {
 public:
  SceneState();
  void set_card(const snapshot::SceneCard& card);

  struct Change {
    bool first = false;    // snapshot of this card
    bool same = false;     // step and time as before
    bool colours = false;  // a cue or the stress is another
    bool led = false;      // another tool is led
  };
  /// Copies the snapshot. `with_stress`: whether the needle's stress is read.
  Change take(const snapshot::Snapshot& snapshot, bool with_stress);
  /// The stress of the last snapshot, or none; whether it is another than before.
  bool read_stress(bool with_stress);

  const snapshot::SceneCard& card() const { return card_; }
  const SceneParts& parts() const { return parts_; }
  const snapshot::Snapshot& now() const { return *snapshot_; }
  bool have_card() const { return have_card_; }
  bool have_snapshot() const { return have_snapshot_; }
  /// Whether the lesson has looked at the scene yet: only then are its marks where it has drawn them.
  bool judged() const;
  /// The tool that the mouse leads, of several; SWAGE_NONE where there is one.
  uint32_t led() const { return led_; }
  /// Whether jaws hold something that can be taken; nothing where no grasp is measured.
  std::optional<bool> taken() const { return taken_; }
  /// A needle is in the tissue.
  bool pierced() const { return pierced_; }
  /// Greatest stress of a needle over that of first yield, in sixteenths; 0 while it is not read.
  double stress() const { return stress_; }

  /// Poses of the last snapshot; of the start before the first.
  std::span<const swage_pose> X_WB() const;
  /// Pose of a body; of the start where the snapshot lacks it.
  const swage_pose& pose(uint32_t body) const;
  QVector3D place_of(const Spot& spot) const;
  /// The middle between the tips of the tool that is led.
  QVector3D middle_of_tips() const;
  /// The nearest thing that may be taken; once the tips are within `reach` of it, the mark that it is to be brought to.
  QVector3D aim_near(const QVector3D& tips, float reach) const;
  /// Where the first mark is that is a point in the world.
  std::optional<QVector3D> first_point() const;
  /// Where all of them are.
  std::vector<QVector3D> points() const;
  bool has_target() const;
  /// The middle of what is watched, where one thing is and the snapshot has it.
  std::optional<QVector3D> watched() const;

 private:
  bool follow_led_tool();

  snapshot::SceneCard card_;
  SceneParts parts_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  bool have_card_ = false, have_snapshot_ = false;
  uint32_t led_ = SWAGE_NONE;
  bool pierced_ = false;
  std::optional<bool> taken_;
  double stress_ = 0;
};

}  // namespace swage::console
