// Tests of the window run in one QApplication, with settings and data in a folder of their own.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <clocale>

#include "viewer/vtk_widget.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) {
    return RUN_ALL_TESTS();  // listing needs no display
  }
  QStandardPaths::setTestModeEnabled(true);
  const QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  glisson::VtkWidget::prepareSurfaceFormat();
  const QApplication application(argc, argv);
  QApplication::setOrganizationName("glisson-tests");
  QApplication::setApplicationName("glisson-tests");
  std::setlocale(LC_ALL, "C");
  return RUN_ALL_TESTS();
}
