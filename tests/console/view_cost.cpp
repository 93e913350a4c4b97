// SPDX-License-Identifier: Apache-2.0
//
// What a picture costs the processor: view_cost lesson.json [pictures]
//
// The expert's attempt is shown picture by picture, each way of showing it in turn, and the time that all threads of this process spent is
// divided by the pictures. Where OpenGL is software the drawing is in it; a busy machine changes it little, unlike pictures per second.
#include <QApplication>
#include <QTest>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

#include "console/app/application.hpp"
#include "console/view3d/scene_view.hpp"
#include "session/rehearsal.hpp"
#include "test_places.hpp"

using namespace swage;
using console::Mirror;
using console::StereoLayout;

namespace {

constexpr int kSnapshots = 40;         // shown in turn
constexpr int kStepsApart = 33;        // 30 pictures a second
constexpr int kFirstStep = 1500;       // the tool is at its work
constexpr int kWarm = 8;               // pictures before the clock starts
constexpr QSize kEye_px(1920, 1080);
constexpr int kPatience_ms = 120000;  // a processor that draws and is busy takes seconds for a picture

double cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Way {
  const char* name;
  QSize window;
  StereoLayout layout;
  bool stereo = true, microscope = false, blur = false;
  Mirror mirror = Mirror::kNone;
};

const Way kWays[] = {{"one eye", kEye_px, StereoLayout::kOneEye, false},
                     {"side by side, both in 1920 x 1080", kEye_px, StereoLayout::kSideBySide},
                     {"side by side, 1920 x 1080 each", {2 * kEye_px.width(), kEye_px.height()}, StereoLayout::kSideBySide},
                     {"over and under, 1920 x 1080 each", {kEye_px.width(), 2 * kEye_px.height()}, StereoLayout::kOverUnder},
                     {"lines, 1920 x 1080 each", kEye_px, StereoLayout::kLines},
                     {"chess board, 1920 x 1080 each", kEye_px, StereoLayout::kChecker},
                     {"anaglyph, 1920 x 1080 each", kEye_px, StereoLayout::kAnaglyph},
                     {"side by side, mirrored, both in 1920 x 1080", kEye_px, StereoLayout::kSideBySide, true, false, false, Mirror::kUpDown},
                     {"microscope, one eye", kEye_px, StereoLayout::kOneEye, true, true},
                     {"microscope, one eye, depth of field", kEye_px, StereoLayout::kOneEye, true, true, true},
                     {"microscope, one eye, 1280 x 720", {1280, 720}, StereoLayout::kOneEye, true, true},
                     {"microscope, one eye, 1280 x 720, depth of field", {1280, 720}, StereoLayout::kOneEye, true, true, true}};

using Snapshots = std::vector<std::unique_ptr<snapshot::Snapshot>>;

double cost_s(const Way& way, const snapshot::SceneCard& card, const Snapshots& shots, int pictures) {
  console::SceneView view;
  view.set_themes(console::UiTheme::stock(QStringLiteral("dark")), console::CueTheme::stock(QStringLiteral("thesis")));
  if (way.stereo) {
    console::StereoLook look;
    look.layout = way.layout;
    look.mirror = way.mirror;
    look.microscope = {way.microscope, 10, way.blur};
    view.set_stereo(look);
  }
  view.resize(way.window);
  view.show();
  view.set_card(card);
  view.show_snapshot(*shots.front());
  if (!QTest::qWaitFor([&] { return view.ready() && view.resting(); }, kPatience_ms)) return -1;
  double start = 0;
  for (int i = 0; i < kWarm + pictures; ++i) {
    if (i == kWarm) start = cpu_s();
    const uint64_t before = view.drawn();
    // the first is on the screen already, and what is alike is not drawn again
    view.show_snapshot(*shots[static_cast<size_t>(i + 1) % shots.size()]);
    if (!QTest::qWaitFor([&] { return view.drawn() > before; }, kPatience_ms)) return -1;
  }
  return (cpu_s() - start) / pictures;
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
  const int pictures = args.value(2, QStringLiteral("60")).toInt();
  std::printf("processor time of a picture, ms, mean of %d\n", pictures);
  for (const Way& way : kWays) {
    const double s = cost_s(way, expert->card(), shots, pictures);
    std::printf("%-50s %8.1f\n", way.name, 1e3 * s);
    std::fflush(stdout);
  }
  return 0;
}
