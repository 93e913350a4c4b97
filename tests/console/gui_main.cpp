// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

#include "console/app/application.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  swage::console::prepare_graphics();
  QApplication app(argc, argv);
  swage::console::prepare_application();
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
