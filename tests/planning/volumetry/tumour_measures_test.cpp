#include "planning/volumetry/tumour_measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "planning/volumetry/box_corners.h"
#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/json.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

const Vec3 kLesionSpacing(0.8, 0.9, 2.5);

VoxelRows randomRows(std::mt19937& random, int voxels, const Index3& size) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  std::uniform_int_distribution<std::size_t> at(0, values.size() - 1);
  for (int n = 0; n < voxels; ++n) {
    values[at(random)] = 1;
  }
  return rowsOf(Mask::fromGrid(size, values));
}

std::vector<Vec3> allCorners(const VoxelRows& rows) {
  std::vector<Vec3> corners;
  for (const RowRun& run : rows.runs) {
    const Box b = boxOf(run, kLesionSpacing);
    for (int c = 0; c < 8; ++c) {
      const Vec3 signs((c & 1) != 0 ? 1 : -1, (c & 2) != 0 ? 1 : -1, (c & 4) != 0 ? 1 : -1);
      corners.push_back(b.centre + signs.cwiseProduct(b.half));
    }
  }
  return corners;
}

TEST(BoxCorners, LongestDiameterAndExtentsAreThoseOfAllCorners) {
  std::mt19937 random(31);
  std::normal_distribution<double> normal;
  for (int n = 0; n < test::trials(60); ++n) {
    const VoxelRows rows = randomRows(random, 1 + n * 3, {14, 12, 7});
    const std::vector<Vec3> all = allCorners(rows);
    double longest = 0;
    for (const Vec3& a : all) {
      for (const Vec3& b : all) {
        longest = std::max(longest, (b - a).norm());
      }
    }
    const auto [from, to] = farthestCorners(rows, kLesionSpacing);
    EXPECT_NEAR((to - from).norm(), longest, 1e-12);
    const std::vector<Vec3> hull = hullCorners(rows, kLesionSpacing);
    EXPECT_LE(hull.size(), all.size());
    for (int d = 0; d < 20; ++d) {
      const Vec3 direction(normal(random), normal(random), normal(random));
      const auto extent = [&](const std::vector<Vec3>& corners) {
        double most = -1e9;
        for (const Vec3& corner : corners) {
          most = std::max(most, direction.dot(corner));
        }
        return most;
      };
      EXPECT_NEAR(extent(hull), extent(all), 1e-12);
    }
  }
}

TEST(BoxCorners, OneVoxelsDiameterIsItsDiagonalAndNoVoxelHasNone) {
  VoxelRows one;
  one.runs.push_back({3, 4, 5, 1});
  const auto [from, to] = farthestCorners(one, kLesionSpacing);
  EXPECT_NEAR((to - from).norm(), kLesionSpacing.norm(), 1e-14);
  EXPECT_EQ(farthestCorners({}, kLesionSpacing).first, Vec3(0, 0, 0));
}

/// A liver [0, 40) x [0, 36) x [0, 50) mm of whole voxels, about.
Case boxLiver(const Inside& tumour) {
  const ImageGeometry g = gridOf({70, 60, 30}, kLesionSpacing, Vec3(-8, -9, -10));
  return newCase(nullptr,
                 segmentationOf(g, {{"liver", StructureKind::Liver, box(Vec3(0, 0, 0), Vec3(40, 36, 50))},
                                    {"met", StructureKind::Tumour, tumour},
                                    {"portal vein", StructureKind::PortalVein, tube(Vec3(5, 20, 0), Vec3::UnitZ(), 2)},
                                    {"hepatic vein", StructureKind::HepaticVein, tube(Vec3(34, 20, 0), Vec3::UnitZ(), 2)}}));
}

TEST(TumourMeasures, ToTheCapsuleLeavesCavitiesOut) {
  const Inside tumour = box(Vec3(20, 10, 15), Vec3(28, 20, 30));
  const Case whole = boxLiver(tumour);
  const ImageGeometry& g = whole.liver->geometry;
  const Vec3 hole = g.toWorld(Vec3(49, 30, 13));  // one voxel, beside the tumour
  const auto holed = [&](const Vec3& p) { return box(Vec3(0, 0, 0), Vec3(40, 36, 50))(p) && (p - hole).norm() > 0.1; };
  const Case made =
      newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, holed}, {"met", StructureKind::Tumour, tumour}}));
  ASSERT_EQ(made.liver->liver.count() + 1, whole.liver->liver.count());
  const TumourMeasures measured = tumourMeasures(made).at(0);
  EXPECT_EQ(measured.capsuleMm, tumourMeasures(whole).at(0).capsuleMm);
  EXPECT_FALSE(measured.capsuleBeyondImage);
}

TEST(TumourMeasures, WhereTheImageEndsTheCapsuleIsAtLeastThatFar) {
  // The liver fills the grid along z, and the tumour lies nearer to its last slice than to the liver's sides.
  const ImageGeometry g = gridOf({70, 60, 20}, kLesionSpacing, Vec3(-8, -9, 0));
  const Case made = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, box(Vec3(0, 0, -9), Vec3(40, 36, 99))},
                                                        {"met", StructureKind::Tumour, box(Vec3(15, 15, 38), Vec3(25, 21, 41))}}));
  const TumourMeasures measured = tumourMeasures(made).at(0);
  EXPECT_NEAR(measured.capsuleMm, 3 * 2.5, 1e-12);
  EXPECT_TRUE(measured.capsuleBeyondImage);
}

TEST(TumourMeasures, OfABoxAreItsSidesAndGaps) {
  const Case made = boxLiver(box(Vec3(20, 10, 15), Vec3(28, 28, 30)));
  const std::vector<TumourMeasures> all = tumourMeasures(made);
  ASSERT_EQ(all.size(), 1U);
  const TumourMeasures& m = all[0];
  EXPECT_EQ(m.id, "tumour_01");
  const IndexBox& voxels = made.segmentation->structures[1].mask->box();
  const Vec3 sides = kLesionSpacing.cwiseProduct(Vec3(voxels.size[0], voxels.size[1], voxels.size[2]));
  EXPECT_NEAR(m.longestDiameterMm, sides.norm(), 1e-12);
  EXPECT_NEAR((m.diameterTo - m.diameterFrom).norm(), m.longestDiameterMm, 1e-12);
  EXPECT_NEAR(m.volumeMl, sides.prod() * kMlPerMm3, 1e-9);
  // The right face of the liver is the nearest: whole voxels between both boxes.
  const IndexBox& liver = made.liver->liver.box();
  const int behind = liver.first[1] + liver.size[1] - (voxels.first[1] + voxels.size[1]);
  EXPECT_NEAR(m.capsuleMm, kLesionSpacing[1] * std::min(behind, voxels.first[1] - liver.first[1]), 1e-12);
  EXPECT_EQ(m.nearestVessel, "hepatic vein");
  const IndexBox& vein = made.segmentation->structures[3].mask->box();
  EXPECT_NEAR(m.vesselMm.value(), kLesionSpacing[0] * (vein.first[0] - voxels.first[0] - voxels.size[0]), 1e-12);
}

TEST(TumourMeasures, TouchingIsZero) {
  const TumourMeasures atCapsule = tumourMeasures(boxLiver(box(Vec3(30, 10, 15), Vec3(45, 20, 30))))[0];
  EXPECT_EQ(atCapsule.capsuleMm, 0);
  EXPECT_EQ(atCapsule.vesselMm, 0);
}

TEST(TumourMeasures, AreTheSameInATurnedShiftedAndMirroredGrid) {
  const Case straight = boxLiver(ball(Vec3(20, 15, 25), 6));
  auto turned = std::make_shared<Segmentation>(*straight.segmentation);
  turned->geometry.direction = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, -1, 1).asDiagonal();
  turned->geometry.origin = Vec3(300, -200, 100);
  const TumourMeasures a = tumourMeasures(straight)[0];
  const TumourMeasures b = tumourMeasures(newCase(nullptr, turned))[0];
  EXPECT_NEAR(a.longestDiameterMm, b.longestDiameterMm, 1e-12);
  EXPECT_EQ(a.capsuleMm, b.capsuleMm);
  EXPECT_EQ(a.vesselMm, b.vesselMm);
  const ImageGeometry& from = straight.segmentation->geometry;
  EXPECT_NEAR((turned->geometry.toWorld(from.toIndex(a.diameterFrom)) - b.diameterFrom).norm(), 0, 1e-9);
}

TEST(TumourMeasures, VesselDistanceIsTheShortestOfAllPairsOfVoxels) {
  std::mt19937 random(32);
  const ImageGeometry g = gridOf({30, 24, 14}, kLesionSpacing);
  std::uniform_real_distribution<double> x(3, 20);
  for (int n = 0; n < test::trials(30); ++n) {
    const Vec3 a(x(random), x(random), 1.4 * x(random));
    const Vec3 b(x(random), x(random), 1.4 * x(random));
    const Case made = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(12, 11, 17), 9)},
                                                          {"met", StructureKind::Tumour, ball(a, 2.5)},
                                                          {"vein", StructureKind::PortalVein, ball(b, 2.5)}}));
    double shortest = 1e9;
    const VoxelRows tumour = rowsOf(*made.segmentation->structures[1].mask);
    const VoxelRows vein = rowsOf(*made.segmentation->structures[2].mask);
    for (const RowRun& p : tumour.runs) {
      for (const RowRun& q : vein.runs) {
        const Box s = boxOf(p, kLesionSpacing);
        const Box t = boxOf(q, kLesionSpacing);
        shortest = std::min(shortest, ((s.centre - t.centre).cwiseAbs() - s.half - t.half).cwiseMax(0.0).norm());
      }
    }
    if (!tumour.runs.empty() && !vein.runs.empty()) {
      EXPECT_NEAR(tumourMeasures(made)[0].vesselMm.value(), shortest, 1e-9);
    }
  }
}

TEST(TumourMeasures, WithoutVesselsSayNothingAboutThem) {
  const ImageGeometry g = gridOf({30, 30, 20}, kLesionSpacing);
  const auto measured =
      tumourMeasures(newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(12, 12, 25), 9)},
                                                         {"met", StructureKind::Tumour, ball(Vec3(12, 12, 25), 3)}})));
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_FALSE(measured[0].vesselMm);
  EXPECT_TRUE(Json::parse(toJson(measured))[0]["nearestVessel"].is_null());
}

}  // namespace
}  // namespace glisson
