// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/pages.hpp"

#include <QAction>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "console/widgets/parts.hpp"

namespace swage::console {

Pages::Pages(QWidget* parent) : QWidget(parent), bar_frame_(new QFrame(this)), stack_(new QStackedWidget(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  bar_frame_->setObjectName(QStringLiteral("top_bar"));
  bar_ = new QHBoxLayout(bar_frame_);
  bar_->setContentsMargins(14, 0, 14, 0);
  bar_->setSpacing(4);
  auto* name = new QLabel(QStringLiteral("Swage"), bar_frame_);
  name->setProperty("brand", true);
  bar_->addWidget(name);
  bar_->addSpacing(10);
  column->addWidget(bar_frame_);
  column->addWidget(stack_, 1);
}

void Pages::add(const Page& page) {
  if (page.scrolls) {
    QScrollArea* scroll = make_scroll(stack_);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setWidget(page.widget);
    stack_->addWidget(scroll);
  } else {
    stack_->addWidget(page.widget);
  }
  pages_ += page;
  if (page.edits) edits_.addStack(page.edits);
  const auto number = static_cast<int>(pages_.size());
  const QKeySequence key(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + number));
  auto* button = make_button(page.title, {}, QStringLiteral("page_") + page.id, bar_frame_);
  button->setProperty("page", true);
  button->setCheckable(true);
  button->setAutoExclusive(true);
  button->setToolTip(tr("%1 (%2)").arg(page.tip, key.toString(QKeySequence::NativeText)));
  button->setChecked(number == 1);
  connect(button, &QPushButton::clicked, this, [this, id = page.id] { go(id); });
  // behind the buttons of the other pages, before the items that the window adds
  bar_->insertWidget(1 + number, button);
  buttons_ += button;
  auto* action = new QAction(page.title, this);
  action->setShortcut(key);
  action->setShortcutContext(Qt::ApplicationShortcut);
  connect(action, &QAction::triggered, button, &QPushButton::click);
  addAction(action);
}

bool Pages::go(const QString& id) {
  const auto at = std::find_if(pages_.begin(), pages_.end(), [&](const Page& p) { return p.id == id; });
  if (at == pages_.end()) return false;
  const auto i = static_cast<int>(at - pages_.begin());
  stack_->setCurrentIndex(i);
  buttons_[i]->setChecked(true);
  edits_.setActiveStack(at->edits);
  if (at->shown) at->shown();
  Q_EMIT gone_to(id);
  return true;
}

void Pages::set_themes(const UiTheme& ui, const CueTheme& cues) {
  for (const Page& page : pages_)
    if (page.themed) page.themed(ui, cues);
}

}  // namespace swage::console
