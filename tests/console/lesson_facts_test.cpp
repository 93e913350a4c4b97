// SPDX-License-Identifier: Apache-2.0
#include "console/models/lesson_facts.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace swage::console {
namespace {

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
  file.write(R"({"lesson": {"plugin": ")" + plugin + R"(", "params": )" + params + "}}");
  return path.toStdString();
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

}  // namespace
}  // namespace swage::console
