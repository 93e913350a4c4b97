// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/medium_look.hpp"

#include <swage/abi/environment.h>

#include <QCoreApplication>

namespace swage::console {
namespace {

// A centimetre of water has no colour of its own. The veil is the convention by which a picture says "water"; it is drawn, not computed, and
// faint enough to leave the colours of cues. Less than a tenth of veil at the work is not seen, more than a third makes a green cue blue.
// No pattern of light moves over the work: the lamp of a microscope stands above a few millimetres of water that the hands hardly ripple,
// and bright lines as wide as a suture would be taken for one.
const QColor kVeil(92, 152, 170);
constexpr float kVeilReach = 14;       // radii of the work after which two thirds are hidden: a fifth at the work itself
constexpr float kBackgroundVeil = 0.55F;
constexpr float kMoistTissue = 1.7F;   // a rinsed field glistens more than living tissue does
constexpr float kSunkFilm = 0.1F;      // water on water has hardly a surface that reflects
constexpr double kMostOfWater = 0.01;  // Pa s; water has 0.001, glycerine 1.4: what is thicker than this is not called water

class MediumWords {
  Q_DECLARE_TR_FUNCTIONS(MediumLook)
};

}  // namespace

MediumLook medium_look(uint32_t medium, float size_mm) {
  MediumLook look;
  if (medium == SWAGE_MEDIUM_DRY) look.tissue_film = 0;
  if (medium == SWAGE_MEDIUM_MOIST) look.tissue_film = kMoistTissue, look.stage_film = 1;
  if (medium != SWAGE_MEDIUM_WATER) return look;
  look.veil = kVeil;
  look.veil_per_mm = 1 / (kVeilReach * (size_mm > 0 ? size_mm : 1));
  look.tissue_film = kSunkFilm;
  return look;
}

QColor veiled(const QColor& colour, const MediumLook& look) {
  if (look.veil_per_mm <= 0) return colour;
  const auto mix = [](float a, float b) { return a + kBackgroundVeil * (b - a); };
  // a dark theme stays dark
  const QColor veil = colour.lightness() < 90 ? look.veil.darker(300) : look.veil;
  return QColor::fromRgbF(mix(colour.redF(), veil.redF()), mix(colour.greenF(), veil.greenF()), mix(colour.blueF(), veil.blueF()));
}

QString medium_words(uint32_t medium, double viscosity) {
  switch (medium) {
    case SWAGE_MEDIUM_DRY:
      return MediumWords::tr("Dry field");
    case SWAGE_MEDIUM_MOIST:
      return MediumWords::tr("Moist field");
    case SWAGE_MEDIUM_WATER:
      return viscosity > kMostOfWater ? MediumWords::tr("In a viscous fluid") : MediumWords::tr("Under water");
    default:
      return {};
  }
}

}  // namespace swage::console
