// SPDX-License-Identifier: LGPL-3.0-or-later
//
// True size and registration of a station: lengths read from a ruler, and four marks to touch with the arm's tip. Changes act at once.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <functional>
#include <memory>
#include <optional>

#include "console/app/station.hpp"
#include "console/link/arm_reader.hpp"

namespace swage::console {

/// A bar whose length on the screen is the labelled one when the size of the screen is right; to be checked with a ruler.
class RulerBar : public QWidget {
  Q_OBJECT
 public:
  explicit RulerBar(QWidget* parent);
  void set_mm_per_pixel(double mm) { mm_per_px_ = mm, update(); }
  double length_px() const { return mm_per_px_ > 0 ? kLength_mm / mm_per_px_ : 0; }
  QSize sizeHint() const override { return {420, 40}; }
  static constexpr double kLength_mm = 100;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double mm_per_px_ = 0;
};

class StationDialog : public QDialog {
  Q_OBJECT
 public:
  /// Makes a reader of the arm that is chosen on the Run page.
  using ArmMaker = std::function<std::unique_ptr<ArmReader>()>;

  StationDialog(const Station& station, bool mirrored, ArmMaker make_arm, QWidget* parent);
  const Station& station() const { return station_; }
  /// The registered device: its id in sessions and its name for people.
  void set_device(const QString& device, const QString& name);
  /// The screen to be measured: the size that it reports is the first guess.
  void set_screen(const QScreen* screen);

 Q_SIGNALS:
  void changed();
  /// The place of the mark to be touched, mm from the middle of the trainee's picture; no value: no mark.
  void mark(const std::optional<QPointF>& at_mm);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* make_ruler(bool mirrored);
  QWidget* make_arm_section();
  QDoubleSpinBox* number(const char* name, const QString& label, double low, double high, double value, const QString& unit,
                         const QString& tip, QFormLayout* form);
  void read_ruler();
  void begin();
  void take();
  void cancel();
  void show_step();
  void show_registration();

  Station station_;
  ArmMaker make_arm_;
  std::unique_ptr<ArmReader> arm_;
  std::vector<session::Touched> touched_;
  QString device_, device_name_;
  QSize screen_px_{1920, 1080};
  QDoubleSpinBox *width_, *height_, *distance_, *eyes_, *scale_, *screen_tilt_, *mirror_tilt_;
  QCheckBox *on_, *held_;
  RulerBar* bar_;
  QLabel *where_, *step_, *registration_;
  QPushButton *begin_, *take_, *forget_;
};

}  // namespace swage::console
