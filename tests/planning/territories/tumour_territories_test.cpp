// Which territories a tumour lies in: voxels are counted, and add up to the tumour inside the liver.

#include "planning/territories/tumour_territories.h"

#include <gtest/gtest.h>

#include "fork.h"

namespace glisson {
namespace {
using namespace test;

const ImageGeometry kGrid = gridOf({40, 24, 20}, Vec3(1, 0.5, 2));
const Inside kLiver = box(Vec3(4.5, 0.9, 3), Vec3(34.5, 11.1, 37));

/// A map of two segments that meet at x = 20.5, on the case's grid.
Territories twoSegments(const Case& source) {
  const auto map = segmentationOf(kGrid, {{"segment 2", StructureKind::Other, box(Vec3(-1, -1, -1), Vec3(20.5, 40, 60))},
                                          {"segment 7", StructureKind::Other, box(Vec3(20.5, -1, -1), Vec3(60, 40, 60))}});
  return segmentTerritories(*source.liver, *map);
}

TEST(TumourTerritories, SharesAreTheVoxelsOnEachSideOfTheBorderLargestFirst) {
  const Case source = newCase(nullptr, segmentationOf(kGrid, {{"liver", StructureKind::Liver, kLiver},
                                                              {"across", StructureKind::Tumour, box({17.5, 2, 8}, {27.5, 6, 16})},
                                                              {"within", StructureKind::Cyst, box({6.5, 2, 8}, {9.5, 6, 16})}}));
  const auto all = tumourTerritories(source, twoSegments(source));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, "tumour_01");
  EXPECT_EQ(all[0].name, "across");
  ASSERT_EQ(all[0].shares.size(), 2U);
  EXPECT_EQ(all[0].shares[0].name, "segment 7");
  EXPECT_DOUBLE_EQ(all[0].shares[0].percent, 70) << "columns 21 to 27 of 18 to 27";
  EXPECT_EQ(all[0].shares[1].name, "segment 2");
  EXPECT_DOUBLE_EQ(all[0].shares[1].percent, 30);
  const double ml = volumeMl(*source.segmentation->structures[1].mask, kGrid);
  EXPECT_NEAR(all[0].shares[0].volumeMl, 0.7 * ml, 1e-12);
  EXPECT_NEAR(all[0].shares[1].volumeMl, 0.3 * ml, 1e-12);
  EXPECT_EQ(all[1].id, "cyst_01");
  ASSERT_EQ(all[1].shares.size(), 1U);
  EXPECT_EQ(all[1].shares[0].name, "segment 2");
  EXPECT_DOUBLE_EQ(all[1].shares[0].percent, 100);
}

TEST(TumourTerritories, WhatLiesOutsideTheLiverLiesInNone) {
  const Case source = newCase(nullptr, segmentationOf(kGrid, {{"liver", StructureKind::Liver, kLiver},
                                                              {"apart", StructureKind::Tumour, box({36.5, 2, 8}, {38.5, 6, 16})}}));
  const auto all = tumourTerritories(source, twoSegments(source));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(all[0].shares.empty());
}

TEST(TumourTerritories, OfABorderBetweenBranchesAreThoseOfItsTwoSides) {
  const ImageGeometry& g = forkCase().liver->geometry;
  const Case source = newCase(
      nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, box(kForkLow, kForkHigh)},
                                  {"portal vein", StructureKind::PortalVein, forkPortal()},
                                  {"tumour", StructureKind::Tumour, box({kForkBorder - 3, 0, 0}, {kForkBorder + 9, 10, 10})}}));
  const VesselGraph portal =
      vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, source.liver->geometry, source.liver->liver);
  const auto all = tumourTerritories(source, territoriesOf(*source.liver, portal, proposeLeftRight(portal)));
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].shares.size(), 2U);
  EXPECT_EQ(all[0].shares[0].name, "left") << "the patient's left is where x grows";
  EXPECT_NEAR(all[0].shares[0].percent, 75, 100.0 / 12 + 1e-9) << "within one of its 12 layers";
  EXPECT_NEAR(all[0].shares[0].percent + all[0].shares[1].percent, 100, 1e-9);
}

TEST(TumourTerritories, WithoutTerritoriesThereAreNone) {
  const Case source = newCase(nullptr, segmentationOf(kGrid, {{"liver", StructureKind::Liver, kLiver},
                                                              {"tumour", StructureKind::Tumour, box({6, 2, 8}, {9, 6, 16})}}));
  EXPECT_TRUE(tumourTerritories(source, {}).empty());
}

}  // namespace
}  // namespace glisson
