#include "planning/volumetry/tumour_depth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <random>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/convex_projection.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

TEST(TumourDepth, BetweenTwoResectionsIsThatOfTheMiddle) {
  const ImageGeometry g = gridOf({81, 41, 41}, Vec3(1, 1, 1), Vec3(-40, -20, -20));
  const auto box = [](const Vec3& half) -> Inside { return [=](const Vec3& p) { return (p.cwiseAbs() - half).maxCoeff() < 0; }; };
  const Case liver = newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, box({30, 15, 15})},
                                                         {"tumour", StructureKind::Tumour, box({8, 4, 4})}}));
  const PlanAssessment r =
      PlanAssessor(liver).assess(planOf({{{Vec3(-5, 0, 0), -Vec3::UnitX()}}, {{Vec3(5, 0, 0), Vec3::UnitX()}}}));
  ASSERT_EQ(r.tumours.at(0).state, TumourState::Cut);
  EXPECT_NEAR(r.tumours[0].marginMm.value(), -5, 0.05);
  EXPECT_NEAR(r.tumours[0].marginAtLeastMm.value(), -5.5, 0.05);
}

TEST(TumourDepth, BetweenFacesSideBySideThroughALargeTumourIsFoundWithinTheFrame) {
  VoxelRows tumour;  // 80 mm across: every point of a plane through it is the deepest
  for (int k = 0; k < 50; ++k) {
    for (int j = 0; j < 140; ++j) {
      append(tumour, {0, j, k, 140});
    }
  }
  const Vec3 spacing(0.57, 0.57, 1.6);
  std::vector<ImageResection> plan(2);
  Vec3 along;
  const auto start = std::chrono::steady_clock::now();
  for (const Vec3& normal : {Vec3(0.8, 0.6, 0), Vec3(1, 1, 1.001), Vec3(0.8, 0.4, 0.447), Vec3(0.3, 0.3, 0.906)}) {
    const Vec3 n = normal.normalized();
    plan[0].planes = {{-n, n.dot(Vec3(40, 40, 40)) - 5}};
    plan[1].planes = {{n, -n.dot(Vec3(40, 40, 40)) - 5}};
    EXPECT_NEAR(greatestDepth(tumour, spacing, plan, along), 5, 1e-6);
  }
  RecordProperty("milliseconds",
                 std::to_string(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()));
}

/// The distance of a point to the half-spaces' intersection, by projecting again and again (Dykstra).
double distanceTo(const ImageResection& resection, const Vec3& p) {
  Vec3 at = p;
  std::vector<Vec3> corrections(resection.planes.size(), Vec3::Zero());
  double moved = 1;
  for (int turn = 0; turn < 2000 && moved > 1e-12; ++turn) {  // a turn that changes nothing is the last one
    moved = 0;
    for (std::size_t n = 0; n < resection.planes.size(); ++n) {
      const Vec3 before = at + corrections[n];
      at = before + std::max(0.0, -resection.planes[n].distance(before)) * resection.planes[n].normal;
      moved += (before - at - corrections[n]).norm();
      corrections[n] = before - at;
    }
  }
  return (at - p).norm();
}

TEST(TumourDepth, TheWayToUpToFourHalfSpacesIsThatOfRepeatedProjection) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  int inside = 0;
  for (int n = 0; n < test::trials(400); ++n) {
    ImageResection resection;
    const Vec3 common = 5 * any();  // a point of all of them: the intersection is not empty
    for (int plane = 0; plane <= n % 4; ++plane) {
      const Vec3 along = any().normalized();
      resection.planes.push_back({along, -along.dot(common) + std::abs(normal(random))});
    }
    const Vec3 p = 10 * any();
    double depth = 1e9;
    Vec3 along = Vec3::Zero();
    keepProjection(p, resection.planes, depth, along);
    EXPECT_NEAR(depth, distanceTo(resection, p), 2e-3) << n;
    inside += depth == 0 ? 1 : 0;
    for (const ImagePlane& plane : resection.planes) {
      EXPECT_GE(plane.distance(p + depth * along), -1e-6) << n;
    }
  }
  EXPECT_GT(inside, 0);
  const std::vector<ImagePlane> apart{{Vec3::UnitX(), -1}, {-Vec3::UnitX(), -1}};  // x >= 1 and x <= -1
  double depth = 7;
  Vec3 along = Vec3::UnitZ();
  keepProjection(Vec3::Zero(), apart, depth, along);
  EXPECT_EQ(depth, 7);
  EXPECT_EQ(along, Vec3(Vec3::UnitZ()));
}

TEST(TumourDepth, UnderSeveralResectionsIsWhatAllPointsOfItsBoxesGive) {
  const Vec3 spacing(0.8, 0.9, 2.5);
  VoxelRows tumour;
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 3; ++j) {
      append(tumour, {j, j, k, 9});
    }
  }
  std::mt19937 random(31);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return Vec3(normal(random), normal(random), normal(random)).normalized(); };
  for (int n = 0; n < test::trials(12); ++n) {
    std::vector<ImageResection> plan(2 + static_cast<std::size_t>(n % 3));
    for (std::size_t r = 0; r < plan.size(); ++r) {
      for (std::size_t p = 0; p < (n % 2 == 0 ? 1 : 1 + r % 2); ++p) {
        const Vec3 along = direction();
        plan[r].planes.push_back({along, -along.dot(Vec3(4, 1, 1)) - 2 - 0.5 * std::abs(normal(random))});
      }
    }
    Vec3 along;
    const double depth = greatestDepth(tumour, spacing, plan, along);
    double brute = 0;
    constexpr int kSteps = 4;  // points of each voxel along an axis
    for (const RowRun& run : tumour.runs) {
      const Box box = boxOf(run, spacing);
      for (int i = 0; i <= kSteps * run.n; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
          for (int k = 0; k <= kSteps; ++k) {
            const Vec3 share(static_cast<double>(i) / (kSteps * run.n), static_cast<double>(j) / kSteps,
                             static_cast<double>(k) / kSteps);
            const Vec3 p = box.centre + (2 * share - Vec3::Ones()).cwiseProduct(box.half);
            double least = 1e9;
            for (const ImageResection& resection : plan) {
              least = std::min(least, distanceTo(resection, p));
            }
            brute = std::max(brute, least);
          }
        }
      }
    }
    EXPECT_GE(depth, brute - 0.051) << n;
    EXPECT_LE(depth, brute + 0.5 * spacing.norm() / kSteps) << n;
  }
}

}  // namespace
}  // namespace glisson
