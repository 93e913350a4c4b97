// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Selects the numbers of a scene that the NOW panel shows, by their names. A scene without some of them shows
// fewer.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// The panel's values for one snapshot; no value where the scene has none.
struct Reading {
  std::optional<double> force;  // N
  std::optional<bool> held;     // grasped by both jaws
  std::optional<double>
      tilt;  // rad, the larger of the two; during insertion, between needle and tissue normal
  std::optional<double> tension;   // N, of the thread being drawn
  std::optional<double> hold;      // completed share of the hold, 0..1
  std::optional<bool> spot, tips;  // of the current grasp
  std::optional<bool> at_target;   // what is held is where it should go in
  QString phase;                   // as text
  QStringList meanings;            // all cues now shown, of objects and of marks
  struct Count {
    QString name, value;
  };
  QVector<Count> counts;
};

/// Finds the signals once per scene, reads them once per picture.
class Reader {
 public:
  Reader() = default;
  explicit Reader(const snapshot::SceneCard& card);
  Reading read(const snapshot::Snapshot& snapshot) const;
  bool has_force() const { return !force_.isEmpty(); }
  /// All meanings of this scene's cues and marks, each once, in the order of the lesson's declarations.
  static QStringList meanings(const snapshot::SceneCard& card);
  /// A needle has an axis that may tilt, a ball has none; without a judged grasp position no tilt is shown.
  bool has_tilt() const { return (grasp_ && !tilt_.isEmpty()) || angle_ >= 0; }
  /// The tilt is the angle between needle and tissue normal.
  bool inserts() const { return angle_ >= 0; }
  /// A needle or tissue draws a thread.
  bool has_tension() const { return !tension_.isEmpty(); }
  bool has_hold() const { return hold_ >= 0; }
  /// The lesson judges grasp position and use of the tips.
  bool has_grasp() const { return grasp_; }

 private:
  struct Counter {
    int metric;
    QString name, unit;
  };
  void find_tension(const snapshot::SceneCard& card);
  QVector<int> force_, held_, tension_;
  int hold_ = -1, angle_ = -1, pierced_ = -1;
  bool grasp_ = false;
  QVector<int> tilt_;
  QVector<Counter> counters_;
  QVector<QString> cues_, phases_;
};

}  // namespace swage::console
