// SPDX-License-Identifier: Apache-2.0
//
// True size by ruler and registration with an arm: the dialog, the stored values, and the settings passed to a session.
#include <swage/abi/device.h>

#include <QPushButton>
#include <nlohmann/json.hpp>

#include "console/app/station_dialog.hpp"
#include "assembly/lesson_text.hpp"
#include "console/models/instrument.hpp"
#include "console/models/said.hpp"
#include "session/sentences.hpp"
#include "toolkit/math.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

using console::ArmReader;
using console::Station;
using console::StationDialog;
using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// An arm whose tip position is set by the test, in the arm's own frame.
class ArmSession final : public session::Session {
 public:
  explicit ArmSession(std::shared_ptr<swage_vec3> tip) : tip_(std::move(tip)) { card_.devices.resize(1); }
  const snapshot::SceneCard& card() const override { return card_; }
  void start() override {}
  void pause(bool) override {}
  void reset_object(const std::string&) override {}
  void mark(const std::string&) override {}
  bool change(const std::string&, const std::string&, base::Problems&) override { return false; }
  void stop() override {}
  bool finished() const override { return false; }
  void wait() override {}
  bool pull_knot(uint64_t, session::PullProgress&) override { return false; }
  void pointer(const swage_pointer&, int64_t) override {}
  bool latest(snapshot::Snapshot& out) const override {
    out.n_device = 1;
    out.device[0].X_WD = {*tip_, {1, 0, 0, 0}};
    out.device[0].valid = SWAGE_VALID_POSE;
    return true;
  }
  bool next_event(judge::Event&) override { return false; }
  session::Result result() const override { return {}; }

 private:
  std::shared_ptr<swage_vec3> tip_;
  snapshot::SceneCard card_;
};

class StationTest : public WindowTest {
 protected:
  static QDoubleSpinBox* box(StationDialog& dialog, const char* name) {
    auto* found = dialog.findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  static QPushButton* button(StationDialog& dialog, const char* name) {
    return dialog.findChild<QPushButton*>(QString::fromLatin1(name));
  }
  static QString said(StationDialog& dialog, const char* name) {
    return dialog.findChild<QLabel*>(QString::fromLatin1(name))->text();
  }
  /// Enters the measurements of a 24-inch screen.
  static void measure(StationDialog& dialog) {
    box(dialog, "station_width")->setValue(527);
    box(dialog, "station_height")->setValue(296);
    box(dialog, "station_distance")->setValue(480);
    box(dialog, "station_eyes")->setValue(62);
    box(dialog, "station_screen_tilt")->setValue(-45);
    box(dialog, "station_scale")->setValue(4);
  }
  StationDialog::ArmMaker reader() {
    return [this] {
      const auto open = [this](const session::Options& o, base::Problems&) {
        asked = o;
        return std::make_unique<ArmSession>(tip);
      };
      session::Options options;
      options.lesson_path = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";
      options.device = "arm";
      options.store_path = "somebodys.db";
      options.settings = console::instrument_settings(options.lesson_path, {}, console::Placement{.force = false}, {});
      return std::make_unique<ArmReader>(open, options);
    };
  }
  /// Moves the tip to the four marks, or to the first `count`; `wrong`: index of one mark that is missed.
  void lead(StationDialog& dialog, const Pose& X_SD, int wrong = -1, int count = 4) {
    const auto marks = console::station_marks(dialog.station().size);
    button(dialog, "station_begin")->click();
    for (int i = 0; i < count; ++i) {
      const QPointF m = marks[static_cast<size_t>(i)];
      Vec3 p_S(1e-3 * m.x(), 1e-3 * m.y(), 0);
      if (i == wrong) p_S.x() += 0.02;
      *tip = toolkit::raw(Vec3(X_SD.inverse() * p_S));
      QPushButton* take = button(dialog, "station_take");
      QTest::qWait(50);  // earlier positions are dropped once the tip rests
      ASSERT_TRUE(eventually([&] { return take->isEnabled(); }));
      ASSERT_TRUE(eventually([&] { return settled(); }));
      take->click();
    }
  }
  // the mean is that of the last third of a second
  static bool settled() {
    QTest::qWait(450);
    return true;
  }

  std::shared_ptr<swage_vec3> tip = std::make_shared<swage_vec3>();
  session::Options asked;
};

TEST_F(StationTest, ARulersNumbersAreRememberedAndTheBarIsAHundredMillimetres) {
  StationDialog dialog({}, true, reader(), nullptr);
  EXPECT_FALSE(button(dialog, "station_begin")->isEnabled()) << "nobody has measured";
  measure(dialog);
  const console::TrueSize& size = dialog.station().size;
  EXPECT_TRUE(size.known());
  EXPECT_FLOAT_EQ(size.scale, 4);
  EXPECT_FALSE(size.on) << "until it is asked for";
  const auto* bar = dynamic_cast<console::RulerBar*>(dialog.findChild<QWidget*>(QStringLiteral("station_bar")));
  ASSERT_NE(bar, nullptr);
  EXPECT_NEAR(bar->length_px(), 100 / (527.0 / 1920), 1e-6);
  EXPECT_TRUE(said(dialog, "station_where").contains(QStringLiteral("10 mm of the scene are 40.0 mm"))) << said(dialog, "station_where").toStdString();

  Station kept = dialog.station();
  kept.registered = true;
  kept.device = QStringLiteral("arm");
  kept.date = QStringLiteral("2026-11-22");
  kept.arm.X_SD = {{0.1, -0.2, 0.3}, {0.5, 0.5, -0.5, 0.5}};
  kept.arm.worst = 1.25e-3;
  console::Settings settings(dir.filePath("station.ini"));
  console::remember(kept, settings);
  const Station back = console::read_station(settings);
  EXPECT_EQ(back.size.screen_mm, kept.size.screen_mm);
  EXPECT_EQ(back.size.distance_mm, 480);
  EXPECT_EQ(back.size.screen_tilt_deg, -45);
  EXPECT_TRUE(back.registered);
  EXPECT_EQ(back.device, kept.device);
  EXPECT_EQ(back.arm.X_SD.p.y, -0.2);
  EXPECT_EQ(back.arm.X_SD.q.y, -0.5);
  EXPECT_EQ(back.arm.worst, 1.25e-3);
  settings.set("station", QStringLiteral("{\"on\": 3"));
  EXPECT_FALSE(console::read_station(settings).size.known()) << "what somebody has spoilt counts as not measured";
}

TEST_F(StationTest, FourMarksRegisterAnArmAndAWrongOneIsRefused) {
  const Pose X_SD(Vec3(0.02, -0.15, 0.08), Quat(0.9, 0.3, -0.2, 0.1).normalized());
  StationDialog dialog({}, true, reader(), nullptr);
  dialog.set_device(QStringLiteral("arm"), QStringLiteral("An arm"));
  measure(dialog);
  QList<QPointF> marks;
  QObject::connect(&dialog, &StationDialog::mark, &dialog, [&](const std::optional<QPointF>& at) {
    if (at) marks += *at;
  });
  lead(dialog, X_SD, 2);
  EXPECT_FALSE(dialog.station().registered);
  EXPECT_TRUE(said(dialog, "station_step").contains(QString::fromStdString(session::say::kPointOff.words(1)))) << said(dialog, "station_step").toStdString();
  console::set_words_language(QStringLiteral("de"));
  lead(dialog, X_SD, 2);
  console::set_words_language(QStringLiteral("en"));
  EXPECT_TRUE(said(dialog, "station_step").contains(QStringLiteral("neben den anderen"))) << said(dialog, "station_step").toStdString();
  lead(dialog, X_SD);
  ASSERT_TRUE(dialog.station().registered) << said(dialog, "station_step").toStdString();
  const session::Registration& arm = dialog.station().arm;
  EXPECT_LT((Vec3(toolkit::vec(arm.X_SD.p)) - X_SD.p).norm(), 1e-9);
  EXPECT_GT(std::abs(toolkit::quat(arm.X_SD.q).dot(X_SD.q)), 1 - 1e-9);
  EXPECT_LT(arm.worst, 1e-9);
  EXPECT_TRUE(said(dialog, "station_registration").startsWith(QStringLiteral("Registered on"))) << said(dialog, "station_registration").toStdString();
  EXPECT_EQ(marks.size(), 12);
  // the arm is read without a store, in its own frame, and without forces
  EXPECT_EQ(asked.store_path, ":none:");
  ASSERT_EQ(asked.settings.size(), 1u);
  const auto devices = nlohmann::json::parse(asked.settings[0].substr(std::string("devices=").size()));
  EXPECT_EQ(devices[0]["motion_scale"], 1);
  EXPECT_EQ(devices[0]["force_scale"], 0);
  EXPECT_EQ(devices[0]["pose"]["p"][0], 0);
  // the registration does not hold for another instrument
  dialog.set_device(QStringLiteral("other"), QStringLiteral("Another"));
  EXPECT_TRUE(said(dialog, "station_registration").contains(QStringLiteral("not used for Another")));
  button(dialog, "station_forget")->click();
  EXPECT_FALSE(dialog.station().registered);
}

// U15: cancelling, restarting or closing at any mark keeps the previous registration.
TEST_F(StationTest, LeavingTheRegistrationAtAnyMarkChangesNothing) {
  const Pose X_SD(Vec3(0.02, -0.15, 0.08), Quat(0.9, 0.3, -0.2, 0.1).normalized());
  Station before;
  before.registered = true;
  before.device = QStringLiteral("arm");
  before.date = QStringLiteral("2026-11-22");
  before.arm.X_SD = {{0.1, -0.2, 0.3}, {0.5, 0.5, -0.5, 0.5}};
  before.arm.worst = 1.25e-3;
  for (int marks = 0; marks < 4; ++marks) {
    SCOPED_TRACE(marks);
    StationDialog dialog(before, true, reader(), nullptr);
    dialog.set_device(QStringLiteral("arm"), QStringLiteral("An arm"));
    measure(dialog);
    dialog.show();
    int changes = 0;
    std::optional<QPointF> shown;
    QObject::connect(&dialog, &StationDialog::changed, &dialog, [&] { ++changes; });
    QObject::connect(&dialog, &StationDialog::mark, &dialog, [&](const std::optional<QPointF>& at) { shown = at; });
    lead(dialog, X_SD, -1, marks);
    EXPECT_TRUE(shown.has_value());
    button(dialog, "station_begin")->click();  // "Begin again": back to the first
    EXPECT_TRUE(said(dialog, "station_step").contains(QStringLiteral("Mark 1 of 4")));
    lead(dialog, X_SD, -1, marks);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_EQ(changes, 0);
    EXPECT_FALSE(shown.has_value()) << "no mark stays on the screen";
    EXPECT_TRUE(dialog.station().registered);
    EXPECT_EQ(dialog.station().date, before.date);
    EXPECT_EQ(dialog.station().arm.X_SD.p.y, before.arm.X_SD.p.y);
    EXPECT_EQ(dialog.station().arm.worst, before.arm.worst);
  }
}

// The placement of a lesson's instrument is that of the arm while the trainee's view has true size and place, and not otherwise.
TEST_F(StationTest, ASessionIsToldWhereTheHandStands) {
  Station station;
  station.size.on = station.size.held = true;
  station.size.screen_mm = {527, 296};
  station.size.scale = 4;
  station.size.screen_tilt_deg = 0;
  station.registered = true;
  station.device = QStringLiteral("mouse");
  station.arm.X_SD = {{0.02, -0.15, 0.08}, {1, 0, 0, 0}};
  console::Settings settings(dir.filePath("settings.ini"));
  console::remember(station, settings);
  launch.options.lesson_path = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";
  script.end_s = 0;
  open();
  const auto told = [&]() -> std::string {
    for (const std::string& s : log->last.settings)
      if (s.starts_with("devices=")) return s.substr(8);
    return {};
  };
  ASSERT_TRUE(wait_for_preview());
  click("start");
  EXPECT_EQ(told(), "") << "no trainee's view, no place";
  control()->stop();
  click("trainee_button");
  console::OrbitCamera& camera = window->trainee()->view()->camera();
  EXPECT_TRUE(camera.held());
  camera.jump();
  EXPECT_NEAR(camera.up().z(), 0, 1e-3) << "the screen lies on the table and is looked at from above";
  click("start");
  ASSERT_NE(told(), "");
  EXPECT_EQ(log->last.display.scale, 4);
  const auto device = nlohmann::json::parse(told())[0];
  EXPECT_EQ(device["motion_scale"], 4);
  // from the front and above: right is +x, up in the picture is +y, towards the person is +z
  const QVector3D focus = camera.focus() * 1e-3F;
  EXPECT_NEAR(device["pose"]["p"][0].get<double>(), focus.x() + 0.02F / 4, 1e-5);
  EXPECT_NEAR(device["pose"]["p"][1].get<double>(), focus.y() - 0.15F / 4, 2e-4);
  EXPECT_NEAR(device["pose"]["p"][2].get<double>(), focus.z() + 0.08F / 4, 2e-4);
  control()->stop();
  page()->setup()->set_left_handed(true);
  click("start");
  const auto mirrored = nlohmann::json::parse(told())[0];
  EXPECT_EQ(mirrored["pose"], device["pose"]) << "what is seen of a mirrored lesson is where the hand is";
}

const std::string kGrasp = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";

TEST_F(StationTest, ALessonWithoutADeviceIsLeftAsItIs) {
  const console::Binding pad{"swage.device.gamepad", "", -1};
  EXPECT_TRUE(console::instrument_settings(SWAGE_SOURCE_DIR "/tests/console/lessons/010_grasp.json", pad, console::Placement{}, {}).empty());
  EXPECT_TRUE(console::instrument_settings("absent.json", pad, console::Placement{}, {}).empty());
  EXPECT_TRUE(console::instrument_settings(kGrasp, {}, {}, {}).empty()) << "nobody asked for anything";
}

// The thesis' instrument in a lesson written for a mouse: pose from a pad, jaws from the sensor, a button as clutch.
TEST_F(StationTest, APersonsInstrumentTakesThePlaceOfTheLessonsOwn) {
  host::Catalogue catalogue;
  host::PluginInfo pad;
  pad.kind = SWAGE_KIND_DEVICE, pad.id = "swage.device.gamepad", pad.version = "1.2.3";
  pad.params.resize(1);
  pad.params[0].id = "start";
  catalogue.add(pad);
  std::vector<assembly::Setting> settings;
  for (const std::string& s : console::instrument_settings(kGrasp, {"swage.device.gamepad", "swage.device.jaw_sensor", 4}, {}, catalogue))
    ASSERT_TRUE(assembly::parse_setting(s, settings.emplace_back()));
  assembly::LessonText lesson;
  base::Problems problems;
  ASSERT_TRUE(assembly::read_lesson_text(kGrasp, settings, lesson, problems));
  const auto& devices = lesson.json["devices"];
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(devices[0]["name"], "hand");
  EXPECT_EQ(devices[0]["plugin"], "swage.device.gamepad");
  EXPECT_EQ(devices[0]["filters"]["clutch"][0], 4);
  EXPECT_EQ(devices[0]["motion_scale"], 10) << "as the lesson says";
  EXPECT_FALSE(devices[0].contains("or")) << "no scripted hand beside it";
  // the mouse's start position of the tips, in the pad's frame: x right, y up, z towards the user
  const auto at = [&](const char* key, int i) { return devices[0]["params"][key][static_cast<size_t>(i)].get<double>(); };
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(at("start", i), 0, 1e-12);
  EXPECT_NEAR(at("start_axis", 0), -1, 1e-12);
  EXPECT_NEAR(at("start_closing", 1), 0.773, 1e-12);
  EXPECT_NEAR(at("start_closing", 2), 0.634, 1e-12);
  EXPECT_EQ(devices[1]["name"], "hand_jaws");
  EXPECT_EQ(devices[1]["plugin"], "swage.device.jaw_sensor");
  EXPECT_EQ(lesson.json["objects"][0]["follows"]["pose"], "hand");
  EXPECT_EQ(lesson.json["objects"][0]["follows"]["closure"], "hand_jaws");
  EXPECT_EQ(lesson.json["requires"]["swage.device.gamepad"], "^1");
  // a pedal of a third device, or of that of the jaws
  const auto clutched = [&](const char* pedal) {
    const auto said = console::instrument_settings(kGrasp, {"swage.device.gamepad", "swage.device.jaw_sensor", 2, pedal}, {}, catalogue);
    return nlohmann::json::parse(said[0].substr(8));
  };
  const auto three = clutched("swage.device.spacemouse"), two = clutched("swage.device.jaw_sensor"), own = clutched("swage.device.gamepad");
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[0]["filters"]["clutch_of"], three[1]["name"]);
  EXPECT_EQ(three[1]["plugin"], "swage.device.spacemouse");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0]["filters"]["clutch_of"], "hand_jaws");
  EXPECT_FALSE(own[0]["filters"].contains("clutch_of"));
  // one device for both, without a clutch
  const auto one = console::instrument_settings(kGrasp, {"swage.device.gamepad", "", -1}, {}, catalogue);
  const auto alone = nlohmann::json::parse(one[0].substr(8));
  EXPECT_EQ(alone.size(), 1u);
  EXPECT_FALSE(alone[0].contains("filters"));
}

TEST_F(StationTest, AnInstrumentIsBoundInSetupAndRememberedForEachPerson) {
  launch.options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
  launch.options.lesson_path = kGrasp;
  launch.options.person = "Ada";
  launch.person_given = true;
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  const auto choose = [&](const char* name, const char* id) {
    auto* combo = child<QComboBox>(name);
    const int index = combo->findData(QString::fromLatin1(id));
    ASSERT_GE(index, 0) << id;
    combo->setCurrentIndex(index);
    Q_EMIT combo->activated(index);
  };
  EXPECT_LT(child<QComboBox>("binding_pose")->findData(QStringLiteral("swage.device.scripted")), 0) << "nobody holds a file";
  EXPECT_FALSE(child<QComboBox>("binding_jaws")->isEnabled());
  choose("binding_pose", "swage.device.gamepad");
  choose("binding_jaws", "swage.device.jaw_sensor");
  EXPECT_EQ(page()->setup()->device_name(), QStringLiteral("Game pad + Jaw sensor"));
  const auto devices = [&] {
    for (const std::string& s : log->last.settings)
      if (s.starts_with("devices=")) return nlohmann::json::parse(s.substr(8));
    return nlohmann::json::array();
  };
  click("start");
  EXPECT_EQ(log->last.device, "");
  ASSERT_EQ(devices().size(), 2u);
  EXPECT_EQ(devices()[0]["plugin"], "swage.device.gamepad");
  control()->stop();
  // another person has another instrument, and the first one's is restored: now, and after a restart
  page()->setup()->set_people({QStringLiteral("Ada"), QStringLiteral("Bo")}, QStringLiteral("Bo"));
  EXPECT_EQ(page()->setup()->device(), QStringLiteral("mouse"));
  EXPECT_EQ(child<QComboBox>("binding_pose")->currentIndex(), 0);
  click("start");
  EXPECT_TRUE(devices().empty());
  control()->stop();
  page()->setup()->set_people({QStringLiteral("Ada"), QStringLiteral("Bo")}, QStringLiteral("Ada"));
  EXPECT_EQ(page()->setup()->device(), QString::fromLatin1(console::kOwnInstrument));
  window->close();
  window.reset();
  open();
  EXPECT_EQ(page()->setup()->device_name(), QStringLiteral("Game pad + Jaw sensor"));
  // a demonstration uses the expert
  page()->setup()->set_mode(QStringLiteral("demo"));
  EXPECT_EQ(page()->setup()->device(), QStringLiteral("expert"));
}

}  // namespace
}  // namespace swage::test
