// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/help_dialog.hpp"

#include <QFile>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QTabWidget>
#include <QTextBrowser>
#include <QTextDocument>

#include "console/models/said.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

struct Line {
  QString key, what;
};

Card make_table(const QString& heading, const QVector<Line>& lines, QWidget* parent) {
  Card card = make_card(heading, parent);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(18);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(1, 1);
  for (const Line& line : lines) {
    auto* key = new QLabel(line.key, card.frame);
    key->setProperty("key", true);
    const int row = grid->rowCount();
    grid->addWidget(key, row, 0);
    auto* what = new QLabel(line.what, card.frame);
    what->setProperty("wraps", true);
    grid->addWidget(what, row, 1);
  }
  card.body->addLayout(grid);
  card.body->addStretch(1);
  return card;
}

Card make_legend(const CueTheme& cues, QWidget* parent) {
  Card card = make_card(QObject::tr("What the cues mean"), parent);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  const QStringList meanings = cues.meanings();
  const auto lines = static_cast<int>((meanings.size() + 1) / 2);  // in two columns
  for (int i = 0; i < meanings.size(); ++i) {
    const CueStyle style = cues.style(meanings[i]);
    const int row = i % lines, left = i < lines ? 0 : 4;
    auto* badges = new QHBoxLayout;
    badges->setSpacing(0);
    for (const QChar sign : style.shape) {
      auto* badge = new CueBadge(card.frame);
      CueStyle one = style;
      one.shape = sign;
      badge->set_style(one);
      badges->addWidget(badge);
    }
    grid->addLayout(badges, row, left, Qt::AlignLeft);
    grid->addWidget(new QLabel(style.text, card.frame), row, left + 1);
    auto* sound = make_muted(style.sound, card.frame);
    sound->setWordWrap(false);
    grid->addWidget(sound, row, left + 2);
  }
  // the signs keep their width, what they mean and how they sound share the rest
  for (const int words : {1, 2, 5, 6}) grid->setColumnStretch(words, words % 4 == 1 ? 2 : 1);
  grid->setColumnMinimumWidth(3, 20);
  card.body->addLayout(grid);
  card.body->addStretch(1);
  return card;
}

}  // namespace

Card HelpDialog::lesson_keys(QWidget* parent) {
  return make_table(tr("Lesson"),
                    {{tr("F2"), tr("While an attempt runs: what is asked, and the limits")},
                     {tr("F3,  Shift+F3"), tr("What the instructor sent: read or taken, not now")},
                     {tr("F4"), tr("An expert's instruments as a guide")},
                     {tr("F5"), tr("Start, again")},
                     {tr("F6"), tr("Pause, resume")},
                     {tr("F7"), tr("Put what the lesson works on back")},
                     {tr("F8"), tr("Mark the moment two seconds ago")},
                     {tr("Shift+F5"), tr("Stop")},
                     {tr("F9"), tr("Trainee's view; there F11 fills the screen")},
                     {tr("F10"), tr("Instructor's window: readings, cues, events")},
                     {tr("Ctrl+R,  Ctrl+→"), tr("After an attempt: review it; the next lesson")},
                     {tr("Ctrl+N,  Ctrl+E"), tr("A lesson of your own, based on the chosen one; edit it")},
                     {tr("Ctrl+I,  Ctrl+Shift+E"), tr("Lessons page: import, export a lesson")},
                     {tr("Ctrl+1, 2, 3 ..."), tr("Go to a page")},
                     {tr("Ctrl+Z,  Ctrl+Y"), tr("Undo, redo")},
                     {tr("F12"), tr("Show frame rate")},
                     {tr("F1"), tr("This page")},
                     {tr("Enter,  Space"), tr("Press the button that has the keyboard")},
                     {tr("Ctrl+Q"), tr("Quit; asks while a lesson runs")}},
                    parent);
}

Card HelpDialog::instrument_keys(QWidget* parent) {
  return make_table(tr("Instrument: mouse and keyboard"),
                    {{tr("Left drag,  A D W S"), tr("Move across")},
                     {tr("Wheel,  Q E"), tr("Move away, come nearer")},
                     {tr("Right drag,  arrows"), tr("Turn")},
                     {tr("Ctrl+right drag,  Z X"), tr("Roll")},
                     {tr("C+left drag,  T G"), tr("Drive the needle along its own curve")},
                     {tr("Middle button,  Space"), tr("Hold: close the jaws to a good grip; again: further")},
                     {tr("Ctrl+middle,  B"), tr("Open the jaws")},
                     {tr("Ctrl+wheel"), tr("Close, open in small steps")},
                     {tr("Shift"), tr("Everything finer")},
                     {tr("Tab"), tr("The other instrument, where there are two")}},
                    parent);
}

Card HelpDialog::picture_keys(QWidget* parent) {
  return make_table(tr("Picture"),
                    {{tr("Orbit Side Top Near,  F11"), tr("Go to a view; to the next one")},
                     {tr("Drag,  arrows"), tr("Turn the camera")},
                     {tr("Right drag, Shift+drag"), tr("Shift the camera")},
                     {tr("Wheel,  + −"), tr("Nearer, further")},
                     {tr("Double click,  Home"), tr("Frame the scene")},
                     {tr("Ctrl+drag"), tr("Turn the camera while the mouse is the instrument")},
                     {tr("Ctrl+Shift+wheel"), tr("Camera nearer, further while the mouse is the instrument")},
                     {tr("Ctrl+Page up, down"), tr("Zoom of the microscope; with Shift its focus")}},
                    parent);
}

Card HelpDialog::review_keys(QWidget* parent) {
  return make_table(tr("Review"),
                    {{tr("Space"), tr("Play, pause")},
                     {tr("← →"), tr("10 ms back, on")},
                     {tr("Shift+← →"), tr("1 ms")},
                     {tr("Ctrl+← →"), tr("1 s")},
                     {tr("Home,  End"), tr("Start, end")},
                     {tr(",  ."), tr("Event before, after")},
                     {tr("L"), tr("Loop around the cursor")},
                     {tr("N"), tr("Note at the cursor")},
                     {tr("Ctrl+E"), tr("Save the attempt")},
                     {tr("Ctrl+Shift+E"), tr("Save its signals")},
                     {tr("Ctrl+R,  Ctrl+Shift+S"), tr("Save its page, its summary")},
                     {tr("Ctrl+Shift+P"), tr("Save the plot that has the keyboard, as PNG, SVG or PDF")}},
                    parent);
}

QWidget* HelpDialog::make_keys() {
  auto* page = new QWidget(this);
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(12);
  grid->addWidget(lesson_keys(page).frame, 0, 0);
  grid->addWidget(instrument_keys(page).frame, 0, 1);
  grid->addWidget(picture_keys(page).frame, 1, 0);
  grid->addWidget(review_keys(page).frame, 1, 1);
  return page;
}

// adds a page in a scroll area, for screens smaller than the page
void HelpDialog::add_tab(QWidget* page, const QString& title) {
  auto* area = new QScrollArea(tabs_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(page);
  tabs_->addTab(area, title);
  wanted_ = wanted_.expandedTo(page->sizeHint());
  // from now on: a page that wraps asks for less width than it can use
  for (auto* label : page->findChildren<QLabel*>())
    if (label->property("wraps").toBool()) label->setWordWrap(true);
}

// in the language of the window, else in English; scrolls by itself, and asks for no room
void HelpDialog::add_handbook(const char* name, const QString& title) {
  auto* text = new QTextBrowser(tabs_);
  text->setObjectName(QStringLiteral("handbook_%1").arg(QLatin1String(name)));
  text->setAccessibleName(title);
  text->setFrameShape(QFrame::NoFrame);
  const QString in_language = QStringLiteral(":/handbook/%1.%2.md").arg(QLatin1String(name), words_language());
  QFile file(QFile::exists(in_language) ? in_language : QStringLiteral(":/handbook/%1.md").arg(QLatin1String(name)));
  if (file.open(QIODevice::ReadOnly)) text->setMarkdown(QString::fromUtf8(file.readAll()));
  text->document()->setDocumentMargin(14);  // px, so that words keep clear of the frame
  tabs_->addTab(text, title);
}

HelpDialog::HelpDialog(const CueTheme& cues, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keys and cues"));
  setObjectName(QStringLiteral("help"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(12);
  tabs_ = new QTabWidget(this);
  add_tab(make_keys(), tr("Keys"));
  add_tab(make_legend(cues, this).frame, tr("Cues"));
  add_handbook("trainee", tr("Trainee's handbook"));
  add_handbook("instructor", tr("Instructor's handbook"));
  tabs_->setFocus();  // Ctrl+Tab goes to the other page
  column->addWidget(tabs_, 1);
  auto* close = make_button(tr("Close"), QStringLiteral("Esc"), QStringLiteral("close_help"), this);
  close->setDefault(true);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  column->addWidget(close, 0, Qt::AlignRight);
  constexpr int kScrollBar_px = 24, kTabsAndButton_px = 130, kTitle_px = 40;
  const QSize screen_px = screen()->availableGeometry().size() - QSize(0, kTitle_px);
  resize((wanted_ + QSize(32 + kScrollBar_px, kTabsAndButton_px)).boundedTo(screen_px));
}

}  // namespace swage::console
