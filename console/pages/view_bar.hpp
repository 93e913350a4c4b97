// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The bar over the picture of the Run page: the lesson's title, the camera, display options, sound. On a narrow page one button has the
// others as a menu. [main]
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QList>
#include <QMap>
#include <QMenu>
#include <QPushButton>
#include <QWidget>

#include "console/pages/sound_control.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

class ViewBar : public QWidget {
  Q_OBJECT
 public:
  explicit ViewBar(QWidget* parent = nullptr);
  void set_title(const QString& title) { title_->setText(title); }
  /// `room`: px for title, buttons and sound together.
  void fold_to(int room);
  /// Tells the present view: tooltips and menu say where F11 goes from there.
  void show_view(CameraPreset now);
  bool cues_on() const { return cues_->isChecked(); }
  /// False in a test: neither cues nor forces nor details, which are answers as well.
  void set_cues_allowed(bool allowed);
  bool forces_on() const { return forces_->isChecked(); }
  bool detail_on() const { return detail_->isChecked(); }
  bool insets_on() const { return insets_->isChecked(); }
  /// Sets the button of the instructor's window; emits instructor_toggled on a change.
  void set_instructor(bool shown) { instructor_->setChecked(shown); }
  SoundControl* sound() { return sound_; }

 Q_SIGNALS:
  /// A camera preset was chosen.
  void view_chosen(swage::console::CameraPreset preset);
  /// The view after the present one is wanted.
  void next_view_wanted();
  /// Display options were changed: cues; small views; contact forces.
  void cues_toggled(bool on);
  void insets_toggled(bool on);
  void forces_toggled(bool on);
  /// The instructor's details were switched: technical events, a needle's stress.
  void detail_toggled(bool on);
  /// The instructor's window is to be shown or closed.
  void instructor_toggled(bool on);

 private:
  void add_title();
  void add_presets();
  void add_toggles();
  void add_menu();
  QPushButton* add_toggle(const QString& text, const char* name, const QString& tip, bool on);
  void fill_menu(QMenu* menu) const;

  QHBoxLayout* row_;
  QLabel* title_ = nullptr;
  QMap<CameraPreset, QPushButton*> presets_;
  CameraPreset now_ = CameraPreset::kOrbit;
  QList<QPushButton*> folding_;  // buttons that move into the menu on a narrow page
  QPushButton *cues_ = nullptr, *insets_ = nullptr, *forces_ = nullptr, *detail_ = nullptr, *instructor_ = nullptr, *menu_ = nullptr;
  SoundControl* sound_ = nullptr;
};

}  // namespace swage::console
