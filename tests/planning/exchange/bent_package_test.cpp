// Packages of plans with bent planes: parts that are closed and add up, a surface that follows the bend, a plan.json that says so.

#include <gtest/gtest.h>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/mesh_files.h"
#include "planning/exchange/package.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/mesh/self_intersection.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/exchange/synthetic_case.h"

namespace glisson {
namespace {

using test::kLiverCentre;
using test::kLiverRadiusMm;
using test::Scratch;
using test::stamped;
using test::syntheticCase;
/// The tumour's side, the plane bowed by up to 12 mm and skewed.
ResectionPlane bowed(const HalfSpace& plane) {
  ResectionPlane bent(plane, flatBend(plane, 45));
  bent.bend->heightsMm = {-12, -4, -3, -9, 2, 14, 13, 3, 1, 15, 12, 6, -10, -2, 2, -7};
  return bent;
}

Case bentCase() {
  Case source = syntheticCase();
  ResectionPlane& plane = source.plans[0].resections[0].planes[0];
  plane = bowed(plane);
  return source;
}

TEST(BentPackage, PartsAreClosedAddUpAndTheSurfaceFollowsTheBend) {
  const Scratch scratch;
  const Case source = bentCase();
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  EXPECT_EQ(verifyPackage(folder), std::vector<std::string>{});
  const SurfaceMesh whole = readMesh(folder / "parenchyma.stl");
  const SurfaceMesh remnant = readMesh(folder / "remnant.stl");
  const SurfaceMesh resected = readMesh(folder / "resected_01.stl");
  const SurfaceMesh surface = readMesh(folder / "resection_surface_01.stl");
  for (const SurfaceMesh* part : {&remnant, &resected}) {
    EXPECT_FALSE(part->defects().any());
    EXPECT_EQ(countSelfIntersections(*part), 0U);
  }
  EXPECT_NEAR(signedVolumeMm3(remnant) + signedVolumeMm3(resected), signedVolumeMm3(whole), 1e-5 * signedVolumeMm3(whole));
  const BentSurface bent(source.plans[0].resections[0].planes[0]);
  for (const Triangle& t : surface.triangles) {
    const auto& v = surface.vertices;
    ASSERT_NEAR(bent.above((v[t[0]] + v[t[1]] + v[t[2]]) / 3), 0, kCurvedCutMm);
    ASSERT_GT((v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).dot(bent.normal()), 0) << "it faces the resected side";
  }
  for (const Vec3& v : resected.vertices) {
    ASSERT_GE(bent.above(v), -1e-3);
  }
  for (const Vec3& v : remnant.vertices) {
    ASSERT_LE(bent.above(v), 1e-3);
  }
}

TEST(BentPackage, MeshAndVoxelsAgreeOnTheShareThatIsResected) {
  const Scratch scratch;
  const Case source = bentCase();
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const double meshShare =
      signedVolumeMm3(readMesh(folder / "resected_01.stl")) / signedVolumeMm3(readMesh(folder / "parenchyma.stl"));
  const PlanAssessment assessed = PlanAssessor(source).assess(source.plans[0]);
  EXPECT_NEAR(assessed.resectedMl / assessed.totalMl, meshShare, 0.004);
  const Json plan = Json::parse(readWholeFile(folder / "plan.json"));
  EXPECT_NEAR(plan.at("assessment").at("resectedMl").get<double>(), assessed.resectedMl, 1e-9);
}

TEST(BentPackage, PlanJsonHasTheBendAndAnotherFormatVersion) {
  const Scratch scratch;
  const Case source = bentCase();
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const Json plan = Json::parse(readWholeFile(folder / "plan.json"));
  EXPECT_EQ(plan.at("formatVersion"), 2);
  const Json& bend = plan.at("resections").at(0).at("planes").at(0).at("bend");
  const Bend& made = *source.plans[0].resections[0].planes[0].bend;
  EXPECT_EQ((bend.at("heightsMm").get<std::array<double, 16>>()), made.heightsMm);
  EXPECT_EQ(bend.at("halfSizeMm").get<double>(), made.halfSizeMm);
  EXPECT_EQ(bend.at("u").at(1).get<double>(), made.u[1]);
  const BentSurface surface(source.plans[0].resections[0].planes[0]);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bend.at("v").at(static_cast<std::size_t>(axis)).get<double>(), surface.v()[axis], 1e-12);
  }
  EXPECT_EQ(bend.at("order"), "[4 j + i]: i along u, j along v");
  const std::filesystem::path flat = exportPackage(syntheticCase(), scratch.path / "flat", stamped()).folder;
  EXPECT_EQ(Json::parse(readWholeFile(flat / "plan.json")).at("formatVersion"), 1);
}

TEST(BentPackage, WedgeOfABentAndAFlatPlaneIsWholeToo) {
  const Scratch scratch;
  Case source = bentCase();
  source.plans[0].resections[0].planes.emplace_back(kLiverCentre + Vec3(0, -8, 0), Vec3(0.2, 1, 0.1).normalized());
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  EXPECT_EQ(verifyPackage(folder), std::vector<std::string>{});
  double sum = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("remnant") || name == "resected_01.stl") {
      sum += signedVolumeMm3(readMesh(entry.path()));
    }
  }
  const double whole = signedVolumeMm3(readMesh(folder / "parenchyma.stl"));
  EXPECT_NEAR(sum, whole, 1e-5 * whole);
}

TEST(BentPackage, SurfaceOfAWedgeReachesItsEdgeInEitherOrderOfThePlanes) {
  std::array<double, 2> areas{};
  for (const std::size_t order : {0U, 1U}) {
    const Scratch scratch;
    Case source = bentCase();
    std::vector<ResectionPlane>& planes = source.plans[0].resections[0].planes;
    planes.emplace_back(kLiverCentre + Vec3(0, -8, 0), Vec3(0.2, 1, 0.1).normalized());
    if (order == 1) {
      std::swap(planes[0], planes[1]);
    }
    const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
    areas[order] = areaMm2(readMesh(folder / "resection_surface_01.stl"));
    const double assessed = PlanAssessor(source).assess(source.plans[0]).resections.at(0).cutAreaMm2;
    EXPECT_NEAR(areas[order], assessed, 0.01 * assessed);
  }
  EXPECT_NEAR(areas[0], areas[1], 0.002 * areas[1]);
}

TEST(BentPackage, SurfaceFollowsTheBendBesideItsSquareToo) {
  const Scratch scratch;
  Case source = syntheticCase();
  ResectionPlane& plane = source.plans[0].resections[0].planes[0];
  plane.bend = flatBend(plane, 20);
  for (std::size_t n = 0; n < 16; ++n) {
    plane.bend->heightsMm[n] = 0.5 * 20 * (2.0 * static_cast<double>(n % 4) / 3 - 1);  // no curvature inside
  }
  const std::filesystem::path folder = exportPackage(source, scratch.path, stamped()).folder;
  const SurfaceMesh surface = readMesh(folder / "resection_surface_01.stl");
  const BentSurface bent(plane);
  double farthest = 0;
  for (const Triangle& t : surface.triangles) {
    const auto& v = surface.vertices;
    const Vec3 middle = (v[t[0]] + v[t[1]] + v[t[2]]) / 3;
    ASSERT_NEAR(bent.above(middle), 0, kCurvedCutMm);
    farthest = std::max(farthest, std::abs(bent.u().dot(middle - bent.origin())));
  }
  EXPECT_GT(farthest, 21) << "the cut goes beyond the square";
}

TEST(BentPackage, BendBesideTheLiverIsRefusedAsAPlaneIs) {
  const Scratch scratch;
  Case source = bentCase();
  source.plans[0].resections[0].planes[0].origin += Vec3(-kLiverRadiusMm - 30, 0, 0);
  EXPECT_THROW(exportPackage(source, scratch.path, stamped()), PlanningError);
  EXPECT_EQ(scratch.entries(), 0U);
}

}  // namespace
}  // namespace glisson
