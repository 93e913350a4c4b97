// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/calibration_dialog.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"
#include "sensor/calibration_file.hpp"

namespace swage::console {
namespace {

constexpr int kPoll_ms = 15;
constexpr int kAmber_days = 30;  // after which a calibration that has not expired is spoken of all the same
constexpr double kPatience_s = 4;  // s; boards that restart when their port is opened need 2 s
enum Column { kLength, kVolts, kResidual, kColumns };

QString number(double value, int decimals) { return QString::number(value, 'f', decimals); }

}  // namespace

CalibrationDialog::CalibrationDialog(const UiTheme& theme, const QString& by, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("calibration"));
  setWindowTitle(tr("Calibrate a jaw sensor"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(make_sensor());
  steps_ = new QTabWidget(this);
  steps_->setObjectName(QStringLiteral("calibration_steps"));
  steps_->addTab(make_points(theme), tr("Lengths"));
  steps_->addTab(make_poses(), tr("Poses"));
  steps_->addTab(make_forces(), tr("Forces"));
  column->addWidget(steps_, 1);
  column->addWidget(make_end());
  by_->setText(by);
  timer_.setInterval(kPoll_ms);
  connect(&timer_, &QTimer::timeout, this, &CalibrationDialog::poll);
  show_points();
  resize(820, 640);
}

QWidget* CalibrationDialog::make_sensor() {
  Card card = make_card(tr("Sensor"), this);
  auto* row = new QHBoxLayout;
  port_ = new QComboBox(card.frame);
  port_->setObjectName(QStringLiteral("calibration_port"));
  port_->setAccessibleName(tr("Port"));
  port_->setEditable(true);
  port_->lineEdit()->setPlaceholderText(tr("No sensor is plugged in; or type its port"));
  for (const std::string& port : sensor::serial_adapters()) port_->addItem(QString::fromStdString(port));
  rate_ = new QComboBox(card.frame);
  rate_->setAccessibleName(tr("Bits per second"));
  for (const int rate : sensor::SerialPort::rates()) rate_->addItem(QString::number(rate), rate);
  rate_->setCurrentIndex(rate_->findData(115200));
  connect_ = make_button(tr("Connect"), {}, QStringLiteral("calibration_connect"), card.frame);
  connect(connect_, &QPushButton::clicked, this, &CalibrationDialog::connect_sensor);
  sensor_ = new QLabel(tr("○ Not connected"), card.frame);
  sensor_->setObjectName(QStringLiteral("calibration_sensor"));
  row->addWidget(port_, 2);
  row->addWidget(rate_);
  row->addWidget(connect_);
  row->addWidget(sensor_, 1);
  card.body->addLayout(row);
  return card.frame;
}

QWidget* CalibrationDialog::make_points(const UiTheme& theme) {
  Card card = make_card(tr("Lengths on the bench"), this);
  auto* row = new QHBoxLayout;
  auto* left = new QVBoxLayout;
  table_ = new QTableWidget(sensor::Draft::kRows, kColumns, card.frame);
  table_->setObjectName(QStringLiteral("calibration_points"));
  table_->setAccessibleName(tr("Lengths and volts"));
  table_->setHorizontalHeaderLabels({tr("Length, mm"), tr("Volts"), tr("Residual, µm")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setCurrentCell(0, kLength);
  connect(table_, &QTableWidget::itemChanged, this, &CalibrationDialog::read_lengths);
  left->addWidget(table_, 1);
  auto* buttons = new QHBoxLayout;
  measure_ = make_measuring(tr("Measure this length"), "calibration_measure", card.frame);
  measure_->setToolTip(tr("Draw the sensor to the length of the chosen line, hold it still, press; the next line follows"));
  connect(measure_, &QPushButton::clicked, this, [this] { measure(table_->currentRow(), measure_); });
  clear_ = make_button(tr("Clear"), {}, QStringLiteral("calibration_clear"), card.frame);
  connect(clear_, &QPushButton::clicked, this, [this] {
    for (auto& r : draft_.rows()) r.volts.reset();
    table_->setCurrentCell(0, kLength);
    show_points();
  });
  buttons->addWidget(measure_);
  buttons->addWidget(clear_);
  buttons->addStretch(1);
  left->addLayout(buttons);
  plot_ = new FitPlot(card.frame);
  plot_->set_theme(theme);
  plot_->set_titles(tr("V"), tr("mm"), tr("Residuals, µm, and the band that is allowed"));
  row->addLayout(left, 3);
  row->addWidget(plot_, 4);
  card.body->addLayout(row, 1);
  verdict_ = new QLabel(card.frame);
  verdict_->setObjectName(QStringLiteral("calibration_verdict"));
  verdict_->setWordWrap(true);
  card.body->addWidget(verdict_);
  return card.frame;
}

QWidget* CalibrationDialog::make_poses() {
  Card card = make_card(tr("Poses of the needleholder"), this);
  auto* why = new QLabel(tr("Measure these three in each session; it takes 20 s. Lengths and forces of before stay."), card.frame);
  why->setWordWrap(true);
  card.body->addWidget(why);
  auto* row = new QVBoxLayout;
  const QString words[] = {tr("Open: let the handle go"), tr("Just closed: the jaws meet"), tr("Squeezed: as far as it goes")};
  const char* const names[] = {"calibration_open", "calibration_closed", "calibration_squeezed"};
  for (int i = 0; i < 3; ++i) {
    pose_[i] = make_measuring(words[i], names[i], card.frame);
    connect(pose_[i], &QPushButton::clicked, this, [this, i] { measure(kPose + i, i < 2 ? pose_[i + 1] : keep_); });
    row->addWidget(pose_[i]);
  }
  card.body->addLayout(row);
  auto* only = new QLabel(tr("Or, where a session says that the handle does not rest where it was open: its zero alone, 5 s."), card.frame);
  only->setWordWrap(true);
  card.body->addSpacing(12);
  card.body->addWidget(only);
  zero_ = make_measuring(tr("Set the zero: let the handle go"), "calibration_zero", card.frame);
  connect(zero_, &QPushButton::clicked, this, [this] { measure(kZero, keep_); });
  card.body->addWidget(zero_);
  card.body->addStretch(1);
  return card.frame;
}

QWidget* CalibrationDialog::make_end() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  by_ = new QLineEdit(box);
  by_->setObjectName(QStringLiteral("calibration_by"));
  by_->setPlaceholderText(tr("Who calibrates"));
  by_->setAccessibleName(tr("Who calibrates"));
  days_ = new QSpinBox(box);
  days_->setObjectName(QStringLiteral("calibration_days"));
  days_->setRange(1, 3650);
  days_->setValue(draft_.valid_days);
  days_->setPrefix(tr("Valid for "));
  days_->setSuffix(tr(" days"));
  said_ = new QLabel(box);
  said_->setObjectName(QStringLiteral("calibration_said"));
  said_->setWordWrap(true);
  keep_ = make_button(tr("Keep"), {}, QStringLiteral("calibration_keep"), box);
  keep_->setProperty("primary", true);
  connect(keep_, &QPushButton::clicked, this, &CalibrationDialog::keep);
  row->addWidget(by_);
  row->addWidget(days_);
  row->addWidget(said_, 1);
  row->addWidget(keep_);
  return box;
}

// A click on these buttons may take the keyboard focus: no instrument is led meanwhile, and the next point is one key away.
QPushButton* CalibrationDialog::make_measuring(const QString& text, const char* name, QWidget* parent) {
  QPushButton* button = make_button(text, {}, QString::fromLatin1(name), parent);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void CalibrationDialog::say(const QString& text, bool bad) { said_->setText(bad ? QStringLiteral("▲ ") + text : text); }

void CalibrationDialog::connect_sensor() {
  bench_.close();
  named_ = false;
  const std::string why = bench_.open(port_->currentText().toStdString(), rate_->currentData().toInt());
  if (!why.empty()) {
    sensor_->setText(tr("○ Not connected"));
    return say(said_message(why), true);
  }
  say({}, false);
  asked_s_ = sensor::now_s();
  sensor_->setText(tr("Listening…"));
  timer_.start();
}

void CalibrationDialog::poll() {
  bench_.listen(sensor::now_s());
  if (!named_ && bench_.known()) {
    named_ = true;
    draft_.serial = bench_.serial();
    draft_.name = bench_.name();
    const std::string path = sensor::calibration_path(draft_.serial), wrong = draft_.begin_from(path);
    if (!wrong.empty()) say(said_of_file(path, wrong), true);
    // a sensor that already has a bench calibration needs only its poses
    if (draft_.in_use().valid() && !draft_.fit().valid()) steps_->setCurrentIndex(1);
    show_points();
    next_ = steps_->currentIndex() == 1 ? pose_[0] : measure_;
  } else if (!named_ && sensor::now_s() > asked_s_ + kPatience_s) {
    timer_.stop();
    bench_.close();
    sensor_->setText(tr("○ Not connected"));
    say(tr("%1 does not say who it is. Is it a sensor that speaks JAW1, and powered?").arg(QString::fromStdString(bench_.port())), true);
  }
  if (named_)
    sensor_->setText(!bench_.plugged() ? tr("▲ %1: unplugged").arg(QString::fromStdString(draft_.serial))
                     : bench_.volts()  ? tr("● %1: %2 V").arg(QString::fromStdString(draft_.serial), number(*bench_.volts(), 4))
                                       : tr("▲ %1: beyond its range").arg(QString::fromStdString(draft_.serial)));
  if (measuring_ >= 0 && !bench_.measuring()) measured();
  const bool ready = named_ && bench_.plugged() && measuring_ < 0;
  measure_->setEnabled(ready);
  for (QPushButton* pose : pose_) pose->setEnabled(ready && draft_.in_use().valid());
  zero_->setEnabled(ready && draft_.may_zero());
  measure_force_->setEnabled(ready && draft_.in_use().valid());
  show_tip();
  if (measuring_ < 0)
    if (QWidget* next = std::exchange(next_, nullptr); next != nullptr && next->isEnabled() && next->isVisible()) next->setFocus();
}

void CalibrationDialog::measure(int what, QWidget* then) {
  if (!named_ || measuring_ >= 0 || what < 0) return;
  measuring_ = what;
  next_ = then;
  measure_->setEnabled(false);
  say(tr("Hold it still…"), false);
  bench_.begin(sensor::now_s(), seconds_);
}

void CalibrationDialog::measured() {
  const int what = std::exchange(measuring_, -1);
  double volts = 0;
  if (const std::string why = bench_.mean(volts); !why.empty()) return say(said_message(why), true);
  say({}, false);
  if (what == kZero) {
    draft_.zero_volts = volts, draft_.zero_gauge_N = bench_.gauge();
  } else if (what == kCheck) {
    draft_.check_volts = volts;
  } else if (what >= kForce) {
    draft_.force_rows[static_cast<size_t>(what - kForce)].volts = volts;
    draft_.check_volts.reset();
    force_table_->setCurrentCell(std::min(what - kForce + 1, static_cast<int>(sensor::Draft::kForceRows) - 1), 0);
  } else if (what >= kPose) {
    draft_.pose_volts[static_cast<size_t>(what - kPose)] = volts;
  } else {
    draft_.rows()[static_cast<size_t>(what)].volts = volts;
    table_->setCurrentCell(std::min(what + 1, sensor::Draft::kRows - 1), kLength);
  }
  show_points();
}

void CalibrationDialog::read_lengths() {
  if (filling_) return;
  for (int i = 0; i < sensor::Draft::kRows; ++i) {
    bool good = false;
    const double mm = table_->item(i, kLength)->text().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&good);
    if (good) draft_.rows()[static_cast<size_t>(i)].length_m = 1e-3 * mm;
  }
  show_points();
}

void CalibrationDialog::show_points() {
  const std::string wrong = draft_.refit();
  const sensor::Displacement& fit = draft_.fit();
  filling_ = true;
  for (int i = 0; i < sensor::Draft::kRows; ++i) {
    const auto& row = draft_.rows()[static_cast<size_t>(i)];
    QString residual;
    for (const sensor::BenchPoint& p : fit.points)
      if (fit.valid() && row.volts && p.length_m == row.length_m && p.volts == *row.volts)
        residual = p.used ? number(1e6 * p.residual_m, 1) : tr("left out");
    const QString texts[] = {number(1e3 * row.length_m, 2), row.volts ? number(*row.volts, 4) : QString(), residual};
    for (int c = 0; c < kColumns; ++c) {
      if (table_->item(i, c) == nullptr) table_->setItem(i, c, new QTableWidgetItem);
      table_->item(i, c)->setText(texts[c]);
      if (c != kLength) table_->item(i, c)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    }
  }
  filling_ = false;
  std::vector<FitPlot::Point> points;
  for (const sensor::BenchPoint& p : fit.points) points.push_back({p.volts, 1e3 * p.length_m, 1e6 * p.residual_m, p.used});
  plot_->set_points(std::move(points), 1e3 * fit.slope, 1e3 * fit.offset, 1e6 * draft_.limits.worst);
  const auto left_out = std::count_if(fit.points.begin(), fit.points.end(), [](const auto& p) { return !p.used; });
  verdict_->setText(fit.valid() ? tr("%1 mm/V, worst residual %2 µm, rms %3 µm; %4 of %5 points left out, beyond the stroke.")
                                      .arg(number(1e3 * fit.slope, 4), number(1e6 * fit.worst, 1), number(1e6 * fit.rms, 1))
                                      .arg(left_out)
                                      .arg(fit.points.size())
                                : said_message(wrong));
  if (!fit.valid() && draft_.in_use().valid())
    verdict_->setText(tr("The stored lengths are used: worst residual %1 µm. Measure new ones where the sensor was mounted anew.")
                          .arg(number(1e6 * draft_.in_use().worst, 1)));
  show_poses();
  show_forces();
  keep_->setEnabled(draft_.in_use().valid());
  if (!named_) {
    measure_->setEnabled(false);
    measure_force_->setEnabled(false);
    check_->setEnabled(false);
    for (QPushButton* pose : pose_) pose->setEnabled(false);
    zero_->setEnabled(false);
  }
}

void CalibrationDialog::show_poses() {
  const char* const marks[] = {"○", "●"};
  const QString words[] = {tr("Open: let the handle go"), tr("Just closed: the jaws meet"), tr("Squeezed: as far as it goes")};
  for (size_t i = 0; i < 3; ++i)
    pose_[i]->setText(QString::fromUtf8(marks[draft_.pose_volts[i] ? 1 : 0]) + QLatin1Char(' ') + words[i] +
                      (draft_.pose_volts[i] ? tr(": %1 mm").arg(number(1e3 * draft_.in_use().length(*draft_.pose_volts[i]), 2)) : QString()));
  zero_->setText(QString::fromUtf8(marks[draft_.zero_volts ? 1 : 0]) + QLatin1Char(' ') + tr("Set the zero: let the handle go") +
                 (draft_.zero_volts ? tr(": %1 mm").arg(number(1e3 * draft_.in_use().length(*draft_.zero_volts), 2)) : QString()));
}

void CalibrationDialog::keep() {
  draft_.by = by_->text().trimmed().toStdString();
  draft_.valid_days = days_->value();
  sensor::Calibration c;
  std::string wrong = draft_.finish(sensor::today(), c);
  const std::string path = sensor::calibration_path(draft_.serial);
  if (wrong.empty()) wrong = sensor::save_calibration(path, c);
  if (!wrong.empty()) say(said_message(wrong), true);
  if (draft_.by.empty()) by_->setFocus();
  if (!wrong.empty()) return;
  say(c.poses.known() ? tr("Kept, valid until %1.").arg(QString::fromStdString(c.expires))
                      : tr("Kept, valid until %1. It is used once the three poses are measured.").arg(QString::fromStdString(c.expires)),
      false);
  Q_EMIT kept();
}

QStringList stored_calibrations() {
  QStringList out;
  for (const std::string& path : sensor::calibration_files()) {
    sensor::Calibration c;
    if (const std::string wrong = sensor::load_calibration(path, c); !wrong.empty()) {
      out += QStringLiteral("▲ ") + said_of_file(path, wrong);
      continue;
    }
    const std::string trouble = sensor::calibration_trouble(c, "", sensor::today());
    out += !trouble.empty()      ? QStringLiteral("▲ %1: ").arg(QString::fromStdString(c.serial)) + said_message(trouble)
           : !c.poses.known() ? QObject::tr("▲ %1: the poses of its needleholder are missing").arg(QString::fromStdString(c.serial))
           : sensor::days_between(c.date, sensor::today()) > kAmber_days
               ? QObject::tr("▲ %1: %2 days old. Check it on a gauge, or calibrate anew").arg(QString::fromStdString(c.serial)).arg(sensor::days_between(c.date, sensor::today()))
                                 : QObject::tr("● %1: of %2 by %3, until %4, worst residual %5 µm")
                                       .arg(QString::fromStdString(c.serial), QString::fromStdString(c.date), QString::fromStdString(c.by),
                                            QString::fromStdString(c.expires), number(1e6 * c.displacement.worst, 1));
  }
  return out;
}

}  // namespace swage::console
