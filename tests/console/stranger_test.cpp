// SPDX-License-Identifier: Apache-2.0
//
// The window as seen by a new user (tests/stranger.md): information during a lesson and after it.
#include <QComboBox>
#include <QFile>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "base/clock.hpp"
#include "console/app/help_dialog.hpp"
#include "console/app/language.hpp"
#include "console/cues/theme_words.hpp"
#include "console/models/metric_titles.hpp"
#include "console/pages/now_panel.hpp"
#include "console/pages/result_panel.hpp"
#include "console/pages/setup_panel.hpp"
#include "console/pages/status_strip.hpp"
#include "console/view3d/scene_input.hpp"
#include "console/view3d/scene_state.hpp"
#include "console/widgets/cue_legend.hpp"
#include "window_fixture.hpp"

namespace swage::console {
namespace {

TEST(Stranger, IsToldTheTimeThatIsLeft) {
  NowPanel now;
  now.set_themes(UiTheme::stock("light"), CueTheme::stock("safe"));
  Criteria asked;
  asked.pass = {"Hold it."};
  asked.max_time_s = 60;
  now.set_scene(Reader(snapshot::SceneCard{}), {0.3, 0.7}, "Grasp it.", asked);
  const auto* left = now.findChild<QLabel*>("time_left");
  const auto* criteria = now.findChild<QLabel*>("criteria");
  EXPECT_TRUE(criteria->isVisibleTo(&now)) << "what is asked, before";
  EXPECT_FALSE(left->isVisibleTo(&now));
  now.set_running(true);
  now.show_reading({}, 12);
  EXPECT_TRUE(left->isVisibleTo(&now));
  EXPECT_TRUE(left->text().contains("00:48")) << left->text().toStdString();
  now.show_reading({}, 70);
  EXPECT_TRUE(left->text().contains("00:10")) << left->text().toStdString();
}

/// A picture of nothing, and what reads the mouse and the keys over it.
struct EmptyPicture {
  EmptyPicture() {
    widget.resize(400, 300);
    panels.set_area(widget.size(), 1);
  }
  QWidget widget;
  SceneState scene;
  ViewPoint point{scene};
  PanelLayout panels{scene, point};
  SceneInput input{&widget, scene, point, panels};
};

TEST(Stranger, IsToldThatADragTurnsTheViewWhileTheInstrumentWaits) {
  EmptyPicture picture;
  SceneInput& input = picture.input;
  EXPECT_TRUE(input.hint(true, false, true).isEmpty()) << "nobody has dragged";
  QMouseEvent move(QEvent::MouseMove, QPointF(30, 20), QPointF(30, 20), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  input.move(&move);
  EXPECT_TRUE(input.hint(true, false, true).contains("turns the view"));
  input.set_instrument(true);
  EXPECT_FALSE(input.hint(true, false, true).contains("turns the view")) << "it waits no more";
}

TEST(Stranger, IsToldHowOftenF11LeadsToTheSide) {
  EmptyPicture picture;
  SceneInput& input = picture.input;
  input.set_instrument(true);
  ControlHints hints;
  hints.side = 1;
  input.set_hints(hints);
  EXPECT_TRUE(input.hint(true, false, false).startsWith("F11: look from the side"));
  hints.drive = true;
  input.set_hints(hints);
  EXPECT_TRUE(input.hint(true, false, false).contains("square to the tissue")) << "at the mark alone the point may slide off";
  hints.side = 3, hints.drive = false;
  input.set_hints(hints);
  EXPECT_TRUE(input.hint(true, false, false).startsWith("F11, 3 times: look from the side"));
}

// While a slow picture is painted a press and its release wait: both are handled at once, and the key is held as long as it was held.
// The session waits for the release, whatever the next picture takes.
TEST(Stranger, HoldsAKeyAsLongAsItWasHeldHoweverLateItIsHandled) {
  EmptyPicture picture;
  SceneInput& input = picture.input;
  input.set_instrument(true);
  uint64_t keys = 0;
  int64_t due_ms = 0;
  const int64_t begun_ns = base::wall_ns();
  QObject::connect(&input, &SceneInput::pointer, [&](const swage_pointer& p, qint64 due_ns) {
    keys = p.keys;
    due_ms = due_ns == 0 ? 0 : (due_ns - begun_ns) / 1'000'000;
  });
  const auto key = [&](bool down, quint64 at_ms) {
    QKeyEvent event(down ? QEvent::KeyPress : QEvent::KeyRelease, Qt::Key_A, Qt::NoModifier);
    event.setTimestamp(at_ms);
    down ? input.key_down(&event) : input.key_up(&event);
  };
  key(true, 5000);
  EXPECT_NE(keys, 0U);
  EXPECT_EQ(due_ms, 0) << "at once";
  key(false, 5300);
  EXPECT_EQ(keys, 0U);
  EXPECT_NEAR(static_cast<double>(due_ms), 300, 15);
  key(true, 5400);
  EXPECT_NEAR(static_cast<double>(due_ms), 400, 15) << "pressed again while the release waits";
  key(false, 5450);
  EXPECT_NEAR(static_cast<double>(due_ms), 450, 15);
  QTest::qWait(600);
  key(true, 9000);
  QTest::qWait(60);
  key(false, 9050);
  EXPECT_EQ(due_ms, 0) << "a release in time is not delayed";
  key(true, 10000);
  input.focus_lost();
  EXPECT_EQ(keys, 0U);
}

// Shift is pressed first and handled a picture earlier than the key: released in the person's order, the key first, or the last part of a
// fine stroke would be a coarse one.
TEST(KeyTimes, AModifierLastsAsLongAsTheKeyThatItIsFor) {
  using Kind = KeyTimes::Kind;
  constexpr int64_t ms = 1'000'000;
  KeyTimes times;
  EXPECT_EQ(times.due_ns(Kind::kModifier, false, 1000 * ms, 7000 * ms), 0);
  EXPECT_EQ(times.due_ns(Kind::kPress, false, 1050 * ms, 7500 * ms), 0) << "450 ms late";
  EXPECT_EQ(times.due_ns(Kind::kRelease, true, 1800 * ms, 7900 * ms), 8250 * ms);
  EXPECT_EQ(times.due_ns(Kind::kModifier, false, 1850 * ms, 7900 * ms), 8300 * ms);
  EXPECT_EQ(times.due_ns(Kind::kPress, false, 3000 * ms, 9000 * ms), 0) << "a new stroke has its own delay";
  EXPECT_EQ(times.due_ns(Kind::kRelease, true, 3100 * ms, 9500 * ms), 0) << "what is handled too late is not made later";
}

TEST(KeyTimes, NothingWaitsForLongAndNothingOvertakes) {
  using Kind = KeyTimes::Kind;
  constexpr int64_t ms = 1'000'000;
  KeyTimes times;
  times.due_ns(Kind::kPress, false, 1000 * ms, 7000 * ms);
  EXPECT_EQ(times.due_ns(Kind::kRelease, true, 90'000 * ms, 7001 * ms), 8001 * ms) << "the clock of the events has jumped";
  EXPECT_EQ(times.due_ns(Kind::kModifier, false, 1005 * ms, 7010 * ms), 8001 * ms);
}

// The close-up of a wound seldom shows the tips: a drag over it moves them as one on the picture does, and not by the thousandth part.
TEST(Stranger, MovesTheInstrumentByADragOverACloseUpToo) {
  base::Problems problems;
  SceneState scene;
  scene.set_card(test::open_fake({}, problems, test::FakeScript{}, std::make_shared<test::FakeLog>())->card());
  QWidget picture;
  picture.resize(800, 600);
  ViewPoint point(scene);
  point.frame(CameraPreset::kOrbit);
  PanelLayout panels(scene, point);
  panels.set_area(picture.size(), 1);
  SceneInput input(&picture, scene, point, panels);
  input.set_instrument(true);
  std::vector<swage_pointer> sent;
  QObject::connect(&input, &SceneInput::pointer, [&](const swage_pointer& p) { sent.push_back(p); });
  const auto drag = [&](const QPointF& from) {
    sent.clear();
    const QPointF to = from + QPointF(40, 0);
    QMouseEvent press(QEvent::MouseButtonPress, from, from, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QMouseEvent move(QEvent::MouseMove, to, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QMouseEvent release(QEvent::MouseButtonRelease, to, to, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
    input.press(&press);
    input.move(&move);
    input.release(&release);
    double dx = 0;
    for (const swage_pointer& p : sent) dx += p.dx;
    return dx;
  };
  const double moved = drag({400, 300});
  EXPECT_GT(moved, 0);
  WoundPlace wound;
  wound.radius = 0.15F;
  const auto loupe = [&]() -> Panel {
    panels.set_wound(wound);
    for (const Panel& panel : panels.panels())
      if (panel.inset == Inset::kWound) return panel;
    ADD_FAILURE() << "no close-up";
    return {};
  };
  wound.middle = scene.middle_of_tips() - QVector3D(0, 0, 4);
  EXPECT_DOUBLE_EQ(drag(loupe().at.center()), moved);
  // one that shows the tips is for fine work: they follow the pointer there
  wound.middle = scene.middle_of_tips();
  const double fine = drag(loupe().at.center());
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 0.5 * moved);
}

// A lesson with another author's instrument uses that instrument, unless a person chooses another.
TEST(Stranger, TakesTheInstrumentThatTheLessonNamesFirst) {
  QTemporaryDir dir;
  const auto write = [&dir](const char* id, const char* first, const char* second) {
    QFile file(dir.filePath(QString::fromLatin1(id) + QStringLiteral(".json")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral(R"({"format": "swage-lesson/1", "id": "%1", "title": "%1", "objects": [], "lesson": {"plugin": "x.lesson"},
                                  "devices": [{"name": "hand", %2, "or": [{%3}]}]})")
                   .arg(QLatin1String(id), QLatin1String(first), QLatin1String(second))
                   .toUtf8());
  };
  const char* const expert = R"("as": "expert", "plugin": "x.skilled")";
  write("a", R"("as": "mouse", "plugin": "x.mouse")", expert);
  write("b", R"("as": "pen", "plugin": "org.example.pen")", expert);
  write("c", R"("plugin": "org.example.pad")", expert);
  write("d", expert, R"("as": "mouse", "plugin": "x.mouse")");
  LessonsModel lessons;
  lessons.set_folders({dir.path()});
  ASSERT_EQ(lessons.rowCount(), 4);
  SetupPanel panel(&lessons);
  const char* const expected[] = {"mouse", "pen", "pad", "mouse"};
  for (int row = 0; row < 4; ++row) {
    panel.select_lesson(row);
    EXPECT_EQ(panel.device(), QLatin1String(expected[row])) << row;
  }
  panel.select_lesson(1);
  EXPECT_FALSE(panel.device_name().contains("Recorded")) << panel.device_name().toStdString();
  auto* choice = panel.findChild<QComboBox*>("device");
  EXPECT_EQ(choice->itemData(0).toString(), "pen");
  const int mouse = choice->findData(QStringLiteral("mouse"));
  ASSERT_GE(mouse, 0) << "the mouse can always be taken";
  choice->setCurrentIndex(mouse);
  Q_EMIT choice->activated(mouse);
  panel.select_lesson(2);
  EXPECT_EQ(panel.device(), "mouse") << "what a person chose stays";
}

class StrangersLesson : public test::WindowTest {
 protected:
  void TearDown() override {
    window.reset();
    use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }
  void put(const QString& name, const char* text) {
    QFile file(dir.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  // its button below the picture, once its scene is shown
  void expect_reset(const QString& label, const QString& tip) {
    open();
    const auto* reset = child<QPushButton>("reset");
    EXPECT_TRUE(eventually([&] { return reset->text() == label + QStringLiteral("   F7"); })) << reset->text().toStdString();
    EXPECT_EQ(reset->accessibleName(), label);
    EXPECT_EQ(reset->toolTip(), tip + QStringLiteral(" (F7)"));
    window.reset();
  }
};

TEST_F(StrangersLesson, SaysWhatItsResetDoes) {
  put("beads.json", R"({ "format": "swage-lesson/1", "id": "org.example.beads", "title": "Thread beads", "objects": [],
    "reset": { "label": "Scatter again", "tip": "Lays all beads out as at the start" }, "lesson": { "plugin": "org.example.beads" } })");
  put("words.de.json", R"({ "format": "swage-words/1", "language": "de", "words": {
    "Scatter again": "Neu streuen", "Lays all beads out as at the start": "Legt alle Perlen aus wie am Anfang" } })");
  launch.options.lesson_path = dir.filePath("beads.json").toStdString();
  expect_reset("Scatter again", "Lays all beads out as at the start");
  ASSERT_TRUE(use_language(QStringLiteral("de")));
  expect_reset("Neu streuen", "Legt alle Perlen aus wie am Anfang");
  // one that names nothing has the program's words
  use_language(QStringLiteral("en"));
  put("plain.json", R"({ "format": "swage-lesson/1", "id": "org.example.plain", "title": "Plain", "objects": [], "lesson": { "plugin": "org.example.plain" } })");
  launch.options.lesson_path = dir.filePath("plain.json").toStdString();
  expect_reset("Put back", "Put what the lesson works on back to where it started");
}

// A cue that no theme knows stands in the legend and in the help as the stock ones do, with its name, signs and sound.
TEST(Stranger, FindsTheCuesOfAPluginInLegendAndHelp) {
  const CueTheme theme = CueTheme::stock("safe").with({{"lamp.lit", "The lamp is lit", "good"}});
  CueLegend legend;
  legend.set_themes(UiTheme::stock("light"), theme);
  legend.set_meanings({"grasp.good", "lamp.lit"});
  const QList<QWidget*> rows = legend.findChildren<QWidget*>();
  const auto row = std::find_if(rows.begin(), rows.end(), [](const QWidget* w) { return w->accessibleName() == "The lamp is lit"; });
  ASSERT_NE(row, rows.end());
  EXPECT_TRUE((*row)->toolTip().contains(theme_word(theme.style("target.near").sound))) << (*row)->toolTip().toStdString();
  const HelpDialog help(theme, nullptr);
  const QList<QLabel*> labels = help.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* l) { return l->text() == "The lamp is lit"; }));
}

// On a machine that draws slowly the loop is on time and the picture is not: that is told, while a lesson runs.
TEST(Stranger, IsToldThatThePictureIsBehindTheHand) {
  StatusStrip strip;
  strip.set_graphics("Picture: x");
  const auto* graphics = strip.findChild<QLabel*>("graphics");
  strip.show_health(snapshot::Snapshot(), snapshot::SceneCard(), 1000, true);
  FrameTimes frames, latency;
  for (int i = 0; i < 5; ++i) latency.add_time(0.15);
  strip.show_frames(frames, latency);
  EXPECT_EQ(graphics->text(), "Picture: x");
  for (int i = 0; i < 5; ++i) latency.add_time(1.2);
  strip.show_frames(frames, latency);
  EXPECT_EQ(graphics->text(), QString::fromUtf8("▲ Picture: x, 1.2 s behind the hand"));
  strip.set_idle("Ready");
  EXPECT_EQ(graphics->text(), "Picture: x");
}

// What a plugin draws and nobody can is told in the strip: of whom, and which part.
TEST(Stranger, SeesThatNotEverythingIsDrawn) {
  StatusStrip strip;
  snapshot::Snapshot now;
  snapshot::SceneCard card;
  card.objects.resize(2);
  card.objects[1].name = "pad";
  strip.show_health(now, card, 1000, true);
  EXPECT_FALSE(strip.text().contains("not everything is drawn"));
  now.health.visuals.cut = 7;  // the first ones are drawn: no fault
  strip.show_health(now, card, 1000, true);
  EXPECT_FALSE(strip.text().contains("not everything is drawn"));
  const auto* loop = strip.findChild<QLabel*>("loop_health");
  EXPECT_TRUE(loop->toolTip().contains("7 times"));
  now.health.visuals = {3, 0, 1, base::kNoCoupling, 4, SWAGE_VISUAL_DISC, static_cast<uint32_t>(base::VisualMember::kDirection), 0};
  strip.show_health(now, card, 1000, true);
  EXPECT_TRUE(strip.text().contains("not everything is drawn"));
  EXPECT_TRUE(strip.text().startsWith(QStringLiteral("▲")));
  EXPECT_EQ(loop->toolTip(), "What is drawn on Pad was left out 3 times; first for its primitive 4 (disc), member direction.");
}

// Thirty numbers would hide the five important ones; deductions are listed separately.
TEST(Stranger, SeesWhatMattersFirstAndWhereThePointsWent) {
  ResultPanel panel;
  session::Result result;
  result.outcome = judge::Outcome::kPassed;
  snapshot::SceneCard card;
  for (int i = 0; i < 8; ++i) {
    const std::string id = i < 6 ? "metric." + std::to_string(i) : "points." + std::to_string(i);
    result.metrics.push_back({id, "1", "", 7.25 + i});
    card.script.metrics.push_back({"lesson", id, "1", ""});
    snapshot::CardMetric own;
    own.rank = i < 2 ? 2 - i : 0;
    if (i >= 6) own.show = SWAGE_SHOW_POINTS;
    card.metrics.push_back(own);
  }
  panel.show_result(result, card, true);
  const auto shown = [&](const QString& value) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->text() == value) return label->isVisibleTo(&panel);
    ADD_FAILURE() << value.toStdString() << " is nowhere";
    return false;
  };
  const auto number = [](double v) { return QLocale().toString(v, 'f', 2); };
  EXPECT_TRUE(shown(number(7.25)) && shown(number(8.25)));
  EXPECT_FALSE(shown(number(9.25))) << "on demand";
  EXPECT_TRUE(shown(QStringLiteral("−%L1").arg(13.25, 0, 'f', 1)));
  auto* all = panel.findChild<QPushButton*>("all_numbers");
  all->click();
  EXPECT_TRUE(shown(number(9.25)));
  // by keys, in display order
  QWidget* at = panel.findChild<QPushButton*>("again");
  for (const char* name : {"to_review", "next_lesson", "to_progress", "all_numbers"}) {
    do at = at->nextInFocusChain();
    while (!qobject_cast<QPushButton*>(at));
    EXPECT_EQ(at->objectName(), name);
  }
}

// A passed attempt whose exit wound was torn far beyond the limit must not hide that behind "All numbers".
TEST(Stranger, SeesWhatIsBeyondItsLimitAmongTheFirstNumbers) {
  ResultPanel panel;
  session::Result result;
  result.outcome = judge::Outcome::kPassed;
  result.metrics = {{"time.task", "s", "", 41.0}, {"wound.exit", "1", "", 9.05}, {"wound.wide", "1", "", 1.2}};
  snapshot::SceneCard card;
  card.metrics.resize(3);
  card.metrics[0].rank = 1;
  for (const size_t i : {1u, 2u}) card.metrics[i].show = SWAGE_SHOW_SHARE;
  const auto first = [&](const char* metric) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->accessibleName() == metric_title(metric) && label->isVisibleTo(&panel)) return label->text().toStdString();
    return std::string();
  };
  panel.show_result(result, card, true);
  EXPECT_EQ(first("wound.exit"), "") << "no limit is known";
  panel.set_targets({{"wound.exit", {{}, 6}}, {"wound.wide", {{}, 6}}});
  panel.show_result(result, card, true);
  EXPECT_TRUE(first("wound.exit").starts_with("▲ 905")) << first("wound.exit");
  EXPECT_NE(first("wound.exit").find("over 600"), std::string::npos) << first("wound.exit");
  EXPECT_EQ(first("wound.wide"), "") << "within its limit it stands on demand";
}

}  // namespace
}  // namespace swage::console
