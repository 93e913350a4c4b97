// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/variant_dialog.hpp"

#include <QAction>
#include <QFile>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include "console/models/live_params.hpp"
#include "console/models/said.hpp"
#include "console/pages/parts_panel.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kValues_px = 460;  // width for a name, a number with its unit, and the reset button
constexpr int kBuildDelay_ms = 300;  // after the last edit, so that typing does not build a scene for each letter

Variant begin_of(const LessonEntry& lesson, bool edits) {
  if (edits) return {lesson.path, lesson.title, lesson.summary, lesson.goal, {}, {}, {}, view_in(lesson.path)};
  return {lesson.path, VariantDialog::tr("%1, adapted").arg(said(lesson.title)), said(lesson.summary), said(lesson.goal), {}};
}

QString draft_file(const LessonEntry& lesson, bool edits, const QString& folder) {
  return folder + (edits ? QStringLiteral("/edit_") : QStringLiteral("/new_")) + slug(lesson.id + QLatin1Char(' ') + lesson.path.section(QLatin1Char('/'), -1)) +
         QStringLiteral(".json");
}

}  // namespace

VariantDialog::VariantDialog(const LessonEntry& lesson, Services services, const QString& folder, QWidget* parent)
    : QDialog(parent),
      lesson_(lesson),
      services_(std::move(services)),
      folder_(folder),
      draft_(begin_of(lesson, folder.isEmpty()), draft_file(lesson, folder.isEmpty(), services_.drafts)) {
  setObjectName(QStringLiteral("variant"));
  setWindowTitle(folder.isEmpty() ? tr("Edit lesson") : tr("New lesson"));
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  auto* values = new QWidget(this);
  values->setMinimumWidth(kValues_px);
  auto* left = new QVBoxLayout(values);
  left->setContentsMargins(0, 0, 0, 0);
  left->addWidget(make_words());
  left->addWidget(make_values(), 1);
  row->addWidget(values, 1);
  row->addWidget(make_picture(), 1);
  column->addLayout(row, 1);
  column->addWidget(make_buttons());
  add_undo();
  resize(QSize(1180, 760).boundedTo(screen()->availableGeometry().size() - QSize(20, 60)));
  build_timer_.setSingleShot(true);
  build_timer_.setInterval(kBuildDelay_ms);
  connect(&build_timer_, &QTimer::timeout, this, &VariantDialog::build);
  connect(&draft_, &LessonDraft::edited, this, &VariantDialog::show_edit);
  if (draft_.taken_up()) told_ = tr("Your unfinished changes are here again; undo takes them back.");
  show_edit(true, true);
  title_->setFocus();
  title_->selectAll();
}

VariantDialog::~VariantDialog() = default;

QWidget* VariantDialog::make_words() {
  Card card = make_card(folder_.isEmpty() ? tr("Lesson of your own") : tr("Based on %1").arg(said(lesson_.title)), this);
  auto* form = new QFormLayout;
  title_ = new QLineEdit(card.frame);
  title_->setObjectName(QStringLiteral("variant_title"));
  summary_ = new QLineEdit(card.frame);
  summary_->setObjectName(QStringLiteral("variant_summary"));
  goal_ = new QPlainTextEdit(card.frame);
  goal_->setObjectName(QStringLiteral("variant_goal"));
  goal_->setTabChangesFocus(true);
  goal_->setFixedHeight(64);
  form->addRow(tr("&Title"), title_);
  form->addRow(tr("Tas&k"), summary_);
  form->addRow(tr("&Learning goal"), goal_);
  look_ = new QComboBox(card.frame);
  look_->setObjectName(QStringLiteral("variant_look"));
  const std::pair<QString, const char*> looks[] = {
      {tr("Unchanged"), ""}, {tr("Orbit"), "orbit"}, {tr("Side"), "side"}, {tr("Top"), "top"}, {tr("Near"), "near"}};
  for (const auto& [text, name] : looks) look_->addItem(text, QString::fromLatin1(name));
  look_->setToolTip(tr("From where the trainee looks first; any view can be chosen later"));
  form->addRow(tr("&View at the start"), look_);
  card.body->addLayout(form);
  show_words();
  connect(look_, &QComboBox::currentIndexChanged, &draft_, [this] { draft_.set_view(look_->currentData().toString()); });
  connect(title_, &QLineEdit::textChanged, &draft_, &LessonDraft::set_title);
  connect(summary_, &QLineEdit::textChanged, &draft_, &LessonDraft::set_summary);
  connect(goal_, &QPlainTextEdit::textChanged, &draft_, [this] { draft_.set_goal(goal_->toPlainText()); });
  // in every field undo acts on the whole lesson
  for (QWidget* field : std::initializer_list<QWidget*>{title_, summary_, goal_}) field->installEventFilter(this);
  return card.frame;
}

bool VariantDialog::eventFilter(QObject* watched, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (key) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    if (pressed->matches(QKeySequence::Undo) || pressed->matches(QKeySequence::Redo)) return event->ignore(), true;
  }
  return QDialog::eventFilter(watched, event);
}

QWidget* VariantDialog::make_values() {
  Card card = make_card(tr("Values"), this);
  find_ = new QLineEdit(card.frame);
  find_->setObjectName(QStringLiteral("variant_find"));
  find_->setPlaceholderText(tr("Find: needle, stiffness, force …"));
  find_->setAccessibleName(tr("Find a value"));
  find_->setClearButtonEnabled(true);
  card.body->addWidget(find_);
  auto* scroll = new QScrollArea(card.frame);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  form_ = new LiveForm(scroll, LiveForm::Of::kVariant);
  form_->set_running(true);
  scroll->setWidget(form_);
  scroll->viewport()->setAutoFillBackground(false);
  form_->setAutoFillBackground(false);
  none_ = make_muted({}, card.frame);
  none_->setObjectName(QStringLiteral("variant_none"));
  none_->hide();
  card.body->addWidget(none_);
  card.body->addWidget(scroll, 1);
  connect(find_, &QLineEdit::textChanged, this, [this](const QString& text) {
    const bool any = form_->find(text);
    none_->setText(tr("No value is called \"%1\".").arg(text));
    none_->setVisible(!any && !text.isEmpty());
  });
  connect(form_, &LiveForm::changed, this, [this](const QString& part, const QString& json) {
    draft_.set_values(form_->changes(), part + json.section(QLatin1Char(':'), 0, 0));
  });
  connect(form_, &LiveForm::refused, this, [this](const QString& words) {
    refused_ = words;
    update_state();
  });
  return card.frame;
}

QWidget* VariantDialog::make_picture() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  Card card = make_card(tr("The scene as it would begin"), side);
  view_ = new SceneView(card.frame);
  view_->setObjectName(QStringLiteral("variant_view"));
  view_->setMinimumSize(320, 220);
  if (services_.dress) services_.dress(*view_);
  card.body->addWidget(view_, 1);
  parts_ = new PartsPanel(&draft_, &services_.catalogue, side);
  connect(parts_, &PartsPanel::told, this, [this](const QString& words) {
    told_ = words;
    update_state();
  });
  column->addWidget(card.frame, 3);
  column->addWidget(parts_, 2);
  return side;
}

QWidget* VariantDialog::make_buttons() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  problem_ = new QLabel(bar);
  problem_->setObjectName(QStringLiteral("variant_problem"));
  problem_->setWordWrap(true);
  auto* cancel = make_button(tr("Cancel"), QStringLiteral("Esc"), QStringLiteral("variant_cancel"), bar);
  try_ = make_button(tr("Save and try it"), QStringLiteral("Ctrl+T"), QStringLiteral("variant_try"), bar);
  try_->setShortcut(QKeySequence(QStringLiteral("Ctrl+T")));
  save_ = make_button(tr("Save"), QStringLiteral("Ctrl+S"), QStringLiteral("variant_save"), bar);
  save_->setProperty("primary", true);
  save_->setDefault(true);
  save_->setShortcut(QKeySequence::Save);
  row->addWidget(problem_, 1);
  for (QPushButton* b : {cancel, try_, save_}) row->addWidget(b);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, [this] {
    to_try_ = false;
    save();
  });
  connect(try_, &QPushButton::clicked, this, [this] {
    to_try_ = true;
    save();
  });
  return bar;
}

void VariantDialog::add_undo() {
  for (const bool undo : {true, false}) {
    QAction* action = undo ? draft_.edits()->createUndoAction(this) : draft_.edits()->createRedoAction(this);
    action->setObjectName(undo ? QStringLiteral("variant_undo") : QStringLiteral("variant_redo"));
    action->setShortcuts(undo ? QKeySequence::Undo : QKeySequence::Redo);
    if (const QKeySequence usual(Qt::CTRL | Qt::Key_Y); !undo && !action->shortcuts().contains(usual))
      action->setShortcuts(action->shortcuts() + QList<QKeySequence>{usual});
    addAction(action);
  }
}

void VariantDialog::preset(const QVector<LiveForm::Change>& values) {
  if (draft_.taken_up()) return;  // a resumed edit keeps its own values
  preset_ = form_->preset(values);
  draft_.set_values(form_->changes(), QStringLiteral("preset"));
  update_state();
}

void VariantDialog::show_edit(bool structure, bool by_undo) {
  if (!save_) return;
  refused_.clear();
  QString problem = draft_.write();
  if (structure && problem.isEmpty()) {
    const QString starts = draft_.file() + QStringLiteral(".parts");
    problem = draft_.write_parts(starts);
    form_->set_params(lesson_params(starts.toStdString(), services_.catalogue));
    QFile::remove(starts);
    form_->find(find_->text());
    parts_->refresh();
  }
  if (by_undo || structure) {
    show_words();
    show_values();
  }
  fault_ = problem;
  update_state();
  build_timer_.start();
}

void VariantDialog::show_words() {
  const Variant now = draft_.now();
  const QSignalBlocker still(look_);
  look_->setCurrentIndex(look_->findData(now.view));
  for (const auto& [line, text] : {std::pair{title_, now.title}, {summary_, now.summary}}) {
    if (line->text() == text) continue;
    const QSignalBlocker quiet(line);
    line->setText(text);
    line->setCursorPosition(0);
  }
  if (goal_->toPlainText() == now.goal) return;
  const QSignalBlocker quiet(goal_);
  goal_->setPlainText(now.goal);
}

void VariantDialog::show_values() {
  QVector<LiveForm::Change> values;
  for (const LiveParam& p : lesson_params(draft_.file().toStdString(), services_.catalogue)) values.append({p.instance, p.param.id, p.start});
  form_->preset(values);
}

void VariantDialog::build() {
  build_timer_.stop();
  base::Problems problems;
  const std::unique_ptr<snapshot::SceneCard> card = services_.build(draft_.file(), problems);
  fault_.clear();
  if (card) {
    view_->set_card(*card, view_named(card->view).value_or(CameraPreset::kOrbit));
    return update_state();
  }
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError && fault_.isEmpty()) fault_ = fault_words(p);
  if (fault_.isEmpty()) fault_ = tr("The lesson cannot be built with these values.");
  update_state();
}

// "Grip force: the first number is ...": a location ".../params/force", or "/set/lesson.force" of a lesson that changes another, becomes the
// title of that parameter in the form.
QString VariantDialog::fault_words(const base::Problem& problem) const {
  const QString where = QString::fromStdString(problem.where);
  const QString set = where.section(QStringLiteral("/set/"), 1).section(QLatin1Char('/'), 0, 0);
  const QString id = set.isEmpty() ? where.section(QStringLiteral("/params/"), 1).section(QLatin1Char('/'), 0, 0) : set.section(QLatin1Char('.'), 1);
  const QString name = id.isEmpty() ? QString() : form_->title_of(id.toStdString(), set.section(QLatin1Char('.'), 0, 0).toStdString());
  const QString words = said_message(problem.message);
  return name.isEmpty() || words.contains(name) ? words : QStringLiteral("%1: %2").arg(name, words);
}

void VariantDialog::update_state() {
  if (!save_) return;
  const auto changes = draft_.now().set.size();
  const bool named = !title_->text().trimmed().isEmpty(), parts = draft_.parts_changed();
  const bool words = folder_.isEmpty() && draft_.words_changed(), view = draft_.view_changed();
  const bool can = (changes > 0 || words || parts || view) && named && fault_.isEmpty();  // an unchanged copy is not saved
  save_->setEnabled(can);
  try_->setEnabled(can);
  QString text = !named         ? tr("A lesson has a title.")
                 : changes == 1 ? tr("One value is changed.")
                 : changes > 1  ? tr("%1 values are changed.").arg(changes)
                 : parts        ? tr("Parts are changed.")
                 : words        ? tr("The words are changed.")
                 : view         ? tr("The view at the start is changed.")
                 : folder_.isEmpty() ? tr("Nothing is changed yet.")
                                : tr("Change a value or a part: a copy under another title would be the same lesson.");
  if (changes > 0 && parts && named) text += QLatin1Char(' ') + tr("So are parts.");
  if (preset_ > 0 && named) text += QLatin1Char(' ') + tr("Those of the last attempt are kept.");
  if (!told_.isEmpty()) text += QLatin1Char(' ') + told_;
  if (!refused_.isEmpty()) text = refused_;
  problem_->setText(fault_.isEmpty() ? text : tr("▲ %1").arg(fault_));
}

QString VariantDialog::write() {
  Variant changed = draft_.now();
  changed.base = lesson_.path;
  if (folder_.isEmpty()) {
    saved_ = lesson_.path;
    return update_variant(lesson_.path, changed);
  }
  const Saved saved = save_variant(changed, folder_);
  saved_ = saved.path;
  return saved.problem;
}

void VariantDialog::save() {
  build();
  QString problem = fault_;
  if (problem.isEmpty()) problem = write();
  if (problem.isEmpty()) return accept();
  fault_ = problem;
  update_state();
}

// Esc, Cancel or a closed window: what was changed is not lost without a question.
void VariantDialog::reject() {
  if (!draft_.changed()) return QDialog::reject();
  QMessageBox box(QMessageBox::NoIcon, windowTitle(), tr("Leave without saving? What you changed here is not kept."), {}, this);
  box.setObjectName(QStringLiteral("leave_unsaved"));
  const QPushButton* leave = box.addButton(tr("Leave"), QMessageBox::DestructiveRole);
  QPushButton* stay = box.addButton(tr("Go on editing"), QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() == leave) QDialog::reject();
}

// ends the edit after Save or Cancel
void VariantDialog::done(int result) {
  build_timer_.stop();
  draft_.end();
  QDialog::done(result);
}

}  // namespace swage::console
