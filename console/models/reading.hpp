// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which of a scene's numbers the NOW panel shows, found by what they are called. A scene without them shows
// fewer.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// What the panel shows of one snapshot; absent what the scene does not say.
struct Reading {
  std::optional<double> force;  // N
  std::optional<bool> held;     // by both jaws
  std::optional<double>
      tilt;  // rad, the larger of the two; while inserting, between needle and tissue's normal
  std::optional<double> tension;   // N, of the thread that is drawn
  std::optional<double> hold;      // share of the hold that is done, 0..1
  std::optional<bool> spot, tips;  // of the current grasp
  QString phase;                   // in words
  QStringList meanings;            // all cues now shown, of objects and of marks
  struct Count {
    QString name, value;
  };
  QVector<Count> counts;
};

/// Finds the places once per scene, reads them once per picture.
class Reader {
 public:
  Reader() = default;
  explicit Reader(const snapshot::SceneCard& card);
  Reading read(const snapshot::Snapshot& snapshot) const;
  bool has_force() const { return !force_.isEmpty(); }
  /// What this scene's cues and marks can mean, each once, in the order in which the lesson declares them.
  static QStringList meanings(const snapshot::SceneCard& card);
  /// A needle has an axis that may lean; a ball has none, and where no spot is judged no lean is.
  bool has_tilt() const { return (grasp_ && !tilt_.isEmpty()) || angle_ >= 0; }
  /// The tilt is that of the needle against the tissue.
  bool inserts() const { return angle_ >= 0; }
  /// A thread is drawn by a needle or through tissue.
  bool has_tension() const { return !tension_.isEmpty(); }
  bool has_hold() const { return hold_ >= 0; }
  /// The lesson judges spot and tips.
  bool has_grasp() const { return grasp_; }

 private:
  struct Counter {
    int metric;
    QString name, unit;
  };
  void find_tension(const judge::Script& script);
  QVector<int> force_, held_, tension_;
  int hold_ = -1, angle_ = -1, pierced_ = -1;
  bool grasp_ = false;
  QVector<int> tilt_;
  QVector<Counter> counters_;
  QVector<QString> cues_, phases_;
};

}  // namespace swage::console
