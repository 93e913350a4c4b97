// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_titles.hpp"

#include <QCoreApplication>
#include <algorithm>

#include "console/models/words.hpp"

namespace swage::console {
namespace {

struct Title {
  const char *id, *text;
  bool share = false;
};

// clang-format off
constexpr Title kTitles[] = {
    {"angle.answers", QT_TRANSLATE_NOOP("metrics", "Answers given")},
    {"angle.bias_depth", QT_TRANSLATE_NOOP("metrics", "Error of judging, in depth")},
    {"angle.bias_side", QT_TRANSLATE_NOOP("metrics", "Error of judging, sideways")},
    {"angle.jnd_depth", QT_TRANSLATE_NOOP("metrics", "Just noticed, in depth")},
    {"angle.jnd_side", QT_TRANSLATE_NOOP("metrics", "Just noticed, sideways")},
    {"angle.right", QT_TRANSLATE_NOOP("metrics", "Right answers"), true},
    {"force.mean", QT_TRANSLATE_NOOP("metrics", "Grip force, mean")},
    {"force.over_dose", QT_TRANSLATE_NOOP("metrics", "Excess force over time")},
    {"force.over_time", QT_TRANSLATE_NOOP("metrics", "Time gripped too hard"), true},
    {"force.peak", QT_TRANSLATE_NOOP("metrics", "Grip force, peak")},
    {"force.slip_risk", QT_TRANSLATE_NOOP("metrics", "Time gripped too lightly"), true},
    {"force.steadiness", QT_TRANSLATE_NOOP("metrics", "Unsteadiness of the grip")},
    {"grasp.balance", QT_TRANSLATE_NOOP("metrics", "Difference between the jaws"), true},
    {"grasp.drops", QT_TRANSLATE_NOOP("metrics", "Drops")},
    {"grasp.in_zone", QT_TRANSLATE_NOOP("metrics", "Grasps in the region"), true},
    {"grasp.regrasps", QT_TRANSLATE_NOOP("metrics", "Grasps again")},
    {"grasp.resets", QT_TRANSLATE_NOOP("metrics", "Needle brought back")},
    {"grasp.snap", QT_TRANSLATE_NOOP("metrics", "Turn of the needle when taken")},
    {"grasp.spot_error", QT_TRANSLATE_NOOP("metrics", "Distance from the region"), true},
    {"grasp.tilt_axis", QT_TRANSLATE_NOOP("metrics", "Lean against the jaw axis")},
    {"grasp.tilt_plane", QT_TRANSLATE_NOOP("metrics", "Lean against the jaw faces")},
    {"grasp.tip_reach", QT_TRANSLATE_NOOP("metrics", "Reach past the needle")},
    {"grasp.tries", QT_TRANSLATE_NOOP("metrics", "Tries")},
    {"hold.breaks", QT_TRANSLATE_NOOP("metrics", "Holds broken")},
    {"hold.error", QT_TRANSLATE_NOOP("metrics", "Distance from the target, held")},
    {"hold.in_target", QT_TRANSLATE_NOOP("metrics", "Time in the target"), true},
    {"hold.progress", QT_TRANSLATE_NOOP("metrics", "Hold done"), true},
    {"hold.settling", QT_TRANSLATE_NOOP("metrics", "Time to settle")},
    {"hold.tremor", QT_TRANSLATE_NOOP("metrics", "Tremor while held")},
    {"insert.angle", QT_TRANSLATE_NOOP("metrics", "Angle in the tissue")},
    {"insert.arc_error", QT_TRANSLATE_NOOP("metrics", "Off the needle's curve")},
    {"insert.cosine", QT_TRANSLATE_NOOP("metrics", "Cosine of penetration, mean")},
    {"insert.deflections", QT_TRANSLATE_NOOP("metrics", "Entries refused")},
    {"insert.depth", QT_TRANSLATE_NOOP("metrics", "Depth, of the wall"), true},
    {"insert.entries", QT_TRANSLATE_NOOP("metrics", "Entries")},
    {"insert.entry_angle", QT_TRANSLATE_NOOP("metrics", "Angle at the entry")},
    {"insert.entry_distance", QT_TRANSLATE_NOOP("metrics", "Entry from the mark")},
    {"insert.exit_angle", QT_TRANSLATE_NOOP("metrics", "Angle at the exit")},
    {"insert.exit_distance", QT_TRANSLATE_NOOP("metrics", "Exit from its mark")},
    {"insert.in_angle", QT_TRANSLATE_NOOP("metrics", "Way within the angle"), true},
    {"insert.progress", QT_TRANSLATE_NOOP("metrics", "Driven in, of what is asked"), true},
    {"motion.path", QT_TRANSLATE_NOOP("metrics", "Way of the tips")},
    {"needle.bending", QT_TRANSLATE_NOOP("metrics", "Bending, of what it bears"), true},
    {"practice.different", QT_TRANSLATE_NOOP("metrics", "Different things held")},
    {"practice.drops", QT_TRANSLATE_NOOP("metrics", "Drops")},
    {"practice.grasps", QT_TRANSLATE_NOOP("metrics", "Grasps")},
    {"practice.touches", QT_TRANSLATE_NOOP("metrics", "Touches")},
    {"stitch.asymmetry", QT_TRANSLATE_NOOP("metrics", "Difference of the bites"), true},
    {"stitch.bite_in", QT_TRANSLATE_NOOP("metrics", "Bite at the entry, wires")},
    {"stitch.bite_out", QT_TRANSLATE_NOOP("metrics", "Bite at the exit, wires")},
    {"stitch.count", QT_TRANSLATE_NOOP("metrics", "Stitches through")},
    {"stitch.obliquity", QT_TRANSLATE_NOOP("metrics", "Slant of the stitch")},
    {"stitch.unevenness", QT_TRANSLATE_NOOP("metrics", "Unevenness along the edge"), true},
    {"task.success", QT_TRANSLATE_NOOP("metrics", "Passed (1) or not (0)")},
    {"time.answer", QT_TRANSLATE_NOOP("metrics", "Time to answer, mean")},
    {"time.approach", QT_TRANSLATE_NOOP("metrics", "Time to the needle")},
    {"time.carry", QT_TRANSLATE_NOOP("metrics", "Time carried")},
    {"time.idle", QT_TRANSLATE_NOOP("metrics", "Idle time"), true},
    {"time.task", QT_TRANSLATE_NOOP("metrics", "Time at work")},
    {"tissue.pull", QT_TRANSLATE_NOOP("metrics", "Pull on the tissue over time")},
    {"tissue.stray", QT_TRANSLATE_NOOP("metrics", "Stray touches of the tissue")},
    {"tissue.swept", QT_TRANSLATE_NOOP("metrics", "Swept inside the tissue")},
    {"view.stereo", QT_TRANSLATE_NOOP("metrics", "Seen in stereo (1) or not (0)")},
    {"wound.area", QT_TRANSLATE_NOOP("metrics", "Wound area, of the needle's"), true},
    {"wound.size", QT_TRANSLATE_NOOP("metrics", "Wound size"), true},
};
// clang-format on

const Title* find(const QString& id) {
  const auto it = std::find_if(std::begin(kTitles), std::end(kTitles),
                               [&](const Title& t) { return id == QLatin1String(t.id); });
  return it == std::end(kTitles) ? nullptr : it;
}

}  // namespace

QString metric_title(const QString& id) {
  const Title* title = find(id);
  return title ? QCoreApplication::translate("metrics", title->text) : human_id(id);
}

QString metric_unit(const QString& id, const QString& unit) {
  const Title* title = find(id);
  return title && title->share && unit == QLatin1String("1") ? QStringLiteral("%") : unit;
}

}  // namespace swage::console
