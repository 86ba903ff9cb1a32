// Hazard H7: a part that is sound in double precision and crosses itself once a file's floats hold it. Coordinates of a CT whose
// table stands 1.2 m from its origin, where neighbouring floats are 1.2e-4 mm apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/glb_reader.h"
#include "planning/exchange/mesh_files.h"
#include "planning/exchange/package.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/cut.h"
#include "reconstruction/mesh/self_intersection.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/exchange/synthetic_case.h"

namespace glisson {
namespace {

using test::Scratch;

const Vec3 kFarCentre{-14.3, -33.7, -1183.4};

/// A liver-sized body with the unevenness of a surface extracted from voxels, some of its vertices within micrometres of x = 0.
SurfaceMesh unevenBody(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&random] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  SurfaceMesh mesh = test::sphere(Vec3::Zero(), 70, 5);
  for (Vec3& v : mesh.vertices) {
    const double wave = 1 + 0.06 * std::sin(v.x() / 7) * std::cos(v.y() / 9) + 0.04 * std::sin(v.z() / 5);
    v = Vec3(wave * v) + 0.15 * Vec3(uniform(), uniform(), uniform()) + kFarCentre;
    if (std::abs(v.x()) < 0.6) {
      v.x() *= std::pow(10.0, -4.0 + 2.0 * uniform());
    }
  }
  return mesh;
}

std::vector<ResectionPlane> manyPlanes() {
  std::vector<ResectionPlane> planes;
  std::mt19937 random(7);
  const auto uniform = [&random] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  for (const double x : {0.0, -14.0, 3.3, 20.1}) {
    planes.push_back({{x, kFarCentre.y(), kFarCentre.z()}, Vec3::UnitX()});
  }
  planes.push_back({{0, 0, -1160.0}, Vec3::UnitZ()});
  for (int n = 0; n < 11; ++n) {
    const Vec3 normal = Vec3(uniform(), uniform(), uniform()).normalized();
    planes.push_back({kFarCentre + 30 * uniform() * normal, normal});
  }
  return planes;
}

std::size_t crossings(const SurfaceMesh& mesh) { return countSelfIntersections(roundedToFloat(mesh)); }

/// By the bits: a double that is a float of normal size ends in 29 zeros.
bool isOnFloats(const Vec3& v) {
  constexpr std::uint64_t kBeyondFloat = (std::uint64_t{1} << 29U) - 1;
  return std::all_of(v.begin(), v.end(), [](double value) { return (std::bit_cast<std::uint64_t>(value) & kBeyondFloat) == 0; });
}

TEST(CutForFloats, LeavesNoSelfIntersectionInTheFileWhereAnExactCutDoes) {
  std::size_t ofExactCuts = 0;
  const SurfaceMesh mesh = roundedToFloat(unevenBody(1));
  ASSERT_EQ(countSelfIntersections(mesh), 0U);
  const double spacing = floatSpacingMm(mesh);
  EXPECT_EQ(spacing, std::ldexp(1.0, -13));
  for (const HalfSpace& plane : manyPlanes()) {
    const CutResult exact = cut(mesh, plane);
    ofExactCuts += crossings(exact.positive) + crossings(exact.negative);
    const CutResult halves = cutForFloats(mesh, plane);
    for (const SurfaceMesh* half : {&halves.positive, &halves.negative}) {
      const SurfaceMesh held = roundedToFloat(*half);
      EXPECT_EQ(countSelfIntersections(held), 0U) << plane.normal.transpose();
      EXPECT_FALSE(held.defects().any()) << held.defects().names().front();
      for (const Vec3& v : half->vertices) {
        ASSERT_TRUE(isOnFloats(v)) << v.transpose();
      }
      EXPECT_EQ(held.triangles.size(), half->triangles.size());  // it is on floats already
    }
    EXPECT_EQ(countSelfIntersections(roundedToFloat(halves.section)), 0U);
    const double sum = signedVolumeMm3(halves.positive) + signedVolumeMm3(halves.negative);
    EXPECT_NEAR(sum, signedVolumeMm3(mesh), 40 * spacing * areaMm2(exact.section) + 1.0);
    EXPECT_NEAR(signedVolumeMm3(halves.positive), signedVolumeMm3(exact.positive), 40 * spacing * areaMm2(exact.positive));
    EXPECT_NEAR(areaMm2(halves.section), areaMm2(exact.section), 1e-3 * areaMm2(exact.section));
    for (const Vec3& v : halves.section.vertices) {
      ASSERT_LE(std::abs(plane.normal.dot(v - plane.origin)), 9 * spacing);
    }
  }
  EXPECT_GT(ofExactCuts, 0U);  // else the body is too easy to show anything
}

Case farCase(const std::vector<ResectionPlane>& planes) {
  Case source = test::syntheticCase();
  test::replaceStructure(source, "parenchyma", [](Structure&, Reconstruction& made) { made.mesh = unevenBody(3); });
  source.plans.front().resections.clear();
  source.plans.front().resections.push_back({"Resection 1", planes});
  return source;
}

TEST(Package, NoClosedPartCrossesItselfAsItsFileHoldsItFarFromTheOrigin) {
  const std::vector<ResectionPlane> planes = manyPlanes();
  for (const std::vector<ResectionPlane>& chosen :
       {std::vector{planes[0]}, std::vector{planes[5]}, std::vector{planes[0], {kFarCentre, -Vec3::UnitZ()}}}) {
    const Scratch scratch;
    const auto folder = exportPackage(farCase(chosen), scratch.path, test::stamped()).folder;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".stl") {
        EXPECT_EQ(countSelfIntersections(readMesh(entry.path())), 0U) << entry.path().filename();
      }
    }
    for (const GlbNode& node : parseGlb(readWholeFile(folder / "model.glb"), "model.glb").nodes) {
      EXPECT_EQ(countSelfIntersections(node.mesh), 0U) << node.id;
    }
  }
}

TEST(Package, APartThatRoundingMakesCrossItselfIsRefused) {
  // Two nested shells 1e-5 mm apart: sound in double precision, on one another's places in floats.
  Case source = test::syntheticCase();
  test::replaceStructure(source, "tumour_01", [](Structure&, Reconstruction& made) {
    SurfaceMesh mesh = test::sphere(kFarCentre, 5, 3);
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::size_t triangles = mesh.triangles.size();
    for (std::uint32_t n = 0; n < count; ++n) {
      mesh.vertices.push_back(kFarCentre + (5 - 4e-5) * (mesh.vertices[n] - kFarCentre) / 5);
    }
    for (std::size_t n = 0; n < triangles; ++n) {
      const Triangle t = mesh.triangles[n];
      mesh.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
    }
    made.mesh = std::move(mesh);
  });
  const Scratch scratch;
  EXPECT_THROW(exportPackage(source, scratch.path, test::stamped()), CheckFailed);
  EXPECT_EQ(scratch.entries(), 0U);
}

}  // namespace
}  // namespace glisson
