// The viewer's tests run in one QApplication with the surface format of its OpenGL widgets.

#include <gtest/gtest.h>

#include <QApplication>

#include "viewer/vtk_widget.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) {
    return RUN_ALL_TESTS();  // listing needs no display
  }
  glisson::VtkWidget::prepareSurfaceFormat();
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
