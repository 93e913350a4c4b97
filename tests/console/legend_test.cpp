// SPDX-License-Identifier: Apache-2.0
//
// The legend of each lesson of the series fits into the smallest window, in each language.
#include <QTableView>
#include <filesystem>

#include "console/app/language.hpp"
#include "console/models/reading.hpp"
#include "console/widgets/cue_legend.hpp"
#include "session/rehearsal.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

namespace fs = std::filesystem;

struct Cues {
  std::string lesson;
  QStringList meanings;
};

const std::vector<Cues>& cues_of_all() {
  static const std::vector<Cues> all = [] {
    std::vector<Cues> out;
    for (const auto& file : fs::directory_iterator(SWAGE_SOURCE_DIR "/lessons/series")) {
      if (file.path().extension() != ".json") continue;
      session::Options options;
      options.lesson_path = file.path().string();
      options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
      options.store_path = ":none:";
      base::Problems problems;
      const auto expert = session::Rehearsal::open(options, "expert", problems);
      EXPECT_NE(expert, nullptr) << options.lesson_path << (problems.empty() ? "" : ": " + problems.front().message);
      if (expert) out.push_back({file.path().stem().string(), console::Reader::meanings(expert->card())});
    }
    return out;
  }();
  return all;
}

class Legends : public WindowTest, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(console::use_language(QString::fromLatin1(GetParam()))); }
  console::Pages* pages() { return window->findChild<console::Pages*>(); }
  void TearDown() override {
    window.reset();
    console::use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }
};

TEST_P(Legends, HaveRoomForTheWordsOfEachLesson) {
  attempts = sample_attempts();
  open();
  window->resize(1280, 800);
  for (const char* page_name : {"run", "review"}) {
    if (page_name == std::string("review")) {
      click("page_people");
      window->people_page()->select_person("Arun P.");
      auto* table = child<QTableView>("attempts");
      table->selectRow(0);
      QTest::keyClick(table, Qt::Key_Return);
      ASSERT_TRUE(eventually([&] { return window->review_page()->player() != nullptr; }));
    }
    auto* legend = pages()->current().widget->findChild<console::CueLegend*>();
    ASSERT_TRUE(eventually([&] { return legend->isVisible() && legend->width() > 200; }));
    for (const Cues& of : cues_of_all()) {
      legend->set_meanings(of.meanings);
      constexpr int kLaidOut_ms = 500;
      EXPECT_TRUE(QTest::qWaitFor([&] { return legend->cut_words().isEmpty(); }, kLaidOut_ms))
          << legend->cut_words().join("; ").toStdString() << " on " << page_name << ": " << of.lesson << " in " << legend->width() << " px";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Legends, testing::Values("en", "de"), [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace swage::test
