// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace swage::console {

/// True when the arguments ask for help or the version, which need no display.
bool asks_for_text(int argc, char** argv);
/// To be called around the making of QApplication: without a display the program prints one sentence that says what to do and exits with 1.
void expect_display();
void display_is_there();
/// To be called before QApplication: sets the renderer and the surface format of Qt3D.
void prepare_graphics();
/// To be called after QCoreApplication: sets the name and the version that --version and reports show.
void name_application();
/// To be called after QApplication: sets name, style and font.
void prepare_application();

}  // namespace swage::console
