// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/cues/theme_words.hpp"

#include <QCoreApplication>

namespace swage::console {
namespace {

// The texts in the files of resources/themes; test console.language compares them.
const char* const kWords[] = {
    QT_TRANSLATE_NOOP("themes", "Position wrong, without tips"),
    QT_TRANSLATE_NOOP("themes", "Position wrong, with tips"),
    QT_TRANSLATE_NOOP("themes", "Position right, without tips"),
    QT_TRANSLATE_NOOP("themes", "Position right, tilted"),
    QT_TRANSLATE_NOOP("themes", "Position right, with tips"),
    QT_TRANSLATE_NOOP("themes", "Held"),
    QT_TRANSLATE_NOOP("themes", "Too much force"),
    QT_TRANSLATE_NOOP("themes", "Grasp here"),
    QT_TRANSLATE_NOOP("themes", "Move here"),
    QT_TRANSLATE_NOOP("themes", "On the mark"),
    QT_TRANSLATE_NOOP("themes", "Off target"),
    QT_TRANSLATE_NOOP("themes", "Done"),
    QT_TRANSLATE_NOOP("themes", "Clear"),
    QT_TRANSLATE_NOOP("themes", "Touching"),
    QT_TRANSLATE_NOOP("themes", "Perpendicular to the tissue"),
    QT_TRANSLATE_NOOP("themes", "Off-angle: rotate along the curve"),
    QT_TRANSLATE_NOOP("themes", "Look here"),
    QT_TRANSLATE_NOOP("themes", "Leans this way"),
    QT_TRANSLATE_NOOP("themes", "Or this way"),
    QT_TRANSLATE_NOOP("themes", "Right"),
    QT_TRANSLATE_NOOP("themes", "To the other side"),
    QT_TRANSLATE_NOOP("themes", "Square knot"),
    QT_TRANSLATE_NOOP("themes", "Granny"),
    QT_TRANSLATE_NOOP("themes", "Sliding knot"),
    QT_TRANSLATE_NOOP("themes", "Loose first throw"),
    QT_TRANSLATE_NOOP("themes", "Pulled here"),
    QT_TRANSLATE_NOOP("themes", "It is another knot"),
    QT_TRANSLATE_NOOP("themes", "It holds"),
    QT_TRANSLATE_NOOP("themes", "It gives way"),
    QT_TRANSLATE_NOOP("themes", "Puncture here"),
    QT_TRANSLATE_NOOP("themes", "Come out here"),
    QT_TRANSLATE_NOOP("themes", "The tissue tears"),
    QT_TRANSLATE_NOOP("themes", "Deflected: change the angle"),
    QT_TRANSLATE_NOOP("themes", "Needle left in the tissue"),
    QT_TRANSLATE_NOOP("themes", "Held at the swage: damages the suture"),
    QT_TRANSLATE_NOOP("themes", "Thread length right"),
    QT_TRANSLATE_NOOP("themes", "Leave this length of thread"),
    QT_TRANSLATE_NOOP("themes", "Pulls on the tissue"),
    QT_TRANSLATE_NOOP("themes", "Turns are on: keep them drawn"),
    QT_TRANSLATE_NOOP("themes", "Too many turns"),
    QT_TRANSLATE_NOOP("themes", "Tied, and flat"),
    QT_TRANSLATE_NOOP("themes", "A throw is loose: draw it down"),
    QT_TRANSLATE_NOOP("themes", "Not this throw, or it slides"),
    QT_TRANSLATE_NOOP("themes", "Edges together"),
    QT_TRANSLATE_NOOP("themes", "The needle is bent"),
    QT_TRANSLATE_NOOP("themes", "Dropped"),
    QT_TRANSLATE_NOOP("themes", "Original colours"),
    QT_TRANSLATE_NOOP("themes", "Colour-blind safe"),
    QT_TRANSLATE_NOOP("themes", "High contrast"),
    QT_TRANSLATE_NOOP("themes", "Dark"),
    QT_TRANSLATE_NOOP("themes", "Light"),
    QT_TRANSLATE_NOOP("themes", "low, one knock"),
    QT_TRANSLATE_NOOP("themes", "low, two knocks"),
    QT_TRANSLATE_NOOP("themes", "high, one knock"),
    QT_TRANSLATE_NOOP("themes", "high, two knocks"),
    QT_TRANSLATE_NOOP("themes", "soft rattle"),
    QT_TRANSLATE_NOOP("themes", "chime"),
    QT_TRANSLATE_NOOP("themes", "falling"),
    QT_TRANSLATE_NOOP("themes", "tear"),
    QT_TRANSLATE_NOOP("themes", "thud"),
    QT_TRANSLATE_NOOP("themes", "click"),
};

}  // namespace

QString theme_word(const QString& text) { return QCoreApplication::translate("themes", text.toUtf8().constData()); }

QStringList theme_words() {
  QStringList out;
  for (const char* word : kWords) out += QString::fromUtf8(word);
  return out;
}

}  // namespace swage::console
