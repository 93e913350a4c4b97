// SPDX-License-Identifier: Apache-2.0
//
// Cost of the views on this machine: view_cost [lesson.json [seconds]]
//
// The expert's attempt is shown in each kind of view while the mouse moves. Printed are pictures per second, the 99th percentile of their
// intervals, the latency from a movement to the first painted picture that can show it (without the screen's own delay),
// and the processor time of all threads of this process per picture. The table is that of resources/charts/seeing.md.
#include <QApplication>
#include <QTest>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <memory>
#include <thread>
#include <vector>

#include "console/app/application.hpp"
#include "console/view3d/scene_view.hpp"
#include "session/rehearsal.hpp"
#include "test_places.hpp"

using namespace swage;
using console::Mirror;
using console::StereoLayout;

namespace {

constexpr int kSnapshots = 40;         // shown in turn, forwards and backwards
constexpr int kStepsApart = 16;        // steps between two snapshots, as at the display rate of a session
constexpr int kFirstStep = 1500;       // the tool has reached its work
constexpr double kWarm_s = 1;          // before the measurement
constexpr QSize kEye_px(1920, 1080), kSmall_px(1280, 800);
constexpr int kPatience_ms = 120000;  // software rendering on a busy machine takes seconds per picture

double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Way {
  const char* name;
  QSize window;
  StereoLayout layout;
  bool stereo = true, microscope = false, blur = false;
  Mirror mirror = Mirror::kNone;
};

/// All kinds of view for eyes of one size.
std::vector<Way> ways(const QSize& eye) {
  const QSize wide(2 * eye.width(), eye.height()), high(eye.width(), 2 * eye.height());
  return {{"one picture, as the instructor's", eye, StereoLayout::kOneEye, false},
          {"one eye", eye, StereoLayout::kOneEye},
          {"side by side, both in one", eye, StereoLayout::kSideBySide},
          {"side by side", wide, StereoLayout::kSideBySide},
          {"over and under", high, StereoLayout::kOverUnder},
          {"lines", eye, StereoLayout::kLines},
          {"chess board", eye, StereoLayout::kChecker},
          {"anaglyph", eye, StereoLayout::kAnaglyph},
          {"anaglyph, grey", eye, StereoLayout::kAnaglyphGrey},
          {"anaglyph, least ghosts", eye, StereoLayout::kAnaglyphLeast},
          {"one after the other, without the driver's part", eye, StereoLayout::kShutter},
          {"side by side, mirrored", wide, StereoLayout::kSideBySide, true, false, false, Mirror::kUpDown},
          {"one eye, microscope", eye, StereoLayout::kOneEye, true, true},
          {"one eye, microscope, depth of field", eye, StereoLayout::kOneEye, true, true, true},
          {"side by side, microscope", wide, StereoLayout::kSideBySide, true, true}};
}

using Snapshots = std::vector<std::unique_ptr<snapshot::Snapshot>>;

struct Seen {
  double per_s = 0, longest_s = 0;         // pictures; 99th percentile of the interval
  double hand_s = 0, hand_longest_s = 0;   // latency from a movement to its picture: median and 99th percentile
  double cpu_s = 0;                        // per picture
};

/// Shows snapshots and moves the mouse for so many seconds.
void play(console::SceneView& view, const Snapshots& shots, double seconds) {
  std::size_t next = 0;
  QTimer display;
  display.setTimerType(Qt::PreciseTimer);
  QObject::connect(&display, &QTimer::timeout, [&] {
    const std::size_t round = next++ % (2 * shots.size());
    view.show_snapshot(*shots[round < shots.size() ? round : 2 * shots.size() - 1 - round]);
    if (next % 4 == 0) QTest::mouseMove(&view, view.rect().center() + QPoint(static_cast<int>(next / 4 % 40), 0));
  });
  display.start(16);
  QTest::qWait(static_cast<int>(1e3 * seconds));
}

bool measure(const Way& way, const snapshot::SceneCard& card, const Snapshots& shots, double seconds, Seen& out) {
  console::SceneView view;
  view.set_themes(console::UiTheme::stock(QStringLiteral("dark")), console::CueTheme::stock(QStringLiteral("thesis")));
  if (way.stereo) {
    console::StereoLook look;
    look.layout = way.layout;
    look.mirror = way.mirror;
    look.microscope = {way.microscope, 10, way.blur};
    view.set_stereo(look);
  }
  view.set_eyes_sink([](const QImage&, const QImage&) {});
  view.resize(way.window);
  view.show();
  view.set_card(card);
  view.set_instrument(true);
  view.show_snapshot(*shots.front());
  if (!QTest::qWaitFor([&] { return view.ready() && view.resting(); }, kPatience_ms)) return false;
  QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
  play(view, shots, kWarm_s);
  const uint64_t before = view.drawn();
  const double cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID), wall = seconds_of(CLOCK_MONOTONIC);
  play(view, shots, seconds);
  const auto drawn = static_cast<double>(view.drawn() - before);
  if (drawn < 1) return false;
  out = {drawn / (seconds_of(CLOCK_MONOTONIC) - wall), view.frames().share(0.99), view.latency().share(0.5), view.latency().share(0.99),
         (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu) / drawn};
  QTest::mouseRelease(&view, Qt::LeftButton, {}, view.rect().center());
  return true;
}

void tell(const Way& way, const Seen& s) {
  std::printf("| %s | %d x %d | %.1f | %.0f | %.0f | %.0f | %.1f |\n", way.name, way.window.width(), way.window.height(), s.per_s, 1e3 * s.longest_s,
              1e3 * s.hand_s, 1e3 * s.hand_longest_s, 1e3 * s.cpu_s);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  console::prepare_graphics();
  QApplication app(argc, argv);
  console::prepare_application();
  const QStringList args = app.arguments();
  session::Options options;
  options.lesson_path = args.value(1, QStringLiteral(SWAGE_SOURCE_DIR "/lessons/series/110_insertion.json")).toStdString();
  options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
  options.store_path = ":none:";
  base::Problems problems;
  const auto expert = session::Rehearsal::open(options, "expert", problems);
  if (!expert) return std::fprintf(stderr, "%s\n", problems.empty() ? "no expert" : problems.front().message.c_str()), 1;
  Snapshots shots;
  for (int i = 0; i < kFirstStep && expert->step(); ++i) {
  }
  for (int k = 0; k < kSnapshots; ++k) {
    for (int i = 0; i < kStepsApart && expert->step(); ++i) {
    }
    shots.push_back(std::make_unique<snapshot::Snapshot>());
    expert->fill(*shots.back());
  }
  const double seconds = args.value(2, QStringLiteral("4")).toDouble();
  const console::GlProbe gl = console::SceneView().gl();
  if (!gl.ok) return std::fprintf(stderr, "%s\n", qUtf8Printable(gl.why)), 1;
  std::printf("%s; %u processors; lesson %s; %g s each\n\n", qUtf8Printable(gl.renderer), std::thread::hardware_concurrency(),
              qUtf8Printable(QString::fromStdString(options.lesson_path).section(QLatin1Char('/'), -1)), seconds);
  std::printf("| seen | window px | fps | longest but one in a hundred ms | hand to picture ms | of 99 in a hundred ms | processor ms |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const QSize& eye : {kEye_px, kSmall_px})
    for (const Way& way : ways(eye)) {
      Seen seen;
      if (measure(way, expert->card(), shots, seconds, seen))
        tell(way, seen);
      else
        std::printf("| %s | %d x %d | none came | | | | |\n", way.name, way.window.width(), way.window.height());
    }
  return 0;
}
