// What the window shows of a plan: territories in the 3D view.

#include <QCheckBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>

#include "app/gui/screenshot.h"
#include "app/gui/territory_estimator.h"
#include "app/gui/view_area.h"
#include "main_window_test.h"
#include "tests/planning/territories/fork.h"
#include "tests/viewer/kept_picture.h"

namespace glisson {
namespace {

using test::waitFor;

class PlanShown : public test::MainWindowTest {
 protected:
  /// Pixels of exactly this colour in one half of the 3D view.
  int pixelsOf(const QColor& colour, bool rightHalf) {
    const QImage image = window->views().modelView().picture();
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        count += (x >= image.width() / 2) == rightHalf && image.pixelColor(x, y) == colour ? 1 : 0;
      }
    }
    return count;
  }
  QColor swatch(int row) {
    const QImage icon = find<QTreeWidget>("territoryTable")->topLevelItem(row)->icon(0).pixmap(12, 12).toImage();
    return icon.isNull() ? QColor() : icon.pixelColor(icon.rect().center());
  }
  /// With this part of the plan panel in sight.
  void keepPicture(const QString& name, const QString& part) {
    window->resize(1400, 1150);
    click("workspacePlan");
    QTest::qWait(300);  // layouts settle in the event loop
    find<QWidget>("planPanel")->findChild<QScrollArea*>()->ensureWidgetVisible(find<QWidget>(part));
    test::kept(pictureOf(*window), name);
  }
};

TEST_F(PlanShown, ProposedLeftAndRightAreSeenInTheColoursOfTheirRowsBeforeTheyAreConfirmed) {
  emit window->opener().opened(test::forkCase(Vec3(2, 2, 2)), nullptr, {});
  ASSERT_TRUE(settle());
  find<QPushButton>("estimateTerritories")->click();
  auto* table = find<QTreeWidget>("territoryTable");
  ASSERT_TRUE(waitFor([&] { return table->topLevelItemCount() == 2 && table->isEnabled(); }));
  EXPECT_EQ(table->topLevelItem(0)->text(0), "left");
  const QColor left = swatch(0);
  const QColor right = swatch(1);
  ASSERT_NE(left, right);
  EXPECT_TRUE(window->territories().isProposal());
  keepPicture("territories_proposed", "territoryBox");
  EXPECT_GT(pixelsOf(left, true), 100) << "the patient's left is on the picture's right";
  EXPECT_EQ(pixelsOf(left, false), 0);
  EXPECT_GT(pixelsOf(right, false), 100);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_FALSE(find<QPushButton>("confirmTerritories")->isEnabled()) << "nobody confirms what is not seen";
  find<QCheckBox>("showTerritories")->click();
  find<QPushButton>("confirmTerritories")->click();
  ASSERT_TRUE(waitFor([&] { return !window->territories().isProposal() && table->isEnabled(); }));
  EXPECT_GT(pixelsOf(left, true), 100);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_EQ(pixelsOf(left, true), 0);
  find<QCheckBox>("showTerritories")->click();
  EXPECT_GT(pixelsOf(left, true), 100);
  openSmall();
  EXPECT_EQ(pixelsOf(left, true), 0) << "another patient's branches";
}

}  // namespace
}  // namespace glisson
