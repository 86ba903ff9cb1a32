#include "planning/volumetry/tumour_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/parallel.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;

/// Two tumours in an oblique, anisotropic grid.
Case obliqueCase() {
  ImageGeometry g = gridOf({60, 50, 24}, Vec3(0.8, 0.9, 2.5), Vec3(10, -20, 30));
  g.direction = (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(-0.3, Vec3::UnitY())).toRotationMatrix();
  const Vec3 middle = g.toWorld(Vec3(30, 25, 12));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(middle, 18)},
                                             {"one", StructureKind::Tumour, ball(middle + Vec3(5, 2, 1), 4)},
                                             {"two", StructureKind::Tumour, ball(middle - Vec3(6, 4, 3), 3)}}));
}

TumourDistance::Way nearestOfAll(const Case& source, const Vec3& point) {
  const ImageGeometry& g = source.liver->geometry;
  const Vec3 p = g.direction.transpose() * (point - g.origin);
  TumourDistance::Way best;
  for (const LabelledMask& structure : source.segmentation->structures) {
    if (structure.kind != StructureKind::Tumour) {
      continue;
    }
    for (const RowRun& run : rowsOf(*structure.mask).runs) {
      const Box box = boxOf(run, g.spacing);
      const Vec3 step = p.cwiseMax(box.centre - box.half).cwiseMin(box.centre + box.half) - p;
      if (step.norm() < best.mm) {
        best.mm = step.norm();
        best.atLeastMm = best.mm > 0 ? best.mm - resolutionMm(step / best.mm, g.spacing) : 0;
      }
    }
  }
  return best;
}

TEST(TumourDistance, IsThatToTheNearestOfAllBoxes) {
  const Case source = obliqueCase();
  const TumourDistance distance(source);
  std::mt19937 random(9);
  std::normal_distribution<double> normal(0, 12);
  const Vec3 middle = source.liver->geometry.toWorld(Vec3(30, 25, 12));
  for (int n = 0; n < 500; ++n) {
    const Vec3 point = middle + Vec3(normal(random), normal(random), normal(random));
    const TumourDistance::Way expected = nearestOfAll(source, point);
    const TumourDistance::Way way = distance.from(point);
    EXPECT_NEAR(way.mm, expected.mm, 1e-9);
    EXPECT_NEAR(way.atLeastMm, expected.atLeastMm, 1e-6);
    EXPECT_EQ(distance.from(point, expected.mm + 1e-6).mm, way.mm);
    EXPECT_TRUE(std::isinf(distance.from(point, 0.99 * expected.mm).mm) || expected.mm == 0);
  }
}

TEST(TumourDistance, OfACaseWithoutTumoursIsInfinite) {
  const ImageGeometry g = gridOf({20, 20, 20}, Vec3(1, 1, 1));
  const Case source = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(10, 10, 10), 8)}}));
  const TumourDistance distance(source);
  EXPECT_TRUE(distance.empty());
  EXPECT_TRUE(std::isinf(distance.from(Vec3(10, 10, 10)).mm));
}

TEST(TumourDistance, LeastOnTheSurfaceIsTheMarginOfThePlan) {
  const Case source = obliqueCase();
  const Vec3 middle = source.liver->geometry.toWorld(Vec3(30, 25, 12));
  const Vec3 normal = Vec3(1, 0.3, 0.2).normalized();
  const HalfSpace plane{middle - 2 * normal, normal};
  const PlanAssessment assessment = PlanAssessor(source).assess(planOf({{plane}}));
  double margin = 1e9;
  for (const TumourAssessment& tumour : assessment.tumours) {
    margin = std::min(margin, tumour.marginMm.value_or(tumour.distanceMm.value_or(1e9)));
  }
  const Vec3 u = normal.unitOrthogonal();
  const PlaneGrid grid{plane.origin - 12 * u - 12 * normal.cross(u), u, normal.cross(u), 0.25, 97, 97};
  const MarginMap map = marginMap(TumourDistance(source), grid, 100);
  double least = 1e9;
  for (const TumourDistance::Way& way : map.ways) {
    least = std::min(least, way.mm);
  }
  EXPECT_GE(least, margin - 1e-9);
  EXPECT_LE(least, margin + 0.25);
  const ThreadLimit limit(1);
  const MarginMap again = marginMap(TumourDistance(source), grid, 100);
  for (std::size_t n = 0; n < map.ways.size(); ++n) {
    ASSERT_EQ(map.ways[n].mm, again.ways[n].mm);
    ASSERT_EQ(map.ways[n].atLeastMm, again.ways[n].atLeastMm);
  }
}

}  // namespace
}  // namespace glisson
