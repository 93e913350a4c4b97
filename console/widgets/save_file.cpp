// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/save_file.hpp"

#include <QFileDialog>

namespace swage::console {
namespace {

/// "json" of "Lessons (*.json)".
QString ending_of(const QString& filter) { return filter.section(QStringLiteral("(*."), 1).section(QLatin1Char(')'), 0, 0); }

}  // namespace

QString ask_save(QWidget* parent, const QString& title, const QString& name, const QString& filters) {
  QFileDialog dialog(parent, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  const QStringList all = filters.split(QStringLiteral(";;"));
  dialog.setNameFilters(all);
  dialog.setDefaultSuffix(ending_of(all.first()));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) { dialog.setDefaultSuffix(ending_of(filter)); });
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace swage::console
