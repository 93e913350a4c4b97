// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/now_panel.hpp"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <cmath>

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr double kTiltAxis_deg = 60;
constexpr double kTensionHeld_s = 0.25;  // interval of the displayed maximum tension, long enough to read the number
constexpr double kSoon_s = 15;  // remaining time at which it is highlighted
constexpr double kShown_N = 8;  // end of the force axis without a limit

// In mN whatever the value is: a thread of 10-0 breaks at 0.3 N, and a unit that changes while it is read misleads.
QString tension_text(double tension_N) { return with_unit(QLocale().toString(1e3 * tension_N, 'f', 1), "mN"); }

}  // namespace

NowPanel::NowPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  Card now = make_card(tr("Now"), this);
  card_ = now.frame;
  phase_ = make_muted(QString(), now.frame);
  now.body->addWidget(phase_);
  advice_ = new QLabel(now.frame);
  advice_->setObjectName(QStringLiteral("advice"));
  advice_->setWordWrap(true);
  now.body->addWidget(advice_);
  now.body->addLayout(make_time(now.frame));
  criteria_ = new QLabel(now.frame);
  criteria_->setObjectName(QStringLiteral("criteria"));
  criteria_->setWordWrap(true);
  criteria_->setTextFormat(Qt::RichText);
  now.body->addWidget(criteria_);
  hidden_ = make_muted(tr("A test: readings are hidden until it is over."), now.frame);
  now.body->addWidget(hidden_);
  readings_ = make_readings(now.frame);
  now.body->addWidget(readings_);
  column->addWidget(now.frame);
  lower_ = make_lower();
  column->addWidget(lower_, 1);
  phase_->setObjectName(QStringLiteral("task_line"));
  column->addStretch(0);
  show_parts();
}

// the time, and the button that unfolds the criteria
QHBoxLayout* NowPanel::make_time(QWidget* parent) {
  auto* row = new QHBoxLayout;
  left_ = new QLabel(parent);
  left_->setObjectName(QStringLiteral("time_left"));
  left_->setWordWrap(true);
  row->addWidget(left_, 1);
  rules_ = make_button(tr("Rules"), QStringLiteral("F2"), QStringLiteral("rules"), parent);
  rules_->setCheckable(true);
  rules_->setToolTip(tr("What is asked, and the limits, in place of the plots"));
  give_key(rules_, QStringLiteral("F2"));
  connect(rules_, &QPushButton::toggled, this, &NowPanel::show_parts);
  row->addWidget(rules_);
  return row;
}

QWidget* NowPanel::make_readings(QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  force_name_ = new QLabel(tr("Jaw force"), box);
  column->addWidget(force_name_);
  meter_ = new ForceMeter(box);
  column->addWidget(meter_);
  auto* facts = new QGridLayout;
  facts->setHorizontalSpacing(8);
  facts->setColumnStretch(2, 1);
  const auto add = [&](int row, const QString& name, bool with_badge) {
    Fact fact{new QLabel(name, box), new QLabel(QStringLiteral("–"), box),
              with_badge ? new CueBadge(box) : nullptr};
    facts->addWidget(fact.name, row, 0);
    if (fact.badge) facts->addWidget(fact.badge, row, 1);
    facts->addWidget(fact.value, row, 2);
    return fact;
  };
  spot_ = add(0, tr("Position"), true);
  tips_ = add(1, tr("Tips"), true);
  tilt_ = add(2, tr("Tilt"), false);
  tension_ = add(3, tr("Thread"), false);
  tension_.name->setToolTip(tr("Tension of the thread that is drawn"));
  tension_.value->setObjectName(QStringLiteral("thread_tension"));
  hold_ = add(4, tr("Hold"), false);
  column->addLayout(facts);
  counts_ = new QGridLayout;
  counts_->setColumnStretch(0, 1);
  column->addLayout(counts_);
  return box;
}

// plots of the last ten seconds, or the parameters to adjust
QWidget* NowPanel::make_lower() {
  Card card = make_card({}, this);
  auto* tabs = new QHBoxLayout;
  tabs->setSpacing(4);
  auto* pages = new QStackedWidget(card.frame);
  const QStringList names = {tr("Plots"), tr("Adjust")};
  for (int i = 0; i < names.size(); ++i) {
    auto* tab = make_button(names[i], {}, QStringLiteral("lower_%1").arg(i), card.frame);
    tab->setProperty("page", true);
    tab->setCheckable(true);
    tab->setAutoExclusive(true);
    tab->setChecked(i == 0);
    tab->setToolTip(i == 0 ? tr("Force and tilt of the last ten seconds")
                           : tr("What may be changed while the lesson runs"));
    connect(tab, &QPushButton::clicked, pages, [pages, i] { pages->setCurrentIndex(i); });
    tabs->addWidget(tab);
    tabs_ += tab;
  }
  tabs->addStretch(1);
  card.body->addLayout(tabs);

  auto* plots = new QWidget(pages);
  auto* column = new QVBoxLayout(plots);
  column->setContentsMargins(0, 0, 0, 0);
  force_plot_ = new TracePlot(tr("Jaw force"), QStringLiteral("N"), plots);
  tilt_plot_ = new TracePlot(tr("Tilt"), QStringLiteral("°"), plots);
  tilt_plot_->set_range(0, kTiltAxis_deg);
  column->addWidget(force_plot_);
  column->addWidget(tilt_plot_);
  pages->addWidget(plots);

  auto* scroll = new QScrollArea(pages);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // the list scrolls: its length must not stretch the column
  form_ = new LiveForm(scroll);
  scroll->setWidget(form_);
  // transparent, on the card's background
  scroll->viewport()->setAutoFillBackground(false);
  form_->setAutoFillBackground(false);
  pages->addWidget(scroll);
  card.body->addWidget(pages, 1);
  return card.frame;
}

void NowPanel::set_themes(const UiTheme& ui, const CueTheme& cues) {
  cues_ = cues;
  meter_->set_theme(ui);
  force_plot_->set_theme(ui, "plot");
  tilt_plot_->set_theme(ui, "plot_2");
}

void NowPanel::set_running(bool running) {
  if (running_ != running) rules_->setChecked(false);
  running_ = running;
  show_parts();
}

void NowPanel::set_readings_hidden(bool hidden) {
  readings_hidden_ = hidden;
  if (hidden) show_task();
  show_parts();
}

void NowPanel::set_advice(const QString& words) {
  const QString text = words.isEmpty() ? words : QStringLiteral("▶ ") + words;
  if (text == advice_->text()) return;
  advice_->setText(text);
  show_parts();
}

/// Before the attempt shows the criteria, during it the readings; without a lesson neither.
void NowPanel::show_parts() {
  const bool asks = !criteria_->text().isEmpty(), unfolded = running_ && rules_->isChecked();
  card_->setVisible(has_scene_);
  criteria_->setVisible(asks && (!running_ || unfolded));
  left_->setVisible(running_);
  rules_->setVisible(running_ && asks);
  advice_->setVisible(running_ && !readings_hidden_ && !advice_->text().isEmpty());
  hidden_->setVisible(readings_hidden_);
  readings_->setVisible(has_scene_ && !readings_hidden_ && (running_ || !asks));
  lower_->setVisible(has_scene_ && !readings_hidden_ && !unfolded && (running_ || !asks));  // before the attempt criteria take this room
}

// In a test the time limit ends the attempt; in practice exceeding it is reported.
void NowPanel::show_time(double time_s) {
  const double left = asked_.max_time_s - time_s;
  const bool soon = asked_.max_time_s > 0 && left <= kSoon_s;
  const QString text = asked_.max_time_s <= 0 ? tr("Time: %1").arg(clock_text(time_s))
                       : left > 0             ? tr("Time left: %1").arg(clock_text(std::ceil(left)))
                                              : tr("Over the time limit by %1").arg(clock_text(-left));
  left_->setText(soon ? QStringLiteral("▲ ") + text : text);
  QFont font = left_->font();
  font.setBold(soon);
  left_->setFont(font);
}

// the lesson's task, until a phase is known
void NowPanel::show_task() {
  phase_->setText(task_.isEmpty() ? tr("Press START, then follow the marks in the picture.") : task_);
}

void NowPanel::set_scene(const Reader& reader, const ForceBand& band, const QString& task, const Criteria& criteria) {
  asked_ = criteria;
  task_ = task;
  criteria_->setText(list_text(criteria.show ? tr("Demonstration") : tr("To pass"), criteria.pass) +
                     list_text(tr("Limits in a test"), criteria.limits) + list_text(tr("Ends every attempt"), criteria.ends) +
                     list_text(tr("Points"), criteria.points));
  force_name_->setVisible(reader.has_force());
  meter_->setVisible(reader.has_force());
  show_task();
  spot_.set_visible(reader.has_grasp());
  tips_.set_visible(reader.has_grasp());
  tilt_.set_visible(reader.has_tilt());
  tension_.set_visible(reader.has_tension());
  hold_.set_visible(reader.has_hold());
  tilt_.name->setText(reader.inserts() ? tr("Angle") : tr("Tilt"));
  tilt_.name->setToolTip(reader.inserts() ? tr("Between the needle and the perpendicular to the tissue")
                                          : tr("Away from a right-angled grasp"));
  tilt_plot_->set_title(reader.inserts() ? tr("Deviation from perpendicular") : tr("Tilt"));
  const bool judged = std::isfinite(band.high);
  const double axis = nice_end(judged ? 1.4 * band.high : kShown_N);
  meter_->set_range(axis, band.low, band.high);
  force_plot_->set_range(0, axis);
  force_plot_->clear();
  tilt_plot_->clear();
  force_plot_->set_limit(judged ? meter_->limit() : std::nan(""));
  force_plot_->setVisible(reader.has_force());
  tilt_plot_->setVisible(reader.has_tilt());
  // without plots only the parameters are shown
  const bool plots = reader.has_force() || reader.has_tilt();
  if (!plots) tabs_[1]->click();
  if (plots && tabs_[0]->isHidden()) tabs_[0]->click();
  tabs_[0]->setVisible(plots);
  show_reading({}, 0);
  has_scene_ = true;
  show_parts();
}

void NowPanel::Fact::set_visible(bool shown) const {
  name->setVisible(shown);
  value->setVisible(shown);
  if (badge) badge->setVisible(shown);
}

void NowPanel::show_fact(const Fact& fact, std::optional<bool> is, QChar filled, const QString& yes,
                         const QString& no) {
  CueStyle style =
      cues_.style(is.value_or(false) ? QStringLiteral("grasp.good") : QStringLiteral("grasp.wrong"));
  style.shape = is ? QString(*is ? filled : filled.toLower()) : QString();
  fact.badge->set_style(style);
  fact.value->setText(!is ? QStringLiteral("–") : *is ? yes : no);
}

// Shows the tension beside the lesson's limit, if there is one.
void NowPanel::show_tension(const Reading& r, double time_s) {
  tension_N_ = std::max(tension_N_, r.tension.value_or(0));
  const bool again = time_s < tension_since_s_;  // a new attempt: its time starts again
  if (r.tension && !again && time_s < tension_since_s_ + kTensionHeld_s && time_s > 0) return;
  const double now = again ? r.tension.value_or(0) : tension_N_, most = asked_.max_tension_N;
  const QString text = tension_text(now);
  tension_.value->setText(!r.tension   ? QStringLiteral("–")
                          : most <= 0  ? text
                          : now > most ? tr("▲ %1, over %2").arg(text, tension_text(most))
                                       : tr("%1 of %2").arg(text, tension_text(most)));
  tension_N_ = 0;
  tension_since_s_ = time_s;
}

void NowPanel::show_reading(const Reading& r, double time_s) {
  // the phase follows from judged events: in a test it would reveal that a grasp is right
  if (!r.phase.isEmpty() && !readings_hidden_) phase_->setText(said(r.phase));
  show_time(time_s);
  const bool contact = r.force && *r.force > 0;
  // tissue and tray exert force on closed jaws, too
  meter_->set_value(contact ? r.force : std::nullopt, !contact || r.held.value_or(true));
  show_fact(spot_, r.spot, QLatin1Char('O'), tr("right"), tr("not yet"));
  show_fact(tips_, r.tips, QLatin1Char('V'), tr("used"), tr("not yet"));
  tilt_.value->setText(r.tilt ? quantity_text(*r.tilt, QStringLiteral("rad")) : QStringLiteral("–"));
  show_tension(r, time_s);
  hold_.value->setText(r.hold ? QStringLiteral("%1 %").arg(100 * *r.hold, 0, 'f', 0) : QStringLiteral("–"));
  while (count_names_.size() < r.counts.size()) {
    const int row = static_cast<int>(count_names_.size());
    count_names_.append(make_muted({}, this));
    count_values_.append(new QLabel(this));
    counts_->addWidget(count_names_.last(), row, 0);
    counts_->addWidget(count_values_.last(), row, 1, Qt::AlignRight);
  }
  for (int i = 0; i < count_names_.size(); ++i) {
    const bool shown = i < r.counts.size();
    count_names_[i]->setVisible(shown);
    count_values_[i]->setVisible(shown);
    if (!shown) continue;
    count_names_[i]->setText(r.counts[i].name);
    count_values_[i]->setText(r.counts[i].value);
  }
  if (time_s <= 0) return;
  if (r.force) force_plot_->add(time_s, *r.force);
  tilt_plot_->add(time_s, r.tilt ? *r.tilt * display_factor(QStringLiteral("rad")) : std::nan(""));
}

}  // namespace swage::console
