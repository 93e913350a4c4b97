// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The present state of the scene: its card and the last snapshot. World frame; places in mm. Free of Qt3D. [main]
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
    bool first = false;    // first snapshot of this card
    bool same = false;     // step and time did not change
    bool colours = false;  // a cue or the stress changed
    bool led = false;      // the active tool changed
  };
  /// Copies the snapshot. `with_stress`: whether the needle's stress is read.
  Change take(const snapshot::Snapshot& snapshot, bool with_stress);
  /// Reads the stress of the last snapshot, or sets it to 0; returns whether it changed.
  bool read_stress(bool with_stress);

  /// A copy of the last snapshot; nullptr before the first.
  std::shared_ptr<snapshot::Snapshot> moment() const;
  /// While it lives, now() and all places are those of an earlier moment, which a slow picture shows; of nullptr: nothing changes.
  class At {
   public:
    At(SceneState& scene, const std::shared_ptr<snapshot::Snapshot>& moment);
    ~At();
    At(const At&) = delete;
    At& operator=(const At&) = delete;

   private:
    SceneState& scene_;
    std::shared_ptr<snapshot::Snapshot> newest_;
  };

  const snapshot::SceneCard& card() const { return card_; }
  const SceneParts& parts() const { return parts_; }
  const snapshot::Snapshot& now() const { return *snapshot_; }
  bool have_card() const { return have_card_; }
  bool have_snapshot() const { return have_snapshot_; }
  /// Whether the lesson has been updated once: only then are its marks in place.
  bool judged() const;
  /// The active tool of the mouse, of several; SWAGE_NONE where there is one.
  uint32_t led() const { return led_; }
  /// Whether jaws hold an object; no value where no grasp is measured.
  std::optional<bool> taken() const { return taken_; }
  /// A needle is in the tissue.
  bool pierced() const { return pierced_; }
  /// Greatest stress of a needle over that of first yield, in steps of 1/16; 0 while it is not read.
  double stress() const { return stress_; }

  /// Poses of the last snapshot; before the first, those of the start.
  std::span<const swage_pose> X_WB() const;
  /// Pose of a body; that of the start where the snapshot lacks it.
  const swage_pose& pose(uint32_t body) const;
  QVector3D place_of(const Spot& spot) const;
  /// The middle between the tips of the active tool.
  QVector3D middle_of_tips() const;
  /// The object that this tool is; no value without a tool.
  std::optional<uint32_t> active_tool() const;
  /// The nearest object that may be grasped; once the tips are within `reach` of it, the mark to which it is to be brought.
  QVector3D aim_near(const QVector3D& tips, float reach) const;
  /// Position of the first mark that is a point in the world.
  std::optional<QVector3D> first_point() const;
  /// What the lesson is about, where the view "near" looks: the stitch to be tied where no needle is there, else the first point, else a
  /// knot.
  std::optional<QVector3D> subject() const;
  /// Whether that is a stitch to be tied.
  bool ties() const;
  /// Where a tissue is tied: the middle of the stitch, mm. No value for other objects.
  std::optional<QVector3D> tied_at(uint32_t object) const;
  /// Whether the lesson is about a knot that is there from the start, and marks no point.
  bool has_knot() const;
  /// Positions of all such marks.
  std::vector<QVector3D> points() const;
  bool has_target() const;
  /// What is to be seen beside the watched object: the tips; while they hold a needle with a thread, the place where it goes in, to which
  /// the thread is drawn.
  QVector3D beside_watched() const;
  /// The middle of the watched object, if there is one and the snapshot has it.
  std::optional<QVector3D> watched() const;

 private:
  bool follow_led_tool();
  bool thread_alone() const;

  snapshot::SceneCard card_;
  SceneParts parts_;
  std::shared_ptr<snapshot::Snapshot> snapshot_;
  bool have_card_ = false, have_snapshot_ = false;
  uint32_t led_ = SWAGE_NONE;
  bool pierced_ = false;
  std::optional<bool> taken_;
  double stress_ = 0;
};

}  // namespace swage::console
