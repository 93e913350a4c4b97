// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The trainee's window: the scene for two eyes, as under a stereo microscope, and nothing else; and the dialog in which
// the instructor chooses its layout.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QWidget>

#include "console/app/settings.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

/// Screen and layout of the trainee's view.
struct TraineeLook {
  StereoLook stereo;
  int screen = 0;  // index into QGuiApplication::screens(); a missing one means the first
  bool full_screen = false;
};
TraineeLook read_trainee_look(const Settings& settings);
void remember(const TraineeLook& look, Settings& settings);

/// The window. F11 toggles full screen, Esc leaves full screen or closes the window.
class TraineeWindow : public QWidget {
  Q_OBJECT
 public:
  TraineeWindow();
  SceneView* view() { return view_; }
  void show_as(const TraineeLook& look);

 Q_SIGNALS:
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_in_turn(bool on);
  SceneView* view_;
  QWidget* in_turn_ = nullptr;  // covers the view where the driver shows the eyes in turn
};

/// The dialog. Every change acts at once.
class TraineeSettings : public QDialog {
  Q_OBJECT
 public:
  TraineeSettings(const TraineeLook& look, QWidget* parent);
  TraineeLook look() const;
  void set_open(bool open);

 Q_SIGNALS:
  void changed();
  void toggled();

 private:
  void add_layout(QFormLayout* form, const StereoLook& stereo);
  void add_mirror(QFormLayout* form, const StereoLook& stereo);
  void add_eyes(QFormLayout* form, const StereoRig& rig);
  void add_microscope(QFormLayout* form, const Microscope& microscope);
  void add_screen(QFormLayout* form, const TraineeLook& look);
  QDoubleSpinBox* length(const QString& name, float value, double most, const QString& tip);

  QComboBox *layout_, *mirror_, *screen_;
  QDoubleSpinBox *eyes_, *convergence_, *zoom_;
  QCheckBox *squeezed_, *swapped_, *full_, *microscope_, *blur_;
  QPushButton* toggle_;
};

}  // namespace swage::console
