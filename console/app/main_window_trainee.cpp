// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The main window, the trainee's and the dialogs of a station: where hand and tool stand in one place, and what a sensor's volts mean.
#include <QGuiApplication>
#include <QScreen>

#include "console/app/calibration_dialog.hpp"
#include "console/app/main_window.hpp"
#include "console/app/station_dialog.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

void MainWindow::show_trainee() {
  if (!trainee_) {
    trainee_ = std::make_unique<TraineeWindow>();
    run_->add_view(trainee_->view());
    connect(trainee_->view(), &SceneView::microscope_zoomed, this, [this](float zoom) { trainee_look_.stereo.microscope.zoom = zoom; });
    // it is closed from within
    connect(trainee_.get(), &TraineeWindow::closed, this, [this] {
      if (trainee_) trainee_.release()->deleteLater();
      if (trainee_settings_) trainee_settings_->set_open(false);
    });
  }
  trainee_->show_as(trainee_look_);
  show_message_to_trainee();
  if (trainee_settings_) trainee_settings_->set_open(true);
}

void MainWindow::toggle_trainee() {
  if (!trainee_) return show_trainee();
  trainee_->close();
}

void MainWindow::show_trainee_settings() {
  if (!trainee_settings_) {
    trainee_settings_ = new TraineeSettings(trainee_look_, this);
    connect(trainee_settings_, &TraineeSettings::changed, this, [this] {
      trainee_look_ = trainee_settings_->look();
      trainee_look_.stereo.true_size = station_.size;
      if (trainee_) show_trainee();
    });
    connect(trainee_settings_, &TraineeSettings::toggled, this, &MainWindow::toggle_trainee);
  }
  trainee_settings_->set_open(trainee_ != nullptr);
  trainee_settings_->show();
  trainee_settings_->raise();
}

void MainWindow::read_station_look() {
  station_ = read_station(settings_);
  trainee_look_ = read_trainee_look(settings_);
  trainee_look_.stereo.true_size = station_.size;
  run_->set_placing([this](const std::string& device) { return place_hand(device); });
}

void MainWindow::show_station() {
  if (!station_dialog_) {
    const auto make_arm = [this] { return run_->make_arm_reader(); };
    station_dialog_ = new StationDialog(station_, trainee_look_.stereo.mirror != Mirror::kNone, make_arm, this);
    connect(station_dialog_, &StationDialog::changed, this, [this] {
      station_ = station_dialog_->station();
      console::remember(station_, settings_);
      trainee_look_.stereo.true_size = station_.size;
      if (trainee_) trainee_->view()->set_stereo(trainee_look_.stereo);
    });
    connect(station_dialog_, &StationDialog::mark, this, [this](const std::optional<QPointF>& at_mm) {
      if (at_mm && !trainee_) show_trainee();
      if (trainee_) trainee_->view()->set_station_mark(at_mm);
    });
  }
  const QList<QScreen*> screens = QGuiApplication::screens();
  station_dialog_->set_screen(screens.value(trainee_look_.screen, screens.first()));
  station_dialog_->set_device(run_->setup()->device(), run_->setup()->device_name());
  station_dialog_->show();
  station_dialog_->raise();
}

void MainWindow::show_calibration() {
  auto* dialog = new CalibrationDialog(UiTheme::stock(ui_id_), {}, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &CalibrationDialog::kept, this, [this] { setup_->show_calibrations(stored_calibrations()); });
  dialog->show();
}

// The instrument where the registered arm stands before the trainee's picture; nothing where that is not so. A mirrored lesson is no
// exception: what is seen of it is where the hand is.
std::optional<Placement> MainWindow::place_hand(const std::string& device) {
  const TrueSize& size = station_.size;
  const bool placed = trainee_ && size.on && size.held && size.known() && station_.registered && station_.device.toStdString() == device;
  if (!placed) return {};
  const OrbitCamera& camera = trainee_->view()->camera();
  const QVector3D at = camera.focus() / static_cast<float>(kMmPerM);
  const QQuaternion q = camera.q_WC();
  const swage_vec3 p_WS{static_cast<double>(at.x()), static_cast<double>(at.y()), static_cast<double>(at.z())};
  const swage_quat q_WS{static_cast<double>(q.scalar()), static_cast<double>(q.x()), static_cast<double>(q.y()), static_cast<double>(q.z())};
  const double scale = static_cast<double>(size.scale);
  return Placement{session::place_device(station_.arm, p_WS, q_WS, scale), scale};
}

// Each person's own instrument is taken up with the name.
void MainWindow::connect_instrument() {
  setup_->set_devices(held_devices(run_->catalogue()));
  const auto take = [this] {
    const QString person = run_->setup()->person();
    const Binding binding = read_binding(settings_, person);
    setup_->show_binding(binding, person);
    run_->set_binding(binding);
  };
  connect(run_->setup(), &SetupPanel::person_chosen, this, take);
  connect(setup_, &SetupPage::binding_chosen, this, [this](const Binding& binding) {
    console::remember(binding, run_->setup()->person(), settings_);
    run_->set_binding(binding);
  });
  take();
}

}  // namespace swage::console
