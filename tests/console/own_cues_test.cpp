// SPDX-License-Identifier: Apache-2.0
//
// Cues of a lesson plugin that no theme has: their style comes from their role, their name from the plugin's translations.
#include "console/models/own_cues.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QSet>
#include <QTemporaryDir>

#include "colour_vision.hpp"
#include "console/cues/tones.hpp"
#include "console/models/said.hpp"

namespace swage::console {
namespace {

const QStringList kRoleNames = {"good", "warning", "bad", "target"};
constexpr uint32_t kSeenOnly = SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE;
constexpr uint32_t kAllOfIt = kSeenOnly | SWAGE_CHANNEL_SOUND | SWAGE_CHANNEL_FORCE;

host::PluginInfo lamp(const std::string& folder = "/nowhere") {
  host::PluginInfo plugin;
  plugin.bundle_dir = folder;
  plugin.cues = {{"lamp.lit", "It is lit.", kAllOfIt, SWAGE_CUE_GOOD},
                 {"lamp.dims", "It is nearly out.", kAllOfIt, SWAGE_CUE_WARNING},
                 {"lamp.gone_out", "It is out.", kSeenOnly, SWAGE_CUE_BAD},
                 {"lamp.socket", "It belongs here.", kAllOfIt, SWAGE_CUE_TARGET},
                 {"lamp.swings", "It swings.", kAllOfIt, SWAGE_CUE_NEUTRAL}};
  return plugin;
}

QVector<CueTheme> all_themes() {
  QVector<CueTheme> out;
  for (const QString& id : CueTheme::stock()) out << CueTheme::stock(id) << CueTheme::stock(id).on_dark();
  return out;
}

TEST(OwnCues, AreToldApartByShapeAndByColourInEachTheme) {
  for (const CueTheme& theme : all_themes()) {
    const CueTheme all = theme.with(own_cues({lamp()}));
    QSet<QString> shapes;
    QSet<QRgb> colours;
    for (const host::CueInfo& cue : lamp().cues) {
      const CueStyle style = all.style(QString::fromStdString(cue.id));
      shapes += style.shape;
      colours += style.colour.rgb();
      EXPECT_TRUE(all.meanings().contains(QString::fromStdString(cue.id))) << cue.id << " is not in the help";
    }
    EXPECT_EQ(shapes.size(), 5) << theme.id().toStdString();
    EXPECT_EQ(colours.size(), 5) << theme.id().toStdString();
    QStringList roles = theme.roles(), expected = kRoleNames;
    roles.sort(), expected.sort();
    EXPECT_EQ(roles, expected) << theme.id().toStdString();
  }
}

TEST(OwnCues, AreSafeInEveryVisionAndSeenOnDark) {
  for (const CueTheme& theme : {CueTheme::stock("safe"), CueTheme::stock("safe").on_dark()})
    for (const test::Vision v : {test::Vision::kUsual, test::Vision::kRedBlind, test::Vision::kGreenBlind, test::Vision::kBlueBlind})
      for (int i = 0; i < kRoleNames.size(); ++i)
        for (int k = 0; k < i; ++k)
          EXPECT_GE(test::difference(theme.role(kRoleNames[i]).colour, theme.role(kRoleNames[k]).colour, v), 20)
              << kRoleNames[i].toStdString() << " " << kRoleNames[k].toStdString();
  // roles use colours of cues whose contrast on dark is tested with the themes
  const CueTheme dark = CueTheme::stock("safe").on_dark();
  EXPECT_EQ(dark.role("good").colour, dark.style("target.near").colour);
  EXPECT_EQ(dark.role("warning").colour, dark.style("loop.too_many").colour);
  EXPECT_EQ(dark.role("bad").colour, dark.style("target.left").colour);
  EXPECT_EQ(dark.role("target").colour, dark.style("target.point").colour);
}

TEST(OwnCues, HaveTheColourOfADarkWindowWhicheverComesFirst) {
  const QVector<OwnCue> cues = own_cues({lamp()});
  const CueTheme safe = CueTheme::stock("safe");
  EXPECT_EQ(safe.with(cues).on_dark().style("lamp.lit").colour, safe.on_dark().with(cues).style("lamp.lit").colour);
  EXPECT_NE(safe.with(cues).on_dark().style("lamp.lit").colour, safe.with(cues).style("lamp.lit").colour);
}

TEST(OwnCues, AreHeardAndFeltAsTheirRowsSay) {
  for (const CueTheme& theme : all_themes()) {
    const CueTheme all = theme.with(own_cues({lamp()}));
    EXPECT_EQ(all.style("lamp.lit").sound, theme.style("target.near").sound);
    EXPECT_FALSE(tone(all.style("lamp.dims").sound).empty());
    EXPECT_NE(all.style("lamp.dims").sound, all.style("lamp.lit").sound);
    EXPECT_GT(all.style("lamp.lit").force.pulses, 0);
    EXPECT_EQ(theme.role("bad").sound, theme.style("target.left").sound);
    EXPECT_GT(theme.role("bad").force.pulses, 0);
    EXPECT_TRUE(all.style("lamp.gone_out").sound.isEmpty()) << "its row has no sound";
    EXPECT_EQ(all.style("lamp.gone_out").force.pulses, 0) << "nor a force";
    EXPECT_TRUE(all.style("lamp.socket").sound.isEmpty()) << "a place is silent";
    EXPECT_TRUE(all.style("lamp.swings").sound.isEmpty()) << "a neutral cue is silent";
  }
}

TEST(OwnCues, AThemeKeepsItsLookOfWhatItKnowsAndTheFirstRowStays) {
  host::PluginInfo other = lamp();
  other.cues = {{"grasp.good", "Another thing.", kAllOfIt, SWAGE_CUE_BAD}, {"lamp.lit", "Another lamp.", kAllOfIt, SWAGE_CUE_BAD}};
  for (const CueTheme& theme : all_themes()) {
    const CueTheme all = theme.with(own_cues({lamp(), other}));
    EXPECT_EQ(all.style("grasp.good").colour, theme.style("grasp.good").colour);
    EXPECT_EQ(all.style("grasp.good").text, theme.style("grasp.good").text);
    EXPECT_EQ(all.style("lamp.lit").colour, theme.role("good").colour);
    EXPECT_EQ(all.meanings().count("lamp.lit"), 1);
  }
}

TEST(OwnCues, AreCalledByTheWordsOfTheirPlugin) {
  QTemporaryDir dir;
  QFile file(dir.filePath("words.de.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "swage-words/1", "language": "de", "words": {"lamp.lit": "Lampe brennt"}})");
  file.close();
  set_words_language(QStringLiteral("de"));
  learn_words(dir.path());
  const CueTheme all = CueTheme::stock("safe").with(own_cues({lamp(dir.path().toStdString())}));
  EXPECT_EQ(all.style("lamp.lit").text, "Lampe brennt");
  EXPECT_EQ(all.style("lamp.gone_out").text, "Lamp gone out") << "nobody has given it a name";
  EXPECT_EQ(all.style("lamp.swings").text, "Lamp swings");
  set_words_language(QStringLiteral("en"));
}

TEST(OwnCues, AFaultyRoleOfAThemeIsTold) {
  QTemporaryDir dir;
  const QString path = dir.filePath("roles.json");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "swage-cue-theme/1", "cues": [], "roles": [{"role": "good", "colour": "#123456", "shape": "O", "sound": "trumpet"}]})");
  file.close();
  QString error;
  EXPECT_TRUE(CueTheme::load(path, &error).roles().isEmpty());
  EXPECT_TRUE(error.contains("good") && error.contains("trumpet")) << error.toStdString();
}

}  // namespace
}  // namespace swage::console
