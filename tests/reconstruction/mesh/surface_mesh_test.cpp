#include "reconstruction/mesh/surface_mesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "reconstruction/cancel_poll.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/edges.h"
#include "tests/reconstruction/mesh/solids.h"

namespace glisson {
namespace {

using test::box;
using test::reversed;
using test::sphere;
using test::tetrahedron;
using test::together;

TEST(SurfaceMesh, ATetrahedronHasItsVolumeAreaCentroidAndEulerNumber) {
  const SurfaceMesh mesh = tetrahedron();
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_TRUE(mesh.defects().names().empty());
  EXPECT_NEAR(signedVolumeMm3(mesh), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(volumeMl(mesh), 1e-3 / 6.0, 1e-18);
  EXPECT_NEAR(areaMm2(mesh), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
  EXPECT_NEAR((centroidOf(mesh) - Vec3(0.25, 0.25, 0.25)).norm(), 0.0, 1e-15);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
}

TEST(SurfaceMesh, ABoxFarFromTheOriginKeepsItsVolumeToTheLastDigits) {
  const SurfaceMesh mesh = box({-1234.5, 987.25, 5000.0}, {20, 30, 40}, 5);
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_NEAR(signedVolumeMm3(mesh), 24000.0, 1e-8);
  EXPECT_NEAR((centroidOf(mesh) - Vec3(-1224.5, 1002.25, 5020.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((boundsOf(mesh).high - Vec3(-1214.5, 1017.25, 5040.0)).norm(), 0.0, 1e-12);
}

TEST(SurfaceMesh, ASpheresVolumeConvergesToTheFormula) {
  const SurfaceMesh mesh = sphere({10, -20, 30}, 15.0, 5);
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_NEAR(signedVolumeMm3(mesh) / (4.0 / 3.0 * std::numbers::pi * 3375.0), 1.0, 1.5e-3);
  EXPECT_NEAR(areaMm2(mesh) / (4.0 * std::numbers::pi * 225.0), 1.0, 1e-3);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
}

TEST(SurfaceMesh, AMissingTriangleIsOpenByThreeEdgesAndHasNoVolume) {
  SurfaceMesh mesh = sphere(Vec3::Zero(), 1.0, 2);
  mesh.triangles.pop_back();
  const MeshDefects defects = mesh.defects();
  EXPECT_EQ(defects.openEdges, 3U);
  EXPECT_EQ(defects.names(), std::vector<std::string>{"open: 3 edges"});
  EXPECT_THROW(volumeMl(mesh), ReconstructionError);
}

TEST(SurfaceMesh, AnEmptyMeshIsOpen) {
  const SurfaceMesh mesh;
  EXPECT_TRUE(mesh.defects().any());
  EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{"open: no triangles"});
  EXPECT_THROW(volumeMl(mesh), ReconstructionError);
  EXPECT_THROW(boundsOf(mesh), std::invalid_argument);
}

TEST(SurfaceMesh, OneTurnedTriangleIsAnOrientationDefectOnItsThreeEdges) {
  SurfaceMesh mesh = sphere(Vec3::Zero(), 1.0, 2);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  EXPECT_EQ(mesh.defects().orientationEdges, 3U);
  EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{"orientation: 3 edges"});
  EXPECT_THROW(volumeMl(mesh), ReconstructionError);
}

TEST(SurfaceMesh, AMeshTurnedInsideOutIsInward) {
  const SurfaceMesh mesh = reversed(sphere(Vec3::Zero(), 1.0, 2));
  EXPECT_TRUE(mesh.defects().inward);
  EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{"orientation: inward"});
}

TEST(SurfaceMesh, AMirroredMeshIsInwardUntilItsTrianglesAreTurned) {
  SurfaceMesh mesh = box({1, 2, 3}, {4, 5, 6}, 3);
  for (Vec3& v : mesh.vertices) {
    v[0] = -v[0];
  }
  EXPECT_TRUE(mesh.defects().inward);
  EXPECT_NEAR(signedVolumeMm3(mesh), -120.0, 1e-9);
  EXPECT_FALSE(reversed(mesh).defects().any());
}

TEST(SurfaceMesh, ACavityIsNoDefectAndIsTakenOffTheVolume) {
  const SurfaceMesh mesh = together(box({0, 0, 0}, {10, 10, 10}, 2), reversed(box({3, 3, 3}, {2, 2, 2})));
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_NEAR(signedVolumeMm3(mesh), 992.0, 1e-9);
  EXPECT_EQ(eulerCharacteristic(mesh), 4);
  std::uint32_t count = 0;
  const auto pieces = componentOfTriangles(mesh, count);
  EXPECT_EQ(count, 2U);
  EXPECT_EQ(pieces.front(), 0U);
  EXPECT_EQ(pieces.back(), 1U);
}

TEST(SurfaceMesh, TwoBoxesSharingAnEdgeHaveOneEdgeThatIsNotManifold) {
  SurfaceMesh mesh = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {1, 1, 1}));
  // Weld the shared edge from (1,1,0) to (1,1,1).
  for (const double z : {0.0, 1.0}) {
    std::vector<std::uint32_t> same;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      if (mesh.vertices[v] == Vec3(1, 1, z)) {
        same.push_back(v);
      }
    }
    ASSERT_EQ(same.size(), 2U);
    for (Triangle& t : mesh.triangles) {
      std::replace(t.begin(), t.end(), same[1], same[0]);
    }
  }
  EXPECT_EQ(mesh.defects().nonManifoldEdges, 1U);
  EXPECT_EQ(mesh.defects().orientationEdges, 0U);
  EXPECT_EQ(mesh.defects().names().front(), "edge: 1 edge is not manifold");
}

TEST(SurfaceMesh, TwoBoxesSharingAVertexHaveOneVertexThatIsNotManifoldUntilTheirFansAreSplit) {
  SurfaceMesh mesh = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {1, 1, 1}));
  std::vector<std::uint32_t> same;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v] == Vec3(1, 1, 1)) {
      same.push_back(v);
    }
  }
  ASSERT_EQ(same.size(), 2U);
  for (Triangle& t : mesh.triangles) {
    std::replace(t.begin(), t.end(), same[1], same[0]);
  }
  EXPECT_EQ(mesh.defects().nonManifoldVertices, 1U);
  EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{"vertex: 1 vertex is not manifold"});
  EXPECT_EQ(splitFans(mesh), 1U);
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_NEAR(signedVolumeMm3(mesh), 2.0, 1e-14);
}

TEST(SurfaceMesh, DegenerateTrianglesAreCountedWhateverMakesThemSo) {
  SurfaceMesh flat = tetrahedron();
  flat.vertices.emplace_back(0.5, 0.5, 0.0);  // on the edge 1-2
  flat.triangles = {{0, 2, 4}, {0, 4, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {1, 4, 2}};
  EXPECT_EQ(flat.defects().degenerateTriangles, 1U);
  EXPECT_EQ(flat.defects().names(), std::vector<std::string>{"degenerate: 1 triangle"});

  SurfaceMesh repeated = tetrahedron();
  repeated.triangles.push_back({1, 1, 2});
  EXPECT_EQ(repeated.defects().degenerateTriangles, 1U);
  EXPECT_EQ(repeated.defects().openEdges, 0U);

  SurfaceMesh beyond = tetrahedron();
  beyond.triangles[0][1] = 99;
  EXPECT_EQ(beyond.defects().degenerateTriangles, 1U);
  EXPECT_EQ(beyond.defects().openEdges, 3U);

  SurfaceMesh infinite = tetrahedron();
  infinite.vertices[3][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(infinite.defects().degenerateTriangles, 3U);
}

TEST(SurfaceMesh, ASmallButSoundTriangleFarFromTheOriginIsNotDegenerate) {
  SurfaceMesh mesh = tetrahedron();
  for (Vec3& v : mesh.vertices) {
    v = (1e-6 * v + Vec3(300, -200, 1500)).eval();
  }
  EXPECT_FALSE(mesh.defects().any());
}

TEST(SurfaceMesh, VerticesNoTriangleUsesChangeNothing) {
  SurfaceMesh mesh = tetrahedron();
  mesh.vertices.insert(mesh.vertices.begin(), Vec3(1e6, 0, 0));
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      ++corner;
    }
  }
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  EXPECT_EQ(boundsOf(mesh).high, Vec3(1, 1, 1));
  dropUnusedVertices(mesh);
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_NEAR(signedVolumeMm3(mesh), 1.0 / 6.0, 1e-15);
}

TEST(SurfaceMesh, ItsMeasuresEndWhenTheyAreCancelled) {
  const SurfaceMesh mesh = sphere(Vec3::Zero(), 10, 3);
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW((void)mesh.defects(context), Cancelled);
  EXPECT_THROW(boundsOf(mesh, context), Cancelled);
  EXPECT_THROW(signedVolumeMm3(mesh, context), Cancelled);
}

TEST(CancelPoll, LooksAgainWhileTheLoopRuns) {
  const ExecutionContext context;
  CancelPoll poll(context);
  poll();
  context.cancel();
  const auto loop = [&] {
    for (int n = 0; n < 100000; ++n) {
      poll();
    }
  };
  EXPECT_THROW(loop(), Cancelled);
}

}  // namespace
}  // namespace glisson
