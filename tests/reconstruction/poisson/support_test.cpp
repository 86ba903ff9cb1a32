// No finer triangles than the samples support: what is collapsed, what is left alone, and that the mesh stays sound.
#include "reconstruction/poisson/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/parallel.h"
#include "tests/support/trials.h"

namespace glisson::poisson {
namespace {

template <typename Inside>
PoissonResult psrOf(const Vec3& spacing, Sampling sampling, int depth, const Inside& inside) {
  ImageGeometry geometry;
  geometry.spacing = spacing;
  for (std::size_t a = 0; a < 3; ++a) {
    geometry.size[a] = static_cast<int>(40 / spacing[static_cast<Eigen::Index>(a)]);
  }
  std::vector<std::uint8_t> values(geometry.voxelCount());
  std::size_t n = 0;
  for (int k = 0; k < geometry.size[2]; ++k) {
    for (int j = 0; j < geometry.size[1]; ++j) {
      for (int i = 0; i < geometry.size[0]; ++i, ++n) {
        values[n] = inside(geometry.toWorld(Vec3(i, j, k)) - Vec3(19.6, 20.1, 19.7)) ? 1 : 0;
      }
    }
  }
  PoissonParameters parameters;
  parameters.sampling = sampling;
  parameters.depth = depth;
  return reconstructPoisson(Mask::fromGrid(geometry.size, values), geometry, parameters);
}

bool inBall(const Vec3& p) { return p.norm() < 15; }
bool inTorus(const Vec3& p) { return std::hypot(std::hypot(p[0], p[1]) - 12, p[2]) < 4; }
bool inSheet(const Vec3& p) { return std::abs(p[2] - 0.3 * p[0]) < 1.2 && p.norm() < 16; }
bool inTwoBalls(const Vec3& p) { return (p - Vec3(7.3, 0, 0)).norm() < 7 || (p + Vec3(7.3, 0, 0)).norm() < 7; }

void expectSound(const SurfaceMesh& mesh) {
  for (const auto& name : mesh.defects().names()) {
    ADD_FAILURE() << name;
  }
  EXPECT_EQ(countSelfIntersections(mesh), 0U);
}

/// A surface in a cube of 2^7 cells from the world's origin, with samples where it is to be supported.
struct Case {
  SurfaceMesh mesh;
  double cellMm = 40.0 / 128;
  CubeSamples samples;

  template <typename Supported>
  Case(SurfaceMesh surface, const Supported& supported) : mesh(std::move(surface)) {
    samples.depth = 7;
    for (const Vec3& v : mesh.vertices) {
      if (supported(v)) {
        const Vec3 at = v / cellMm;
        samples.positions.push_back({static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])});
      }
    }
  }
  void coarsen(const ExecutionContext& context = {}) { coarsenUnsupported(samples, Vec3::Zero(), cellMm, mesh, context); }
};

SurfaceMesh ball() { return psrOf(Vec3(0.5, 0.5, 0.5), Sampling::Unbiased, 7, inBall).mesh; }

TEST(Support, WhereEveryCellHoldsASampleTheMeshStaysAsItIs) {
  const SurfaceMesh before = ball();
  Case full(before, [](const Vec3&) { return true; });
  full.coarsen();
  EXPECT_EQ(full.mesh.triangles, before.triangles);
  EXPECT_TRUE(full.mesh.vertices == before.vertices);
}

TEST(Support, WithoutSamplesAThirdOfTheTrianglesGoesAndTheVolumeStays) {
  const SurfaceMesh before = ball();
  Case bare(before, [](const Vec3&) { return false; });
  bare.coarsen();
  EXPECT_LT(bare.mesh.triangles.size(), 0.67 * static_cast<double>(before.triangles.size()));
  EXPECT_NEAR(signedVolumeMm3(bare.mesh) / signedVolumeMm3(before), 1.0, 1e-12);
  EXPECT_EQ(eulerCharacteristic(bare.mesh), 2);
  expectSound(bare.mesh);
  for (const Triangle& t : bare.mesh.triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      EXPECT_LT((bare.mesh.vertices[t[n]] - bare.mesh.vertices[t[(n + 1) % 3]]).norm(), 2 * bare.cellMm);
    }
  }
}

TEST(Support, VerticesBesideSamplesStayAndOnlyTheOthersBecomeFewer) {
  const SurfaceMesh before = ball();
  const double middle = centroidOf(before)[2];
  const auto isSupported = [&](const Vec3& v) { return v[2] < middle; };
  Case half(before, isSupported);
  half.coarsen();
  const auto below = [&](const SurfaceMesh& mesh) {
    std::vector<Vec3> kept;
    std::ranges::copy_if(mesh.vertices, std::back_inserter(kept), isSupported);
    return kept;
  };
  EXPECT_TRUE(below(half.mesh) == below(before));
  EXPECT_LT(half.mesh.vertices.size(), 0.85 * static_cast<double>(before.vertices.size()));
  EXPECT_NEAR(signedVolumeMm3(half.mesh) / signedVolumeMm3(before), 1.0, 1e-12);
  expectSound(half.mesh);
}

TEST(Support, ThinCurvedAndAlmostTouchingBodiesStaySoundAndKeepTheirTopology) {
  for (const auto& inside : {inTorus, inSheet, inTwoBalls}) {
    const SurfaceMesh before = psrOf(Vec3(0.5, 0.5, 0.5), Sampling::Unbiased, 7, inside).mesh;
    Case bare(before, [](const Vec3&) { return false; });
    bare.coarsen();
    EXPECT_LT(bare.mesh.triangles.size(), before.triangles.size());
    EXPECT_EQ(eulerCharacteristic(bare.mesh), eulerCharacteristic(before));
    std::uint32_t piecesBefore = 0;
    std::uint32_t pieces = 0;
    componentOfTriangles(before, piecesBefore);
    componentOfTriangles(bare.mesh, pieces);
    EXPECT_EQ(pieces, piecesBefore);
    EXPECT_NEAR(signedVolumeMm3(bare.mesh) / signedVolumeMm3(before), 1.0, 1e-12);
    expectSound(bare.mesh);
  }
}

TEST(Support, RandomBodiesGetNoNewCrossingsAndKeepTopologyAndVolume) {
  std::mt19937 random(2016);
  const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967295.0; };
  for (int body = 0; body < test::trials(40); ++body) {
    std::vector<Vec3> centres;
    std::vector<double> radii;
    for (int n = 0; n < 12; ++n) {
      centres.emplace_back(between(-13, 13), between(-13, 13), between(-13, 13));
      radii.push_back(between(1.2, 6));
    }
    const PoissonResult made = psrOf(Vec3(0.9, 0.9, 2.4), Sampling::Unbiased, 7, [&](const Vec3& p) {
      bool inside = false;
      for (std::size_t n = 0; n < centres.size(); ++n) {
        inside ^= (p - centres[n]).norm() < radii[n];
      }
      return inside;
    });
    Case bare(made.mesh, [](const Vec3&) { return false; });
    bare.cellMm = made.cellMm;
    bare.coarsen();
    EXPECT_LT(bare.mesh.triangles.size(), made.mesh.triangles.size());
    EXPECT_FALSE(bare.mesh.defects().any()) << body;
    EXPECT_LE(countSelfIntersections(bare.mesh), countSelfIntersections(made.mesh)) << body;
    EXPECT_EQ(eulerCharacteristic(bare.mesh), eulerCharacteristic(made.mesh)) << body;
    EXPECT_NEAR(signedVolumeMm3(bare.mesh) / signedVolumeMm3(made.mesh), 1.0, 1e-11) << body;
  }
}

TEST(Support, PaperPointsOfThickSlicesGiveFewerTrianglesAndThoseOfThinOnesAsManyAsFaces) {
  const auto share = [](const Vec3& spacing, const auto& inside) {
    const SurfaceMesh paper = psrOf(spacing, Sampling::Paper, 7, inside).mesh;
    const SurfaceMesh unbiased = psrOf(spacing, Sampling::Unbiased, 7, inside).mesh;
    expectSound(paper);
    EXPECT_EQ(eulerCharacteristic(paper), eulerCharacteristic(unbiased));
    return static_cast<double>(paper.triangles.size()) / static_cast<double>(unbiased.triangles.size());
  };
  for (const auto& inside : {inBall, inTorus}) {
    EXPECT_LT(share(Vec3(0.4, 0.4, 2.0), inside), 0.9);
    EXPECT_GT(share(Vec3(0.5, 0.5, 0.5), inside), 0.95);
  }
}

TEST(Support, TheSameBytesForOneTwoAndEightThreads) {
  const auto make = [] { return psrOf(Vec3(0.4, 0.4, 2.0), Sampling::Paper, 7, inTorus).mesh; };
  const SurfaceMesh reference = make();
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    const SurfaceMesh mesh = make();
    EXPECT_EQ(mesh.triangles, reference.triangles);
    EXPECT_TRUE(mesh.vertices == reference.vertices) << threads << " threads";
  }
}

TEST(Support, ACancelEndsIt) {
  Case bare(ball(), [](const Vec3&) { return false; });
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(bare.coarsen(context), Cancelled);
}

}  // namespace
}  // namespace glisson::poisson
