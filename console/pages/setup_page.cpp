// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/setup_page.hpp"

#include <QFormLayout>
#include <QHBoxLayout>

#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kColumn_px = 560;  // longer lines are hard to read

QComboBox* make_choice(const QString& label, const char* name, const QString& tip, QFormLayout* form) {
  auto* choice = new QComboBox;
  choice->setObjectName(QString::fromLatin1(name));
  choice->setAccessibleName(label);
  choice->setToolTip(tip);
  form->addRow(label, choice);
  return choice;
}

}  // namespace

SetupPage::SetupPage(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 10);
  row->setSpacing(12);
  for (QVBoxLayout*& column : columns_) {
    auto* box = new QWidget(this);
    box->setMaximumWidth(kColumn_px);
    column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addStretch(1);
    row->addWidget(box, 1);
  }
  row->addStretch(0);
  add_section(tr("Colours"), make_colours());
  add_section(tr("Trainee's view"), make_trainee());
}

void SetupPage::add_section(const QString& heading, QWidget* section) {
  Card card = make_card(heading, this);
  card.body->addWidget(section);
  QVBoxLayout* column = columns_[sections_++ % 2];
  column->insertWidget(column->count() - 1, card.frame);
}

QWidget* SetupPage::make_colours() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  theme_ = make_choice(tr("Theme"), "theme", tr("Colours of the window"), form);
  for (const QString& id : UiTheme::names()) theme_->addItem(UiTheme::stock(id).title(), id);
  cues_ = make_choice(tr("Cue colours"), "cue_theme", tr("Colours of the cues; shapes, words and sounds stay the same"),
                      form);
  for (const QString& id : CueTheme::stock()) cues_->addItem(CueTheme::stock(id).title(), id);
  for (QComboBox* choice : {theme_, cues_}) {
    connect(choice, &QComboBox::activated, this,
            [this] { Q_EMIT themes_chosen(theme_->currentData().toString(), cues_->currentData().toString()); });
  }
  return box;
}

QWidget* SetupPage::make_trainee() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(make_muted(tr("The scene for two eyes, in a window of its own for the trainee's screen."), box));
  auto* row = new QHBoxLayout;
  auto* open = make_button(tr("Open, close"), QStringLiteral("F9"), QStringLiteral("setup_trainee"), box);
  auto* settings = make_button(tr("Screen, layout, eyes…"), {}, QStringLiteral("setup_trainee_options"), box);
  connect(open, &QPushButton::clicked, this, &SetupPage::trainee_view);
  connect(settings, &QPushButton::clicked, this, &SetupPage::trainee_settings);
  row->addWidget(open);
  row->addWidget(settings);
  row->addStretch(1);
  column->addLayout(row);
  return box;
}

void SetupPage::show_themes(const QString& ui, const QString& cues) {
  theme_->setCurrentIndex(theme_->findData(ui));
  cues_->setCurrentIndex(cues_->findData(cues));
}

}  // namespace swage::console
