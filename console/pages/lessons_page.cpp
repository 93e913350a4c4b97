// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/lessons_page.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSplitter>
#include <QVBoxLayout>

#include "assembly/lesson_text.hpp"
#include "console/models/variant.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/save_file.hpp"

namespace swage::console {
namespace {

constexpr int kCheckDelay_ms = 150;  // delay before the scene is built, so that scrolling through the list builds none

/// Filters lessons whose title, task or goal contain every word of the search.
class Search : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void set_words(const QString& text) {
    words_ = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const QModelIndex i = sourceModel()->index(row, 0, parent);
    const QString text = i.data().toString() + QLatin1Char(' ') + i.data(LessonsModel::kSummary).toString() +
                         QLatin1Char(' ') + i.data(LessonsModel::kGoal).toString();
    return std::all_of(words_.begin(), words_.end(),
                       [&](const QString& w) { return text.contains(w, Qt::CaseInsensitive); });
  }

 private:
  QStringList words_;
};

/// the file's whole text, for publishing; "" when it cannot be read
std::string lesson_text(const QString& path) {
  assembly::LessonText out;
  base::Problems problems;
  const bool ok = assembly::read_lesson_text(path.toStdString(), {}, out, problems);
  return ok && !base::failed(problems) ? out.text : std::string();
}

}  // namespace

LessonsPage::LessonsPage(LessonsModel* lessons, CriteriaReader criteria, QWidget* parent)
    : QWidget(parent), criteria_(std::move(criteria)), found_(new Search(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 6);
  auto* splitter = new QSplitter(this);
  splitter->setObjectName(QStringLiteral("lessons_splitter"));
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(make_list(lessons));
  splitter->addWidget(make_detail());
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  row->addWidget(splitter);
  check_timer_.setSingleShot(true);
  check_timer_.setInterval(kCheckDelay_ms);
  connect(&check_timer_, &QTimer::timeout, this, &LessonsPage::check);
  show_lesson();
}

// Ctrl+E is the page's shortcut, although text fields use it for the end of the line.
bool LessonsPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_E && key->modifiers() == Qt::ControlModifier) return event->ignore(), true;
  }
  return QWidget::eventFilter(watched, event);
}

// Builds the scene as the Run page does: only that finds every error.
void LessonsPage::check() {
  if (running_ || !checker_ || !isVisible() || !practise_->isEnabled()) return;
  if (const QString why = checker_(lesson()); !why.isEmpty()) tell_fault(why);
}

void LessonsPage::tell_fault(const QString& why) {
  for (QPushButton* b : {practise_, test_, variant_}) b->setEnabled(false);
  asked_->setText(tr("▲ It cannot run: %1").arg(why).toHtmlEscaped());
}

QWidget* LessonsPage::make_list(LessonsModel* lessons) {
  Card card = make_card(tr("Lessons"), this);
  words_ = make_search(tr("Search title, task and goal"), QStringLiteral("lesson_search"), card.frame);
  words_->installEventFilter(this);
  card.body->addWidget(words_);
  found_->setSourceModel(lessons);
  list_ = new QListView(card.frame);
  list_->setObjectName(QStringLiteral("all_lessons"));
  list_->setAccessibleName(tr("Lessons"));
  list_->setModel(found_);
  list_->setItemDelegate(new TwoLineDelegate(LessonsModel::kSummary, list_));
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setMinimumWidth(240);
  none_ = make_muted({}, card.frame);
  none_->setObjectName(QStringLiteral("no_lesson_found"));
  card.body->addWidget(list_, 1);
  card.body->addWidget(none_, 1, Qt::AlignTop);
  none_->hide();
  connect(words_, &QLineEdit::textChanged, this, &LessonsPage::search);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &LessonsPage::show_lesson);
  connect(list_, &QListView::activated, this, [this] { practise_->click(); });
  return card.frame;
}

QWidget* LessonsPage::make_detail() {
  Card card = make_card({}, this);
  detail_ = card.frame;
  title_ = new QLabel(card.frame);
  title_->setObjectName(QStringLiteral("lesson_headline"));
  title_->setProperty("big", true);
  title_->setWordWrap(true);
  task_ = new QLabel(card.frame);
  task_->setWordWrap(true);
  asked_ = new QLabel(card.frame);
  asked_->setObjectName(QStringLiteral("lesson_asked"));
  asked_->setWordWrap(true);
  asked_->setTextFormat(Qt::RichText);
  asked_->setAlignment(Qt::AlignTop);
  QScrollArea* scroll = make_scroll(card.frame);
  auto* text = new QWidget(scroll);
  auto* column = new QVBoxLayout(text);
  column->setContentsMargins(0, 0, 0, 0);
  for (QLabel* label : {title_, task_, asked_}) column->addWidget(label);
  column->addStretch(1);
  scroll->setWidget(text);
  card.body->addWidget(scroll, 1);

  note_ = new QLabel(card.frame);
  note_->setObjectName(QStringLiteral("lesson_note"));
  note_->setWordWrap(true);
  note_->hide();
  card.body->addWidget(note_);
  auto* row = new QHBoxLayout;
  practise_ = add_button(row, tr("Practise"), "Enter", "practise_lesson", [this] { Q_EMIT run(lesson(), QStringLiteral("practice")); });
  practise_->setProperty("primary", true);
  test_ = add_button(row, tr("Test"), "Ctrl+T", "test_lesson", [this] { Q_EMIT run(lesson(), QStringLiteral("test")); });
  test_->setText(tr("Test"));
  test_->setShortcut(QKeySequence(QStringLiteral("Ctrl+T")));
  row->addStretch(1);
  card.body->addLayout(row);
  add_own_buttons(card.body);
  add_version_row(card.body);
  return card.frame;
}

QPushButton* LessonsPage::add_button(QHBoxLayout* row, const QString& words, const char* key, const char* name, std::function<void()> call) {
  const QString keys = QString::fromLatin1(key);
  auto* button = make_button(words, keys, QString::fromLatin1(name), detail_);
  if (keys != QLatin1String("Enter")) button->setShortcut(QKeySequence(keys));  // the list handles Enter itself
  connect(button, &QPushButton::clicked, this, call);
  row->addWidget(button);
  return button;
}

void LessonsPage::add_own_buttons(QVBoxLayout* column) {
  auto* own = new QHBoxLayout;
  variant_ = add_button(own, tr("New lesson from this…"), "Ctrl+N", "new_from_this", [this] { Q_EMIT make_variant(lesson()); });
  edit_ = add_button(own, tr("Edit…"), "Ctrl+E", "edit_this", [this] { Q_EMIT edit_lesson(lesson()); });
  delete_ = add_button(own, tr("Delete…"), "Ctrl+Del", "delete_this", [this] { Q_EMIT delete_lesson(lesson()); });
  // text without the key, which would make the page wider than a remembered layout; the tooltips have the keys
  delete_->setText(tr("Delete…"));
  delete_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Del")));
  own->addStretch(1);
  auto* files = new QHBoxLayout;
  import_ = add_button(files, tr("Import…"), "Ctrl+I", "import_lesson", [this] { ask_import(); });
  import_->setText(tr("Import…"));
  import_->setToolTip(tr("Take in a lesson file from another station"));
  give_key(import_, QStringLiteral("Ctrl+I"));
  export_ = add_button(files, tr("Export…"), "Ctrl+Shift+E", "export_lesson", [this] { ask_export(); });
  export_->setText(tr("Export…"));
  export_->setToolTip(tr("Write this lesson to a file for another station"));
  give_key(export_, QStringLiteral("Ctrl+Shift+E"));
  files->addStretch(1);
  column->addLayout(own);
  column->addLayout(files);
}

void LessonsPage::add_version_row(QVBoxLayout* column) {
  auto* released = new QHBoxLayout;
  version_ = make_muted({}, detail_);
  version_->setObjectName(QStringLiteral("lesson_version"));
  released->addWidget(version_, 1);
  publish_ = add_button(released, tr("Publish"), "Ctrl+P", "publish_lesson", [this] { publish(); });
  publish_->setToolTip(tr("Keep this lesson as it is now, as a version that courses and attempts refer to"));
  give_key(publish_, QStringLiteral("Ctrl+P"));
  retire_ = add_button(released, tr("Retire"), "Ctrl+R", "retire_lesson", [this] { retire(); });
  column->addLayout(released);
}

void LessonsPage::ask_import() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Import a lesson"), {}, tr("Lessons (*.json)"));
  if (!file.isEmpty()) Q_EMIT import_lesson(file);
}

void LessonsPage::ask_export() {
  const QString name = slug(list_->currentIndex().data(LessonsModel::kTitle).toString()) + QStringLiteral(".json");
  const QString file = ask_save(this, tr("Export the lesson"), name, tr("Lessons (*.json)"));
  if (!file.isEmpty()) Q_EMIT export_lesson(lesson(), file);
}

void LessonsPage::set_running(bool running) {
  running_ = running;
  show_lesson();
}

void LessonsPage::tell(const QString& words) {
  note_->setText(words);
  note_->setVisible(!words.isEmpty());
}

void LessonsPage::search(const QString& words) {
  static_cast<Search*>(found_)->set_words(words);
  const bool any = found_->rowCount() > 0;
  list_->setVisible(any);
  none_->setVisible(!any);
  none_->setText(found_->sourceModel()->rowCount() == 0
                     ? tr("No lessons found. Put lesson files into %1.").arg(own_lessons_folder())
                     : tr("No lesson has these words. Clear the search to see all."));
  if (any && !list_->currentIndex().isValid()) list_->setCurrentIndex(found_->index(0, 0));
}

// Clears a search that hides this lesson: a lesson just made or renamed must be visible.
void LessonsPage::select(const QString& path) {
  const auto row_of = [&] {
    for (int i = 0; i < found_->rowCount(); ++i)
      if (found_->index(i, 0).data(LessonsModel::kPath).toString() == path) return i;
    return -1;
  };
  if (row_of() < 0 && !words_->text().isEmpty()) words_->clear();
  if (const int row = row_of(); row >= 0) return list_->setCurrentIndex(found_->index(row, 0));
  if (!list_->currentIndex().isValid()) list_->setCurrentIndex(found_->index(0, 0));
}

QString LessonsPage::lesson() const { return list_->currentIndex().data(LessonsModel::kPath).toString(); }

void LessonsPage::set_desk(SchoolDesk* desk) {
  desk_ = desk;
  show_lesson();
}

void LessonsPage::show_version(bool can) {
  record::School* school = desk_ ? desk_->school() : nullptr;
  last_.reset();
  std::string text;
  if (school && can) text = lesson_text(lesson());
  for (QWidget* w : std::initializer_list<QWidget*>{publish_, retire_, version_}) w->setVisible(!text.empty());
  if (text.empty()) return;
  const std::string id = list_->currentIndex().data(LessonsModel::kId).toString().toStdString();
  for (const record::LessonVersion& v : school->lessons())
    if (v.lesson_id == id && (!last_ || v.number > last_->number)) last_ = v;
  const bool same = last_ && last_->digest == record::lesson_digest(text);
  publish_->setEnabled(!same);
  retire_->setVisible(last_.has_value());
  if (!last_) return version_->setText(tr("Not published: attempts refer to the file as it is when they run."));
  const QString when = when_text(QString::fromStdString(last_->frozen_utc));
  retire_->setText(last_->retired_utc.empty() ? tr("Retire version %1").arg(last_->number) : tr("Offer version %1 again").arg(last_->number));
  retire_->setShortcut(QKeySequence(QStringLiteral("Ctrl+R")));  // setText() removes the shortcut
  QString words = same ? tr("Published as version %1, %2.").arg(last_->number).arg(when)
                       : tr("▲ Changed since version %1 was published, %2.").arg(last_->number).arg(when);
  if (!last_->retired_utc.empty()) words += QLatin1Char(' ') + tr("It is retired.");
  version_->setText(words);
}

void LessonsPage::publish() {
  const QModelIndex at = list_->currentIndex();
  const std::string text = lesson_text(lesson());
  record::LessonVersion made;
  if (!desk_ || text.empty()) return;
  const bool done = desk_->publish(at.data(LessonsModel::kId).toString(), at.data(LessonsModel::kTitle).toString(), text, made);
  show_lesson();
  if (!done) version_->setText(tr("▲ %1").arg(desk_->problem()));
}

void LessonsPage::retire() {
  if (!desk_ || !last_) return;
  const bool done = desk_->retire(*last_, last_->retired_utc.empty());
  show_lesson();
  if (!done) version_->setText(tr("▲ %1").arg(desk_->problem()));
}

void LessonsPage::show_lesson() {
  const QModelIndex at = list_->currentIndex();
  const QString problem = at.data(LessonsModel::kProblem).toString();
  const bool can = at.isValid() && problem.isEmpty(), own = at.isValid() && is_own_lesson(lesson());
  for (QPushButton* b : {practise_, test_, variant_}) b->setEnabled(can && !running_);
  export_->setEnabled(can);
  import_->setEnabled(!running_);
  for (QPushButton* b : {edit_, delete_}) {
    b->setVisible(own);
    b->setEnabled(!running_);
  }
  tell(running_ ? tr("A lesson is running. Until it ends, no lesson can be changed or started.") : QString());
  show_version(can);
  title_->setText(at.isValid() ? at.data().toString() : tr("Choose a lesson."));
  task_->setText(QStringList({at.data(LessonsModel::kSummary).toString(), at.data(LessonsModel::kGoal).toString()})
                     .join(QStringLiteral("\n\n"))
                     .trimmed());
  if (!can) return problem.isEmpty() ? asked_->clear() : tell_fault(problem);
  const Criteria asked = criteria_(lesson());
  test_->setEnabled(!asked.show && !running_);
  asked_->setText(list_text(asked.show ? tr("A demonstration") : tr("Passed when"), asked.pass) +
                  list_text(tr("Limits in a test"), asked.limits) + list_text(tr("Ends every attempt"), asked.ends) +
                  list_text(tr("Points"), asked.points));
  check_timer_.start();
}

}  // namespace swage::console
