// SPDX-License-Identifier: Apache-2.0
//
// A lesson that is exported and imported is unchanged; a file that is no lesson is refused with file, line and reason.
#include "console/models/lesson_files.hpp"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "assembly/lesson_text.hpp"
#include "assembly/sentences.hpp"

namespace swage::console {
namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class LessonFiles : public ::testing::Test {
 protected:
  LessonFiles() {
    host::PluginInfo hand;
    hand.kind = SWAGE_KIND_DEVICE, hand.id = "x.hand";
    hand.params.push_back({});
    hand.params[0].type = SWAGE_PARAM_FILE, hand.params[0].id = "file";
    catalogue.add(hand);
    QDir(dir.path()).mkpath("series");
    QDir(dir.path()).mkpath("hands");
    write("hands/a.hand", "hand");
    write("series/base.json", R"({ "format": "swage-lesson/1", "id": "base", "title": "Base",
      "devices": [ { "name": "hand", "plugin": "x.hand", "params": { "file": "../hands/a.hand" } } ],
      "objects": [ { "name": "needle", "plugin": "x.needle" } ], "lesson": { "plugin": "x.lesson" } })");
    write("own.json", R"({ "format": "swage-lesson/1", "id": "own.mine", "title": "Mine", "based_on": "series/base.json",
      "set": { "needle.size": 3 } })");
  }
  QString write(const QString& name, const QByteArray& text) {
    QFile file(dir.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  Imported import(const QString& file) {
    const auto build = [this](const QString& path, base::Problems& problems) -> std::unique_ptr<snapshot::SceneCard> {
      built = read(path);
      if (fault.empty()) return std::make_unique<snapshot::SceneCard>();
      problems.push_back({base::Severity::kError, path.toStdString() + fault, "The lesson has no object \"tray\"."});
      return nullptr;
    };
    return import_lesson(file, {dir.filePath("other/lessons"), dir.filePath("other/drafts/import.json"), {dir.filePath("series")}}, catalogue, build);
  }

  QTemporaryDir dir;
  host::Catalogue catalogue;
  QByteArray built;
  std::string fault;
};

TEST_F(LessonFiles, GoToAnotherStationWhole) {
  const QString file = dir.filePath("mine.swage.json");
  ASSERT_EQ(export_lesson(dir.filePath("own.json"), file), "");
  const auto out = nlohmann::json::parse(read(file).toStdString());
  EXPECT_FALSE(out.contains("based_on")) << "the other station need not have what it is based on";
  EXPECT_EQ(out["id"], "own.mine");
  EXPECT_EQ(out["objects"][0]["params"]["size"], 3);
  const Imported in = import(file);
  ASSERT_EQ(in.problem, "");
  EXPECT_EQ(in.path, dir.filePath("other/lessons/mine.json"));
  const auto taken = nlohmann::json::parse(read(in.path).toStdString());
  EXPECT_EQ(taken["devices"][0]["params"]["file"], QDir(dir.path()).canonicalPath().toStdString() + "/hands/a.hand")
      << "found where the lessons of this station have it";
  EXPECT_FALSE(QFile::exists(dir.filePath("other/drafts/import.json")));
  EXPECT_TRUE(import(file).problem.contains("already")) << "no other is written over";
}

TEST_F(LessonFiles, ALessonAsItIsWrittenStaysSoByteForByte) {
  const QString file = dir.filePath("base_out.json");
  ASSERT_EQ(export_lesson(dir.filePath("series/base.json"), file), "");
  EXPECT_EQ(read(file), read(dir.filePath("series/base.json")));
  EXPECT_NE(export_lesson(dir.filePath("none.json"), file), "");
  EXPECT_NE(export_lesson(dir.filePath("series/base.json"), "/proc/no/such.json"), "");
}

TEST_F(LessonFiles, AFaultyFileIsRefusedWithFileLineAndReason) {
  EXPECT_EQ(import(write("cut.json", "{ \"format\": \"swage-lesson/1\",\n \"id\": ")).problem,
            QString::fromStdString("cut.json, line 2: " + assembly::say::kNotJson(8)));
  const QString file = write("tray.json", "{ \"format\": \"swage-lesson/1\",\n \"id\": \"t\", \"title\": \"T\",\n \"objects\": [], \"lesson\": { \"plugin\": \"x.lesson\" } }");
  fault = ":3 #/objects";
  EXPECT_EQ(import(file).problem, "tray.json, line 3: The lesson has no object \"tray\".");
  EXPECT_EQ(QDir(dir.filePath("other/lessons")).entryList(QDir::Files), QStringList()) << "nothing was written";
}

// The merged text of a derived lesson has other lines than its file.
TEST_F(LessonFiles, AFaultIsToldAtTheLineOfTheFileThatIsImported) {
  const QString file = write("based.json", R"({ "format": "swage-lesson/1", "id": "own.b", "title": "B",
 "based_on": "series/base.json",
 "set": { "needle.size": 3 } })");
  const auto import_with = [&](const std::string& there) {
    const auto build = [&](const QString& path, base::Problems& problems) -> std::unique_ptr<snapshot::SceneCard> {
      problems.push_back({base::Severity::kError, path.toStdString() + (path == file ? there : ":220 #/set"), "No such size."});
      return nullptr;
    };
    return import_lesson(file, {dir.filePath("o/lessons"), dir.filePath("o/drafts/import.json"), {dir.filePath("series")}}, catalogue, build)
        .problem;
  };
  EXPECT_EQ(import_with(":3 #/set"), "based.json, line 3: No such size.");
  EXPECT_EQ(import_with(""), "based.json: No such size.") << "no line rather than a wrong one";
}

}  // namespace
}  // namespace swage::console
