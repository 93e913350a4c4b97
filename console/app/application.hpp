// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace swage::console {

/// Before QApplication: which renderer and surface format Qt3D uses.
void prepare_graphics();
/// After QApplication: name, style, font.
void prepare_application();

}  // namespace swage::console
