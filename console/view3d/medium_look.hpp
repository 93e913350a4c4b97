// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the medium of a scene looks: air, a dry field, a moist one, water. Free of Qt3D.
#pragma once

#include <QColor>
#include <QString>
#include <cstdint>

namespace swage::console {

/// All zero but `film`: air, as without a medium in the lesson.
struct MediumLook {
  QColor veil = Qt::black;  // colour that hides what is far away
  float veil_per_mm = 0;    // share of the veil over a short way, 1/mm
  float tissue_film = 1;    // reflection of the film on living tissue, of the usual one
  float stage_film = 0;     // the same on what stands fixed
  bool operator==(const MediumLook&) const = default;
};

/// `medium`: SWAGE_MEDIUM_* of abi/environment.h. `size_mm`: radius of what is looked at; the same scene looks alike at any scale.
MediumLook medium_look(uint32_t medium, float size_mm);
/// A colour of the background or of the ground as it is seen through the medium.
QColor veiled(const QColor& colour, const MediumLook& look);
/// "Under water", for the corner of the picture; "" where the lesson sets no medium. `viscosity`: of the fluid, Pa s.
QString medium_words(uint32_t medium, double viscosity);

}  // namespace swage::console
