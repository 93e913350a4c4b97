// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/view_bar.hpp"

#include <QHBoxLayout>
#include <QShortcut>
#include <algorithm>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kBarGap_px = 10;                          // between groups of buttons
constexpr int kLongestTitle_px = 330, kSound_px = 140;  // room for title and sound beside the buttons

}  // namespace

ViewBar::ViewBar(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
  // does not limit the width of the window: buttons without room go into the menu
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row_->setContentsMargins(0, 0, 0, 0);
  add_title();
  add_presets();
  row_->addSpacing(kBarGap_px);
  add_toggles();
  add_menu();
  sound_ = new SoundControl(this);
  row_->addWidget(sound_);
}

void ViewBar::add_title() {
  title_ = new ElidedLabel(this);
  title_->setObjectName(QStringLiteral("lesson_title"));
  QFont font = title_->font();
  font.setPointSizeF(font.pointSizeF() * 1.2), font.setBold(true);
  title_->setFont(font);
  row_->addWidget(title_, 1);
}

void ViewBar::add_presets() {
  const struct {
    QString text, name;
    CameraPreset preset;
  } presets[] = {{tr("Orbit"), QStringLiteral("view_orbit"), CameraPreset::kOrbit},
                 {tr("Side"), QStringLiteral("view_side"), CameraPreset::kSide},
                 {tr("Top"), QStringLiteral("view_top"), CameraPreset::kTop},
                 {tr("Near"), QStringLiteral("view_near"), CameraPreset::kNear}};
  for (const auto& p : presets) {
    auto* button = make_button(p.text, {}, p.name, this);
    connect(button, &QPushButton::clicked, this, [this, preset = p.preset] { Q_EMIT view_chosen(preset); });
    row_->addWidget(button);
    folding_ += button;
    presets_[p.preset] = button;
  }
  show_view(now_);
  // of this window alone: in the trainee's F11 fills the screen
  connect(new QShortcut(QKeySequence(Qt::Key_F11), this), &QShortcut::activated, this, &ViewBar::next_view_wanted);
}

void ViewBar::show_view(CameraPreset now) {
  now_ = now;
  const QString from = presets_[now]->text(), to = presets_[view_after(now)]->text();
  for (QPushButton* button : presets_) button->setToolTip(tr("%1 view; F11 goes on from %2 to %3").arg(button->text(), from, to));
}

// a button that can be toggled
QPushButton* ViewBar::add_toggle(const QString& text, const char* name, const QString& tip, bool on) {
  auto* button = make_button(text, {}, QString::fromLatin1(name), this);
  button->setCheckable(true);
  button->setChecked(on);
  button->setToolTip(tip);
  row_->addWidget(button);
  folding_ += button;
  return button;
}

void ViewBar::add_toggles() {
  cues_ = add_toggle(tr("Cues"), "cues", tr("Show cues in the picture"), true);
  connect(cues_, &QPushButton::toggled, this, &ViewBar::cues_toggled);
  insets_ = add_toggle(tr("Insets"), "second",
                       tr("Small views: while the mouse is the instrument one at right angles, near the jaws; the "
                          "wound magnified while there is one"),
                       true);
  connect(insets_, &QPushButton::toggled, this, &ViewBar::insets_toggled);
  forces_ = add_toggle(tr("Forces"), "forces", tr("Show contact forces in the picture"), false);
  connect(forces_, &QPushButton::toggled, this, &ViewBar::forces_toggled);
  detail_ =
      add_toggle(tr("Detail"), "detail",
                 tr("For the instructor: list also what the machine did, and colour a needle that bends by its stress"), false);
  connect(detail_, &QPushButton::toggled, this, &ViewBar::detail_toggled);
  row_->addSpacing(kBarGap_px);
  instructor_ = add_toggle(tr("Instructor"), "instructor",
                           tr("Readings, cues and events in a window of their own (F10); in a test on a screen that the trainee does not see"), false);
  connect(instructor_, &QPushButton::toggled, this, &ViewBar::instructor_toggled);
}

void ViewBar::set_cues_allowed(bool allowed) {
  for (QPushButton* b : {cues_, forces_, detail_}) b->setEnabled(allowed);
}

void ViewBar::add_menu() {
  menu_ = make_button(tr("View"), {}, QStringLiteral("view_menu"), this);
  auto* menu = new QMenu(menu_);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_menu(menu); });
  menu_->setMenu(menu);
  row_->addWidget(menu_);
}

void ViewBar::fill_menu(QMenu* menu) const {
  menu->clear();
  for (QPushButton* b : folding_) {
    // the key is that of the window; the menu tells it where it leads to from the present view
    const QString key = b == presets_[view_after(now_)] ? QStringLiteral("\tF11") : QString();
    QAction* action = menu->addAction(b->accessibleName() + key, b, &QPushButton::click);
    action->setCheckable(b->isCheckable());
    action->setChecked(b->isChecked());
    action->setEnabled(b->isEnabled());
  }
}

void ViewBar::fold_to(int room) {
  int wanted = std::min(title_->sizeHint().width(), kLongestTitle_px) + kSound_px;
  for (const QPushButton* b : folding_) wanted += b->sizeHint().width() + 6;
  const bool fold = room < wanted;
  for (QPushButton* b : folding_) b->setVisible(!fold);
  menu_->setVisible(fold);
}

}  // namespace swage::console
