// The list of methods: every one is named, found, and makes closed, outward surfaces near the body, the same bytes always.
#include "reconstruction/methods/methods.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>

#include "bodies.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/parallel.h"
#include "reconstruction/reconstruct.h"

namespace glisson {
namespace {

using test::Body;
using test::bodyWhere;

const Vec3 kCentre(15.2, 14.9, 15.4);
constexpr double kRadius = 11;

Body ball() {
  return bodyWhere({38, 38, 20}, Vec3(0.8, 0.8, 1.6), [](const Vec3& p) { return (p - kCentre).norm() < kRadius; });
}

struct Named {
  const ReconstructionMethod* method;
  const MethodVariant* variant;
};
std::vector<Named> allVariants() {
  std::vector<Named> all;
  for (const ReconstructionMethod& method : listedMethods()) {
    for (const MethodVariant& variant : method.variants) {
      all.push_back({&method, &variant});
    }
  }
  return all;
}

TEST(Methods, AreNamedOnceByWhatFilesAndFlagsCanHold) {
  std::set<std::string> models;
  for (const auto& [method, variant] : allVariants()) {
    for (const std::string& id : {method->id, variant->id}) {
      EXPECT_FALSE(id.empty());
      EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_."), std::string::npos) << id;
    }
    EXPECT_NE(method->id, "psr");
    EXPECT_NE(method->id, "mcsd");
    EXPECT_FALSE(method->name.empty());
    EXPECT_TRUE(method->description.ends_with('.')) << method->id;
    EXPECT_NE(method->citation.find("20"), std::string::npos) << method->id;
    EXPECT_TRUE(models.insert(method->id + "_" + variant->id).second) << variant->id;
  }
  for (const ReconstructionMethod& method : listedMethods()) {
    EXPECT_EQ(&listedMethod(method.id), &method);
    EXPECT_EQ(variantOf(method, "").id, method.usual);
  }
  for (const char* paper : {"psr_knn", "mpu", "vessels"}) {
    EXPECT_EQ(listedMethod(paper).id, paper);
  }
}

TEST(Methods, AnUnknownNameIsRefusedWithThoseThereAre) {
  const auto refusal = [](const auto& act) {
    try {
      act();
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal([] { listedMethod("magic"); }),
            "There is no reconstruction method \"magic\"; choose psr, mcsd, psr_knn, mpu, vessels.");
  EXPECT_EQ(refusal([] { variantOf(listedMethod("psr_knn"), "d9"); }),
            "The method psr_knn has no variant \"d9\"; choose d5, d6, d7, d8, d7_k40.");
}

TEST(Methods, MakeOneClosedOutwardPieceNearTheBall) {
  const Body body = ball();
  for (const auto& [method, variant] : allVariants()) {
    const std::string what = method->id + " " + variant->id;
    const MethodSurface made = variant->make({body.mask, body.geometry}, {});
    for (const std::string& name : made.mesh.defects().names()) {
      ADD_FAILURE() << what << ": " << name;
    }
    EXPECT_EQ(eulerCharacteristic(made.mesh), 2) << what;
    EXPECT_NEAR(signedVolumeMm3(made.mesh) / (static_cast<double>(body.mask.count()) * body.geometry.voxelVolumeMm3()), 1, 0.04)
        << what;
    EXPECT_LT(voxelError(made.mesh, body.mask, body.geometry).mean, 0.4) << what;
    EXPECT_GT(made.cellMm, 0) << what;
    EXPECT_GT(made.sampleSeconds + made.solveSeconds + made.extractSeconds, 0) << what;
  }
}

TEST(Methods, OfBodiesOfFewVoxelsAreClosedAndOfTheirSize) {
  for (const int side : {1, 2, 3}) {
    const Body cube = bodyWhere({12, 12, 12}, Vec3(0.8, 0.8, 1.6), [side](const Vec3& p) {
      const Vec3 index = p.cwiseQuotient(Vec3(0.8, 0.8, 1.6));
      return index.minCoeff() > 3.5 && index.maxCoeff() < 3.5 + side;
    });
    const double voxelsMm3 = static_cast<double>(cube.mask.count()) * cube.geometry.voxelVolumeMm3();
    for (const auto& [method, variant] : allVariants()) {
      const std::string what = method->id + " " + variant->id + " " + std::to_string(side);
      const SurfaceMesh mesh = variant->make({cube.mask, cube.geometry}, {}).mesh;
      EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{}) << what;
      // The body whose corners are the six faces' centres has a sixth of a voxel's volume.
      EXPECT_GT(signedVolumeMm3(mesh), (side == 1 ? 0.12 : 0.4) * voxelsMm3) << what;
      EXPECT_LT(signedVolumeMm3(mesh), 2.5 * voxelsMm3) << what;
    }
  }
}

TEST(Methods, MakeTheSameBytesForAnyNumberOfThreads) {
  const Body body = ball();
  for (const ReconstructionMethod& method : listedMethods()) {
    const auto make = [&](int threads) {
      const ThreadLimit limit(threads);
      return variantOf(method, "").make({body.mask, body.geometry, Sampling::Paper}, {}).mesh;
    };
    const SurfaceMesh one = make(1);
    const SurfaceMesh two = make(2);
    EXPECT_EQ(one.vertices, two.vertices) << method.id;
    EXPECT_EQ(one.triangles, two.triangles) << method.id;
  }
}

TEST(Methods, ReconstructChecksThemLikeTheOthers) {
  const Body body = ball();
  ReconstructionParameters parameters;
  parameters.method = Method::Listed;
  parameters.listedMethod = "mpu";
  parameters.listedVariant = "e0.01";
  parameters.simplify = SimplifyTarget{.triangles = 500};
  const Reconstruction made = reconstruct(body.mask, body.geometry, StructureKind::Tumour, parameters);
  EXPECT_EQ(made.parameters.describe(), "MPU implicits eps=0.01, simplified to 500 triangles");
  EXPECT_LE(made.mesh.triangles.size(), 500U);
  EXPECT_FALSE(made.defects.any());
  EXPECT_EQ(made.meshComponents, 1U);
  EXPECT_NEAR(made.volumeDeviation(), 0, 0.04);
  parameters.listedMethod = "magic";
  EXPECT_THROW(reconstruct(body.mask, body.geometry, StructureKind::Tumour, parameters), UsageError);
}

TEST(Methods, StopOnCancelAndRefuseAnEmptyMask) {
  const Body body = ball();
  const ExecutionContext context;
  context.cancel();
  for (const auto& [method, variant] : allVariants()) {
    EXPECT_THROW(variant->make({body.mask, body.geometry}, context), Cancelled) << method->id;
    EXPECT_THROW(variant->make({Mask(), body.geometry}, {}), ReconstructionError) << method->id;
  }
}

TEST(ScaleAdaptiveVessels, HaveLargeTrianglesWhereTheSurfaceIsFlatAndSmallOnesWhereItIsCurved) {
  const Vec3 centre(12.1, 12.1, 12.1);
  const Body cube =
      bodyWhere({48, 48, 48}, Vec3::Constant(0.5), [&](const Vec3& p) { return (p - centre).cwiseAbs().maxCoeff() < 9; });
  const SurfaceMesh mesh = variantOf(listedMethod("vessels"), "v0.2").make({cube.mask, cube.geometry}, {}).mesh;
  std::array<double, 2> area{};
  std::array<double, 2> count{};
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 away = ((a + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3 - centre).cwiseAbs();
    // Within 2 mm of one of the cube's edges: two coordinates are great.
    const std::size_t curved = (away.array() > 7).count() > 1 ? 1 : 0;
    area[curved] += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    count[curved] += 1;
  }
  EXPECT_GT(area[0] / count[0], 4 * area[1] / count[1]);
}

TEST(ScaleAdaptiveVessels, KeepAThinTubeWholeWithinTheBoundOfTheirName) {
  const Body tube = bodyWhere({30, 30, 60}, Vec3::Constant(0.5), [](const Vec3& p) {
    return (p - Vec3(7.1 + 0.2 * p[2], 7.3, std::clamp(p[2], 4.0, 26.0))).norm() < 0.8;
  });
  const auto make = [&](const char* variant) {
    return variantOf(listedMethod("vessels"), variant).make({tube.mask, tube.geometry}, {}).mesh;
  };
  const SurfaceMesh fine = make("v0.2");
  const SurfaceMesh coarse = make("v1");
  for (const SurfaceMesh* mesh : {&fine, &coarse}) {
    EXPECT_EQ(eulerCharacteristic(*mesh), 2);
    EXPECT_FALSE(mesh->defects().any());
  }
  EXPECT_LT(coarse.triangles.size(), fine.triangles.size());
  // Both are within their bound of the surface that was solved.
  const std::vector<double> apart = MeshDistance(coarse).to(fine.vertices);
  EXPECT_LE(*std::max_element(apart.begin(), apart.end()), (1.0 + 0.2) * 0.5);
}

}  // namespace
}  // namespace glisson
