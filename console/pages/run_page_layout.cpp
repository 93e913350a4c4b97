// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What RunPage is put together from: the bar over the picture, the picture, what is done with an attempt, what happened.
#include <QHBoxLayout>
#include <QMenu>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "console/pages/event_table.hpp"
#include "console/pages/run_page.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kBottom_px = 140;  // three events, or ten cues in two columns; higher where a lesson has more
// On a page narrower or lower than these the side panels are slimmer, and the strip of events gives its room to the picture.
constexpr int kNarrow_px = 1180, kLow_px = 600;
constexpr int kSide_px = 270, kSlimSide_px = 230;        // the whole page fits a screen of 1280
constexpr int kLessons_px = 290, kSlimLessons_px = 256;  // and the titles of the lessons fit the list

// a button that stays as it was pressed
QPushButton* add_toggle(QHBoxLayout* row, QWidget* bar, const QString& text, const char* name,
                        const QString& tip, bool on) {
  auto* button = make_button(text, {}, QString::fromLatin1(name), bar);
  button->setCheckable(true);
  button->setChecked(on);
  button->setToolTip(tip);
  row->addWidget(button);
  return button;
}

}  // namespace

QWidget* RunPage::make_middle() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  view_ = new SceneView(box);
  column->addWidget(make_view_bar());
  problem_ = new QLabel(box);
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setWordWrap(true);
  problem_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  problem_->setProperty("card", true);
  problem_->setVisible(false);
  column->addWidget(problem_);
  unrecorded_ = make_button(tr("Run without recording"), {}, QStringLiteral("run_unrecorded"), box);
  unrecorded_->setToolTip(tr("The lesson runs; nothing of this attempt is kept"));
  unrecorded_->setVisible(false);
  connect(unrecorded_, &QPushButton::clicked, this, &RunPage::start_unrecorded);
  column->addWidget(unrecorded_, 0, Qt::AlignLeft);
  column->addWidget(view_, 1);
  column->addWidget(make_actions());

  column->addWidget(make_bottom());
  return box;
}

void RunPage::resizeEvent(QResizeEvent* event) {
  const bool narrow = width() < kNarrow_px;
  setup_->setFixedWidth(narrow ? kSlimLessons_px : kLessons_px);
  right_box_->setFixedWidth(narrow ? kSlimSide_px : kSide_px);
  bottom_->setVisible(height() >= kLow_px);
  show_keys_below();
  fold_view_bar();
  QWidget::resizeEvent(event);
}

// Where the buttons over the picture do not fit beside each other and the title, one button has them as a menu.
void RunPage::fold_view_bar() {
  constexpr int kLongestTitle_px = 330, kSound_px = 140;
  int wanted = std::min(title_->sizeHint().width(), kLongestTitle_px) + kSound_px;
  for (const QPushButton* b : folding_) wanted += b->sizeHint().width() + 6;
  const int sides = setup_->maximumWidth() + right_box_->maximumWidth();
  const bool fold = width() - sides < wanted;
  for (QPushButton* b : folding_) b->setVisible(!fold);
  view_menu_->setVisible(fold);
}

// Five buttons fit below a narrow picture when each has its key on a second line.
void RunPage::show_keys_below() {
  const QString beside = QStringLiteral("   "), below = QStringLiteral("\n");
  const bool narrow = width() < kNarrow_px;
  for (QPushButton* b : {pause_, reset_, mark_, stop_, guide_button_}) {
    QString text = b->text();
    b->setText(narrow ? text.replace(beside, below) : text.replace(below, beside));
  }
}

void RunPage::fill_view_menu(QMenu* menu) const {
  menu->clear();
  for (QPushButton* b : folding_) {
    QAction* action = menu->addAction(b->accessibleName(), b, &QPushButton::click);
    action->setCheckable(b->isCheckable());
    action->setChecked(b->isChecked());
    action->setEnabled(b->isEnabled());
  }
}

// what happened, and what the cues mean
QWidget* RunPage::make_bottom() {
  auto* box = bottom_ = new QWidget(this);
  box->setMinimumHeight(kBottom_px);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // as high as the legend asks for
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  event_table_ = make_event_table(shown_events_, box);
  event_table_->setObjectName(QStringLiteral("events"));
  event_table_->setAccessibleName(tr("What happened in this attempt"));
  event_table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  row->addWidget(event_table_, 5);
  legend_ = new CueLegend(box);
  row->addWidget(legend_, 9);
  return box;
}

QWidget* RunPage::make_view_bar() {
  auto* bar = new QWidget(this);
  // it never keeps the window wide: what does not fit goes into the menu
  bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  title_ = new ElidedLabel(bar);
  title_->setObjectName(QStringLiteral("lesson_title"));
  QFont font = title_->font();
  font.setPointSizeF(font.pointSizeF() * 1.2), font.setBold(true);
  title_->setFont(font);
  row->addWidget(title_, 1);
  const struct {
    QString text, name;
    CameraPreset preset;
  } presets[] = {{tr("Orbit"), QStringLiteral("view_orbit"), CameraPreset::kOrbit},
                 {tr("Side"), QStringLiteral("view_side"), CameraPreset::kSide},
                 {tr("Top"), QStringLiteral("view_top"), CameraPreset::kTop},
                 {tr("Near"), QStringLiteral("view_near"), CameraPreset::kNear}};
  for (const auto& p : presets) {
    auto* button = make_button(p.text, {}, p.name, bar);
    button->setToolTip(tr("%1 view").arg(p.text));
    connect(button, &QPushButton::clicked, this, [this, preset = p.preset] { look(preset); });
    row->addWidget(button);
    folding_ += button;
  }
  row->addSpacing(10);
  cues_button_ = add_toggle(row, bar, tr("Cues"), "cues", tr("Show cues in the picture"), true);
  connect(cues_button_, &QPushButton::toggled, this, &RunPage::update_cues);
  second_button_ =
      add_toggle(row, bar, tr("Insets"), "second",
                 tr("Small views: while the mouse is the instrument one at right angles, near the jaws; the "
                    "wound magnified while there is one"),
                 true);
  connect(second_button_, &QPushButton::toggled, this, &RunPage::update_second);
  auto* forces =
      add_toggle(row, bar, tr("Forces"), "forces", tr("Show contact forces in the picture"), false);
  connect(forces, &QPushButton::toggled, this, [this](bool on) { view_->set_forces_shown(on); });
  auto* detail = add_toggle(
      row, bar, tr("Detail"), "detail",
      tr("For the instructor: list also what the machine did, and colour a needle that bends by its stress"),
      false);
  connect(detail, &QPushButton::toggled, this, [this](bool on) {
    shown_events_->show_technical(on);
    view_->set_stress_shown(on);
  });
  row->addSpacing(10);
  instructor_button_ = add_toggle(row, bar, tr("Instructor"), "instructor",
                                  tr("Readings, cues and events in a window of their own, also in a test (F10)"), false);
  connect(instructor_button_, &QPushButton::toggled, this, &RunPage::show_instructor);
  folding_ += {cues_button_, second_button_, forces, detail, instructor_button_};
  view_menu_ = make_button(tr("View"), {}, QStringLiteral("view_menu"), bar);
  auto* menu = new QMenu(view_menu_);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_view_menu(menu); });
  view_menu_->setMenu(menu);
  row->addWidget(view_menu_);
  row->addWidget(make_sound(bar));
  return bar;
}

QWidget* RunPage::make_sound(QWidget* bar) {
  auto* box = new QWidget(bar);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  sound_button_ = make_button(tr("Sound"), {}, QStringLiteral("sound"), box);
  sound_button_->setCheckable(true);
  sound_button_->setChecked(true);
  sound_button_->setToolTip(tr("Let the cues be heard"));
  volume_ = new QSlider(Qt::Horizontal, box);
  volume_->setObjectName(QStringLiteral("volume"));
  volume_->setAccessibleName(tr("Volume"));
  volume_->setToolTip(tr("Volume of the cues"));
  volume_->setRange(0, 100);
  volume_->setFixedWidth(60);
  volume_->setValue(static_cast<int>(100 * speaker_.volume()));
  connect(sound_button_, &QPushButton::toggled, volume_, &QSlider::setEnabled);
  connect(volume_, &QSlider::valueChanged, this, [this](int v) { speaker_.set_volume(v / 100.0); });
  // what it will sound like
  connect(volume_, &QSlider::sliderReleased, this,
          [this] { speaker_.play(tone(QStringLiteral("high, two knocks"))); });
  row->addWidget(sound_button_);
  row->addWidget(volume_);
  return box;
}

QWidget* RunPage::make_actions() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  pause_ = make_button(tr("Pause"), QStringLiteral("F6"), QStringLiteral("pause"), bar);
  reset_ = make_button(tr("Put back"), QStringLiteral("F7"), QStringLiteral("reset"), bar);
  reset_->setToolTip(tr("Put what the lesson works on back to where it started (F7)"));
  mark_ = make_button(tr("Mark"), QStringLiteral("F8"), QStringLiteral("mark"), bar);
  mark_->setToolTip(tr("Remember the moment two seconds ago (F8)"));
  stop_ = make_button(tr("Stop"), QStringLiteral("Shift+F5"), QStringLiteral("stop"), bar);
  guide_button_ = make_button(tr("Guide"), QStringLiteral("F4"), QStringLiteral("guide"), bar);
  guide_button_->setCheckable(true);
  guide_button_->setToolTip(tr("An expert's instruments, seen through, show what comes next and wait for you; not in a test (F4)"));
  connect(guide_button_, &QPushButton::toggled, this, [this](bool on) {
    if (control_->running()) guide_.toggle(on && !cues_hidden(), control_->shown());
  });
  for (QPushButton* b : {pause_, reset_, mark_, stop_, guide_button_}) row->addWidget(b, 1);
  connect(pause_, &QPushButton::clicked, control_, &RunControl::toggle_pause);
  connect(reset_, &QPushButton::clicked, control_, &RunControl::reset_work);
  connect(mark_, &QPushButton::clicked, control_, &RunControl::mark);
  connect(stop_, &QPushButton::clicked, control_, &RunControl::stop);
  return bar;
}

QWidget* RunPage::make_right() {
  auto* scroll = make_scroll(this);
  right_box_ = scroll;
  right_ = new QStackedWidget(scroll);
  scroll->setWidget(right_);
  now_ = new NowPanel(right_);
  result_ = new ResultPanel(right_);
  right_->addWidget(now_);
  right_->addWidget(result_);
  return scroll;
}

}  // namespace swage::console
