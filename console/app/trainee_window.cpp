// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/trainee_window.hpp"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

#include "console/view3d/quad_window.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr QSize kWindow_px(1280, 640);  // two square pictures

bool flag(const Settings& settings, const char* key) { return settings.text(key) == QLatin1String("true"); }

QString layout_words(StereoLayout layout) {
  switch (layout) {
    case StereoLayout::kSideBySide:
      return QObject::tr("Side by side");
    case StereoLayout::kOverUnder:
      return QObject::tr("Over and under");
    case StereoLayout::kLines:
      return QObject::tr("Lines in turn (passive 3D)");
    case StereoLayout::kChecker:
      return QObject::tr("Chess board (DLP 3D)");
    case StereoLayout::kAnaglyph:
      return QObject::tr("Red and cyan glasses, colour");
    case StereoLayout::kAnaglyphGrey:
      return QObject::tr("Red and cyan glasses, grey");
    case StereoLayout::kAnaglyphLeast:
      return QObject::tr("Red and cyan glasses, least ghosts");
    case StereoLayout::kShutter:
      return QObject::tr("One after the other (shutter glasses)");
    case StereoLayout::kOneEye:
      return QObject::tr("One eye");
    case StereoLayout::kLeftEye:
      return QObject::tr("Left eye only");
    case StereoLayout::kRightEye:
      return QObject::tr("Right eye only");
  }
  return {};
}

}  // namespace

TraineeLook read_trainee_look(const Settings& settings) {
  TraineeLook look;
  StereoLook& stereo = look.stereo;
  stereo.layout = layout_of(settings.text("trainee_layout"));
  stereo.squeezed = flag(settings, "trainee_squeezed");
  stereo.mirror = mirror_of(settings.text("trainee_mirror"));
  stereo.rig.swapped = flag(settings, "trainee_swapped");
  stereo.rig.eye_distance_mm =
      settings.text("trainee_eye_distance_mm", QString::number(StereoRig{}.eye_distance_mm)).toFloat();
  stereo.rig.convergence_mm =
      settings.text("trainee_convergence_mm", QString::number(StereoRig{}.convergence_mm)).toFloat();
  stereo.microscope.on = flag(settings, "trainee_microscope");
  stereo.microscope.blur = flag(settings, "trainee_blur");
  stereo.microscope.zoom = std::clamp(settings.text("trainee_zoom", QString::number(Microscope{}.zoom)).toFloat(), kLeastZoom, kMostZoom);
  look.full_screen = flag(settings, "trainee_full_screen");
  look.screen = settings.text("trainee_screen", QStringLiteral("1")).toInt();
  return look;
}

void remember(const TraineeLook& look, Settings& settings) {
  settings.set("trainee_layout", layout_name(look.stereo.layout));
  settings.set("trainee_squeezed", look.stereo.squeezed);
  settings.set("trainee_mirror", mirror_name(look.stereo.mirror));
  settings.set("trainee_swapped", look.stereo.rig.swapped);
  settings.set("trainee_eye_distance_mm", look.stereo.rig.eye_distance_mm);
  settings.set("trainee_convergence_mm", look.stereo.rig.convergence_mm);
  settings.set("trainee_microscope", look.stereo.microscope.on);
  settings.set("trainee_zoom", look.stereo.microscope.zoom);
  settings.set("trainee_blur", look.stereo.microscope.blur);
  settings.set("trainee_full_screen", look.full_screen);
  settings.set("trainee_screen", look.screen);
}

TraineeWindow::TraineeWindow() : view_(new SceneView(this)) {
  setObjectName(QStringLiteral("trainee"));
  setWindowTitle(tr("Swage, trainee"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view_);
  view_->setObjectName(QStringLiteral("trainee_view"));
  view_->setAccessibleName(tr("The scene for the trainee"));
  view_->set_stereo({});
  resize(kWindow_px);
}

void TraineeWindow::show_as(const TraineeLook& look) {
  StereoLook stereo = look.stereo;
  // the stored layout was chosen with another driver
  if (stereo.layout == StereoLayout::kShutter && !has_quad_buffers()) stereo.layout = StereoLayout::kSideBySide;
  view_->set_stereo(stereo);
  show_in_turn(stereo.layout == StereoLayout::kShutter);
  const QList<QScreen*> screens = QGuiApplication::screens();
  QScreen* wanted = screens.value(look.screen, screens.first());
  if (screen() != wanted || !isVisible())
    setGeometry(QRect(wanted->geometry().topLeft() + QPoint(40, 40), size()));
  look.full_screen ? showFullScreen() : showNormal();
  view_->setFocus();
}

void TraineeWindow::show_in_turn(bool on) {
  if (on == (in_turn_ != nullptr)) return;
  view_->set_eyes_sink({});
  delete in_turn_;
  in_turn_ = nullptr;
  if (!on) return;
  auto* window = new QuadWindow(view_);
  in_turn_ = QWidget::createWindowContainer(window, this);
  in_turn_->setGeometry(rect());
  in_turn_->show();
  view_->set_eyes_sink([window](const QImage& left, const QImage& right) { window->show_eyes(left, right); });
}

void TraineeWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (in_turn_) in_turn_->setGeometry(rect());
}

void TraineeWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_F11) return isFullScreen() ? showNormal() : showFullScreen();
  if (event->key() == Qt::Key_Escape) {
    if (isFullScreen()) return showNormal();
    close();
    return;
  }
  QWidget::keyPressEvent(event);
}

void TraineeWindow::closeEvent(QCloseEvent* event) {
  event->accept();
  Q_EMIT closed();
}

TraineeSettings::TraineeSettings(const TraineeLook& look, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("trainee_settings"));
  setWindowTitle(tr("Trainee view"));
  auto* form = new QFormLayout(this);
  add_layout(form, look.stereo);
  add_mirror(form, look.stereo);
  add_eyes(form, look.stereo.rig);
  add_microscope(form, look.stereo.microscope);
  add_screen(form, look);
  toggle_ = make_button({}, {}, QStringLiteral("trainee_toggle"), this);
  toggle_->setDefault(true);
  auto* close = make_button(tr("Close"), {}, QStringLiteral("trainee_settings_close"), this);
  close->setToolTip(tr("Every change is kept at once (Esc)"));
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  auto* row = new QHBoxLayout;
  row->addWidget(toggle_, 1);
  row->addWidget(close);
  form->addRow(row);
  set_open(false);
  for (QComboBox* box : {layout_, mirror_, screen_})
    connect(box, &QComboBox::currentIndexChanged, this, &TraineeSettings::changed);
  for (QCheckBox* box : {squeezed_, swapped_, full_, microscope_, blur_})
    connect(box, &QCheckBox::toggled, this, &TraineeSettings::changed);
  for (QDoubleSpinBox* box : {eyes_, convergence_, zoom_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &TraineeSettings::changed);
  connect(toggle_, &QPushButton::clicked, this, &TraineeSettings::toggled);
}

void TraineeSettings::add_layout(QFormLayout* form, const StereoLook& stereo) {
  layout_ = new QComboBox(this);
  layout_->setObjectName(QStringLiteral("trainee_layout"));
  for (const StereoLayout l : kStereoLayouts)
    if (l != StereoLayout::kShutter || has_quad_buffers()) layout_->addItem(layout_words(l), layout_name(l));
  layout_->setCurrentIndex(std::max(0, layout_->findData(layout_name(stereo.layout))));
  layout_->setToolTip(
      tr("Red and cyan glasses change the colours of the cues: shapes and words then tell them"));
  form->addRow(tr("&Picture"), layout_);
  if (!has_quad_buffers()) {
    QLabel* shutter = make_muted(tr("Glasses that shut in turn (frame-sequential) need a driver with quad buffers, and this one has none."), this);
    shutter->setObjectName(QStringLiteral("trainee_shutter"));
    form->addRow(QString(), shutter);
  }
  squeezed_ = new QCheckBox(tr("&Half-width side by side (3D TV)"), this);
  squeezed_->setChecked(stereo.squeezed);
  form->addRow(QString(), squeezed_);
}

void TraineeSettings::add_mirror(QFormLayout* form, const StereoLook& stereo) {
  mirror_ = new QComboBox(this);
  mirror_->setObjectName(QStringLiteral("trainee_mirror"));
  mirror_->addItem(tr("None"), mirror_name(Mirror::kNone));
  mirror_->addItem(tr("Left and right"), mirror_name(Mirror::kLeftRight));
  mirror_->addItem(tr("Up and down"), mirror_name(Mirror::kUpDown));
  mirror_->setCurrentIndex(mirror_->findData(mirror_name(stereo.mirror)));
  mirror_->setToolTip(tr("For a screen that is seen in a mirror over the hand"));
  form->addRow(tr("&Mirror"), mirror_);
}

void TraineeSettings::add_eyes(QFormLayout* form, const StereoRig& rig) {
  swapped_ = new QCheckBox(tr("S&wap eyes"), this);
  swapped_->setChecked(rig.swapped);
  form->addRow(QString(), swapped_);
  eyes_ = length(QStringLiteral("trainee_eyes"), rig.eye_distance_mm, 70,
                 tr("Stereo base of the microscope, at a working distance of 250 mm; 24 mm is usual, more "
                    "exaggerates the depth"));
  form->addRow(tr("&Eye separation"), eyes_);
  convergence_ = length(QStringLiteral("trainee_convergence"), rig.convergence_mm, 1000,
                        tr("Things at this distance lie in the plane of the screen. 250 mm is the plane in focus; with less, everything recedes behind the screen"));
  convergence_->setMinimum(50);
  form->addRow(tr("&Convergence"), convergence_);
}

void TraineeSettings::add_microscope(QFormLayout* form, const Microscope& microscope) {
  microscope_ = new QCheckBox(tr("Look of a &microscope"), this);
  microscope_->setObjectName(QStringLiteral("trainee_microscope"));
  microscope_->setToolTip(tr("A round field, its light fading to the rim"));
  microscope_->setChecked(microscope.on);
  form->addRow(QString(), microscope_);
  zoom_ = length(QStringLiteral("trainee_zoom"), microscope.zoom, static_cast<double>(kMostZoom),
                 tr("As makers say it: 1 is the bare eye at 250 mm. In the view Ctrl+Page up and down, a pedal that sends them, or the wheel. Where the "
                    "station was measured it is true"));
  zoom_->setMinimum(static_cast<double>(kLeastZoom));
  zoom_->setSuffix(tr(" ×"));
  form->addRow(tr("Ma&gnification"), zoom_);
  blur_ = new QCheckBox(tr("&Depth of field"), this);
  blur_->setObjectName(QStringLiteral("trainee_blur"));
  blur_->setToolTip(tr("What lies before and behind the plane in focus is unsharp; in the view Ctrl+Shift+Page up and down move that plane. "
                       "Without a graphics card pictures come less often"));
  blur_->setChecked(microscope.blur);
  form->addRow(QString(), blur_);
}

void TraineeSettings::add_screen(QFormLayout* form, const TraineeLook& look) {
  screen_ = new QComboBox(this);
  screen_->setObjectName(QStringLiteral("trainee_screen"));
  for (const QScreen* s : QGuiApplication::screens())
    screen_->addItem(
        QStringLiteral("%1 (%2 × %3)").arg(s->name()).arg(s->size().width()).arg(s->size().height()));
  screen_->setCurrentIndex(std::clamp(look.screen, 0, screen_->count() - 1));
  form->addRow(tr("Sc&reen"), screen_);
  full_ = new QCheckBox(tr("&Full screen (F11)"), this);
  full_->setChecked(look.full_screen);
  form->addRow(QString(), full_);
}

QDoubleSpinBox* TraineeSettings::length(const QString& name, float value, double most, const QString& tip) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(0, most);
  box->setDecimals(1);
  box->setSuffix(tr(" mm"));
  box->setValue(static_cast<double>(value));
  box->setToolTip(tip);
  box->setAccessibleDescription(tip);
  return box;
}

TraineeLook TraineeSettings::look() const {
  TraineeLook look;
  look.stereo.layout = layout_of(layout_->currentData().toString());
  look.stereo.squeezed = squeezed_->isChecked();
  look.stereo.mirror = mirror_of(mirror_->currentData().toString());
  look.stereo.rig = {static_cast<float>(eyes_->value()), static_cast<float>(convergence_->value()),
                     swapped_->isChecked()};
  look.stereo.microscope = {microscope_->isChecked(), static_cast<float>(zoom_->value()), blur_->isChecked()};
  look.screen = screen_->currentIndex();
  look.full_screen = full_->isChecked();
  return look;
}

void TraineeSettings::set_open(bool open) {
  toggle_->setText((open ? tr("Close the trainee's view") : tr("Show the trainee's view")) +
                   QStringLiteral("   F9"));
  toggle_->setAccessibleName(open ? tr("Close the trainee's view") : tr("Show the trainee's view"));
}

}  // namespace swage::console
