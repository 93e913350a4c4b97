// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/attempt_opener.hpp"

#include <QFileDialog>

namespace swage::console {

AttemptOpener::AttemptOpener(const WindowPages* pages, StoreLink* store, QWidget* window)
    : pages_(pages), store_(store), window_(window) {
  connect(pages->run(), &RunPage::review, this, &AttemptOpener::open);
  connect(pages->people()->person(), &PersonPanel::review, this, &AttemptOpener::open);
  connect(pages->people()->person(), &PersonPanel::open_file, this, &AttemptOpener::ask_file);
  connect(pages->review(), &ReviewPage::ask_file, this, &AttemptOpener::ask_file);
}

void AttemptOpener::open(const QString& attempt_id) {
  const std::shared_ptr<record::Store> store = store_->store();
  if (!store) return;
  pages_->review()->open(store, attempt_id);
  pages_->all()->go(QStringLiteral("review"));
}

void AttemptOpener::open_at(const QString& attempt_id, std::optional<double> time_s) {
  const std::shared_ptr<record::Store> store = store_->store();
  if (!store) return;
  QString id = attempt_id;
  if (id == QLatin1String("latest")) {
    const std::vector<record::AttemptRow> all = store->attempt_heads();
    id = all.empty() ? QString() : QString::fromStdString(all.front().id);
  }
  open(id);
  if (time_s) pages_->review()->go(*time_s);
}

void AttemptOpener::ask_file() {
  const QString file = QFileDialog::getOpenFileName(window_, tr("Open an attempt"), {},
                                                    tr("Swage attempts (*.swage);;All files (*)"));
  if (!file.isEmpty()) open_file(file);
}

void AttemptOpener::open_file(const QString& file) {
  pages_->review()->open_file(file);
  pages_->all()->go(QStringLiteral("review"));
}

}  // namespace swage::console
