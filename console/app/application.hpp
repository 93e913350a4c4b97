// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace swage::console {

/// Help or version are asked for: that needs no display.
bool asks_for_text(int argc, char** argv);
/// Around the making of QApplication: where no display answers, one sentence says what to do and the program ends with 1.
void expect_display();
void display_is_there();
/// Before QApplication: which renderer and surface format Qt3D uses.
void prepare_graphics();
/// After QCoreApplication: name and version, which --version and reports tell.
void name_application();
/// After QApplication: name, style, font.
void prepare_application();

}  // namespace swage::console
