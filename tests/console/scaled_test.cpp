// SPDX-License-Identifier: Apache-2.0
//
// U2: every page in both languages on a screen of 1920 x 1080 pixels, whatever the desktop's scale (QT_SCALE_FACTOR): no text is
// clipped, and every control is reached by Tab.
#include <QAbstractButton>
#include <QCheckBox>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSet>
#include <QStyle>
#include <QTableWidget>

#include "console/app/language.hpp"
#include "console/widgets/parts.hpp"
#include "record/school.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

const char* const kPages[] = {"run", "lessons", "courses", "people", "review", "setup", "stations"};

class Scaled : public WindowTest, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(console::use_language(QString::fromLatin1(GetParam())));
    attempts = sample_attempts();
    const double scale = std::max(1.0, qEnvironmentVariable("QT_SCALE_FACTOR").toDouble());
    launch.size = (QSizeF(1920, 1080) / scale).toSize();
    open();
    ASSERT_TRUE(wait_for_preview());
  }
  void TearDown() override {
    window.reset();
    console::use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  // px that a widget needs for its text in one line; 0 for text that wraps or is elided, or without text
  static int wanted(const QWidget* w) {
    if (const auto* label = qobject_cast<const QLabel*>(w)) {
      const bool elides = dynamic_cast<const console::ElidedLabel*>(w) != nullptr;
      if (elides || label->text().isEmpty()) return 0;
      if (label->wordWrap()) return longest_word(*label);
      return label->minimumSizeHint().width();
    }
    const auto* button = qobject_cast<const QAbstractButton*>(w);
    if (!button || button->text().isEmpty()) return 0;
    const auto* keyed = dynamic_cast<const console::KeyedButton*>(w);
    const QString text = (keyed ? keyed->words() : button->text()).remove(QLatin1Char('&'));
    int width = button->fontMetrics().horizontalAdvance(text);
    QStyle* style = w->style();
    if (qobject_cast<const QCheckBox*>(w))
      width += style->pixelMetric(QStyle::PM_IndicatorWidth) + style->pixelMetric(QStyle::PM_CheckBoxLabelSpacing);
    if (qobject_cast<const QRadioButton*>(w))
      width += style->pixelMetric(QStyle::PM_ExclusiveIndicatorWidth) + style->pixelMetric(QStyle::PM_RadioButtonLabelSpacing);
    return width;
  }
  static int longest_word(const QLabel& label) {
    int out = 0;
    if (Qt::mightBeRichText(label.text())) return 0;
    for (const QString& word : label.text().split(QRegularExpression(QStringLiteral("\\s+"))))
      out = std::max(out, label.fontMetrics().horizontalAdvance(word));
    return out;
  }
  // contents of a horizontal scroll area may be wider than the window
  static bool scrolls(const QWidget* w) {
    for (const QWidget* p = w->parentWidget(); p; p = p->parentWidget()) {
      const auto* area = qobject_cast<const QAbstractScrollArea*>(p);
      if (area && area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) return true;
    }
    return false;
  }
  // in a group of exclusive buttons Tab stops at one, and arrows reach the others
  static bool by_tab(const QAbstractButton* b) {
    if (!b->autoExclusive()) return b->focusPolicy() & Qt::TabFocus;
    for (const QAbstractButton* other : b->parentWidget()->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly))
      if (other->autoExclusive() && (other->focusPolicy() & Qt::TabFocus)) return true;
    return false;
  }
  std::string name_of(const QWidget* w) {
    QString words;
    if (const auto* b = qobject_cast<const QAbstractButton*>(w)) words = b->text();
    if (const auto* l = qobject_cast<const QLabel*>(w)) words = l->text();
    return (w->objectName() + QStringLiteral(" \"") + words + QLatin1Char('"')).toStdString();
  }
};

TEST_P(Scaled, NoTextOfAnyPageIsClipped) {
  ASSERT_EQ(window->size(), launch.size) << "the pages ask for more room than the screen has: "
                                         << window->minimumSizeHint().width() << " x " << window->minimumSizeHint().height();
  int seen = 0;
  for (const char* page : kPages) {
    window->show_page(QString::fromLatin1(page));
    QTest::qWait(50);
    for (const QWidget* w : window->findChildren<QWidget*>()) {
      const int px = w->isVisible() ? wanted(w) : 0;
      if (px == 0) continue;
      ++seen;
      EXPECT_LE(px, w->width()) << page << ": " << name_of(w) << " is clipped";
      const auto* label = qobject_cast<const QLabel*>(w);
      if (label && label->wordWrap()) {
        EXPECT_LE(label->heightForWidth(w->width()), w->height()) << page << ": " << name_of(w) << " is cut off below";
      }
      // a control outside the window cannot be read
      const QRect at(w->mapTo(window.get(), QPoint()), w->size());
      if (!scrolls(w)) {
        EXPECT_TRUE(at.left() >= 0 && at.right() < window->width()) << page << ": " << name_of(w) << " lies outside";
      }
    }
  }
  EXPECT_GT(seen, 150);
}

// From the first control on, Tab visits each enabled one and returns to the first.
TEST_P(Scaled, TabComesToEveryControl) {
  for (const char* page : kPages) {
    window->show_page(QString::fromLatin1(page));
    QSet<const QWidget*> reached;
    QWidget* at = window.get();
    for (int i = 0; i < 2000; ++i) {
      at = at->nextInFocusChain();
      if (at == window.get()) break;
      reached.insert(at);
    }
    EXPECT_EQ(at, window.get()) << page << ": the chain does not close";
    for (const QAbstractButton* b : window->findChildren<QAbstractButton*>()) {
      if (!b->isVisible() || !b->isEnabled() || b->text().isEmpty()) continue;
      EXPECT_TRUE(reached.contains(b)) << page << ": " << name_of(b);
      EXPECT_TRUE(by_tab(b)) << page << ": " << name_of(b) << " is passed over by Tab";
    }
  }
}

// A course with its rule and limits, beside two lists: the layout with the least room.
class SmallScreen : public Scaled {
 protected:
  void SetUp() override {
    ASSERT_TRUE(console::use_language(QString::fromLatin1(GetParam())));
    with_school = true;
    std::string error;
    const auto school = record::School::open(school_file(), error);
    ASSERT_TRUE(school) << error;
    record::Course course;
    course.title = "Spring";
    record::CourseStep& step = course.steps.emplace_back();
    step.lesson_id = step.title = "org.example.a";
    step.limits.push_back({.metric = "points.time", .unit = "1", .most = 0.91171, .source = "staff"});
    ASSERT_TRUE(school->save_course(course));
    launch.size = {1280, 800};
    open();
  }
};

TEST_P(SmallScreen, ACourseFitsIt) {
  window->show_page(QStringLiteral("courses"));
  const auto* table = child<QTableWidget>("limits");
  ASSERT_TRUE(eventually([&] { return table->isVisible() && table->rowCount() == 1; }));
  EXPECT_TRUE(table->item(0, 0)->text().startsWith(QLatin1String(GetParam()) == QLatin1String("de") ? "Verlorene Punkte: " : "Points lost: "));
  for (const QWidget* part : {static_cast<const QWidget*>(table), static_cast<const QWidget*>(child<QLabel>("rule_says")),
                              static_cast<const QWidget*>(child<QPushButton>("suggest_limits"))})
    EXPECT_LT(part->mapTo(window.get(), QPoint(part->width(), 0)).x(), window->width()) << name_of(part);
}

INSTANTIATE_TEST_SUITE_P(Languages, SmallScreen, testing::Values("en", "de"),
                         [](const auto& one) { return std::string(one.param); });
INSTANTIATE_TEST_SUITE_P(Languages, Scaled, testing::Values("en", "de"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace swage::test
