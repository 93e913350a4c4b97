// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/setup_panel.hpp"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QRadioButton>
#include <QVBoxLayout>

#include "console/models/instrument.hpp"
#include "console/models/said.hpp"
#include "console/models/variant.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"
#include "record/store.hpp"

namespace swage::console {
namespace {

const char* const kModes[] = {"practice", "test", "demo"};
constexpr int kIsHand = Qt::UserRole + 1;  // of an instrument in the list: a recorded hand
/// A list whose chosen row stays in sight: on a low screen the list has few rows, and fewer where the words below it wrap.
class ChosenInSight final : public QListView {
 public:
  using QListView::QListView;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QListView::resizeEvent(event);
    scrollTo(currentIndex());
  }
};

constexpr char kMouse[] = "mouse", kExpert[] = "expert";  // what lessons call their devices ("as")

}  // namespace

SetupPanel::SetupPanel(LessonsModel* lessons, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  // on a low screen the choices scroll, and START stays visible
  auto* scroll = make_scroll(this);
  auto* choices = new QWidget(scroll);
  auto* inner = new QVBoxLayout(choices);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->setSpacing(10);
  inner->addWidget(make_who());
  inner->addWidget(make_lessons(lessons), 1);
  inner->addWidget(make_mode());
  scroll->setWidget(choices);
  column->addWidget(scroll, 1);
  start_ = make_button(tr("START"), QStringLiteral("F5"), QStringLiteral("start"), this);
  start_->setProperty("primary", true);
  start_->setMinimumHeight(48);
  column->addWidget(start_);
  connect(start_, &QPushButton::clicked, this, &SetupPanel::start);
  update_start();
  update_course();
}

QWidget* SetupPanel::make_who() {
  Card card = make_card(tr("Trainee"), this);
  person_ = new QComboBox(card.frame);
  person_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  person_->setMinimumContentsLength(12);
  person_->setObjectName(QStringLiteral("person"));
  person_->setAccessibleName(tr("Trainee"));
  person_->setEditable(true);
  person_->setInsertPolicy(QComboBox::NoInsert);
  person_->lineEdit()->setPlaceholderText(tr("Guest"));
  person_->setToolTip(tr("Choose a name or type a new one. Without a name the attempt is kept for Guest."));
  card.body->addWidget(person_);
  connect(person_, &QComboBox::currentTextChanged, this, &SetupPanel::person_chosen);
  // after the choice of a name the focus leaves the field, as the keys that move the instrument are letters
  const auto leave = [this] {
    if (person_->hasFocus()) focus_start();  // Tab also chooses the name, and goes where it goes
  };
  connect(person_, &QComboBox::activated, this, leave, Qt::QueuedConnection);  // queued: this Enter does not press START
  connect(person_->lineEdit(), &QLineEdit::returnPressed, this, &SetupPanel::focus_start, Qt::QueuedConnection);
  course_ = make_muted({}, card.frame);
  course_->setObjectName(QStringLiteral("course_next"));
  card.body->addWidget(course_);
  not_open_ = make_muted(tr("▲ Chosen lesson: not open yet"), card.frame);
  not_open_->setObjectName(QStringLiteral("course_not_open"));
  not_open_->hide();
  card.body->addWidget(not_open_);
  to_course_ = make_keyed_button(tr("To that lesson"), QStringLiteral("Ctrl+L"), QStringLiteral("to_course_lesson"), card.frame);
  to_course_->setToolTip(tr("Chooses the next lesson of the course, in Test: only tests count there"));
  give_key(to_course_, QStringLiteral("Ctrl+L"));
  connect(to_course_, &QPushButton::clicked, this, [this] {
    select_lesson(course_row_);
    set_mode(QStringLiteral("test"));
    focus_start();
  });
  card.body->addWidget(to_course_);
  left_ = new QCheckBox(tr("Left-handed"), card.frame);
  left_->setObjectName(QStringLiteral("left_handed"));
  left_->setToolTip(tr("Mirrors the whole lesson, hand and picture; kept with the attempt"));
  connect(left_, &QCheckBox::toggled, this, &SetupPanel::lesson_changed);
  card.body->addWidget(left_);
  return card.frame;
}

QWidget* SetupPanel::make_lessons(LessonsModel* lessons) {
  Card card = make_card(tr("Lesson"), this);
  lessons_ = new ChosenInSight(card.frame);
  lessons_->setObjectName(QStringLiteral("lessons"));
  lessons_->setAccessibleName(tr("Lessons"));
  lessons_->setModel(lessons);
  lessons_->setItemDelegate(new TwoLineDelegate(LessonsModel::kSummary, lessons_));
  lessons_->setUniformItemSizes(false);
  lessons_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  lessons_->setMinimumHeight(130);
  no_lessons_ =
      make_muted(tr("No lessons found. Put lesson files into ~/.local/share/swage/lessons, or name one when "
                    "starting the program: swage-console lesson.json"),
                 card.frame);
  card.body->addWidget(lessons_, 1);
  no_lessons_->setAlignment(Qt::AlignTop);
  card.body->addWidget(no_lessons_, 1);
  variant_ =
      make_keyed_button(tr("New lesson from this…"), QStringLiteral("Ctrl+N"), QStringLiteral("make_variant"), card.frame);
  variant_->setToolTip(
      tr("A lesson of your own, based on the chosen one: another needle, stiffer tissue, a stricter limit"));
  give_key(variant_, QStringLiteral("Ctrl+N"));
  connect(variant_, &QPushButton::clicked, this, &SetupPanel::make_variant);
  card.body->addWidget(variant_);
  card.body->addLayout(make_own(card.frame));
  no_lessons_->setVisible(lessons->rowCount() == 0);
  lessons_->setVisible(lessons->rowCount() > 0);
  connect(lessons_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    fill_devices();
    update_start();
    update_course();
    Q_EMIT lesson_changed();
  });
  connect(lessons_, &QListView::activated, this, &SetupPanel::start);
  return card.frame;
}

// buttons for the user's own lessons
QHBoxLayout* SetupPanel::make_own(QWidget* parent) {
  auto* row = new QHBoxLayout;
  edit_ = make_keyed_button(tr("Edit…"), QStringLiteral("Ctrl+E"), QStringLiteral("edit_lesson"), parent);
  edit_->setToolTip(tr("Title, task, goal and values of this lesson of your own"));
  give_key(edit_, QStringLiteral("Ctrl+E"));
  delete_ = make_button(tr("Delete…"), {}, QStringLiteral("delete_lesson"), parent);
  delete_->setToolTip(tr("Put this lesson of your own into the bin; attempts at it stay"));
  give_key(delete_, QStringLiteral("Ctrl+Del"));
  connect(edit_, &QPushButton::clicked, this, &SetupPanel::edit_lesson);
  connect(delete_, &QPushButton::clicked, this, &SetupPanel::delete_lesson);
  row->addWidget(edit_, 1);
  row->addWidget(delete_, 1);
  return row;
}

QWidget* SetupPanel::make_mode() {
  Card card = make_card(tr("Mode"), this);
  modes_ = new QButtonGroup(this);
  const struct {
    QString text, tip;
  } choices[] = {{tr("Practice"), tr("Cues are shown. Limits of a test are told and end nothing; a recorded hand is judged as in a test.")},
                 {tr("Test"), tr("Cues and readings are hidden; limits end the attempt, and it counts.")},
                 {tr("Demo"), tr("Watch the expert's hand. Nothing is recorded.")}};
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  for (int i = 0; i < 3; ++i) {
    auto* button = new QRadioButton(choices[i].text, card.frame);
    button->setObjectName(QString::fromLatin1(kModes[i]));
    button->setToolTip(choices[i].tip);
    button->setAccessibleDescription(choices[i].tip);
    modes_->addButton(button, i);
    row->addWidget(button);
  }
  row->addStretch(1);
  modes_->button(0)->setChecked(true);
  card.body->addLayout(row);
  explain_ = make_muted(choices[0].tip, card.frame);
  card.body->addWidget(explain_);
  connect(modes_, &QButtonGroup::idToggled, this, [this](int, bool on) {
    if (!on) return;
    update_modes();
    Q_EMIT mode_changed();
  });

  card.body->addWidget(make_heading(tr("Instrument"), card.frame));
  device_ = new QComboBox(card.frame);
  // a long name of an instrument must not make the column wider than the screen leaves it
  device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  device_->setMinimumContentsLength(12);
  device_->setObjectName(QStringLiteral("device"));
  device_->setAccessibleName(tr("Instrument"));
  fill_devices();
  connect(device_, &QComboBox::activated, this, [this] {
    // a choice of the lesson's own device is kept for the next lesson
    const QString chosen = device_->currentData().toString();
    wanted_device_ = chosen == lesson_device() ? QString() : chosen;
    update_modes();
  });
  card.body->addWidget(device_);
  return card.frame;
}

QString SetupPanel::person() const {
  const QString name = person_->currentText().trimmed();
  return name.isEmpty() || name == tr("Guest") ? QString::fromLatin1(record::kGuest) : name;
}

bool SetupPanel::person_is_new() const {
  const QString name = person();
  if (name == QLatin1String(record::kGuest) || known_.contains(name)) return false;
  return person_->findText(name, Qt::MatchExactly | Qt::MatchCaseSensitive) < 0;
}

void SetupPanel::focus_person() {
  person_->setFocus();
  person_->lineEdit()->selectAll();
}

void SetupPanel::focus_start() { start_->isEnabled() ? start_->setFocus() : lessons_->setFocus(); }

void SetupPanel::set_people(const QStringList& names, const QString& current) {
  {
    const QSignalBlocker quiet(person_);
    person_->clear();
    person_->addItem(tr("Guest"));
    for (const QString& name : names) {
      if (name != QLatin1String(record::kGuest)) person_->addItem(name);
    }
    person_->setCurrentText(current.isEmpty() ? tr("Guest") : person_text(current));
  }
  Q_EMIT person_chosen();
}

bool SetupPanel::has_lessons() const { return lessons_->model()->rowCount() > 0; }

QString SetupPanel::lesson() const { return lessons_->currentIndex().data(LessonsModel::kPath).toString(); }

void SetupPanel::select_lesson(int row) {
  const QAbstractItemModel* model = lessons_->model();
  no_lessons_->setVisible(model->rowCount() == 0);
  lessons_->setVisible(model->rowCount() > 0);
  lessons_->setCurrentIndex(model->index(row, 0));
}

QString SetupPanel::mode() const { return QString::fromLatin1(kModes[modes_->checkedId()]); }

void SetupPanel::set_mode(const QString& mode) {
  for (int i = 0; i < 3; ++i) {
    if (mode == QLatin1String(kModes[i])) modes_->button(i)->setChecked(true);
  }
}

QString SetupPanel::device() const {
  return mode() == QLatin1String("demo") ? QString::fromLatin1(kExpert) : device_->currentData().toString();
}

void SetupPanel::set_device(const QString& device) {
  wanted_device_ = device;
  fill_devices();
}

// the device that the lesson lists first; the expert is for demonstrations only
QString SetupPanel::lesson_device() const {
  const QStringList hands = lessons_->currentIndex().data(LessonsModel::kHands).toStringList();
  return hands.isEmpty() || hands.first() == QLatin1String(kExpert) ? QString::fromLatin1(kMouse) : hands.first();
}

// the devices that the lesson lists, in its order; the mouse is always among them
void SetupPanel::fill_devices() {
  QStringList hands = lessons_->currentIndex().data(LessonsModel::kHands).toStringList();
  const QString own = QString::fromLatin1(kOwnInstrument), mouse = QString::fromLatin1(kMouse), first = lesson_device();
  if (!hands.contains(mouse)) hands.insert(first == mouse ? 0 : 1, mouse);
  if (wanted_device_ == own && own_instrument_.isEmpty()) wanted_device_.clear();
  if (!own_instrument_.isEmpty()) hands.prepend(own);
  const QString wanted = wanted_device_.isEmpty() ? first : wanted_device_;
  if (!hands.contains(wanted)) hands += wanted;
  device_->clear();
  for (const QString& hand : hands) {
    const bool plugin = hand.contains(QLatin1Char('.'));
    const bool recorded = hand != own && hand != mouse && !plugin && hand != first;
    const QString name = hand == own                ? own_instrument_
                         : hand == mouse            ? tr("Mouse and keyboard")
                         : plugin                   ? hand
                         : recorded                 ? tr("Recorded hand: %1").arg(said(hand))
                                                    : said(hand);
    device_->addItem(name, hand);
    device_->setItemData(device_->count() - 1, recorded, kIsHand);
  }
  device_->setCurrentIndex(device_->findData(wanted));
  update_modes();
}

void SetupPanel::set_own_instrument(const QString& title) {
  // a newly bound instrument is selected
  wanted_device_ = title.isEmpty() ? QString() : QString::fromLatin1(kOwnInstrument);
  own_instrument_ = title;
  fill_devices();
}

bool SetupPanel::mirrored() const {
  return left_handed() || lessons_->currentIndex().data(LessonsModel::kMirror).toBool();
}

QString SetupPanel::summary() const { return lessons_->currentIndex().data(LessonsModel::kSummary).toString(); }

QString SetupPanel::task() const {
  return QStringList({summary(), lessons_->currentIndex().data(LessonsModel::kGoal).toString()}).join(QLatin1Char('\n')).trimmed();
}

void SetupPanel::set_running(bool running, bool paused) {
  running_ = running;
  paused_ = paused;
  for (QWidget* w : std::initializer_list<QWidget*>{person_, left_, lessons_}) w->setEnabled(!running);
  update_modes();
  update_start();
  update_course();
}

void SetupPanel::set_startable(bool on) {
  startable_ = on;
  update_start();
}

void SetupPanel::set_show(bool show) {
  show_ = show;
  update_modes();
}

void SetupPanel::update_modes() {
  for (QAbstractButton* b : modes_->buttons()) b->setEnabled(!running_ && !show_);
  const bool test_by_hand = modes_->checkedId() == 1 && device_ && device_->currentData(kIsHand).toBool();
  explain_->setText(show_          ? tr("A demonstration: nothing is judged or recorded.")
                    : test_by_hand ? tr("Cues and readings are hidden, and limits end the attempt. A recorded hand's attempt counts for nobody.")
                                   : modes_->checkedButton()->toolTip());
  device_->setEnabled(!running_ && modes_->checkedId() != 2);
}

void SetupPanel::set_course(const QString& words, int row) {
  course_->setText(words);
  course_row_ = row;
  update_course();
}

void SetupPanel::set_not_open(const QString& words) {
  not_open_->setToolTip(words);  // one line, so that the column still fits a screen of 800 lines
  not_open_->setVisible(!words.isEmpty());
}

void SetupPanel::update_course() {
  course_->setVisible(!course_->text().isEmpty());
  to_course_->setVisible(!course_->text().isEmpty() && course_row_ >= 0 && course_row_ != lessons_->currentIndex().row());
  to_course_->setEnabled(!running_);
}

bool SetupPanel::has_next() const {
  return lessons_->currentIndex().isValid() &&
         lessons_->currentIndex().row() + 1 < lessons_->model()->rowCount();
}

void SetupPanel::select_next() {
  if (has_next()) select_lesson(lessons_->currentIndex().row() + 1);
}

void SetupPanel::update_start() {
  if (!start_) return;
  start_->setEnabled(!running_ && startable_ && lessons_->currentIndex().isValid());
  start_->setToolTip(startable_ ? QString() : tr("This lesson cannot run; the picture says why."));
  variant_->setEnabled(!running_ && startable_ && lessons_->currentIndex().isValid() &&
                       lessons_->currentIndex().data(LessonsModel::kProblem).toString().isEmpty());
  const bool own = is_own_lesson(lesson());
  for (QPushButton* button : {edit_, delete_}) {
    button->setVisible(own);
    button->setEnabled(!running_);
  }
  start_->setText(!running_ ? tr("START   F5") : paused_ ? tr("Paused") : tr("Running…"));
}

}  // namespace swage::console
