// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/station_dialog.hpp"

#include <QDate>
#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {

RulerBar::RulerBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("station_bar"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("A bar of 100 mm, to hold a ruler to"));
}

void RulerBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setPen(QPen(palette().color(QPalette::WindowText), 2));
  if (mm_per_px_ <= 0) {
    p.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, tr("The size of the screen is not known yet."));
    return;
  }
  const double end = 1 + length_px(), y = 12;
  p.drawLine(QPointF(1, y), QPointF(end, y));
  for (int cm = 0; cm <= 10; ++cm) p.drawLine(QPointF(1 + 0.1 * cm * length_px(), y - (cm % 5 == 0 ? 9 : 5)), QPointF(1 + 0.1 * cm * length_px(), y));
  p.drawText(QRectF(0, y + 2, std::max(end, 200.0), 26), Qt::AlignLeft | Qt::AlignTop, tr("100 mm: hold a ruler to it"));
}

StationDialog::StationDialog(const Station& station, bool mirrored, ArmMaker make_arm, QWidget* parent)
    : QDialog(parent), station_(station), make_arm_(std::move(make_arm)) {
  setObjectName(QStringLiteral("station"));
  setWindowTitle(tr("True size and place"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(make_ruler(mirrored));
  column->addWidget(make_arm_section());
  column->addStretch(1);
  show_step();
  show_registration();
}

QDoubleSpinBox* StationDialog::number(const char* name, const QString& label, double low, double high, double value,
                                      const QString& unit, const QString& tip, QFormLayout* form) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QString::fromLatin1(name));
  box->setRange(low, high);
  box->setDecimals(1);
  box->setSuffix(QLatin1Char(' ') + unit);
  box->setValue(value);
  box->setToolTip(tip);
  box->setAccessibleDescription(tip);
  form->addRow(label, box);
  connect(box, &QDoubleSpinBox::valueChanged, this, &StationDialog::read_ruler);
  return box;
}

QWidget* StationDialog::make_ruler(bool mirrored) {
  Card card = make_card(tr("By a ruler"), this);
  auto* form = new QFormLayout;
  const TrueSize& s = station_.size;
  const QString mm = tr("mm"), deg = tr("°");
  width_ = number("station_width", tr("Screen &width"), 0, 5000, s.screen_mm.width(), mm, tr("Width of the part that lights up, along its lower edge"), form);
  height_ = number("station_height", tr("Screen &height"), 0, 5000, s.screen_mm.height(), mm, tr("Height of the part that lights up, along its left edge"), form);
  bar_ = new RulerBar(card.frame);
  form->addRow(QString(), bar_);
  distance_ = number("station_distance", tr("&Eyes to picture"), 50, 5000, static_cast<double>(s.distance_mm), mm,
                     mirrored ? tr("From the eyes to the mirror and on to the screen") : tr("From the eyes to the screen"), form);
  eyes_ = number("station_eyes", tr("Between the &pupils"), 0, 90, static_cast<double>(s.eye_distance_mm), mm,
                 tr("63 mm is usual; 0 shows one picture to both eyes"), form);
  screen_tilt_ = number("station_screen_tilt", tr("&Tilt of the screen"), -180, 180, static_cast<double>(s.screen_tilt_deg), deg,
                        tr("From the table: 90 stands upright, 0 lies with its face up, -45 looks down onto a mirror"), form);
  mirror_tilt_ = number("station_mirror_tilt", tr("Tilt of the m&irror"), -180, 180, static_cast<double>(s.mirror_tilt_deg), deg,
                        tr("From the table; counts where the trainee's view is mirrored"), form);
  scale_ = number("station_scale", tr("&Scale"), 0.1, 100, static_cast<double>(s.scale), tr("×"),
                  tr("1 shows 10 mm as 10 mm; a microscope enlarges 4 to 25 times"), form);
  on_ = new QCheckBox(tr("Show the trainee's view in this size"), card.frame);
  on_->setObjectName(QStringLiteral("station_on"));
  on_->setChecked(s.on);
  held_ = new QCheckBox(tr("Turn it until the picture stands upright for the person"), card.frame);
  held_->setObjectName(QStringLiteral("station_held"));
  held_->setChecked(s.held);
  held_->setToolTip(tr("Nobody turns the view then; needed for hand and tool in one place"));
  form->addRow(on_);
  form->addRow(held_);
  where_ = make_muted({}, card.frame);
  where_->setObjectName(QStringLiteral("station_where"));
  form->addRow(where_);
  for (QCheckBox* box : {on_, held_}) connect(box, &QCheckBox::toggled, this, &StationDialog::read_ruler);
  card.body->addLayout(form);
  return card.frame;
}

QWidget* StationDialog::make_arm_section() {
  Card card = make_card(tr("Hand and tool in one place"), this);
  step_ = make_muted({}, card.frame);
  step_->setObjectName(QStringLiteral("station_step"));
  registration_ = new QLabel(card.frame);
  registration_->setObjectName(QStringLiteral("station_registration"));
  registration_->setWordWrap(true);
  card.body->addWidget(registration_);
  card.body->addWidget(step_);
  auto* row = new QHBoxLayout;
  begin_ = make_button(tr("Register…"), {}, QStringLiteral("station_begin"), card.frame);
  take_ = make_button(tr("Tip is at the mark"), {}, QStringLiteral("station_take"), card.frame);
  forget_ = make_button(tr("Forget"), {}, QStringLiteral("station_forget"), card.frame);
  connect(begin_, &QPushButton::clicked, this, &StationDialog::begin);
  connect(take_, &QPushButton::clicked, this, &StationDialog::take);
  connect(forget_, &QPushButton::clicked, this, [this] {
    station_.registered = false;
    show_registration();
    Q_EMIT changed();
  });
  for (QPushButton* b : {begin_, take_, forget_}) row->addWidget(b);
  row->addStretch(1);
  card.body->addLayout(row);
  return card.frame;
}

void StationDialog::set_device(const QString& device, const QString& name) {
  if (device == device_) return;
  cancel();
  device_ = device, device_name_ = name;
  show_registration();
}

void StationDialog::set_screen(const QScreen* screen) {
  if (screen == nullptr) return;
  screen_px_ = screen->size();
  if (station_.size.screen_mm.isEmpty()) {
    width_->setValue(screen->physicalSize().width());
    height_->setValue(screen->physicalSize().height());
  }
  read_ruler();
}

void StationDialog::read_ruler() {
  TrueSize& s = station_.size;
  s.screen_mm = {width_->value(), height_->value()};
  s.distance_mm = static_cast<float>(distance_->value());
  s.eye_distance_mm = static_cast<float>(eyes_->value());
  s.scale = static_cast<float>(scale_->value());
  s.screen_tilt_deg = static_cast<float>(screen_tilt_->value());
  s.mirror_tilt_deg = static_cast<float>(mirror_tilt_->value());
  s.on = on_->isChecked();
  s.held = held_->isChecked();
  bar_->set_mm_per_pixel(mm_per_pixel(s, screen_px_).width());
  where_->setText(s.known() ? tr("One pixel is %1 mm; 10 mm of the scene are %2 mm on the screen.")
                                  .arg(mm_per_pixel(s, screen_px_).width(), 0, 'f', 3)
                                  .arg(10 * static_cast<double>(s.scale), 0, 'f', 1)
                            : tr("Measure width and height of the screen first."));
  show_registration();
  Q_EMIT changed();
}

void StationDialog::begin() {
  arm_ = make_arm_();
  touched_.clear();
  const QString why = arm_ ? arm_->start() : tr("An attempt runs, or no lesson is chosen on the Run page.");
  if (!why.isEmpty()) {
    arm_.reset();
    step_->setText(QStringLiteral("▲ ") + why);
    return;
  }
  connect(arm_.get(), &ArmReader::moved, this, [this] { take_->setEnabled(arm_ && arm_->still().has_value()); });
  show_step();
}

void StationDialog::take() {
  const std::optional<swage_vec3> p_D = arm_ ? arm_->still() : std::nullopt;
  if (!p_D) return;
  const QPointF at = station_marks(station_.size)[touched_.size()];
  touched_.push_back({{1e-3 * at.x(), 1e-3 * at.y(), 0}, *p_D});
  if (touched_.size() < 4) return show_step();
  const std::string wrong = session::fit_registration(touched_, station_.arm);
  cancel();
  if (!wrong.empty()) return step_->setText(QStringLiteral("▲ ") + said_message(wrong) + tr(" Nothing is kept."));
  station_.registered = true;
  station_.device = device_;
  station_.date = QDate::currentDate().toString(Qt::ISODate);
  show_registration();
  Q_EMIT changed();
}

void StationDialog::cancel() {
  arm_.reset();
  touched_.clear();
  Q_EMIT mark({});
  show_step();
}

void StationDialog::show_step() {
  const bool runs = arm_ != nullptr;
  take_->setVisible(runs);
  take_->setEnabled(false);
  begin_->setText(runs ? tr("Begin again") : tr("Register…"));
  if (!runs) return step_->clear();
  const QString names[] = {tr("upper left"), tr("upper right"), tr("lower right"), tr("lower left")};
  step_->setText(tr("Mark %1 of 4, %2: lead the tip to it and hold still.").arg(touched_.size() + 1).arg(names[touched_.size()]));
  Q_EMIT mark(station_marks(station_.size)[touched_.size()]);
}

void StationDialog::show_registration() {
  begin_->setEnabled(station_.size.known() && !device_.isEmpty());
  forget_->setVisible(station_.registered);
  if (!station_.registered)
    return registration_->setText(
        tr("%1 is not registered: the arm's tip is led to four marks of the trainee's view, and its place is known then.")
            .arg(device_name_.isEmpty() ? tr("The instrument") : device_name_));
  const QString said = tr("Registered on %1, worst mark %2 mm off, rms %3 mm.")
                           .arg(station_.date)
                           .arg(1e3 * station_.arm.worst, 0, 'f', 2)
                           .arg(1e3 * station_.arm.rms, 0, 'f', 2);
  registration_->setText(station_.device == device_ ? said
                                                    : said + tr(" It is that of %1, and not used for %2.").arg(station_.device, device_name_));
}

void StationDialog::hideEvent(QHideEvent* event) {
  if (arm_) cancel();
  QDialog::hideEvent(event);
}

}  // namespace swage::console
