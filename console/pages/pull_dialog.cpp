// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/pull_dialog.hpp"

#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "console/models/words.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr double kMilli = 1e-3;
// ms between two pictures, and of stepping in each: a step takes some 0.6 ms, so that 5 s of the pull take about 5 s
constexpr int kPicture_ms = 40, kStepping_ms = 30;
constexpr float kPin_mm = 0.25F;  // from the middle between the pins to the one that stays
constexpr float kBeside_mm = 1;   // of the picture beyond a loop that is drawn straight
constexpr uint64_t kSteps = 5;  // between two looks at the clock

/// Tensions of threads are told in mN.
QString tension_text(double N) {
  return std::isfinite(N) ? with_unit(QStringLiteral("%L1").arg(N / kMilli, 0, 'f', 0), "mN") : QStringLiteral("–");
}

}  // namespace

QString knot_text(const QString& word) {
  QString text = word;
  text.replace(QLatin1Char('-'), QChar(0x2212)).replace(QLatin1Char(' '), QStringLiteral(", "));
  return QStringLiteral("(%1)").arg(text);
}

PullDialog::PullDialog(Services services, double at_s, QWidget* parent)
    : QDialog(parent), services_(std::move(services)), at_s_(at_s), snapshot_(std::make_unique<snapshot::Snapshot>()) {
  setObjectName(QStringLiteral("pull_dialog"));
  setWindowTitle(tr("Pull the knot"));
  resize(860, 520);
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  view_ = new SceneView(this);
  view_->setAccessibleName(tr("The knot over two pins that are drawn apart"));
  view_->setMinimumSize(300, 240);
  if (services_.dress) services_.dress(*view_);
  row->addWidget(view_, 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  again_ = buttons->addButton(tr("Pull &again"), QDialogButtonBox::ActionRole);
  again_->setObjectName(QStringLiteral("pull_again"));
  keep_ = buttons->addButton(tr("&Keep as a note"), QDialogButtonBox::ActionRole);
  keep_->setObjectName(QStringLiteral("pull_keep"));
  keep_->setVisible(static_cast<bool>(services_.keep));
  keep_->setToolTip(tr("A note at this moment of the attempt: it is in the list of events and in the report"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(again_, &QPushButton::clicked, this, [this] { pull(); });
  connect(keep_, &QPushButton::clicked, this, &PullDialog::keep);
  timer_.setInterval(kPicture_ms);
  connect(&timer_, &QTimer::timeout, this, &PullDialog::tick);
}

PullDialog::~PullDialog() = default;

QWidget* PullDialog::make_side() {
  auto* side = new QWidget(this);
  side->setFixedWidth(270);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  const auto label = [&](const char* name) {
    auto* made = new QLabel(side);
    made->setObjectName(QString::fromLatin1(name));
    made->setWordWrap(true);
    column->addWidget(made);
    return made;
  };
  knot_ = label("pull_knot");
  column->addSpacing(8);
  share_ = new QProgressBar(side);
  share_->setRange(0, 1000);
  share_->setTextVisible(false);
  share_->setAccessibleName(tr("Tension, of the load"));
  column->addWidget(share_);
  numbers_ = label("pull_numbers");
  result_ = label("pull_result");
  QFont font = result_->font();
  font.setBold(true);
  result_->setFont(font);
  column->addStretch(1);
  auto* form = new QFormLayout;
  load_ = number("pull_load", QStringLiteral("mN"), 1, 10000, 10, 0);
  load_->setValue(wish_.load_N / kMilli);
  form->addRow(tr("&Load"), load_);
  friction_ = number("pull_friction", {}, 0.01, 3, 0.05, 2);
  friction_->setToolTip(tr("Of the thread on itself: nylon has 0.1 to 0.3"));
  form->addRow(tr("&Friction"), friction_);
  column->addLayout(form);
  column->addWidget(make_muted(tr("The attempt is not changed: a copy of its thread, cut free of the tissue, is laid over two pins, one of which goes away "
                                  "from the other. It has failed when a tenth of a usual loop has slipped through."),
                               side));
  return side;
}

QDoubleSpinBox* PullDialog::number(const char* name, const QString& unit, double low, double high, double step, int decimals) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QString::fromLatin1(name));
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  if (!unit.isEmpty()) box->setSuffix(QStringLiteral(" ") + unit);
  return box;
}

bool PullDialog::pull() {
  const bool first = !puller_;
  wish_ = {load_->value() * kMilli, first ? 0 : friction_->value()};
  timer_.stop();
  why_.clear();
  puller_ = services_.open(wish_, why_);
  if (!puller_) {
    result_->setText(tr("▲ %1").arg(why_));
    return false;
  }
  const PulledKnot knot = puller_->knot();
  if (first) friction_->setValue(knot.friction);
  knot_->setText(tr("Knot %1 as it is at %2, loop %3").arg(knot_text(knot.word), clock_text(at_s_), quantity_text(knot.loop_m, QStringLiteral("m"))));
  view_->set_card(puller_->card(), CameraPreset::kTop);
  // the loop as it is drawn straight, from the pin that stays: half its length
  const auto half_mm = static_cast<float>(0.5 * knot.loop_m / kMilli);
  const QVector3D middle_mm(0.5F * half_mm - kPin_mm, 0, 0);
  view_->camera().frame(middle_mm, half_mm + kBeside_mm);
  view_->look(CameraPreset::kTop);
  view_->camera().stay_at(middle_mm);
  view_->camera().jump();
  state_ = {};
  show_state();
  timer_.start();
  return true;
}

void PullDialog::tick() {
  QElapsedTimer clock;
  clock.start();
  bool on = true;
  while (on && clock.elapsed() < kStepping_ms) on = puller_->step(kSteps);
  if (!on) timer_.stop();
  show_state();
}

void PullDialog::show_state() {
  state_ = puller_->state();
  puller_->fill(*snapshot_);
  view_->show_snapshot(*snapshot_);
  const double share = std::isfinite(state_.bears_N) ? state_.bears_N / wish_.load_N : 0;  // nothing is measured before the first step
  share_->setValue(static_cast<int>(1000 * std::min(1.0, share)));
  const QString bears = tension_text(state_.bears_N), slip = quantity_text(state_.slip_m, QStringLiteral("m"));
  numbers_->setText(tr("Tension %1, slip %2").arg(bears, slip));
  QString said = tr("Being pulled …");
  if (state_.over) said = state_.holds ? tr("✓ It holds.") : state_.broke ? tr("▲ The thread parts.") : tr("▲ It gives way.");
  if (state_.over && !state_.health.isEmpty()) said += QStringLiteral("\n") + tr("The solver fell short: %1").arg(state_.health);
  result_->setText(said);
  keep_->setEnabled(state_.over);
}

QString PullDialog::note() const {
  const PulledKnot knot = puller_->knot();
  const QString what = tr("Knot %1 pulled, friction %L2:").arg(knot_text(knot.word)).arg(knot.friction);
  const QString slip = quantity_text(state_.slip_m, QStringLiteral("m"));
  if (state_.holds) return tr("%1 holds %2, slip %3").arg(what, tension_text(wish_.load_N), slip);
  const QString bears = tension_text(state_.bears_N);
  return state_.broke ? tr("%1 the thread parts at %2, slip %3").arg(what, bears, slip) : tr("%1 gives way at %2, slip %3").arg(what, bears, slip);
}

void PullDialog::keep() {
  if (!services_.keep(note())) return result_->setText(tr("▲ The note was not kept."));
  keep_->setEnabled(false);
  result_->setText(result_->text() + QStringLiteral("\n") + tr("Kept as a note."));
}

}  // namespace swage::console
