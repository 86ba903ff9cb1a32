// Territories in the 3D view: their branches are seen through the liver, in colours that are told apart.

#include <gtest/gtest.h>

#include "tests/viewer/bodies.h"
#include "tests/viewer/colour_difference.h"
#include "tests/viewer/kept_picture.h"
#include "viewer/model_view.h"

namespace glisson {
namespace {

QColor qt(Rgb colour) { return {colour.r, colour.g, colour.b}; }

int pixelsOf(const QImage& image, Rgb colour, int fromX, int toX) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = fromX; x < toX; ++x) {
      count += test::colourDifference(image.pixelColor(x, y), qt(colour), false) < 5 ? 1 : 0;
    }
  }
  return count;
}

TEST(TerritoryView, BranchesAreSeenInTheirColoursInsideTheLiverUntilTheyAreTakenAway) {
  ModelView view;
  view.resize(640, 480);
  view.setModel(test::asymmetricModel(1.0));  // opaque: nothing hides them
  const Rgb left = territoryColour(0);
  const Rgb right = territoryColour(1);
  const std::vector<DrawnTerritory> drawn{{"left", left, {{{Vec3(5, 0, 0), Vec3(60, 0, 10)}, 2}}},
                                          {"right", right, {{{Vec3(-5, 0, 0), Vec3(-5, 0, 0), Vec3(-60, 0, 10)}, 2}}},
                                          {"", kNoTerritoryColour, {{{Vec3(0, 0, -40), Vec3(0, 0, 0)}, 2}, {{Vec3::Zero()}, 2}}}};
  view.setTerritories(drawn);
  const QImage seen = test::kept(view.picture(), "territories");
  const int middle = static_cast<int>(view.camera().toPixel(Vec3::Zero()).x());
  EXPECT_GT(pixelsOf(seen, left, middle, seen.width()), 200) << "the patient's left is on the picture's right";
  EXPECT_EQ(pixelsOf(seen, left, 0, middle), 0);
  EXPECT_GT(pixelsOf(seen, right, 0, middle), 200);
  EXPECT_EQ(pixelsOf(seen, right, middle, seen.width()), 0);
  EXPECT_GT(pixelsOf(seen, kNoTerritoryColour, middle - 20, middle + 20), 100);
  view.setTerritories({});
  EXPECT_EQ(pixelsOf(view.picture(), left, 0, seen.width()), 0);
}

TEST(TerritoryView, ColoursAreToldApartFromEachOtherAndFromWhatIsAroundThemByDeuteranopesToo) {
  constexpr double kToldApart = 20;
  std::vector<QColor> colours{qt(kNoTerritoryColour)};
  for (std::size_t n = 0; n < kTerritoryColours; ++n) {
    colours.push_back(qt(territoryColour(n)));
  }
  using K = StructureKind;
  for (const bool deuteranope : {false, true}) {
    for (std::size_t a = 0; a < colours.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GE(test::colourDifference(colours[a], colours[b], deuteranope), kToldApart) << a << ' ' << b << ' ' << deuteranope;
      }
      for (const K kind : {K::Liver, K::PortalVein, K::HepaticVein, K::Tumour}) {
        EXPECT_GE(test::colourDifference(colours[a], qt(defaultColour(kind)), deuteranope), kToldApart)
            << a << ' ' << kindId(kind) << ' ' << deuteranope;
      }
    }
  }
}

}  // namespace
}  // namespace glisson
