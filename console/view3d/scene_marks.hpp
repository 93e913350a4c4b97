// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is painted over a panel at places of its scene: targets, forces, cues, whose tool is led, whose ghost it is. [main]
#pragma once

#include <QCoreApplication>

#include "console/view3d/ghost_tools.hpp"
#include "console/view3d/overlay.hpp"
#include "console/view3d/panels.hpp"
#include "console/view3d/shown.hpp"

namespace swage::console {

/// Points that a lesson holds at one place, as the answers of a question before it is asked: one circle shows them, and no word fits.
enum class Together { kAlone, kFirst, kLater };
/// Whether the point `mark` is alone, or else the first or a later one of those at its place.
Together at_one_place(const judge::Script& script, const snapshot::Snapshot& now, uint32_t mark);

class SceneMarks {
  Q_DECLARE_TR_FUNCTIONS(SceneMarks)

 public:
  SceneMarks(const SceneState& scene, const Shown& shown, const GhostTools& ghost) : scene_(scene), shown_(shown), ghost_(ghost) {}
  /// The greatest wound, and the object that it is in.
  void set_wound(const WoundPlace& wound, uint32_t object) { wound_ = wound, wounded_object_ = object; }
  const WoundPlace& wound() const { return wound_; }
  /// Share of a hold that is done; whether it is another than before.
  bool set_hold(double share) { return std::exchange(hold_, share) != share; }
  /// `leads`: mouse and keys lead a tool.
  void paint(Overlay& overlay, const Panel& panel, bool leads) const;

 private:
  QVector3D grasp_point(uint32_t object) const;
  QVector3D cue_point(uint32_t object) const;
  double clear_px(uint32_t object, const Panel& panel) const;
  void keep_work_clear(Overlay& overlay, const Panel& panel) const;
  void paint_targets(Overlay& overlay, const Panel& panel) const;
  void paint_forces(Overlay& overlay, const Panel& panel) const;
  void paint_cues(Overlay& overlay, const Panel& panel) const;
  void paint_jaws(Overlay& overlay, const Panel& panel) const;
  void paint_led(Overlay& overlay, const Panel& panel) const;

  const SceneState& scene_;
  const Shown& shown_;
  const GhostTools& ghost_;
  WoundPlace wound_;
  uint32_t wounded_object_ = 0;
  double hold_ = 0;
};

}  // namespace swage::console
