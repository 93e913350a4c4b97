// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/application.hpp"

#include <QApplication>
#include <QStyleFactory>
#include <QSurfaceFormat>

namespace swage::console {

void prepare_graphics() {
  // the other renderer of Qt 6.4 crashes without OpenGL and turns captured pictures upside down
  qputenv("QT3D_RENDERER", "opengl");
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);  // the view resolves its own samples
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void prepare_application() {
  QCoreApplication::setApplicationName(QStringLiteral("swage-console"));
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
}

}  // namespace swage::console
