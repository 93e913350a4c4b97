// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/fault_card.hpp"

#include <QVBoxLayout>
#include <algorithm>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"
#include "record/recorder.hpp"

namespace swage::console {
namespace {

// Largest number of listed problems, of two or more lines each: with more the picture has no room at 800 pixels of height.
constexpr qsizetype kMostProblems = 5;

}  // namespace

FaultCard::FaultCard(QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      unrecorded_(make_button(tr("Run without recording"), {}, QStringLiteral("run_unrecorded"), this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  words_->setObjectName(QStringLiteral("problem"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->setProperty("card", true);
  column->addWidget(words_);
  unrecorded_->setToolTip(tr("The lesson runs; nothing of this attempt is kept"));
  connect(unrecorded_, &QPushButton::clicked, this, &FaultCard::run_unrecorded);
  column->addWidget(unrecorded_, 0, Qt::AlignLeft);
  clear();
}

void FaultCard::take_room() { setVisible(!words_->isHidden() || !unrecorded_->isHidden()); }

void FaultCard::say(const QString& words) {
  words_->setText(words);
  words_->show();
  take_room();
}

void FaultCard::hide_words() {
  words_->hide();
  take_room();
}

void FaultCard::set_offered(bool offered) {
  unrecorded_->setVisible(offered);
  take_room();
}

void FaultCard::clear() {
  set_offered(false);
  hide_words();
}

void FaultCard::say_unrecorded() { say(tr("▲ NOT RECORDED: nothing of this attempt is kept. %1").arg(refused_)); }

void FaultCard::show_record_warning(const base::Problems& problems) {
  for (const base::Problem& p : problems) {
    if (p.severity == base::Severity::kNote || !p.where.starts_with(record::kRecordPlace)) continue;
    say(QStringLiteral("▲ ") + said_message(p.message));
  }
}

void FaultCard::show_problems(const base::Problems& problems) {
  QStringList lines;
  // with problems of the record only, the lesson itself can run
  bool only_record = false;
  for (const base::Problem& p : problems) {
    if (p.severity != base::Severity::kError) continue;
    only_record = p.where.starts_with(record::kRecordPlace);
    if (!only_record) break;
    refused_ = said_message(p.message);
  }
  set_offered(only_record);
  for (const base::Problem& p : problems) lines += QString::fromStdString(p.where + "\n    ") + said_message(p.message);
  words_->setToolTip(lines.join(QLatin1Char('\n')));
  const qsizetype more = lines.size() - kMostProblems;
  lines = lines.first(std::min(lines.size(), kMostProblems));
  if (more > 0) lines += more == 1 ? tr("… and one more.") : tr("… and %1 more.").arg(more);
  say(tr("This lesson cannot run:") + QLatin1Char('\n') + lines.join(QLatin1Char('\n')));
}

}  // namespace swage::console
