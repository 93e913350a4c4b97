// SPDX-License-Identifier: Apache-2.0
//
// Files of the user's own lessons: their names, and what an edit changes and keeps.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "console/models/variant.hpp"

namespace swage::console {
namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(Variants, ATitleMakesAName) {
  EXPECT_EQ(slug("Stiff wall, 2/8"), "stiff_wall_2_8");
  EXPECT_EQ(slug("  Schräge Fläche "), "schrage_flache");
  EXPECT_EQ(slug("..//"), "lesson") << "no way out of the folder";
}

TEST(Variants, NameTheirBaseFromWhereTheyAre) {
  const Variant v{"/a/b/base.json", " Mine ", "", "", {{"needle.size", "\"4 mm\""}}};
  EXPECT_TRUE(variant_text(v, "/a/b").contains("\"based_on\": \"base.json\""));
  EXPECT_TRUE(variant_text(v, "/a").contains("\"based_on\": \"b/base.json\""));
  EXPECT_TRUE(variant_text(v, "/c").contains("\"based_on\": \"/a/b/base.json\""));
  EXPECT_TRUE(variant_text(v, "/c").contains("\"title\": \"Mine\""));
}

TEST(Variants, AreNotWrittenOverOneAnother) {
  QTemporaryDir dir;
  const Saved first = save_variant({"/a/base.json", "Mine", "", "", {}}, dir.filePath("lessons"));
  ASSERT_EQ(first.problem, "");
  const QByteArray text = read(first.path);
  EXPECT_FALSE(text.isEmpty());
  const Saved second = save_variant({"/b/base.json", "Mine", "", "", {}}, dir.filePath("lessons"));
  EXPECT_TRUE(second.path.isEmpty());
  EXPECT_TRUE(second.problem.contains("already"));
  EXPECT_EQ(read(first.path), text);
  EXPECT_FALSE(save_variant({"/a/base.json", "  ", "", "", {}}, dir.path()).problem.isEmpty());
  EXPECT_FALSE(save_variant({"/a/base.json", "Mine", "", "", {}}, "/proc/no/such").problem.isEmpty());
}

TEST(OwnLessons, AreThoseInTheirFolder) {
  QTemporaryDir dir;
  const QString own = dir.filePath("own");
  const Saved mine = save_variant({"/a/base.json", "Mine", "", "", {}}, own);
  EXPECT_TRUE(is_own_lesson(mine.path, own));
  EXPECT_FALSE(is_own_lesson(own + "/../other.json", own));
  EXPECT_FALSE(is_own_lesson("/a/base.json", own));
  EXPECT_FALSE(is_own_lesson(mine.path, dir.filePath("none")));
}

TEST(OwnLessons, AreEditedInPlaceAndKeepTheirIdAndAllElse) {
  QTemporaryDir dir;
  const QString path = dir.filePath("mine.json");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({ "format": "swage-lesson/1", "based_on": "b.json", "id": "own.mine", "title": "Mine", "author": "A. B.",
    "set": { "needle.size": "4 mm", "tissue.thickness": "2 mm" } })");
  file.close();
  ASSERT_EQ(update_variant(path, {"", " Yours ", "Task", "", {{"needle.size", "\"3 mm\""}}}), "");
  const auto json = nlohmann::json::parse(read(path).toStdString());
  EXPECT_EQ(json["title"], "Yours");
  EXPECT_EQ(json["summary"], "Task");
  EXPECT_FALSE(json.contains("goal"));
  EXPECT_EQ(json["id"], "own.mine");
  EXPECT_EQ(json["author"], "A. B.");
  EXPECT_EQ(json["set"]["needle.size"], "3 mm");
  EXPECT_EQ(json["set"]["tissue.thickness"], "2 mm");
  EXPECT_NE(update_variant(path, {"", "  ", "", "", {}}), "");
  EXPECT_NE(update_variant(dir.filePath("none.json"), {"", "T", "", "", {}}), "");
  QFile broken(dir.filePath("broken.json"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("{ \"set\": 3 }");
  broken.close();
  EXPECT_NE(update_variant(broken.fileName(), {"", "T", "", "", {}}), "");
  EXPECT_EQ(read(broken.fileName()), "{ \"set\": 3 }") << "what cannot be edited stays as it was";
}

TEST(OwnLessons, PartsAreEditedInPlace) {
  QTemporaryDir dir;
  const auto write = [&](const char* text) {
    QFile file(dir.filePath("mine.json"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  };
  const auto json = [&] { return nlohmann::json::parse(read(dir.filePath("mine.json")).toStdString()); };
  Variant changed{"", "Mine", "", "", {}};
  changed.remove = {"tray", "ring"};
  changed.add["objects"] = {{{"name", "pad"}, {"plugin", "x"}}};
  // a part of the file itself, and one of the base
  QString path = write(R"({ "format": "swage-lesson/1", "based_on": "b.json", "id": "own.mine", "title": "Mine",
    "add": { "objects": [ { "name": "ring", "plugin": "x" } ] }, "set": { "ring.size": 1, "needle.size": 2 } })");
  ASSERT_EQ(update_variant(path, changed), "");
  EXPECT_EQ(json()["remove"], nlohmann::json({"tray"}));
  EXPECT_EQ(json()["add"]["objects"].size(), 1u);
  EXPECT_EQ(json()["add"]["objects"][0]["name"], "pad");
  EXPECT_EQ(json()["set"], nlohmann::json({{"needle.size", 2}})) << "values go with their part";
  // a lesson without a base
  path = write(R"({ "format": "swage-lesson/1", "id": "own.mine", "title": "Mine",
    "objects": [ { "name": "tray", "plugin": "x" }, { "name": "ring", "plugin": "x" }, { "name": "needle", "plugin": "x" } ] })");
  changed.set = {{"needle.size", "3"}};
  ASSERT_EQ(update_variant(path, changed), "");
  EXPECT_EQ(json()["objects"].size(), 2u);
  EXPECT_EQ(json()["objects"][0]["params"]["size"], 3);
  EXPECT_EQ(json()["objects"][1]["name"], "pad");
  EXPECT_FALSE(json().contains("add") || json().contains("remove") || json().contains("set"));
  changed.remove = {"nobody"};
  EXPECT_NE(update_variant(path, changed), "");
}

}  // namespace
}  // namespace swage::console
