// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/attempt_exports.hpp"

#include <QHBoxLayout>
#include <QMenu>
#include <QSaveFile>

#include "console/models/said.hpp"
#include "console/report/attempt_report.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/save_file.hpp"

namespace swage::console {
namespace {

QString write_file(const QString& name, const std::string& text) {
  QSaveFile file(name);
  const bool ok =
      file.open(QIODevice::WriteOnly) &&
      file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
      file.commit();
  return ok ? QString() : QObject::tr("%1 cannot be written: %2.").arg(name, file.errorString());
}

}  // namespace

AttemptExports::AttemptExports(const ReviewedAttempt& attempt, QWidget* parent) : QWidget(parent), attempt_(attempt) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  report_ = make_button(tr("Report (PDF)"), {}, QStringLiteral("save_report"), this);
  report_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
  report_->setToolTip(QStringLiteral("%1 (%2)").arg(tr("Pages to print: result, metrics, ratings, worst moments, traces, notes"),
                                                     report_->shortcut().toString(QKeySequence::NativeText)));
  connect(report_, &QPushButton::clicked, this,
          [this] { save(tr("Save pages about the attempt"), QStringLiteral("_report.pdf"), &AttemptExports::write_report); });
  row->addWidget(report_);
  export_ = make_button(tr("Export"), {}, QStringLiteral("review_export"), this);
  export_->setToolTip(tr("The attempt as a file for other programs, or for another station"));
  auto* menu = new QMenu(export_);
  menu->setToolTipsVisible(true);
  export_->setMenu(menu);
  row->addWidget(export_);
  add_action(tr("Save attempt"), "save_swage", tr("Save the whole attempt"), QStringLiteral(".swage"),
             tr("Everything in one file: swage replay and another station's Swage can read it"), QKeySequence(Qt::CTRL | Qt::Key_E),
             &AttemptExports::write_swage);
  add_action(tr("Export signals (CSV)"), "save_signals", tr("Save the signals"), QStringLiteral("_signals.csv"),
             tr("A thousand lines a second, SI units"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), &AttemptExports::write_signals);
  add_action(tr("Export summary (CSV)"), "save_summary", tr("Save metrics and events"), QStringLiteral("_summary.csv"),
             tr("Facts, metrics, ratings and events"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), &AttemptExports::write_summary);
}

void AttemptExports::add_action(const QString& text, const char* name, const QString& title, const QString& ending, const QString& tip,
                                const QKeySequence& key, Write write) {
  QAction* action = export_->menu()->addAction(text);
  action->setObjectName(QString::fromLatin1(name));
  action->setToolTip(tip);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [=, this] { save(title, ending, write); });
  actions_ += action;
}

void AttemptExports::set_available(bool on) {
  for (QAction* action : actions_) action->setEnabled(on);
  export_->setEnabled(on);
  report_->setEnabled(on);
}

QString AttemptExports::write_swage(const QString& file) const {
  std::string error;
  const bool ok = attempt_.store() && attempt_.store()->export_attempt(attempt_.review().attempt.id, file.toStdString(), error);
  return ok ? QString() : tr("%1 cannot be written: %2").arg(file, said_message(error));
}

// writes numbers only; what they were measured with is written beside them
QString AttemptExports::write_signals(const QString& file) const {
  QString problem = write_file(file, signals_csv(attempt_.recording()));
  for (const record::Exported& about : attempt_.exported())
    if (problem.isEmpty()) problem = write_file(file + QStringLiteral(".about.json"), record::about_json(about) + "\n");
  return problem;
}

QString AttemptExports::write_summary(const QString& file) const {
  std::string text = summary_csv(attempt_.review());
  for (const record::Exported& about : attempt_.exported()) text += made_with_csv(about);
  return write_file(file, text);
}

QString AttemptExports::write_report(const QString& file) const {
  return write_attempt_report({attempt_.review(), attempt_.recording(), attempt_.worst(), entry_track(attempt_.recording()), attempt_.notes(),
                               attempt_.exported()},
                              file);
}

void AttemptExports::save(const QString& title, const QString& ending, Write write) {
  const record::AttemptRow& row = attempt_.review().attempt;
  const QString name =
      QString::fromStdString(row.lesson_id + "_" + row.started_utc).replace(QLatin1Char(':'), QLatin1Char('-')) + ending;
  const QString file = ask_save(this, title, name, QStringLiteral("(*.%1)").arg(ending.section(QLatin1Char('.'), -1)));
  if (file.isEmpty()) return;
  const QString problem = (this->*write)(file);
  Q_EMIT told(problem.isEmpty() ? tr("Saved to: %1").arg(file) : problem);
}

}  // namespace swage::console
