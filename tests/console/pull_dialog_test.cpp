// SPDX-License-Identifier: Apache-2.0
//
// "Pull the knot" on the Review page, by keys and clicks.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "console/app/language.hpp"
#include "console/link/run_control.hpp"
#include "console/pages/pull_dialog.hpp"
#include "console/view3d/scene_view.hpp"
#include "console/widgets/parts.hpp"
#include "session/sentences.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class PullPages : public WindowTest {
 protected:
  void open_review() {
    with_knot = true;
    attempts = sample_attempts();
    open();
    click("page_people");
    window->people_page()->select_person("Arun P.");
    window->people_page()->person()->focus_attempts();
    auto* table = child<QTableView>("attempts");
    table->selectRow(0);
    QTest::keyClick(table, Qt::Key_Return);
    ASSERT_TRUE(review()->isVisible());
    ASSERT_TRUE(at_rest());
  }
  console::ReviewPage* review() { return window->review_page(); }
  bool at_rest() {
    return eventually([&] { return !review()->moving(); });
  }
  /// Presses K over the traces and does `what` once the pull is over; true when the dialog has come.
  template <class Do>
  bool pull_by_key(Do what) {
    bool came = false;
    in_dialog("pull_dialog", [&](QDialog* dialog) {
      auto* pulls = qobject_cast<console::PullDialog*>(dialog);
      came = pulls != nullptr && eventually([&] { return !pulls->pulling(); });
      if (came) what(*pulls);
      dialog->reject();
    });
    QTest::keyClick(review()->timeline(), Qt::Key_K);
    return came;
  }
  static QString words(const QDialog& dialog, const char* name) { return dialog.findChild<QLabel*>(QString::fromLatin1(name))->text(); }
};

TEST_F(PullPages, AKnotThatHoldsIsTold) {
  open_review();
  review()->go(1);
  ASSERT_TRUE(at_rest());
  EXPECT_TRUE(pull_by_key([&](console::PullDialog& dialog) {
    EXPECT_TRUE(dialog.state().holds);
    EXPECT_EQ(words(dialog, "pull_knot"), "Knot (2, \u22121, 1) as it is at 00:01, loop 4.60\u202Fmm");
    EXPECT_EQ(words(dialog, "pull_result"), "\u2713 It holds.");
    EXPECT_EQ(dialog.findChild<QProgressBar*>()->value(), 1000);
    EXPECT_EQ(dialog.findChild<QDoubleSpinBox*>("pull_friction")->value(), 0.3) << "as in the attempt";
    EXPECT_TRUE(dialog.note().startsWith("Knot (2, \u22121, 1) pulled, friction 0.3: holds 100")) << dialog.note().toStdString();
    EXPECT_FALSE(dialog.findChild<QPushButton*>("pull_keep")->isVisible()) << "this store takes no notes";
  }));
}

TEST_F(PullPages, AKnotThatGivesWayIsToldAndPulledAgainWithOtherValues) {
  pull = {0.03, 0.5e-3, false, ""};
  open_review();
  EXPECT_TRUE(pull_by_key([&](console::PullDialog& dialog) {
    EXPECT_FALSE(dialog.state().holds);
    EXPECT_EQ(words(dialog, "pull_result"), "\u25B2 It gives way.");
    EXPECT_EQ(dialog.findChild<QProgressBar*>()->value(), 300);
    EXPECT_TRUE(words(dialog, "pull_numbers").contains("30")) << words(dialog, "pull_numbers").toStdString();
    dialog.findChild<QDoubleSpinBox*>("pull_load")->setValue(20);
    dialog.findChild<QDoubleSpinBox*>("pull_friction")->setValue(0.5);
    QTest::mouseClick(dialog.findChild<QPushButton*>("pull_again"), Qt::LeftButton);
    EXPECT_TRUE(eventually([&] { return !dialog.pulling(); }));
    EXPECT_TRUE(dialog.state().holds) << "20 mN of the 30 that it bears";
    EXPECT_TRUE(dialog.note().contains("friction 0.5")) << dialog.note().toStdString();
  }));
}

TEST_F(PullPages, AThreadThatPartsIsTold) {
  pull = {0.05, 0.1e-3, true, ""};
  open_review();
  EXPECT_TRUE(pull_by_key([&](console::PullDialog& dialog) { EXPECT_EQ(words(dialog, "pull_result"), "\u25B2 The thread parts."); }));
}

TEST_F(PullPages, WithoutAKnotAtTheCursorItIsSaidWhy) {
  pull.no_knot = "There is no knot.";
  open_review();
  click("review_pull");
  EXPECT_TRUE(child<QLabel>("review_note")->text().contains("There is no knot.")) << child<QLabel>("review_note")->text().toStdString();
  EXPECT_TRUE(child<QLabel>("review_note")->text().contains("00:00"));
}

// The pins draw the loop straight; a wide loop of a single throw left the picture of a usual one.
TEST_F(PullPages, TheWholeLoopIsInThePicture) {
  for (const double loop_m : {4.6e-3, 9e-3}) {
    pull.loop_m = loop_m;
    open_review();
    EXPECT_TRUE(pull_by_key([&](console::PullDialog& dialog) {
      const auto& camera = dialog.findChild<console::SceneView*>()->camera();
      const auto half_mm = static_cast<float>(500 * loop_m);
      EXPECT_NEAR(camera.focus().x(), 0.5F * half_mm - 0.25F, 1e-3F);
      const float half_height_mm = camera.distance() * std::tan(0.5F * console::OrbitCamera::kFovDeg * 0.0174533F);
      EXPECT_GT(half_height_mm, half_mm) << "the loop drawn to either side";
      EXPECT_LT(half_height_mm, half_mm + 2) << "and no smaller than need be";
    }));
    window.reset();
  }
}

TEST_F(PullPages, AskedForOnTheWayItIsPulledOnceThePictureIsThere) {
  open_review();
  review()->go(1.5);
  ASSERT_TRUE(review()->moving());
  bool came = false;
  QString knot;
  in_dialog("pull_dialog", [&](QDialog* dialog) {
    came = !review()->moving();
    knot = words(*dialog, "pull_knot");
    dialog->reject();
  });
  QTest::keyClick(review()->timeline(), Qt::Key_K);
  EXPECT_TRUE(child<QLabel>("review_note")->isVisible()) << "it is said that it will be";
  EXPECT_TRUE(eventually([&] { return came; }));
  EXPECT_TRUE(knot.contains("00:01")) << knot.toStdString();
  EXPECT_FALSE(child<QLabel>("review_note")->isVisible());
}

TEST_F(PullPages, WhereTheCursorGoesOnNothingIsPulledAndWhatWasSaidOfTheMomentGoes) {
  pull.no_knot = "There is no knot.";
  open_review();
  click("review_pull");
  ASSERT_TRUE(child<QLabel>("review_note")->isVisible());
  review()->go(1.9);
  EXPECT_FALSE(child<QLabel>("review_note")->isVisible()) << "it was about another moment";
  QTest::keyClick(review()->timeline(), Qt::Key_K);
  review()->go(0.5);
  ASSERT_TRUE(at_rest());
  QApplication::processEvents();
  EXPECT_FALSE(child<QLabel>("review_note")->isVisible()) << child<QLabel>("review_note")->text().toStdString();
}

TEST_F(PullPages, BeforeAnythingIsMeasuredThereIsNoTension) {
  pull.steps = 1u << 30;
  open_review();
  bool came = false, ended = false;
  in_dialog("pull_dialog", [&](QDialog* dialog) {
    auto* pulls = qobject_cast<console::PullDialog*>(dialog);
    pulls->pull();  // and no step yet
    EXPECT_EQ(words(*dialog, "pull_numbers"), "Tension –, slip –");
    EXPECT_EQ(dialog->findChild<QProgressBar*>()->value(), 0);
    EXPECT_EQ(words(*dialog, "pull_result"), "Being pulled …");
    came = pulls->pulling();
    // until then keys are those of the page behind it, which has an Escape of its own
    EXPECT_TRUE(eventually([&] { return QApplication::activeWindow() == dialog; }));
    EXPECT_TRUE(pulls->pulling());
    QTest::keyClick(dialog, Qt::Key_Escape);
    ended = !dialog->isVisible();
    dialog->reject();
  });
  click("review_pull");
  EXPECT_TRUE(came);
  EXPECT_TRUE(ended) << "Escape ends it while it pulls";
  EXPECT_EQ(window->findChild<QDialog*>("pull_dialog"), nullptr);
  EXPECT_TRUE(review()->isVisible());
}

class GermanPull : public PullPages {
 protected:
  void SetUp() override { ASSERT_TRUE(console::use_language(QStringLiteral("de"))); }
  void TearDown() override {
    window.reset();
    console::use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }
};

TEST_F(GermanPull, WhyNothingIsPulledIsSaidInGermanAndWholeAt1024) {
  pull.no_knot = session::say::kNoKnot();
  open_review();
  ASSERT_TRUE(eventually([&] {
    window->resize(1024, 768);
    return window->size() == QSize(1024, 768);
  }));
  click("review_pull");
  const auto* note = dynamic_cast<console::ElidedLabel*>(child<QLabel>("review_note"));
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->text().contains("Hier ist kein Knoten")) << note->text().toStdString();
  EXPECT_TRUE(eventually([&] { return note->height() >= note->heightForWidth(note->width()); })) << note->height();
  EXPECT_EQ(note->lines(note->width()).join(QLatin1Char(' ')), note->text()) << note->width();
}

TEST_F(GermanPull, EachButtonHasALetterOfItsOwn) {
  open_review();
  EXPECT_TRUE(pull_by_key([&](console::PullDialog& dialog) {
    QStringList letters;
    auto add = [&](const QString& text) {
      if (const auto at = text.indexOf(QLatin1Char('&')); at >= 0) letters += text.mid(at + 1, 1).toUpper();
    };
    for (const auto* button : dialog.findChildren<QPushButton*>()) add(button->text());
    for (const auto* label : dialog.findChildren<QLabel*>()) add(label->text());
    EXPECT_GE(letters.size(), 4);
    EXPECT_EQ(letters.removeDuplicates(), 0) << letters.join(' ').toStdString();
  }));
}

TEST_F(PullPages, WhereNoLessonReadsKnotsThereIsNothingToPull) {
  open_review();
  EXPECT_TRUE(child<QPushButton>("review_pull")->isVisible());
  with_knot = false;
  click("page_people");
  QTest::keyClick(child<QTableView>("attempts"), Qt::Key_Return);
  ASSERT_TRUE(review()->isVisible());
  EXPECT_FALSE(child<QPushButton>("review_pull")->isVisible());
  QTest::keyClick(review()->timeline(), Qt::Key_K);  // does nothing
}

// once an attempt has been passed, where its lesson asks for it
TEST_F(PullPages, AKnotIsPulledBeforeTheResultIsShown) {
  script.rate = 100;
  script.pulls = 30;
  open();
  QVector<double> bears;
  bool result_open = false;
  QObject::connect(control(), &console::RunControl::pulling, window.get(), [&](double bears_N, double load_N) {
    EXPECT_EQ(load_N, 0.1);
    bears += bears_N;
    result_open = result_open || page()->result()->isVisible();
  });
  click("start");
  ASSERT_TRUE(wait_for_end());
  ASSERT_FALSE(bears.isEmpty());
  EXPECT_TRUE(std::is_sorted(bears.begin(), bears.end()));
  EXPECT_FALSE(result_open);
  EXPECT_EQ(page()->result()->outcome(), "✓ Passed");
}

// a pull that would never end
TEST_F(PullPages, StopEndsThePull) {
  script.rate = 100;
  script.pulls = 1 << 30;
  open();
  bool pulled = false;
  QObject::connect(control(), &console::RunControl::pulling, window.get(), [&] { pulled = true; });
  click("start");
  ASSERT_TRUE(eventually([&] { return pulled; }));
  QTest::keyClick(window.get(), Qt::Key_F6);  // no pause of what is over
  EXPECT_EQ(control()->state(), console::RunControl::State::kRunning);
  EXPECT_EQ(log->paused, 0);
  click("stop");
  EXPECT_EQ(page()->result()->outcome(), "✓ Passed");
}

}  // namespace
}  // namespace swage::test
