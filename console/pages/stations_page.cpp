// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/stations_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>

#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kChosen_px = 330, kPicture_px = 190, kSent_px = 130;
constexpr int kAge_ms = 1000;

}  // namespace

StationsPage::StationsPage(StationLink* link, LessonsModel* lessons, QWidget* parent)
    : QWidget(parent), link_(link), lessons_(lessons), model_(new StationsModel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 6);
  stack_ = new QStackedWidget(this);
  auto* both = new QWidget(stack_);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(make_list(), 1);
  row->addWidget(make_chosen());
  stack_->addWidget(both);
  stack_->addWidget(make_empty());
  column->addWidget(stack_);
  connect(link_, &StationLink::stations_changed, this, &StationsPage::show_stations);
  connect(link_, &StationLink::named, this, &StationsPage::show_stations);
  connect(link_, &StationLink::sent_changed, this, &StationsPage::show_sent);
  connect(link_, &StationLink::problem_changed, this, &StationsPage::show_problem);
  connect(link_, &StationLink::refused, this, [this](const QString& why) { say(tr("▲ %1").arg(why)); });
  connect(link_, &StationLink::marked, this, [this](const QString& station, double time_s) {
    say(tr("✓ Marked at %1 of the attempt at %2").arg(clock_text(time_s), station));
    moment_->clear();
  });
  connect(link_, &StationLink::pictured, this, [this](const QString& station, const QImage& image, double age_s) {
    if (station != chosen()) return;
    pictured_ = station;
    picture_->setPixmap(QPixmap::fromImage(image).scaled(picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
    say(age_s < 1.5 ? tr("Picture of now") : tr("Picture of %1 s ago").arg(static_cast<int>(age_s)));
  });
  age_.setInterval(kAge_ms);
  connect(&age_, &QTimer::timeout, this, &StationsPage::show_problem);
  show_stations();
  show_chosen();
}

QWidget* StationsPage::make_list() {
  Card card = make_card({}, this);
  auto* head = new QHBoxLayout;
  head->addWidget(make_heading(tr("Stations"), card.frame));
  count_ = make_muted({}, card.frame);
  count_->setObjectName(QStringLiteral("stations_count"));
  head->addWidget(count_, 1);
  card.body->addLayout(head);
  problem_ = new QLabel(card.frame);
  problem_->setObjectName(QStringLiteral("stations_problem"));
  problem_->setWordWrap(true);
  problem_->hide();
  card.body->addWidget(problem_);
  table_ = make_row_table(model_, tr("Stations"), QStringLiteral("stations"), card.frame);
  table_->setWordWrap(false);
  QHeaderView* columns = table_->horizontalHeader();
  // the longest columns share the remaining width
  for (const int wide : {int(StationsModel::kLesson), int(StationsModel::kPhase), int(StationsModel::kCues), int(StationsModel::kHealth)})
    columns->setSectionResizeMode(wide, QHeaderView::Stretch);
  table_->setToolTip(tr("Enter: write to this station"));
  card.body->addWidget(table_, 1);
  card.body->addWidget(make_heading(tr("Said from here"), card.frame));
  sent_ = new QListWidget(card.frame);
  sent_->setObjectName(QStringLiteral("sent"));
  sent_->setAccessibleName(tr("Messages and lessons that were sent from here, with their receipts"));
  sent_->setFixedHeight(kSent_px);
  sent_->setSelectionMode(QAbstractItemView::NoSelection);
  card.body->addWidget(sent_);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &StationsPage::show_chosen);
  connect(table_, &QTableView::activated, this, [this] { words_->setFocus(); });
  return card.frame;
}

QWidget* StationsPage::make_picture(QWidget* parent) {
  picture_ = new QLabel(parent);
  picture_->setObjectName(QStringLiteral("station_picture"));
  picture_->setAccessibleName(tr("Picture of the scene at this station"));
  picture_->setFixedHeight(kPicture_px);
  picture_->setMinimumWidth(1);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setWordWrap(true);
  picture_->setProperty("muted", true);
  return picture_;
}

QWidget* StationsPage::make_chosen() {
  Card card = make_card({}, this);
  card.frame->setFixedWidth(kChosen_px);
  name_ = make_heading({}, card.frame);
  name_->setObjectName(QStringLiteral("chosen_station"));
  card.body->addWidget(name_);
  facts_ = new QLabel(card.frame);
  facts_->setObjectName(QStringLiteral("station_facts"));
  facts_->setWordWrap(true);
  facts_->setTextFormat(Qt::PlainText);
  card.body->addWidget(facts_);
  card.body->addWidget(make_picture(card.frame));
  make_actions(card.frame, card.body);
  said_ = make_muted({}, card.frame);
  said_->setObjectName(QStringLiteral("station_said"));
  card.body->addWidget(said_);
  card.body->addStretch(1);
  forget_ = make_button(tr("Remove from the list"), {}, QStringLiteral("forget_station"), card.frame);
  forget_->setToolTip(tr("For a station that is gone; it comes back by itself when it is started again"));
  connect(forget_, &QPushButton::clicked, this, &StationsPage::forget);
  card.body->addWidget(forget_);
  return card.frame;
}

void StationsPage::make_actions(QWidget* parent, QVBoxLayout* body) {
  const auto button = [&](const QString& text, const char* key, const char* name, auto call) {
    auto* made = make_button(text, QString::fromLatin1(key), QString::fromLatin1(name), parent);
    if (key[0] != 0) made->setShortcut(QKeySequence(QString::fromLatin1(key)));
    connect(made, &QPushButton::clicked, this, call);
    return made;
  };
  const auto line = [&](const QString& what, const char* name) {
    auto* made = new QLineEdit(parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setAccessibleName(what);
    made->setPlaceholderText(what);
    made->setMaxLength(200);  // two lines in the trainee's view
    return made;
  };
  look_ = button(tr("Picture"), "Ctrl+P", "ask_picture", &StationsPage::ask_picture);
  look_->setToolTip(tr("A picture of the scene as that station shows it, taken once (%1)").arg(key_text(QStringLiteral("Ctrl+P"))));
  body->addWidget(look_);
  words_ = line(tr("Words for this station"), "station_words");
  connect(words_, &QLineEdit::returnPressed, this, &StationsPage::send_words);
  send_ = button(tr("Send"), "", "send_words", &StationsPage::send_words);
  lesson_ = new QComboBox(parent);
  lesson_->setObjectName(QStringLiteral("station_lesson"));
  lesson_->setAccessibleName(tr("Lesson for this station"));
  lesson_->setModel(lessons_);
  lesson_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  give_ = button(tr("Send lesson"), "Ctrl+L", "send_lesson", &StationsPage::send_lesson);
  moment_ = line(tr("What is to be seen here"), "station_moment");
  connect(moment_, &QLineEdit::returnPressed, this, &StationsPage::mark);
  mark_ = button(tr("Mark"), "Ctrl+M", "mark_station", &StationsPage::mark);
  mark_->setToolTip(tr("Pins a note to the moment two seconds ago in the attempt that runs there; the trainee does not see it (%1)")
                        .arg(key_text(QStringLiteral("Ctrl+M"))));
  for (const auto& [left, right] : {std::pair<QWidget*, QWidget*>{words_, send_}, {lesson_, give_}, {moment_, mark_}}) {
    auto* row = new QHBoxLayout;
    row->addWidget(left, 1);
    row->addWidget(right);
    body->addLayout(row);
  }
}

QWidget* StationsPage::make_empty() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  empty_ = new QLabel(box);
  empty_->setObjectName(QStringLiteral("no_stations"));
  empty_->setWordWrap(true);
  empty_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  empty_->setMaximumWidth(760);
  // no alignment, with which the height would be computed for another width
  auto* middle = new QHBoxLayout;
  middle->addStretch(1);
  middle->addWidget(empty_, 8);
  middle->addStretch(1);
  column->addStretch(2);
  column->addLayout(middle);
  column->addStretch(3);
  return box;
}

void StationsPage::set_cues(const CueTheme& cues) {
  model_->set_cue_words([cues](const QString& meaning) { return cues.style(meaning).text; });
}

QString StationsPage::chosen() const { return table_->currentIndex().siblingAtColumn(0).data(StationsModel::kName).toString(); }

void StationsPage::choose(const QString& station) {
  const int row = model_->row_of(station);
  if (row >= 0) table_->setCurrentIndex(model_->index(row, 0));
}

void StationsPage::say(const QString& words) { said_->setText(words); }

void StationsPage::show_stations() {
  const QString was = chosen();
  model_->set_stations(link_->stations(), link_->name());
  const int n = model_->rowCount();
  count_->setText(n == 1 ? tr("1 station") : tr("%1 stations").arg(n));
  if (!was.isEmpty()) choose(was);
  if (chosen().isEmpty() && n > 0) table_->setCurrentIndex(model_->index(0, 0));
  show_chosen();
  show_problem();
}

// While the server does not answer, the last list stays visible, with its age.
void StationsPage::show_problem() {
  const bool any = model_->rowCount() > 0;
  const QString why = link_->problem();
  problem_->setVisible(!why.isEmpty());
  problem_->setText(tr("▲ What is shown is %1 s old. %2").arg(static_cast<int>(link_->age_s())).arg(why));
  why.isEmpty() ? age_.stop() : age_.start();
  const bool first = any && stack_->currentIndex() == 1 && isVisible();
  stack_->setCurrentIndex(any ? 0 : 1);
  if (first) table_->setFocus();
  if (any) return;
  if (!link_->has_server())
    return empty_->setText(
        tr("The attempts of this school are kept in a file, so there is only this station.\n\n"
           "To see all stations here, what each trainee does and how it goes, let every station use one PostgreSQL database "
           "(package postgresql of Debian). Start each with\n\n"
           "    swage-console --store postgresql://user@server/swage?sslmode=verify-full --station \"Table 1\"\n\n"
           "The users of that server decide who may see and say what, and sslmode encrypts it on its way. Nothing else listens on "
           "the network, and no lesson ever waits for it."));
  empty_->setText(why.isEmpty() ? tr("Asking the server …") : tr("▲ The stations cannot be seen. %1\n\nIt is tried again every 2 s.").arg(why));
}

void StationsPage::show_chosen() {
  const QModelIndex at = table_->currentIndex();
  const bool any = at.isValid();
  for (QWidget* w : std::initializer_list<QWidget*>{look_, words_, send_, lesson_, give_, moment_, mark_, forget_}) w->setEnabled(any);
  if (!any) {
    name_->setText(tr("No station chosen"));
    return facts_->clear();
  }
  const record::StationNow& now = model_->at(at.row());
  using State = record::StationState;
  const bool there = !now.lost() && now.state != State::kClosed;
  const bool runs = there && (now.state == State::kRunning || now.state == State::kPaused);
  for (QWidget* w : std::initializer_list<QWidget*>{look_, words_, send_, lesson_, give_}) w->setEnabled(there);
  for (QWidget* w : std::initializer_list<QWidget*>{moment_, mark_}) w->setEnabled(runs && !now.attempt_id.empty());
  forget_->setEnabled(!there);
  const auto said = [&](int column) { return at.siblingAtColumn(column).data().toString(); };
  name_->setText(said(StationsModel::kStation));
  QStringList facts;
  for (const int column : {StationsModel::kWho, StationsModel::kLesson, StationsModel::kState, StationsModel::kPhase})
    if (!said(column).isEmpty()) facts += said(column);
  facts_->setText(facts.join(QLatin1Char('\n')));
  if (pictured_ == chosen()) return;
  picture_->clear();
  picture_->setText(tr("No picture yet"));
  pictured_.clear();
}

void StationsPage::show_sent() {
  sent_->clear();
  for (const record::StationMessage& m : link_->sent()) sent_->addItem(sent_text(m));
}

void StationsPage::send_words() {
  const QString words = words_->text().trimmed();
  if (words.isEmpty() || chosen().isEmpty()) return words_->setFocus();
  link_->send(chosen(), StationLink::Kind::kWords, words);
  words_->clear();
}

void StationsPage::send_lesson() {
  const int row = lesson_->currentIndex();
  if (row < 0 || chosen().isEmpty()) return;
  link_->send(chosen(), StationLink::Kind::kLesson, lessons_->at(row).id, lessons_->at(row).title);
}

void StationsPage::mark() {
  if (!chosen().isEmpty()) link_->mark(chosen(), moment_->text().trimmed());
}

void StationsPage::ask_picture() {
  if (chosen().isEmpty()) return;
  say(tr("A picture is asked for …"));
  link_->send(chosen(), StationLink::Kind::kPicture, {});
}

void StationsPage::forget() {
  if (!chosen().isEmpty()) link_->forget(chosen());
}

void StationsPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  link_->watch(true);
}

void StationsPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  link_->watch(false);
}

}  // namespace swage::console
