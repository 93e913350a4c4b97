// SPDX-License-Identifier: Apache-2.0
//
// What the host says to a person, in German: every sentence of its catalogues that reaches the console is translated.
#include <QFile>
#include <QRegularExpression>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "base/solver_health.hpp"
#include "console/models/said.hpp"
#include "console/models/sentence_words.hpp"
#include "host/units.hpp"
#include "session/sentences.hpp"
#include "test_places.hpp"

namespace swage::test {
namespace {

struct Sentence {
  QString section, name;
  std::string text;
};

// The constants of a catalogue, each with the comment above its group.
std::vector<Sentence> catalogue(const QString& folder) {
  QFile file(QStringLiteral(SWAGE_SOURCE_DIR "/") + folder + QStringLiteral("/sentences.hpp"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QString source = QString::fromUtf8(file.readAll());
  static const QRegularExpression kLine(QStringLiteral(R"re(^// (.+)$|constexpr auto (k\w+) =\s*((?:"(?:[^"\\]|\\.)*"\s*)+)_sentence)re"),
                                        QRegularExpression::MultilineOption);
  static const QRegularExpression kLetters(QStringLiteral(R"re("((?:[^"\\]|\\.)*)")re")), kCode(QStringLiteral(R"re(\\u([0-9a-f]{4}))re"));
  std::vector<Sentence> out;
  QString section;
  for (auto it = kLine.globalMatch(source); it.hasNext();) {
    const auto match = it.next();
    if (match.captured(2).isEmpty()) {
      section = match.captured(1);
      continue;
    }
    QString text;
    for (auto part = kLetters.globalMatch(match.captured(3)); part.hasNext();) text += part.next().captured(1);
    for (auto code = kCode.match(text); code.hasMatch(); code = kCode.match(text)) text.replace(code.capturedStart(), 6, QChar(code.captured(1).toInt(nullptr, 16)));
    text.replace(QStringLiteral("\\\""), QStringLiteral("\""));
    out.push_back({section, match.captured(2), text.toStdString()});
  }
  return out;
}

// With values that no language has.
std::string filled(std::string text) {
  int n = 0;
  for (std::size_t at = text.find("{}"); at != text.npos; at = text.find("{}")) text.replace(at, 2, "Qx" + std::to_string(n++));
  return text;
}

// What only people see who write plugins or use the command line stays English.
const std::set<QString> kOfAuthors = {
    "a table of parameters", "any declaration", "bodies, particles and hinges", "shapes", "descriptors of a library", "files of rating scales",
    "end of a plugin's test", "findings of the tests of a plugin", "marks of a lesson"};
const std::set<QString> kOfTheCommandLine = {"kNotBackedUp", "kNotRestored", "kNothingLeft", "kServerNotSalvaged", "kThereAlready", "kNoHome",
                                             "kNeedsNovice", "kSchoolNeedsLesson", "kSchoolNeedsPeople", "kSyntheticAlready"};
// signs and values alone
const std::set<QString> kWithoutWords = {"kBadFile", "kUnits"};

class HostSentences : public ::testing::Test {
 protected:
  void SetUp() override { console::set_words_language(QStringLiteral("de")); }
  void TearDown() override { console::set_words_language(QStringLiteral("en")); }
};

TEST_F(HostSentences, EachThatReachesAPersonIsGerman) {
  EXPECT_TRUE(console::problems_of_words().empty()) << console::problems_of_words().front().message;
  int seen = 0;
  for (const char* room : {"session", "step", "toolkit", "host", "assembly", "record"}) {
    const std::vector<Sentence> all = catalogue(QStringLiteral("framework/") + QString::fromLatin1(room));
    EXPECT_FALSE(all.empty()) << room;
    for (const Sentence& s : all) {
      if (kOfAuthors.contains(s.section) || kOfTheCommandLine.contains(s.name) || kWithoutWords.contains(s.name)) continue;
      ++seen;
      const std::string message = filled(s.text);
      const QString german = console::said_message(message);
      EXPECT_NE(german.toStdString(), message) << room << " " << s.name.toStdString() << ": no German in console/translations/words_host.de.json";
      for (int i = 0; message.find("Qx" + std::to_string(i)) != message.npos; ++i)
        EXPECT_TRUE(german.contains(QStringLiteral("Qx%1").arg(i))) << s.name.toStdString() << ": " << german.toStdString();
    }
  }
  EXPECT_GT(seen, 250);
  for (const auto& field : base::kSolverHealthFields) EXPECT_NE(console::said(std::string(field.doc)).toStdString(), field.doc);
  for (const char* dimension : {"a length", "a force", "an angle"}) EXPECT_NE(console::said(std::string(dimension)).toStdString(), dimension);
}

TEST_F(HostSentences, ValuesStayAndSentencesInThemAreTranslated) {
  EXPECT_EQ(console::said_message(session::say::kNoHand("left hand")), "Diese Lektion hat keine Hand namens \"left hand\".");
  const std::string live = session::say::kNotLive("needle.arc", "swage.object.needle", session::say::kLiveAre("wire"));
  EXPECT_EQ(console::said_message(live), "\"needle.arc\" von swage.object.needle kann sich nicht ändern, während die Szene läuft. Was es kann: wire.");
  // one after the other, and what nobody has translated
  EXPECT_EQ(console::said_message(session::say::kNoKnot() + " Ask Ada."), "Hier ist kein Knoten, der sich sicher lesen lässt: nichts wird gezogen. Ask Ada.");
  EXPECT_EQ(console::said_message("Ask Ada. Or Bob."), "Ask Ada. Or Bob.");
  EXPECT_EQ(console::said_message(""), "");
  // a name that is a word of the host's too stays as it is
  EXPECT_EQ(console::said_message(session::say::kNoHand("environment")), "Diese Lektion hat keine Hand namens \"environment\".");
}

TEST_F(HostSentences, EnglishStaysAsItIsWritten) {
  console::set_words_language(QStringLiteral("en"));
  EXPECT_EQ(console::said_message(session::say::kNoKnot()).toStdString(), session::say::kNoKnot());
}

TEST(SentenceWordsTest, OfSeveralThatFitTheOneWithMostLettersIsUsed) {
  const host::Words words = {{"{} is there.", "{} ist da."}, {"The {} is there.", "Das {} ist da."}, {"{}: {}; {}.", "{} - {} / {}!"}};
  const console::SentenceWords german(words);
  EXPECT_EQ(german.of("The cat is there."), "Das cat ist da.");
  EXPECT_EQ(german.of("Max is there."), "Max ist da.");
  EXPECT_EQ(german.of("a: b: c; d; e."), "a - b: c / d; e!");
  EXPECT_EQ(german.of("Nobody is here"), "");
}

}  // namespace
}  // namespace swage::test
