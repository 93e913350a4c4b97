// SPDX-License-Identifier: Apache-2.0
//
// The German window: every string is translated, no translation is malformed, and visible texts are German.
#include "console/app/language.hpp"

#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTextBrowser>
#include <QXmlStreamReader>

#include "console/app/help_dialog.hpp"
#include "console/cues/theme_words.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/parts_panel.hpp"
#include "console/widgets/parts.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

struct Message {
  QString context, source;
  QStringList forms;  // one, or one per number
  bool finished = true, numbered = false;
};

QVector<Message> read_messages(const QString& path) {
  QVector<Message> out;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return out;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const QString name = xml.name().toString();
    if (name == QLatin1String("name")) context = xml.readElementText();
    if (name == QLatin1String("message")) {
      out += Message{context, {}, {}};
      out.last().numbered = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    }
    if (name == QLatin1String("source")) out.last().source = xml.readElementText();
    if (name == QLatin1String("translation")) {
      out.last().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (!out.last().numbered) out.last().forms += xml.readElementText();
    }
    if (name == QLatin1String("numerusform")) out.last().forms += xml.readElementText();
  }
  return out;
}

QString german_file() { return QStringLiteral(SWAGE_SOURCE_DIR "/console/translations/swage_de.ts"); }

QStringList places_in(const QString& text) {
  QStringList out;
  static const QRegularExpression kPlace(QStringLiteral("%(L?\\d+|n)"));
  for (auto it = kPlace.globalMatch(text); it.hasNext();) out += it.next().captured();
  out.sort();
  return out;
}

std::string say(const Message& m, const QString& form) {
  return (m.context + QStringLiteral(": \"") + m.source + QStringLiteral("\" -> \"") + form + QLatin1Char('"')).toStdString();
}

TEST(German, NoStringIsLeft) {
  QTemporaryDir dir;
  const QString copy = dir.filePath(QStringLiteral("copy.ts"));
  ASSERT_TRUE(QFile::copy(german_file(), copy));
  QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
  QProcess update;
  update.start(QStringLiteral(SWAGE_SOURCE_DIR "/console/translations/update.sh"), {copy});
  ASSERT_TRUE(update.waitForFinished(120000));
  const QString complaints = QString::fromUtf8(update.readAllStandardError());
  ASSERT_EQ(update.exitCode(), 0) << complaints.toStdString();
  // strings of such a class are looked up under its base class's name, and stay English
  EXPECT_FALSE(complaints.contains(QStringLiteral("lacks Q_OBJECT"))) << complaints.toStdString();
  const auto messages = read_messages(copy);
  EXPECT_GT(messages.size(), 800);
  for (const Message& m : messages) {
    EXPECT_TRUE(m.finished) << say(m, {}) << ": not translated. console/translations/update.sh, then translate";
    for (const QString& form : m.forms) EXPECT_FALSE(form.isEmpty()) << say(m, form);
  }
}

// themes are data: their texts must be listed for the translators, too
TEST(German, WordsOfTheThemesAreListed) {
  const QStringList listed = console::theme_words();
  int found = 0;
  for (const QString& name : QDir(QStringLiteral(SWAGE_SOURCE_DIR "/resources/themes")).entryList({QStringLiteral("*.json")})) {
    QFile file(QStringLiteral(SWAGE_SOURCE_DIR "/resources/themes/") + name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QJsonObject theme = QJsonDocument::fromJson(file.readAll()).object();
    QStringList words = {theme[QStringLiteral("title")].toString()};
    for (const QJsonValue cue : theme[QStringLiteral("cues")].toArray())
      words += {cue.toObject()[QStringLiteral("text")].toString(), cue.toObject()[QStringLiteral("sound")].toString()};
    words.removeAll(QString());
    found += static_cast<int>(words.size());
    for (const QString& word : words)
      EXPECT_TRUE(listed.contains(word)) << name.toStdString() << ": \"" << word.toStdString() << "\" is not in cues/theme_words.cpp";
  }
  EXPECT_GT(found, 60);
}

TEST(German, PlacesMnemonicsAndEndsAreThoseOfTheSource) {
  const auto messages = read_messages(german_file());
  ASSERT_GT(messages.size(), 800);
  for (const Message& m : messages) {
    for (const QString& form : m.forms) {
      if (form.isEmpty()) continue;  // reported by the test above
      EXPECT_TRUE(m.numbered || places_in(form) == places_in(m.source)) << say(m, form);
      EXPECT_EQ(form.count(QLatin1Char('&')), m.source.count(QLatin1Char('&'))) << say(m, form);
      EXPECT_EQ(form.count(QLatin1Char('\n')), m.source.count(QLatin1Char('\n'))) << say(m, form);
      EXPECT_EQ(form.front().isSpace(), m.source.front().isSpace()) << say(m, form);
      EXPECT_EQ(form.back().isSpace(), m.source.back().isSpace()) << say(m, form);
      EXPECT_EQ(form.startsWith(QLatin1Char('<')), m.source.startsWith(QLatin1Char('<'))) << say(m, form);
    }
    EXPECT_EQ(m.forms.size(), m.numbered ? 2 : 1) << say(m, {}) << ": German has two forms of what is counted";
  }
}

class GermanWindow : public WindowTest {
 protected:
  void SetUp() override {
    ASSERT_TRUE(console::use_language(QStringLiteral("de")));
    attempts = sample_attempts();
    launch.size = QSize(1280, 800);
  }
  void TearDown() override {
    window.reset();
    console::use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }
  /// A widget's text as in the translation file: without the shortcut after it.
  static QString words_of(const QWidget* w) {
    QString text;
    if (const auto* button = qobject_cast<const QAbstractButton*>(w)) text = button->text();
    if (const auto* label = qobject_cast<const QLabel*>(w)) text = label->text();
    return text.section(QStringLiteral("   "), 0, 0);
  }
};

TEST_F(GermanWindow, ShowsNoEnglishAndClipsNoButton) {
  QSet<QString> english;
  for (const Message& m : read_messages(german_file()))
    if (m.forms.size() == 1 && m.forms.first() != m.source) english.insert(m.source);
  open();
  int seen = 0;
  for (const char* page : {"page_run", "page_lessons", "page_courses", "page_people", "page_review", "page_setup", "page_stations"}) {
    click(page);
    for (const QWidget* w : window->findChildren<QWidget*>()) {
      const QString words = words_of(w);
      if (!w->isVisible() || words.isEmpty()) continue;
      ++seen;
      EXPECT_FALSE(english.contains(words)) << page << ": \"" << words.toStdString() << "\" is English";
      const auto* button = qobject_cast<const QPushButton*>(w);
      if (!button) continue;
      const QString text = QString(button->text()).remove(QLatin1Char('&'));
      EXPECT_LE(button->fontMetrics().horizontalAdvance(text), button->width()) << page << ": \"" << text.toStdString() << "\" is clipped";
    }
  }
  EXPECT_GT(seen, 80);
  EXPECT_EQ(child<QPushButton>("page_people")->text(), "Personen");
}

// As the English window does (FirstSight.ASmallScreenHasRoomForEverything): 960x540 is 1920x1080 at 200 %.
TEST_F(GermanWindow, FitsSmallScreens) {
  open();
  ASSERT_TRUE(wait_for_preview());
  for (const QSize& size : {QSize(1280, 800), QSize(1024, 768), QSize(960, 540)}) {
    EXPECT_TRUE(eventually([&] {
      window->resize(size);
      return window->size() == size;
    })) << window->width() << " x " << window->height();
    for (const char* name : {"start", "pause", "reset", "mark", "stop", "guide", "trainee_button", "help_button"}) {
      const auto* button = child<QPushButton>(name);
      const QRect at(button->mapTo(window.get(), QPoint()), button->size());
      EXPECT_TRUE(window->rect().contains(at)) << name << " at " << size.width();
      const auto* keyed = dynamic_cast<const console::KeyedButton*>(button);
      if (keyed) {
        EXPECT_LE(button->fontMetrics().horizontalAdvance(keyed->words()), button->width()) << name << " at " << size.width();
      }
    }
  }
  // nothing in the column of the lessons is cut where it is slim, with the buttons of a lesson of one's own
  const auto* setup = page()->setup();
  for (const char* name : {"edit_lesson", "delete_lesson"}) child<QWidget>(name)->setVisible(true);
  QApplication::processEvents();
  for (const char* name : {"make_variant", "person", "device", "demo", "edit_lesson", "delete_lesson"})
    EXPECT_LT(child<QWidget>(name)->mapTo(setup, QPoint(child<QWidget>(name)->width(), 0)).x(), setup->width()) << name;
  for (const console::Page& one : window->findChild<console::Pages*>()->all()) {
    window->show_page(one.id);
    EXPECT_LE(window->minimumSizeHint().width(), 960) << one.id.toStdString();
  }
}

// A page that is wider than the window hides its right side behind a scroll bar.
TEST_F(GermanWindow, CoursesAndPeopleNeedNoSidewaysScrollingAt1024) {
  with_school = true;
  {
    std::string error;
    const auto school = record::School::open(school_file(), error);
    ASSERT_TRUE(school) << error;
    record::Person one;
    one.name = "Synthetic 13";
    record::Course course;
    course.title = "Grundkurs";
    course.steps.resize(1);
    course.steps[0].lesson_id = "test.lesson.grasp";
    EXPECT_TRUE(school->add_person(one) && school->save_course(course)) << school->error();
  }
  open();
  for (const char* id : {"courses", "people"}) {
    window->show_page(QLatin1String(id));
    EXPECT_TRUE(eventually([&] {
      window->resize(1024, 768);
      return window->size() == QSize(1024, 768);
    })) << id << ": " << window->width() << " x " << window->height() << ", at least " << window->minimumSizeHint().width() << " x " << window->minimumSizeHint().height();
    const QWidget* page = window->findChild<console::Pages*>()->current().widget;
    QList<QScrollArea*> areas = page->findChildren<QScrollArea*>();
    for (QWidget* up = page->parentWidget(); up; up = up->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(up)) areas += area;
    EXPECT_GE(areas.size(), 2) << id;
    for (const QScrollArea* area : areas)
      EXPECT_TRUE(!area->isVisible() || eventually([&] { return area->horizontalScrollBar()->maximum() == 0; }))
          << id << ": " << area->horizontalScrollBar()->maximum() << " px too wide";
  }
}

// The insertion of a hanging needle has the most cues of all lessons without a thread, and the longest words.
TEST_F(GermanWindow, CutsNoWordOfTheLegend) {
  open();
  console::CueLegend* legend = page()->legend();
  legend->set_meanings({"grasp.wrong", "grasp.tips_only", "grasp.point_only", "grasp.good", "grip.too_hard", "target.near", "insert.good",
                        "insert.angle_off", "needle.stuck", "tissue.tear", "target.done", "needle.bent", "tissue.deflected", "needle.dropped",
                        "target.left"});
  ASSERT_TRUE(eventually([&] { return legend->isVisible() && legend->width() > 200; }));
  constexpr int kLaidOut_ms = 1000;
  EXPECT_TRUE(QTest::qWaitFor([&] { return legend->cut_words().isEmpty(); }, kLaidOut_ms))
      << legend->cut_words().join("; ").toStdString() << " in " << legend->width() << " px";
}

TEST_F(GermanWindow, WritesNumbersAndDatesAsGermansDo) {
  EXPECT_EQ(console::quantity_text(0.6, QStringLiteral("N")), QStringLiteral("0,60") + QChar(0x202f) + QStringLiteral("N"));
  EXPECT_TRUE(console::when_text(QStringLiteral("2026-11-19T09:23:00Z")).startsWith(QStringLiteral("19. Nov")));
  EXPECT_EQ(console::mode_text(QStringLiteral("practice")), QStringLiteral("Übung"));
  open();
  click("page_people");
  const auto* people = child<QTableView>("people");
  EXPECT_EQ(people->model()->headerData(0, Qt::Horizontal).toString(), "Name");
  EXPECT_EQ(people->model()->headerData(console::PeopleModel::kSeen, Qt::Horizontal).toString(), "Zuletzt da");
  // plural forms by %n
  EXPECT_EQ(QCoreApplication::translate("swage::console::SchoolDesk", "Add %n people", nullptr, 1), QStringLiteral("1 Person hinzufügen"));
  EXPECT_EQ(QCoreApplication::translate("swage::console::SchoolDesk", "Add %n people", nullptr, 3), QStringLiteral("3 Personen hinzufügen"));
}

void put(const QString& path, const QByteArray& text) {
  QDir().mkpath(QFileInfo(path).absolutePath());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

QByteArray german_words(const QByteArray& pairs) {
  return R"({ "format": "swage-words/1", "language": "de", "words": {)" + pairs + "} }";
}

// No text of this lesson is in the program: its translations lie beside it. Records stay untranslated.
TEST_F(GermanWindow, SaysInGermanWhatAStrangersLessonSays) {
  const QString file = dir.filePath(QStringLiteral("strangers/clip.json"));
  put(file, R"({ "format": "swage-lesson/1", "id": "org.example.clip", "title": "Set a clip", "summary": "Close the clip.", "goal": "Not too hard.",
                 "objects": [], "lesson": { "plugin": "x.lesson" },
                 "devices": [ { "name": "hand", "as": "mouse", "plugin": "swage.device.mouse" } ] })");
  put(dir.filePath(QStringLiteral("strangers/words.de.json")),
      german_words(R"("Set a clip": "Eine Klammer setzen", "Close the clip.": "Die Klammer schließen.")"));
  launch.options.lesson_path = file.toStdString();
  open();
  click("page_lessons");
  EXPECT_EQ(child<QLabel>("lesson_headline")->text(), "Eine Klammer setzen");
  const auto* list = child<QListView>("all_lessons");
  EXPECT_EQ(list->currentIndex().data(console::LessonsModel::kSummary).toString(), "Die Klammer schließen.");
  EXPECT_EQ(list->currentIndex().data(console::LessonsModel::kGoal).toString(), "Not too hard.") << "nobody has translated it";
  EXPECT_EQ(list->currentIndex().data(console::LessonsModel::kTitle).toString(), "Set a clip");
}

TEST(GermanWords, OfAStrangersPluginComeFromItsBundle) {
  QTemporaryDir dir;
  const QString clip = dir.filePath(QStringLiteral("org.example.clip")), other = dir.filePath(QStringLiteral("org.example.other"));
  put(clip + "/words.de.json", german_words(R"("Clip force": "Klammerkraft", "clip.closed": "Geschlossen", "Drag": "Ziehen",
                                              "The clip is closed": "Die Klammer ist zu")"));
  put(other + "/words.de.json", german_words(R"("Drag": "Widerstand")"));
  put(dir.filePath(QStringLiteral("broken/words.de.json")), "{");
  ASSERT_TRUE(console::use_language(QStringLiteral("de")));
  for (const QString& folder : {clip, other, dir.filePath(QStringLiteral("broken"))}) console::learn_words(folder);
  EXPECT_EQ(console::problems_of_words().size(), 1U);
  EXPECT_EQ(console::said(std::string("Clip force")), "Klammerkraft");
  EXPECT_EQ(console::said_id("clip.closed"), "Geschlossen");
  EXPECT_EQ(console::said_id("clip.opened"), "Clip opened");
  EXPECT_EQ(console::said_event("The clip is closed; value: its force."), "Die Klammer ist zu");
  EXPECT_EQ(console::said("Drag", other.toStdString()), "Widerstand");
  EXPECT_EQ(console::said("Drag", clip.toStdString()), "Ziehen");
  // two clips are distinguished by their names in the lesson
  const judge::Name one{"left", "clip.closed", "1", ""}, two{"right", "clip.closed", "1", ""};
  EXPECT_EQ(console::said_name(one, {one, two}), "Geschlossen (Left)");
  EXPECT_EQ(console::said_name(one, {one}), "Geschlossen");
  EXPECT_EQ(console::remark_text(QStringLiteral("at 52 % of real speed, no forces for 1.5 s")), "mit 52 % der wirklichen Geschwindigkeit, 1,5 s ohne Kräfte");
  console::use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
  console::learn_words(clip);
  EXPECT_EQ(console::said(std::string("Clip force")), "Clip force");
  EXPECT_EQ(console::said_id("clip.closed"), "Clip closed");
}

// Ids without a translation are named in English by the file beside the plugin, in every language that has no name for them.
TEST(Words, AnEventIsCalledAsItsPluginSays) {
  QTemporaryDir dir;
  const QString clip = dir.filePath(QStringLiteral("org.example.clip"));
  put(clip + "/words.en.json", R"({ "format": "swage-words/1", "language": "en", "words": { "clip.closed": "Clip shut", "clip.lost": "Clip lost" } })");
  put(clip + "/words.de.json", german_words(R"("clip.closed": "Klammer zu")"));
  for (const auto& [language, closed] : {std::pair{"en", "Clip shut"}, std::pair{"de", "Klammer zu"}}) {
    ASSERT_TRUE(console::use_language(QString::fromLatin1(language)));
    console::learn_words(clip);
    EXPECT_EQ(console::said_id("clip.closed"), closed);
    EXPECT_EQ(console::said_id("clip.lost"), "Clip lost");
    EXPECT_EQ(console::said_id("clip.opened"), "Clip opened") << "nobody has named it";
    EXPECT_NE(console::said_id("host.gap"), "Host gap");
  }
  console::use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
}

// Objects, couplings and instruments are named by their plugins' bundles, in the editor and where an instrument is put together.
TEST(GermanWords, NameThePartsOfALesson) {
  QTemporaryDir dir;
  const QString bundle = dir.filePath(QStringLiteral("org.example.clip")), file = dir.filePath(QStringLiteral("lesson/clip.json"));
  put(bundle + "/words.de.json", german_words(R"("Vessel clip": "Gefäßklemme", "Clip applier": "Anlegezange", "Shuts a vessel.": "Verschließt ein Gefäß.")"));
  put(file, R"({ "format": "swage-lesson/1", "id": "org.example.clip", "title": "Clip", "devices": [],
                 "objects": [ { "name": "left_clip", "plugin": "org.example.clip" } ], "lesson": { "plugin": "x.lesson" } })");
  put(dir.filePath(QStringLiteral("lesson/words.de.json")), german_words(R"("left_clip": "Linke Klemme")"));
  host::Catalogue::Options nothing;
  nothing.use_environment = false;
  host::Catalogue catalogue(nothing);
  host::PluginInfo clip, applier;
  clip.kind = SWAGE_KIND_OBJECT, clip.id = "org.example.clip", clip.name = "Vessel clip", clip.summary = "Shuts a vessel.", clip.bundle_dir = bundle.toStdString();
  applier.kind = SWAGE_KIND_DEVICE, applier.id = "org.example.applier", applier.name = "Clip applier", applier.bundle_dir = clip.bundle_dir;
  catalogue.add(clip);
  catalogue.add(applier);
  ASSERT_TRUE(console::use_language(QStringLiteral("de")));
  for (const QString& folder : {bundle, dir.filePath(QStringLiteral("lesson"))}) console::learn_words(folder);
  console::LessonDraft draft({file, "Clip", "", "", {}}, dir.filePath(QStringLiteral("draft.json")));
  const console::PartsPanel parts(&draft, &catalogue, nullptr);
  EXPECT_EQ(parts.findChild<QListWidget*>("parts")->item(0)->text(), "Linke Klemme: Gefäßklemme");
  const console::PartDialog add(console::LessonPart::Kind::kObject, draft, catalogue, nullptr);
  const auto* plugin = add.findChild<QComboBox*>("part_plugin");
  EXPECT_GE(plugin->findText("Gefäßklemme"), 0);
  EXPECT_EQ(plugin->findText("Vessel clip"), -1);
  EXPECT_EQ(plugin->itemData(plugin->findText("Gefäßklemme"), Qt::ToolTipRole).toString(), "Verschließt ein Gefäß.");
  console::SetupPage setup;
  setup.set_devices({&applier});
  EXPECT_GE(setup.findChild<QComboBox*>("binding_pose")->findText("Anlegezange"), 0);
  console::use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
}

// Help shows the handbooks in the language of the window
TEST(GermanWords, AreThoseOfTheHandbooksInHelp) {
  for (const auto& [language, title] : {std::pair{"de", "Handbuch für Übende"}, std::pair{"en", "The trainee's handbook"}}) {
    ASSERT_TRUE(console::use_language(QString::fromLatin1(language)));
    const console::HelpDialog help(console::CueTheme::stock("safe"), nullptr);
    const auto* page = help.findChild<QTextBrowser*>("handbook_trainee");
    ASSERT_NE(page, nullptr);
    EXPECT_TRUE(page->toPlainText().startsWith(QString::fromUtf8(title))) << page->toPlainText().left(60).toStdString();
  }
  QLocale::setDefault(QLocale::c());
}

TEST(Language, IsReadOutOfTheArgumentsAndOnlyThoseThereAreIsTaken) {
  EXPECT_EQ(console::language_in({"swage-console", "--language", "de", "--start"}), "de");
  EXPECT_EQ(console::language_in({"swage-console", "--language=de"}), "de");
  EXPECT_EQ(console::language_in({"swage-console"}), "");
  EXPECT_EQ(console::language_in({"swage-console", "--language"}), "");
  EXPECT_FALSE(console::use_language(QStringLiteral("xx")));
}

}  // namespace
}  // namespace swage::test
