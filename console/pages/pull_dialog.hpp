// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does this knot hold? The knot of an attempt, copied and pulled before the instructor's eyes.
#pragma once

#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <functional>
#include <memory>

#include "console/link/knot_puller.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

class SceneView;

class PullDialog : public QDialog {
  Q_OBJECT
 public:
  struct Services {
    /// Copies the knot once more; nullptr and a sentence where it cannot be pulled.
    std::function<std::unique_ptr<KnotPuller>(const PullWish& wish, QString& why)> open;
    std::function<bool(const QString& text)> keep = {};  // as a note of the attempt; none: it cannot be kept
    std::function<void(SceneView&)> dress = {};          // sets the colours of the picture
  };
  /// `at_s`: the moment of the attempt at which the knot is as it is pulled.
  PullDialog(Services services, double at_s, QWidget* parent);
  ~PullDialog() override;

  /// Pulls once more, with the values of the fields. False: why() has the reason.
  bool pull();
  const QString& why() const { return why_; }
  bool pulling() const { return timer_.isActive(); }
  const PullState& state() const { return state_; }
  /// What came of it, as a note says it: "Knot (2, -1, 1) pulled, friction 0.3: holds 100 mN, slip 0.06 mm".
  QString note() const;

 private:
  QWidget* make_side();
  QDoubleSpinBox* number(const char* name, const QString& unit, double low, double high, double step, int decimals);
  void tick();
  void show_state();
  void keep();

  const Services services_;
  const double at_s_;
  std::unique_ptr<KnotPuller> puller_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  PullState state_;
  PullWish wish_;
  QString why_;
  QTimer timer_;
  SceneView* view_ = nullptr;
  QLabel *knot_ = nullptr, *result_ = nullptr, *numbers_ = nullptr;
  QProgressBar* share_ = nullptr;
  QDoubleSpinBox *load_ = nullptr, *friction_ = nullptr;
  QPushButton *again_ = nullptr, *keep_ = nullptr;
};

/// "2 -1 1" as people write a knot: "(2, −1, 1)".
QString knot_text(const QString& word);

}  // namespace swage::console
