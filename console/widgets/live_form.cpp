// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/live_form.hpp"

#include "console/models/said.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLocale>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "console/models/words.hpp"
#include "console/widgets/number_box.hpp"
#include "console/widgets/parts.hpp"
#include "host/params.hpp"

namespace swage::console {

namespace {

// the entry of a list that stands for a choice, by the choice's index
int entry_of(const QComboBox& box, double choice) {
  for (int i = 0; i < box.count(); ++i)
    if (box.itemData(i).value<QVector<int>>().contains(static_cast<int>(choice))) return i;
  return -1;
}

}  // namespace

LiveForm::LiveForm(QWidget* parent, Of of) : QFrame(parent), column_(new QVBoxLayout(this)), of_(of) {
  setObjectName(QStringLiteral("live_form"));
  column_->setContentsMargins(0, 0, 0, 0);
  explain_ = make_muted({}, this);
  problem_ = new QLabel(this);
  problem_->setObjectName(QStringLiteral("live_problem"));
  problem_->setWordWrap(true);
  problem_->hide();
  column_->addWidget(explain_);
  column_->addWidget(problem_);
  column_->addStretch(1);
}

void LiveForm::set_params(const QVector<LiveParam>& params) {
  delete body_;
  fields_.clear();
  problem_->hide();
  body_ = new QWidget(this);
  auto* grid = new QGridLayout(body_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setColumnStretch(0, 1);
  std::string part;
  QLabel* heading = nullptr;
  for (const LiveParam& param : params) {
    if (param.instance != part) {
      part = param.instance;
      heading = make_heading(said_id(part), body_);
      grid->addWidget(heading, grid->rowCount(), 0, 1, 3);
    }
    add_field(param, heading, grid);
  }
  column_->insertWidget(1, body_);
  for (const Field& field : fields_) take_start(field);
  find({});
  set_running(running_);
}

void LiveForm::add_field(const LiveParam& param, QLabel* heading, QGridLayout* grid) {
  const auto index = static_cast<int>(fields_.size());
  fields_.append({param, param.start, param.start, {}, nullptr, nullptr, heading});
  const int row = grid->rowCount();
  const QString name = said(param.param.label.empty() ? param.param.id : param.param.label, param.folder);
  const QString doc = said(param.param.doc, param.folder);
  auto* label = new QLabel(name, body_);
  label->setWordWrap(true);
  label->setToolTip(doc);
  grid->addWidget(label, row, 0);
  fields_[index].label = label;
  auto* editors = new QVBoxLayout;
  const int n = param.param.type == SWAGE_PARAM_VECTOR ? static_cast<int>(param.param.dimension) : 1;
  for (int c = 0; c < n; ++c) {
    QWidget* editor = make_editor(index, c);
    editor->setObjectName(
        QStringLiteral("live_%1_%2_%3")
            .arg(QString::fromStdString(param.instance), QString::fromStdString(param.param.id))
            .arg(c));
    editor->setAccessibleName(n > 1 ? tr("%1, %2 of %3").arg(name).arg(c + 1).arg(n) : name);
    editor->setAccessibleDescription(doc);
    editor->setToolTip(doc);
    editors->addWidget(editor);
    fields_[index].editors += editor;
  }
  label->setBuddy(fields_[index].editors.first());
  grid->addLayout(editors, row, 1);
  auto* back = new QToolButton(body_);
  back->setText(QStringLiteral("↺"));
  back->setToolTip(tr("Back to the lesson's own value"));
  back->setAccessibleName(tr("%1: back to the lesson's own value").arg(name));
  back->setEnabled(false);
  connect(back, &QToolButton::clicked, this, [this, index] {
    put(index, fields_[index].param.start);
    edit(index, 0, fields_[index].value[0] * fields_[index].param.factor());
  });
  fields_[index].back = back;
  grid->addWidget(back, row, 2);
}

QWidget* LiveForm::make_editor(int field, int component) {
  const LiveParam& p = fields_[field].param;
  const double start = p.start[static_cast<size_t>(component)];
  if (p.param.type == SWAGE_PARAM_BOOL) {
    auto* box = new QCheckBox(body_);
    box->setChecked(start > 0.5);
    connect(box, &QCheckBox::toggled, this, [=, this](bool on) { edit(field, component, on ? 1 : 0); });
    return box;
  }
  if (p.param.type == SWAGE_PARAM_CHOICE) {
    auto* box = new QComboBox(body_);
    for (const LiveParam::Entry& entry : p.entries()) box->addItem(entry.words, QVariant::fromValue(entry.choices));
    box->setCurrentIndex(entry_of(*box, start));
    connect(box, &QComboBox::currentIndexChanged, this,
            [=, this](int i) { edit(field, component, box->itemData(i).value<QVector<int>>().first()); });
    return box;
  }
  auto* box = new NumberBox(QString::fromStdString(p.param.display_unit.empty() ? p.param.unit : p.param.display_unit), body_);
  const double factor = p.factor();
  box->setDecimals(p.decimals());
  box->setRange(p.param.min * factor, p.param.max * factor);
  box->setSingleStep(p.step());
  box->setSpecialValueText(p.least_text());
  if (!p.unit().isEmpty()) box->setSuffix(QChar(0x202f) + p.unit());
  if (p.is_range()) box->setPrefix(component == 0 ? tr("from ") : tr("to "));
  if (p.is_size() && component == 1) box->setPrefix(tr("by "));
  box->setValue(start * factor);
  box->setKeyboardTracking(false);  // while "0.25" is typed, neither 0 nor 0.2 is set
  connect(box, &QDoubleSpinBox::valueChanged, this, [=, this](double v) { edit(field, component, v); });
  // after the change to which it belongs
  connect(box, &NumberBox::refused, this, [=, this](const QString& words) { refuse(field, box, words); }, Qt::QueuedConnection);
  return box;
}

void LiveForm::refuse(int index, QWidget* editor, const QString& words) {
  const QString all = QStringLiteral("%1: %2").arg(fields_[index].label->text(), words);
  QToolTip::showText(editor->mapToGlobal(QPoint(0, editor->height())), all, editor);
  Q_EMIT refused(all);
}

void LiveForm::edit(int index, int component, double shown) {
  if (filling_) return;
  Field& field = fields_[index];
  field.before = field.value;
  field.value[static_cast<size_t>(component)] = shown / field.param.factor();
  enable(field);
  take_start(field);
  last_ = index;
  Q_EMIT changed(QString::fromStdString(field.param.instance),
                 QString::fromStdString(field.param.json(field.value)), words(field));
}

QString LiveForm::words(const Field& field) const {
  const LiveParam& p = field.param;
  const QString name = said(p.param.label.empty() ? p.param.id : p.param.label, p.folder);
  if (p.param.type == SWAGE_PARAM_BOOL)
    return QStringLiteral("%1: %2").arg(name, field.value[0] > 0.5 ? tr("on") : tr("off"));
  if (p.param.type == SWAGE_PARAM_CHOICE)
    return QStringLiteral("%1: %2").arg(
        name, said(p.param.choices[static_cast<size_t>(field.value[0])], p.folder));
  if (const QString least = p.least_text(); !least.isEmpty() && field.value[0] <= p.param.min) return QStringLiteral("%1: %2").arg(name, least);
  QStringList numbers;
  for (int c = 0; c < field.editors.size(); ++c)
    numbers += QLocale().toString(field.value[static_cast<size_t>(c)] * p.factor(), 'f', p.decimals());
  return QStringLiteral("%1: %2 %3").arg(name, numbers.join(QStringLiteral(", ")), p.unit()).trimmed();
}

void LiveForm::put(int index, const std::array<double, 4>& value) {
  Field& field = fields_[index];
  filling_ = true;
  field.value = value;
  for (int c = 0; c < field.editors.size(); ++c) {
    const double v = value[static_cast<size_t>(c)];
    if (auto* spin = qobject_cast<QDoubleSpinBox*>(field.editors[c]))
      spin->setValue(v * field.param.factor());
    if (auto* check = qobject_cast<QCheckBox*>(field.editors[c])) check->setChecked(v > 0.5);
    if (auto* choice = qobject_cast<QComboBox*>(field.editors[c]))
      choice->setCurrentIndex(entry_of(*choice, v));
  }
  enable(field);
  filling_ = false;
  take_start(field);
}

void LiveForm::enable(const Field& field) {
  for (QWidget* editor : field.editors) editor->setEnabled(running_ && field.means);
  field.back->setEnabled(running_ && field.means && field.value != field.param.start);
}

// Parameters that follow this choice have other start values under it; an unedited one changes with the choice, and one without a meaning
// under it is reset.
void LiveForm::take_start(const Field& choice) {
  if (choice.param.param.type != SWAGE_PARAM_CHOICE) return;
  const auto chosen = static_cast<std::size_t>(choice.value[0]);
  for (int i = 0; i < fields_.size(); ++i) {
    Field& field = fields_[i];
    LiveParam& p = field.param;
    if (p.follows != choice.param.param.id || p.instance != choice.param.instance || chosen >= p.start_of.size()) continue;
    const bool untouched = field.value == p.start;
    field.means = std::isfinite(p.start_of[chosen]);
    if (field.means) p.start[0] = p.start_of[chosen];
    put(i, untouched || !field.means ? p.start : field.value);
  }
}

void LiveForm::answer(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  if (!problem.isEmpty() && last_ >= 0) put(last_, fields_[last_].before);
}

void LiveForm::set_running(bool running) {
  running_ = running;
  for (const Field& field : fields_) enable(field);
  if (of_ == Of::kVariant)
    return explain_->setText(
        tr("What you change here is written into the lesson; all else stays as it is. Values that are rarely changed are found by their name."));
  explain_->setText(fields_.isEmpty() ? tr("Nothing of this lesson may be changed while it runs.")
                    : running         ? tr("A change acts at once and is recorded.")
                                      : tr("Can be changed while the lesson runs."));
}

QVector<std::pair<std::string, std::string>> LiveForm::changes() const {
  QVector<std::pair<std::string, std::string>> out;
  for (const Field& field : fields_) {
    if (field.value == field.param.start) continue;
    swage_value value{};
    std::copy(field.value.begin(), field.value.end(), value.number);
    out.append(
        {field.param.instance + "." + field.param.param.id, host::value_text(field.param.param, value)});
  }
  return out;
}

QVector<LiveForm::Change> LiveForm::changed_values() const {
  QVector<Change> out;
  for (const Field& field : fields_)
    if (field.value != field.param.start) out.append({field.param.instance, field.param.param.id, field.value});
  return out;
}

int LiveForm::preset(const QVector<Change>& values) {
  int taken = 0;
  for (const Change& change : values)
    for (int i = 0; i < fields_.size(); ++i) {
      if (fields_[i].param.instance != change.instance || fields_[i].param.param.id != change.id) continue;
      put(i, change.value);
      ++taken;
    }
  return taken;
}

QString LiveForm::title_of(const std::string& id, const std::string& instance) const {
  QString title;
  for (const Field& field : fields_) {
    if (field.param.param.id != id || (!instance.empty() && field.param.instance != instance)) continue;
    if (!title.isEmpty() && title != field.label->text()) return {};
    title = field.label->text();
  }
  return title;
}

// "hold" matches the time of a hold and not all parameters of the holder; "limit" the section of limits; "needle" matches all of the needle;
// "tiss" all of the tissue, if no parameter's name matches; and a word of an explanation is looked for where nothing else matches
bool LiveForm::find(const QString& text) {
  const auto has = [&](const QString& words) { return words.contains(text, Qt::CaseInsensitive); };
  const auto named = [&](const Field& field) { return has(field.label->text()) || has(said(field.param.param.group, field.param.folder)); };
  const auto explained = [&](const Field& field) { return has(field.label->toolTip()); };
  const auto part_named = [&](const Field& field) { return has(field.heading->text()); };
  const bool names = std::any_of(fields_.begin(), fields_.end(), named);
  const bool parts = std::any_of(fields_.begin(), fields_.end(), part_named);
  QHash<QLabel*, bool> any;
  for (const Field& field : fields_) {
    const bool of_part = names ? field.heading->text().split(QLatin1Char(' ')).contains(text, Qt::CaseInsensitive) : part_named(field);
    const bool rare = field.param.param.hidden() && field.value == field.param.start;
    const bool shown = text.isEmpty() ? !rare : named(field) || of_part || (!names && !parts && explained(field));
    field.label->setVisible(shown);
    field.back->setVisible(shown);
    for (QWidget* editor : field.editors) editor->setVisible(shown);
    any[field.heading] = any[field.heading] || shown;
  }
  for (auto it = any.begin(); it != any.end(); ++it) it.key()->setVisible(it.value());
  return std::any_of(any.begin(), any.end(), [](bool shown) { return shown; });
}

}  // namespace swage::console
