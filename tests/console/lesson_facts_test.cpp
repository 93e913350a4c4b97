// SPDX-License-Identifier: Apache-2.0
#include "console/models/lesson_facts.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <fstream>
#include <iterator>

#include "console/models/said.hpp"

namespace swage::console {
namespace {

host::MetricInfo metric(const char* id, const char* least, const char* most) {
  host::MetricInfo m;
  m.id = id;
  m.least = least;
  m.most = most;
  return m;
}

host::Catalogue catalogue() {
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.lesson";
  host::Param force;
  force.type = SWAGE_PARAM_VECTOR;
  force.dimension = 2;
  force.id = "force";
  force.label = "Force";
  force.unit = force.display_unit = "N";
  force.max = 100;
  force.default_number = {0.05, 1, 0, 0};
  plugin.params = {force};
  plugin.metrics = {metric("force.peak", "", "force"), metric("force.mean", "force", "force"), metric("force.over_time", "", "")};
  host::Catalogue::Options nothing;
  nothing.use_environment = false;
  nothing.install_dir = "/nowhere";
  host::Catalogue out(nothing);
  out.add(plugin);
  return out;
}

std::string lesson(const QTemporaryDir& dir, const QByteArray& params,
                   const QByteArray& plugin = "org.example.lesson") {
  const QString path = dir.filePath("lesson.json");
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write(R"({"format": "swage-lesson/1", "id": "t", "title": "T", "objects": [], "lesson": {"plugin": ")" + plugin + R"(", "params": )" + params + "}}");
  return path.toStdString();
}

/// A catalogue with these has only what is added to it.
host::Catalogue::Options no_folders() {
  host::Catalogue::Options out;
  out.use_environment = false;
  out.install_dir = "/nowhere";
  return out;
}

TEST(LessonFacts, ForceBandIsReadWithUnits) {
  const QTemporaryDir dir;
  const auto band = force_band(lesson(dir, R"({"force": ["200 mN", "0.9 N"]})"), catalogue());
  ASSERT_TRUE(band);
  EXPECT_DOUBLE_EQ(band->low, 0.2);
  EXPECT_DOUBLE_EQ(band->high, 0.9);
}

TEST(LessonFacts, DefaultsCountAndFaultsGiveNothing) {
  const QTemporaryDir dir;
  const auto band = force_band(lesson(dir, "{}"), catalogue());
  ASSERT_TRUE(band);
  EXPECT_DOUBLE_EQ(band->high, 1);
  EXPECT_FALSE(force_band(lesson(dir, R"({"force": ["2 mm", "3 mm"]})"), catalogue()));
  EXPECT_FALSE(force_band(lesson(dir, "{}", "org.example.other"), catalogue()));
  EXPECT_FALSE(force_band(dir.filePath("none.json").toStdString(), catalogue()));
}

// a lesson with an upper force limit only
host::Catalogue limits() {
  const auto real = [](const char* id, const char* unit, double value) {
    host::Param p;
    p.type = SWAGE_PARAM_REAL;
    p.id = p.label = id;
    p.unit = p.display_unit = unit;
    p.max = 100;
    p.default_number = {value, 0, 0, 0};
    return p;
  };
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.limits";
  plugin.params = {real("max_force", "N", 1.5), real("tolerance", "m", 3e-4), real("max_tilt", "rad", 0)};
  plugin.criteria = {{"Hold it straight, to within {max_tilt}.", "max_tilt", SWAGE_CRITERION_PASS}};
  plugin.metrics = {metric("force.peak", "", "max_force"), metric("force.mean", "", ""),
                    metric("insert.entry_distance", "", "tolerance"), metric("time", "", "par_time"), metric("grasp.tilt", "", "max_tilt")};
  host::Catalogue::Options nothing;
  nothing.use_environment = false;
  nothing.install_dir = "/nowhere";
  host::Catalogue out(nothing);
  out.add(plugin);
  return out;
}

TEST(LessonFacts, PeakAndMeanForceHaveTargetsOfTheirOwn) {
  const QTemporaryDir dir;
  const std::string interval = lesson(dir, R"({"force": ["0.2 N", "0.9 N"]})");
  EXPECT_EQ(metric_target(interval, "force.peak", catalogue()), (MetricTarget{{}, 0.9}));
  EXPECT_EQ(metric_target(interval, "force.mean", catalogue()), (MetricTarget{0.2, 0.9}));
  EXPECT_EQ(metric_target(interval, "force.over_time", catalogue()), MetricTarget{});
  const std::string limit = lesson(dir, "{}", "org.example.limits");
  const auto band = force_band(limit, limits());
  ASSERT_TRUE(band);
  EXPECT_DOUBLE_EQ(band->low, 0);
  EXPECT_DOUBLE_EQ(band->high, 1.5);
  EXPECT_EQ(metric_target(limit, "force.peak", limits()), (MetricTarget{{}, 1.5}));
  EXPECT_EQ(metric_target(limit, "force.mean", limits()), MetricTarget{});
  EXPECT_EQ(metric_target(limit, "insert.entry_distance", limits()), (MetricTarget{{}, 3e-4}));
  EXPECT_EQ(metric_target(limit, "time", limits()), MetricTarget{});
  EXPECT_EQ(metric_targets(limit, limits()), (std::map<std::string, MetricTarget>{{"force.peak", {{}, 1.5}}, {"insert.entry_distance", {{}, 3e-4}}}));
  // the tilt of 0 stands for any: its criterion is off, and nothing is asked
  EXPECT_EQ(metric_target(limit, "grasp.tilt", limits()), MetricTarget{});
  EXPECT_EQ(metric_target(lesson(dir, R"({"max_tilt": "0.5 rad"})", "org.example.limits"), "grasp.tilt", limits()), (MetricTarget{{}, 0.5}));
}

// A knot that the program pulls: told before the attempt, drawn as a limit, and open to limits of one's own.
TEST(LessonFacts, ThePullOfAKnotIsAsked) {
  const QTemporaryDir dir;
  const std::string none = lesson(dir, "{}", "org.example.limits"), file = dir.filePath("pulled.json").toStdString();
  EXPECT_FALSE(metric_targets(none, limits()).contains("knot.bears"));
  std::ifstream in(none);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto with = [&](const std::string& pull) {
    std::ofstream(file) << "{\"pull\": " << pull << ", " << text.substr(text.find('{') + 1);
    return read_criteria(file, limits()).points;
  };
  EXPECT_EQ(with(R"({"load": "0.1 N"})").last(), QStringLiteral("At the end the program pulls a copy of the knot, up to 100%1mN, and tells what it bears.").arg(QChar(0x202f)));
  EXPECT_TRUE(with(R"({"load": "0.1 N", "points": 30})").last().endsWith("costs up to 30 points."));
  EXPECT_EQ(metric_target(file, "knot.bears", limits()), (MetricTarget{0.1, {}}));
  EXPECT_EQ(lesson_metrics(file, limits()).size(), lesson_metrics(none, limits()).size() + 3);
}

// Criteria contain the lesson's own values.
TEST(LessonFacts, CriteriaAreSentencesWithTheValuesOfTheLesson) {
  host::Param time, carry, task;
  time.type = SWAGE_PARAM_REAL;
  time.id = time.label = "hold_time";
  time.unit = time.display_unit = "s";
  time.max = 100;
  time.default_number = {3, 0, 0, 0};
  carry.type = SWAGE_PARAM_BOOL;
  carry.id = carry.label = "carry";
  task.type = SWAGE_PARAM_CHOICE;
  task.id = task.label = "task";
  task.choices = {"insert", "stitch"};
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.asks";
  plugin.params = {time, carry, task};
  plugin.criteria = {{"Hold it for {hold_time}.", "", SWAGE_CRITERION_PASS},
                     {"Carry it.", "carry", SWAGE_CRITERION_PASS},
                     {"Stay.", "!carry", SWAGE_CRITERION_LIMIT},
                     {"Sew.", "task=stitch", SWAGE_CRITERION_PASS},
                     {"A thread that breaks ends the attempt.", "", SWAGE_CRITERION_ENDS},
                     {"Slowness costs points.", "", SWAGE_CRITERION_POINTS}};
  host::Catalogue all(no_folders());
  all.add(plugin);
  const QTemporaryDir dir;
  const Criteria usual = read_criteria(lesson(dir, "{}", "org.example.asks"), all);
  EXPECT_EQ(usual.pass, QStringList({QStringLiteral("Hold it for 3%1s.").arg(QChar(0x202f))}));
  EXPECT_EQ(usual.limits, QStringList({"Stay."}));
  EXPECT_EQ(usual.ends, QStringList({"A thread that breaks ends the attempt."})) << "in practice as well";
  EXPECT_EQ(usual.points, QStringList({"Slowness costs points."}));
  EXPECT_FALSE(usual.show);
  const Criteria sews = read_criteria(
      lesson(dir, R"({"hold_time": "1.5 s", "carry": true, "task": "stitch"})", "org.example.asks"), all);
  EXPECT_EQ(sews.pass.size(), 3);
  EXPECT_TRUE(sews.limits.isEmpty());
  EXPECT_TRUE(read_criteria(dir.filePath("none.json").toStdString(), all).pass.isEmpty());
}

// The criterion of 130 read "at least 0.0001 N".
TEST(LessonFacts, SmallForcesAreWrittenInMillinewtons) {
  host::Param draw;
  draw.type = SWAGE_PARAM_REAL;
  draw.id = draw.label = "draw";
  draw.unit = draw.display_unit = "N";
  draw.max = 1e5;
  draw.default_number = {1e-4, 0, 0, 0};
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.draws";
  plugin.params = {draw};
  plugin.criteria = {{"At least {draw}.", "", SWAGE_CRITERION_PASS}};
  host::Catalogue all(no_folders());
  all.add(plugin);
  const QTemporaryDir dir;
  const auto said = [&](const char* params) { return read_criteria(lesson(dir, params, "org.example.draws"), all).pass; };
  EXPECT_EQ(said("{}"), QStringList({QStringLiteral("At least 0.1%1mN.").arg(QChar(0x202f))}));
  EXPECT_EQ(said(R"({"draw": "0.02 N"})"), QStringList({QStringLiteral("At least 20%1mN.").arg(QChar(0x202f))}));
  EXPECT_EQ(said(R"({"draw": "0 N"})"), QStringList({QStringLiteral("At least 0%1N.").arg(QChar(0x202f))}));
  EXPECT_EQ(said(R"({"draw": "36000 N"})"), QStringList({QStringLiteral("At least 36000%1N.").arg(QChar(0x202f))})) << "and not 3.6E+04";
}

// A sentence on a text parameter applies if the text is set; 055's criterion on posts was missing.
TEST(LessonFacts, ASentenceAboutATextHoldsWhereThereIsOne) {
  host::Param posts;
  posts.type = SWAGE_PARAM_TEXT;
  posts.id = posts.label = "posts";
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.posts";
  plugin.params = {posts};
  plugin.criteria = {{"Over {posts}.", "posts", SWAGE_CRITERION_PASS}, {"Off the wire.", "!posts", SWAGE_CRITERION_PASS}};
  host::Catalogue all(no_folders());
  all.add(plugin);
  const QTemporaryDir dir;
  EXPECT_EQ(read_criteria(lesson(dir, "{}", "org.example.posts"), all).pass, QStringList({"Off the wire."}));
  EXPECT_EQ(read_criteria(lesson(dir, R"({"posts": "post_1"})", "org.example.posts"), all).pass, QStringList({"Over post 1."}));
}

TEST(LessonFacts, NamesOfObjectsAreSaidInTheLanguageOfTheWindow) {
  host::Param things;
  things.type = SWAGE_PARAM_TEXT;
  things.id = things.label = "things";
  things.default_text = "ball_small, long_rod";
  host::PluginInfo plugin;
  plugin.kind = SWAGE_KIND_LESSON;
  plugin.id = "org.example.names";
  plugin.params = {things};
  plugin.criteria = {{"Hold {things}.", "", SWAGE_CRITERION_PASS}};
  host::Catalogue all(no_folders());
  all.add(plugin);
  const QTemporaryDir dir;
  const std::string path = lesson(dir, "{}", "org.example.names");
  EXPECT_EQ(read_criteria(path, all).pass, QStringList({"Hold ball small, long rod."}));
  QFile words(dir.filePath("words.de.json"));
  ASSERT_TRUE(words.open(QIODevice::WriteOnly));
  words.write(R"({"format": "swage-words/1", "language": "de", "words": {"ball_small": "Kleine Kugel"}})");
  words.close();
  set_words_language(QStringLiteral("de"));
  learn_words(dir.path());
  EXPECT_EQ(read_criteria(path, all).pass, QStringList({"Hold Kleine Kugel, long rod."}));
  set_words_language(QStringLiteral("en"));
}

}  // namespace
}  // namespace swage::console
