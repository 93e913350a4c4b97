// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/trainee_place.hpp"

#include <QGuiApplication>
#include <QScreen>

#include "console/app/station_dialog.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

TraineePlace::TraineePlace(const WindowPages* pages, Settings& settings, QWidget* window)
    : pages_(pages), run_(pages->run()), settings_(settings), parent_(window), station_(read_station(settings)), look_(read_trainee_look(settings)) {
  look_.stereo.true_size = station_.size;
  run_->set_placing([this](const std::string& device) { return place_hand(device); });
  connect(pages->all(), &Pages::gone_to, this, &TraineePlace::choose_scene);
  connect(pages->review(), &ReviewPage::opened, this, &TraineePlace::choose_scene);
  connect(run_->control(), &RunControl::state_changed, this, &TraineePlace::choose_scene);
}

TraineePlace::~TraineePlace() = default;

void TraineePlace::show() {
  if (!window_) {
    window_ = std::make_unique<TraineeWindow>();
    replays_.reset();
    choose_scene();
    connect(window_->view(), &SceneView::microscope_zoomed, this, [this](float zoom) { look_.stereo.microscope.zoom = zoom; });
    // the window is deleted within its own signal
    connect(window_.get(), &TraineeWindow::closed, this, [this] {
      if (window_) window_.release()->deleteLater();
      if (form_) form_->set_open(false);
    });
  }
  window_->show_as(look_);
  Q_EMIT shown();
  if (form_) form_->set_open(true);
}

// An attempt that runs comes first, whatever page is in front: the trainee sees what the hand does.
void TraineePlace::choose_scene() {
  if (!window_) return;
  const bool reviewing = pages_->all()->current().id == QLatin1String("review") && pages_->review()->player();
  const bool replay = reviewing && !run_->control()->running();
  if (replays_ == replay) return;
  SceneView* view = window_->view();
  if (replay) {
    run_->remove_view(view);
    pages_->review()->add_view(view);
  } else {
    pages_->review()->remove_view(view);
    run_->add_view(view);
  }
  replays_ = replay;
  window_->setWindowTitle(replay ? tr("Swage, trainee: replay") : tr("Swage, trainee"));
}

void TraineePlace::show_with(StereoLayout layout) {
  look_.stereo.layout = layout;
  show();
}

void TraineePlace::toggle() { window_ ? close() : show(); }

void TraineePlace::close() {
  if (window_) window_->close();
}

void TraineePlace::show_settings() {
  if (!form_) {
    form_ = new TraineeSettings(look_, parent_);
    connect(form_, &TraineeSettings::changed, this, [this] {
      look_ = form_->look();
      look_.stereo.true_size = station_.size;
      if (window_) show();
    });
    connect(form_, &TraineeSettings::toggled, this, &TraineePlace::toggle);
  }
  form_->set_open(window_ != nullptr);
  form_->show();
  form_->raise();
}

void TraineePlace::show_station() {
  if (!station_dialog_) {
    const auto make_arm = [run = run_] { return run->make_arm_reader(); };
    station_dialog_ = new StationDialog(station_, look_.stereo.mirror != Mirror::kNone, make_arm, parent_);
    connect(station_dialog_, &StationDialog::changed, this, &TraineePlace::take_station);
    connect(station_dialog_, &StationDialog::mark, this, &TraineePlace::show_mark);
  }
  const QList<QScreen*> screens = QGuiApplication::screens();
  station_dialog_->set_screen(screens.value(look_.screen, screens.first()));
  station_dialog_->set_device(run_->setup()->device(), run_->setup()->device_name());
  station_dialog_->show();
  station_dialog_->raise();
}

void TraineePlace::take_station() {
  station_ = station_dialog_->station();
  console::remember(station_, settings_);
  look_.stereo.true_size = station_.size;
  if (window_) window_->view()->set_stereo(look_.stereo);
}

// shows the mark of a registration over the trainee's picture
void TraineePlace::show_mark(const std::optional<QPointF>& at_mm) {
  if (at_mm && !window_) show();
  if (window_) window_->view()->set_station_mark(at_mm);
}

// The placement of the registered arm in the trainee's picture; no value without a registration that fits. Mirrored lessons need no
// exception: their picture, too, is seen where the hand is.
std::optional<Placement> TraineePlace::place_hand(const std::string& device) {
  const TrueSize& size = station_.size;
  const bool placed = window_ && size.on && size.held && size.known() && station_.registered && station_.device.toStdString() == device;
  if (!placed) return {};
  const OrbitCamera& camera = window_->view()->camera();
  const QVector3D at = camera.focus() / static_cast<float>(kMmPerM);
  const QQuaternion q = camera.q_WC();
  const swage_vec3 p_WS{static_cast<double>(at.x()), static_cast<double>(at.y()), static_cast<double>(at.z())};
  const swage_quat q_WS{static_cast<double>(q.scalar()), static_cast<double>(q.x()), static_cast<double>(q.y()), static_cast<double>(q.z())};
  const double scale = static_cast<double>(size.scale);
  return Placement{session::place_device(station_.arm, p_WS, q_WS, scale), scale};
}

}  // namespace swage::console
