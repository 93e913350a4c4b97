// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/application.hpp"

#include <QApplication>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace swage::console {
namespace {

// Qt reports a missing platform plugin in several lines and aborts; this handler prints one sentence instead
void say_what_to_do(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type != QtFatalMsg) return;
  const char* display = std::getenv("DISPLAY");
  const bool named = display && *display;
  std::fprintf(stderr,
               "swage-console: no display: %s%s. Start it on a desktop, set DISPLAY, or run the lesson "
               "without a window: "
               "swage run <lesson.json> --headless\n",
               named ? display : "DISPLAY is not set", named ? " does not answer" : "");
  std::_Exit(1);
}

}  // namespace

bool asks_for_text(int argc, char** argv) {
  constexpr std::array<std::string_view, 6> kText = {"-h", "--help", "--help-all", "-?", "-v", "--version"};
  return std::any_of(argv + 1, argv + std::max(argc, 1), [&](const char* argument) {
    return std::find(kText.begin(), kText.end(), argument) != kText.end();
  });
}

void expect_display() { qInstallMessageHandler(&say_what_to_do); }
void display_is_there() { qInstallMessageHandler(nullptr); }

void prepare_graphics() {
  // the other renderer of Qt 6.4 crashes without OpenGL and captures pictures upside down
  qputenv("QT3D_RENDERER", "opengl");
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);  // the view resolves the samples of its own render targets
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void name_application() {
  QCoreApplication::setApplicationName(QStringLiteral("swage-console"));
  QCoreApplication::setApplicationVersion(QStringLiteral(SWAGE_VERSION));
}

void prepare_application() {
  name_application();
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
}

}  // namespace swage::console
