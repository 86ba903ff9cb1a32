#include "planning/volumetry/box_fraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "planning/volumetry/convex.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {

using test::randomDirection;

std::array<double, 3> widthsOf(const Box& box, const Vec3& normal) {
  const Vec3 w = 2 * normal.cwiseAbs().cwiseProduct(box.half);
  return {w[0], w[1], w[2]};
}

TEST(BoxFraction, CubeAlongItsDiagonalHasTheKnownPolynomial) {
  const std::array<double, 3> w{1, 1, 1};
  EXPECT_NEAR(cutBox(-1.0, w).fraction, 0.125 / 6, 1e-15);
  EXPECT_NEAR(cutBox(-0.5, w).fraction, 1.0 / 6, 1e-15);
  EXPECT_NEAR(cutBox(0.0, w).fraction, 0.5, 1e-15);
  EXPECT_NEAR(cutBox(0.5, w).fraction, 5.0 / 6, 1e-15);
  EXPECT_NEAR(cutBox(0.0, w).density, 0.75, 1e-15);
}

TEST(BoxFraction, AxisParallelPlaneIsLinear) {
  for (const double d : {-0.8, -0.3, 0.0, 0.2, 0.79}) {
    EXPECT_NEAR(cutBox(d, {0, 1.6, 0}).fraction, (d + 0.8) / 1.6, 1e-15);
    EXPECT_NEAR(cutBox(d, {0, 1.6, 0}).density, 1 / 1.6, 1e-15);
  }
  EXPECT_EQ(cutBox(0.8, {0, 1.6, 0}).fraction, 1);
  EXPECT_EQ(cutBox(-0.81, {0, 1.6, 0}).fraction, 0);
}

TEST(BoxFraction, FaceSharedByTwoBoxesCountsOnce) {
  EXPECT_NEAR(cutBox(-0.8, {0, 0, 1.6}).density, 1 / 1.6, 1e-15);
  EXPECT_EQ(cutBox(0.8, {0, 0, 1.6}).density, 0);
}

TEST(BoxFraction, IsExactAtAnyAngle) {
  // The oracle clips the box as a polyhedron: other arithmetic altogether.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  double worstArea = 0;
  for (int n = 0; n < 20000; ++n) {
    Vec3 normal = randomDirection(random);
    if (n % 4 == 1) {
      normal = Vec3(normal[0] * std::pow(10.0, -n % 13), normal[1], normal[2]).normalized();
    } else if (n % 4 == 2) {
      normal = Vec3(normal[0] * std::pow(10.0, -n % 13), normal[1] * std::pow(10.0, -n % 11), 1).normalized();
    }
    const Box box{Vec3::Zero(), Vec3(0.285 * (1 + n % 50), 0.285, 0.8)};
    ImagePlane plane{normal, 0};
    plane.offset = unit(random) * plane.support(box.half);
    const BoxCut cut = cutBox(plane.offset, widthsOf(box, normal));
    const double volume = 8 * box.half.prod();
    worst = std::max(worst, std::abs(cut.fraction - volumeOf(box, {&plane, 1}) / volume));
    worstArea =
        std::max(worstArea, std::abs(cut.density * volume - areaOf(sectionOf(box, plane))) / (1 + areaOf(sectionOf(box, plane))));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worstArea, 1e-9);
}

TEST(BoxFraction, BothSidesAddUpToOne) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 10000; ++n) {
    const Vec3 normal = randomDirection(random);
    const std::array<double, 3> w = widthsOf({Vec3::Zero(), Vec3(5, 0.3, 0.8)}, normal);
    const double d = unit(random) * 0.5 * (w[0] + w[1] + w[2]);
    EXPECT_NEAR(cutBox(d, w).fraction + cutBox(-d, w).fraction, 1, 1e-14);
  }
}

TEST(BoxFraction, RunIsTheSumOfItsVoxels) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vec3 spacing(0.57, 0.57, 1.6);
  for (int n = 0; n < 2000; ++n) {
    ImagePlane plane{randomDirection(random), 0};
    const Box run = boxOf({0, 0, 0, 40}, spacing);
    plane.offset = unit(random) * plane.support(run.half) - plane.normal.dot(run.centre);
    double sum = 0;
    for (int i = 0; i < 40; ++i) {
      const Box voxel = boxOf({i, 0, 0, 1}, spacing);
      sum += cutBox(plane.distance(voxel.centre), widthsOf(voxel, plane.normal)).fraction;
    }
    EXPECT_NEAR(cutBox(plane.distance(run.centre), widthsOf(run, plane.normal)).fraction * 40, sum, 1e-11);
  }
}

TEST(ConvexBody, IntersectionsOfPlanesHaveTheirVolume) {
  const Box box{Vec3(1, 2, 3), Vec3(1, 2, 3)};
  const auto at = [&](const Vec3& normal, double beyond) { return ImagePlane{normal, -normal.dot(box.centre) - beyond}; };
  const std::vector<ImagePlane> octant{at(Vec3::UnitX(), 0), at(Vec3::UnitY(), 0), at(-Vec3::UnitZ(), 0)};
  EXPECT_NEAR(volumeOf(box, octant), 6, 1e-12);
  const std::vector<ImagePlane> slab{at(Vec3::UnitX(), -0.25), at(-Vec3::UnitX(), -0.25)};
  EXPECT_NEAR(volumeOf(box, slab), 0.5 * 4 * 6, 1e-12);
  const std::vector<ImagePlane> twice{at(Vec3::UnitX(), 0), at(Vec3::UnitX(), 0)};
  EXPECT_NEAR(volumeOf(box, twice), 24, 1e-12);
  const std::vector<ImagePlane> nothing{at(Vec3::UnitX(), 0), at(-Vec3::UnitX(), 0)};
  EXPECT_NEAR(volumeOf(box, nothing), 0, 1e-12);
  const std::vector<ImagePlane> face{at(Vec3::UnitX(), -1)};  // a half-space that ends at the box's own face
  EXPECT_NEAR(volumeOf(box, face), 48, 1e-12);
}

TEST(ConvexBody, PartsOfABoxAddUpForRandomPlanes) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-0.4, 0.4);
  const Box box{Vec3(10, -20, 30), Vec3(0.285, 0.285, 0.8)};
  for (int n = 0; n < 3000; ++n) {
    std::vector<ImagePlane> planes;
    for (int p = 0; p < 3; ++p) {
      ImagePlane plane{randomDirection(random), 0};
      plane.offset = unit(random) - plane.normal.dot(box.centre);
      planes.push_back(plane);
    }
    double sum = 0;
    for (unsigned sides = 0; sides < 8; ++sides) {
      std::vector<ImagePlane> part = planes;
      for (unsigned p = 0; p < 3; ++p) {
        if ((sides >> p & 1U) != 0) {
          part[p] = {-part[p].normal, -part[p].offset};
        }
      }
      sum += volumeOf(box, part);
    }
    EXPECT_NEAR(sum, 8 * box.half.prod(), 1e-12);
  }
}

}  // namespace
}  // namespace glisson
