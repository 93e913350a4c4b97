// SPDX-License-Identifier: Apache-2.0
//
// The calibration of a jaw sensor in the window, with a simulated sensor at a pseudo terminal.
#include "console/app/calibration_dialog.hpp"

#include <stdlib.h>

#include <atomic>
#include <cmath>
#include <fstream>

#include "console/models/said.hpp"
#include "devices/sensor_thread.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor/sentences.hpp"
#include "temp_folder.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

using console::CalibrationDialog;
using sensor::SimulatedSensor;

class CalibrationTest : public WindowTest {
 protected:
  CalibrationTest() { setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
  std::unique_ptr<SensorThread> plug() {
    SimulatedSensor::Options options;
    options.serial = "B7";
    return std::make_unique<SensorThread>(
        options, [this](double) { return SimulatedSensor::Measured{volts(length_mm_), 0, 0}; }, folder_ / "port");
  }
  // 1 mm/V and 3 mm at 0 V; below 1 mm the sensor is out of its stroke
  static double volts(double mm) { return mm < 1 ? -2 + 0.3 * (mm - 1) : mm - 3 + 5e-3 * std::sin(7 * mm); }

  template <class W>
  W* in(CalibrationDialog& dialog, const char* name) {
    W* found = dialog.findChild<W*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  QString said(CalibrationDialog& dialog, const char* name) { return in<QLabel>(dialog, name)->text(); }
  void connect_to(CalibrationDialog& dialog) {
    in<QComboBox>(dialog, "calibration_port")->setEditText(QString::fromStdString(folder_ / "port"));
    in<QPushButton>(dialog, "calibration_connect")->click();
  }
  void measure(CalibrationDialog& dialog, const char* button, double mm) {
    length_mm_ = mm;
    QTest::qWait(50);
    auto* press = in<QPushButton>(dialog, button);
    ASSERT_TRUE(eventually([&] { return press->isEnabled(); }));
    press->click();
    ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_said").isEmpty(); })) << said(dialog, "calibration_said").toStdString();
  }

  TempFolder folder_;
  std::atomic<double> length_mm_{0};
};

TEST_F(CalibrationTest, ThirteenPointsAndThreePosesAreFittedAndKept) {
  auto sensor = plug();
  CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), {});
  dialog.set_seconds(0.1);
  connect_to(dialog);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
  for (int i = 0; i < sensor::Draft::kRows; ++i) measure(dialog, "calibration_measure", 0.5 * i);
  const sensor::Displacement& fit = dialog.draft().fit();
  ASSERT_TRUE(fit.valid()) << said(dialog, "calibration_verdict").toStdString();
  EXPECT_NEAR(fit.slope, 1e-3, 5e-6);
  EXPECT_NEAR(fit.offset, 3e-3, 1e-5);
  EXPECT_LT(fit.worst, 20e-6);
  EXPECT_GT(fit.worst, 1e-6) << "the sensor is not quite straight";
  EXPECT_FALSE(fit.points[0].used) << "irregular";
  EXPECT_FALSE(fit.points[1].used);
  EXPECT_TRUE(fit.points[2].used);
  EXPECT_TRUE(said(dialog, "calibration_verdict").contains(QStringLiteral("2 of 13 points left out"))) << said(dialog, "calibration_verdict").toStdString();
  auto* table = in<QTableWidget>(dialog, "calibration_points");
  EXPECT_EQ(table->item(0, 2)->text(), QStringLiteral("left out"));
  EXPECT_NEAR(table->item(7, 2)->text().toDouble(), 1e6 * fit.points[7].residual_m, 0.06);

  in<QPushButton>(dialog, "calibration_keep")->click();
  EXPECT_TRUE(said(dialog, "calibration_said").contains(QStringLiteral("Say who calibrates"))) << "nobody stands for it";
  EXPECT_TRUE(sensor::calibration_files().empty());
  in<QLineEdit>(dialog, "calibration_by")->setText(QStringLiteral("Mei"));
  in<QSpinBox>(dialog, "calibration_days")->setValue(90);
  in<QPushButton>(dialog, "calibration_keep")->click();
  EXPECT_TRUE(said(dialog, "calibration_said").contains(QStringLiteral("once the three poses are measured")));

  in<QLabel>(dialog, "calibration_said")->clear();
  measure(dialog, "calibration_open", 5);
  measure(dialog, "calibration_closed", 3);
  measure(dialog, "calibration_squeezed", 2);
  in<QPushButton>(dialog, "calibration_keep")->click();
  sensor::Calibration kept;
  ASSERT_EQ(sensor::load_calibration(sensor::calibration_path("B7"), kept), "");
  EXPECT_EQ(kept.by, "Mei");
  EXPECT_EQ(kept.date, sensor::today());
  EXPECT_EQ(kept.expires, sensor::days_after(sensor::today(), 90));
  EXPECT_NEAR(kept.poses.open, 5e-3, 30e-6);
  EXPECT_NEAR(kept.poses.squeezed, 2e-3, 30e-6);
  EXPECT_EQ(kept.displacement.points.size(), 13u);
  ASSERT_EQ(console::stored_calibrations().size(), 1);
  EXPECT_TRUE(console::stored_calibrations()[0].startsWith(QStringLiteral("● B7: of"))) << console::stored_calibrations()[0].toStdString();

  // it expires, and the Setup page says so
  kept.expires = "2020-01-01";
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("B7"), kept), "");
  open();
  window->show_page(QStringLiteral("setup"));
  EXPECT_TRUE(child<QLabel>("setup_calibrations")->text().contains(QStringLiteral("expired on 2020-01-01")));
}

// A session uses the stored bench calibration, so the wizard begins with the poses; then forces with a gauge at the tips, and the check.
TEST_F(CalibrationTest, ASessionNeedsPosesAloneAndForcesAreCheckedOnAGauge) {
  sensor::Calibration stored;
  stored.serial = "B7", stored.by = "Ada", stored.date = sensor::today(), stored.expires = sensor::days_after(stored.date, 90);
  stored.displacement = {1e-3, 3e-3, 20e-6, 10e-6, {}};
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("B7"), stored), "");
  auto sensor = plug();
  CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), QStringLiteral("Mei"));
  dialog.set_seconds(0.1);
  connect_to(dialog);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
  EXPECT_EQ(in<QTabWidget>(dialog, "calibration_steps")->currentIndex(), 1);
  EXPECT_TRUE(said(dialog, "calibration_verdict").contains(QStringLiteral("The stored lengths are used")));
  measure(dialog, "calibration_open", 5);
  measure(dialog, "calibration_closed", 3);
  measure(dialog, "calibration_squeezed", 1.5);
  // a handle force of 0.2 N where the jaws meet and 4 N/mm from there on; a fifth of the excess at the tips
  auto* table = in<QTableWidget>(dialog, "calibration_forces");
  EXPECT_FALSE(in<QPushButton>(dialog, "calibration_check")->isEnabled());
  for (int i = 0; i < 5; ++i) {
    const double travel = 0.3 * i;
    table->setCurrentCell(i, 0);
    table->item(i, 0)->setText(QString::number(0.2 + 4 * travel).replace(QLatin1Char('.'), QLatin1Char(i == 2 ? ',' : '.')));
    table->item(i, 1)->setText(QString::number(0.8 * travel));
    measure(dialog, "calibration_measure_force", 3 - travel);
    EXPECT_EQ(said(dialog, "calibration_forces_verdict").startsWith(QStringLiteral("▲")), i < 4) << "five rows are needed";
  }
  measure(dialog, "calibration_check", 3 - 0.75);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_tip").startsWith(QStringLiteral("●")); })) << said(dialog, "calibration_tip").toStdString();
  in<QPushButton>(dialog, "calibration_keep")->click();
  sensor::Calibration kept;
  ASSERT_EQ(sensor::load_calibration(sensor::calibration_path("B7"), kept), "") << said(dialog, "calibration_said").toStdString();
  EXPECT_EQ(kept.by, "Mei");
  EXPECT_EQ(kept.displacement.slope, 1e-3);
  EXPECT_NEAR(kept.poses.closed, 3e-3, 30e-6);
  EXPECT_EQ(kept.poses_date, sensor::today());
  EXPECT_NEAR(kept.force.value(0.75e-3), 3.2, 0.05);
  EXPECT_NEAR(kept.tip.value(3), 0.6, 0.02);
  EXPECT_EQ(kept.check.wanted, 0.6);
  EXPECT_NEAR(kept.check.measured, 0.6, 0.06);
  // the gauge shows 0.6 N where the tables have 0.4 N
  measure(dialog, "calibration_check", 3 - 0.5);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_tip").startsWith(QStringLiteral("▲")); }));
}

// At a bench one hand is at the sensor: the space bar measures point after point and pose after pose, and never types into the port field.
TEST_F(CalibrationTest, TheSpaceBarMeasuresPointAfterPoint) {
  auto sensor = plug();
  CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), QStringLiteral("Mei"));
  dialog.set_seconds(0.1);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
  auto* port = in<QComboBox>(dialog, "calibration_port");
  port->setEditText(QString::fromStdString(folder_ / "port"));
  port->setFocus();
  QTest::keyClick(port, Qt::Key_Return);
  const auto strike = [&](double mm, const char* button) {
    ASSERT_TRUE(eventually([&] { return dialog.focusWidget() == in<QPushButton>(dialog, button) && dialog.focusWidget()->isEnabled(); })) << button << " at " << mm;
    length_mm_ = mm;
    QTest::qWait(50);
    QTest::keyClick(dialog.focusWidget(), Qt::Key_Space);
  };
  for (int i = 0; i < sensor::Draft::kRows; ++i) strike(0.5 * i, "calibration_measure");
  ASSERT_TRUE(eventually([&] { return dialog.draft().rows().back().volts.has_value(); }));
  for (int i = 0; i < sensor::Draft::kRows; ++i) EXPECT_NEAR(dialog.draft().rows()[static_cast<size_t>(i)].volts.value_or(9), volts(0.5 * i), 1e-3) << i;
  in<QTabWidget>(dialog, "calibration_steps")->setCurrentIndex(1);
  in<QPushButton>(dialog, "calibration_open")->setFocus();
  strike(5, "calibration_open");
  strike(3, "calibration_closed");
  strike(2, "calibration_squeezed");
  ASSERT_TRUE(eventually([&] { return dialog.focusWidget() == in<QPushButton>(dialog, "calibration_keep"); }));
  QTest::keyClick(dialog.focusWidget(), Qt::Key_Space);
  EXPECT_EQ(sensor::calibration_files().size(), 1u) << said(dialog, "calibration_said").toStdString();
  EXPECT_EQ(port->currentText().toStdString(), folder_ / "port");
}

// After a report that the handle's rest position has shifted, one button sets the zero and keeps all else.
TEST_F(CalibrationTest, TheZeroAloneIsSet) {
  sensor::Calibration stored;
  stored.serial = "B7", stored.by = "Ada", stored.date = sensor::today(), stored.expires = sensor::days_after(stored.date, 90);
  stored.displacement = {1e-3, 3e-3, 20e-6, 10e-6, {}};
  stored.poses = {5e-3, 3e-3, 2e-3}, stored.poses_date = "2026-11-01";
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("B7"), stored), "");
  auto sensor = plug();
  CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), QStringLiteral("Mei"));
  dialog.set_seconds(0.1);
  connect_to(dialog);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
  measure(dialog, "calibration_zero", 4.5);  // a quarter of the stroke: the handle is being pressed
  in<QPushButton>(dialog, "calibration_keep")->click();
  EXPECT_TRUE(said(dialog, "calibration_said").contains(QString::fromStdString(sensor::say::kRestsElsewhere.words(1)))) << said(dialog, "calibration_said").toStdString();
  in<QLabel>(dialog, "calibration_said")->clear();
  measure(dialog, "calibration_zero", 5.2);
  in<QPushButton>(dialog, "calibration_keep")->click();
  sensor::Calibration kept;
  ASSERT_EQ(sensor::load_calibration(sensor::calibration_path("B7"), kept), "");
  EXPECT_NEAR(kept.poses.open, 5.2e-3, 10e-6);
  EXPECT_NEAR(kept.poses.squeezed, 2.2e-3, 10e-6);
  EXPECT_EQ(kept.poses_date, "2026-11-01");
  EXPECT_EQ(kept.zero_date, sensor::today());
  measure(dialog, "calibration_open", 5.2);
  EXPECT_FALSE(in<QPushButton>(dialog, "calibration_zero")->isEnabled()) << "who measures poses sets them all";
}

// Sentences of the sensor's library, in the window's language.
TEST_F(CalibrationTest, InAGermanWindowTheSensorsSentencesAreGerman) {
  console::set_words_language(QStringLiteral("de"));
  {
    CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), {});
    EXPECT_TRUE(said(dialog, "calibration_verdict").startsWith(QStringLiteral("Eine Ausgleichsgerade braucht"))) << said(dialog, "calibration_verdict").toStdString();
    in<QComboBox>(dialog, "calibration_port")->setEditText(QString::fromStdString(folder_ / "port"));
    in<QPushButton>(dialog, "calibration_connect")->click();  // nothing is plugged in
    EXPECT_TRUE(said(dialog, "calibration_said").contains(QStringLiteral("ist nicht da. Ist der Sensor eingesteckt?"))) << said(dialog, "calibration_said").toStdString();
  }
  sensor::Calibration stored;
  stored.serial = "B7", stored.by = "Ada", stored.date = "2019-12-01", stored.expires = "2020-01-01";
  stored.displacement = {1e-3, 3e-3, 20e-6, 10e-6, {}};
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("B7"), stored), "");
  ASSERT_EQ(console::stored_calibrations().size(), 1);
  EXPECT_TRUE(console::stored_calibrations()[0].contains(QStringLiteral("ist am 2020-01-01 abgelaufen"))) << console::stored_calibrations()[0].toStdString();
  std::ofstream(sensor::calibration_path("B7")) << "no";
  EXPECT_TRUE(console::stored_calibrations()[0].endsWith(QStringLiteral("B7.json: Sie ist kein JSON."))) << console::stored_calibrations()[0].toStdString();
  console::set_words_language(QStringLiteral("en"));
}

// U15: nothing is written before "Keep", at whichever step the window is closed; the previous calibration is kept.
TEST_F(CalibrationTest, ClosingItAtAnyStepWritesNothing) {
  auto sensor = plug();
  const auto until = [&](int points, int poses) {
    SCOPED_TRACE(testing::Message() << points << " points, " << poses << " poses");
    CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("light")), QStringLiteral("Mei"));
    dialog.set_seconds(0.05);
    dialog.show();
    connect_to(dialog);
    ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
    for (int i = 0; i < points; ++i) measure(dialog, "calibration_measure", 0.5 * i);
    const std::pair<const char*, double> steps[] = {{"calibration_open", 5}, {"calibration_closed", 3}, {"calibration_squeezed", 2}};
    for (int i = 0; i < poses; ++i) measure(dialog, steps[i].first, steps[i].second);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
  };
  for (const auto& [points, poses] : {std::pair{0, 0}, {1, 0}, {12, 0}, {13, 0}, {13, 1}, {13, 2}, {13, 3}}) {
    until(points, poses);
    EXPECT_TRUE(sensor::calibration_files().empty()) << points << " points, " << poses << " poses";
  }
}

TEST_F(CalibrationTest, WhatCannotBeIsToldAndNothingIsKept) {
  CalibrationDialog dialog(console::UiTheme::stock(QStringLiteral("dark")), QStringLiteral("Mei"));
  dialog.set_seconds(0.1);
  connect_to(dialog);
  EXPECT_TRUE(said(dialog, "calibration_said").contains(QString::fromStdString(sensor::say::kNotThere.words(1)))) << said(dialog, "calibration_said").toStdString();
  auto sensor = plug();
  connect_to(dialog);
  ASSERT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
  // a handle in motion during the measurement
  std::atomic<bool> moves{true};
  std::thread hand([&] {
    while (moves) length_mm_ = 2 + 0.05 * static_cast<double>(static_cast<int>(20 * length_mm_) % 2 == 0), nap(5e-3);
  });
  in<QPushButton>(dialog, "calibration_measure")->click();
  EXPECT_TRUE(eventually([&] { return said(dialog, "calibration_said").contains(QString::fromStdString(sensor::say::kMoved.words(0))); }))
      << said(dialog, "calibration_said").toStdString();
  moves = false;
  hand.join();
  // a sensor that is unplugged, and found again
  sensor->unplug();
  EXPECT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").contains(QStringLiteral("unplugged")); }));
  EXPECT_FALSE(in<QPushButton>(dialog, "calibration_measure")->isEnabled());
  sensor->plug();
  EXPECT_TRUE(eventually([&] { return said(dialog, "calibration_sensor").startsWith(QStringLiteral("● B7")); }));
  EXPECT_FALSE(in<QPushButton>(dialog, "calibration_keep")->isEnabled()) << "no fit, nothing to keep";
  EXPECT_TRUE(sensor::calibration_files().empty());
}

}  // namespace
}  // namespace swage::test
