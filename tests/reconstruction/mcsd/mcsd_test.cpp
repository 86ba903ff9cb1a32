#include "reconstruction/mcsd/mcsd.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <map>
#include <memory>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/sharp_edges.h"
#include "tests/reconstruction/mcsd/plain_chain.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

using test::asymmetricBody;
using test::expectSameTriangles;
using test::obliqueGeometry;
using test::plainChain;

/// Whether any invariant is broken, found another way than defects() does: maps of edges, fans walked one triangle at a time.
bool bruteForceDefect(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> ringOf;  // vertex -> (side after it -> side before it)
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = t[c];
      const auto b = t[(c + 1) % 3];
      if (a == b || ++directed[{a, b}] > 1) {
        return true;
      }
      ringOf[a][b] = t[(c + 2) % 3];
    }
    const Vec3& a = mesh.vertices[t[0]];
    if ((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() < 1e-13) {
      return true;
    }
  }
  for (const auto& [edge, n] : directed) {
    if (!directed.contains({edge.second, edge.first})) {
      return true;
    }
  }
  for (const auto& [vertex, ring] : ringOf) {
    std::size_t steps = 0;
    std::uint32_t at = ring.begin()->first;
    do {
      at = ring.at(at);
      ++steps;
    } while (at != ring.begin()->first);
    if (steps != ring.size()) {
      return true;
    }
  }
  return signedVolumeMm3(mesh) < 0;
}

const Index3 kSize{40, 30, 26};

TEST(Mcsd, IsThePlainVtkChainTriangleForTriangle) {
  const Mask mask = asymmetricBody(kSize);
  for (const bool leftHanded : {false, true}) {
    const ImageGeometry geometry = obliqueGeometry(kSize, leftHanded);
    for (const auto filter : {SmoothingFilter::Sinc, SmoothingFilter::Laplacian}) {
      for (const auto order : {McsdOrder::DecimateFirst, McsdOrder::SmoothFirst}) {
        for (const int smoothing : {0, 10, 45}) {
          for (const double decimation : {0.0, 0.25, 0.9}) {
            const McsdParameters p{smoothing, filter, decimation, order, smoothing == 0};
            SCOPED_TRACE(std::to_string(smoothing) + " " + std::to_string(decimation));
            expectSameTriangles(reconstructMcsd(mask, geometry, p).mesh, plainChain(mask, geometry, p));
          }
        }
      }
    }
  }
}

/// An edge that is sharp where a voxel is a cube need not be where slices are thick, nor the other way round.
TEST(Mcsd, EdgesAreSharpInMillimetres) {
  const Mask mask = asymmetricBody(kSize);
  ImageGeometry geometry = obliqueGeometry(kSize, true);
  geometry.spacing = Vec3(1, 1, 6);
  McsdParameters p{.smoothing = 0, .decimation = 0};
  const SurfaceMesh merged = reconstructMcsd(mask, geometry, p).mesh;
  p.splitNormals = true;
  const SurfaceMesh split = reconstructMcsd(mask, geometry, p).mesh;
  const SurfaceMesh expected = splitAtSharpEdges(merged);
  EXPECT_GT(split.vertices.size(), merged.vertices.size());
  EXPECT_EQ(split.vertices, expected.vertices);
  EXPECT_EQ(split.triangles, expected.triangles);
}

/// Bounds of the mask's voxel boxes in index coordinates against those of the mesh brought back to index coordinates.
double worstBoundsMm(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry) {
  SurfaceMesh inIndex = mesh;
  for (Vec3& v : inIndex.vertices) {
    v = geometry.toIndex(Vec3(v));
  }
  const Bounds bounds = boundsOf(inIndex);
  double worst = 0;
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(a);
    worst = std::max(worst, geometry.spacing[a] * std::abs(bounds.low[a] - (mask.box().first[n] - 0.5)));
    worst = std::max(worst, geometry.spacing[a] * std::abs(bounds.high[a] - (mask.box().first[n] + mask.box().size[n] - 0.5)));
  }
  return worst;
}

TEST(Mcsd, TheUnsmoothedSurfaceHasTheMasksVoxelFaceBoundsOnEveryGrid) {
  const Mask mask = asymmetricBody(kSize);
  for (const bool leftHanded : {false, true}) {
    const ImageGeometry geometry = obliqueGeometry(kSize, leftHanded);
    const SurfaceMesh mesh = reconstructMcsd(mask, geometry, {0, SmoothingFilter::Sinc, 0.0, McsdOrder::DecimateFirst, false}).mesh;
    EXPECT_FALSE(mesh.defects().any());
    EXPECT_LT(worstBoundsMm(mesh, mask, geometry), 1e-6);
  }
}

TEST(Mcsd, TheDefaultKeepsCentroidAndBoundsOfAnAsymmetricBodyAndFacesOutward) {
  const Mask mask = asymmetricBody(kSize);
  for (const bool leftHanded : {false, true}) {
    const ImageGeometry geometry = obliqueGeometry(kSize, leftHanded);
    const SurfaceMesh mesh = reconstructMcsd(mask, geometry, {}).mesh;
    EXPECT_EQ(mesh.defects().names(), std::vector<std::string>{});
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < kSize[2]; ++k) {
      for (int j = 0; j < kSize[1]; ++j) {
        for (int i = 0; i < kSize[0]; ++i) {
          sum += mask.at(i, j, k) ? Vec3(i, j, k) : Vec3::Zero();
        }
      }
    }
    const Vec3 centroid = geometry.toIndex(centroidOf(mesh));
    EXPECT_LT((centroid - sum / static_cast<double>(mask.count())).cwiseAbs().maxCoeff(), 0.1);
    EXPECT_LT(worstBoundsMm(mesh, mask, geometry), 1.5 * geometry.spacing.maxCoeff());
  }
}

TEST(Mcsd, AMaskThatFillsItsGridIsClosed) {
  const Index3 size{4, 5, 6};
  const Mask mask = Mask::fromGrid(size, std::vector<std::uint8_t>(120, 1));
  ImageGeometry geometry;
  geometry.size = size;
  const SurfaceMesh mesh = reconstructMcsd(mask, geometry, {0, SmoothingFilter::Sinc, 0.0, McsdOrder::DecimateFirst, false}).mesh;
  EXPECT_FALSE(mesh.defects().any());
  EXPECT_LT(worstBoundsMm(mesh, mask, geometry), 1e-6);
}

TEST(Mcsd, EveryRandomLabelMapGivesASoundSurfaceUnsmoothedAndAnHonestAnswerAfterDecimation) {
  std::mt19937 random(20161);
  for (int trial = 0; trial < test::trials(300); ++trial) {
    const auto side = [&] { return 3 + static_cast<int>(random() % 12); };
    const Index3 size{side(), side(), side()};
    std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    const auto share = 5 + random() % 90;
    for (auto& v : values) {
      v = random() % 100 < share ? 1 : 0;
    }
    values[0] = 1;
    const Mask mask = Mask::fromGrid(size, values);
    const ImageGeometry geometry = obliqueGeometry(size, trial % 2 == 1);
    const SurfaceMesh plain =
        reconstructMcsd(mask, geometry, {0, SmoothingFilter::Sinc, 0.0, McsdOrder::DecimateFirst, false}).mesh;
    EXPECT_EQ(plain.defects().names(), std::vector<std::string>{});
    McsdParameters p;
    p.decimation = 0.1 * static_cast<double>(random() % 10);
    p.smoothing = 2 + static_cast<int>(random() % 30);
    p.filter = trial % 3 == 0 ? SmoothingFilter::Laplacian : SmoothingFilter::Sinc;
    // Noise is no anatomy: decimation folds edges together, smoothing turns bodies inside out. Nothing may be left unnamed.
    const SurfaceMesh mesh = reconstructMcsd(mask, geometry, p).mesh;
    EXPECT_EQ(mesh.defects().any(), bruteForceDefect(mesh)) << trial;
  }
}

TEST(Mcsd, AnEmptyMaskAndSenselessParametersAreRefused) {
  ImageGeometry geometry;
  geometry.size = {3, 3, 3};
  EXPECT_THROW(reconstructMcsd(Mask(), geometry, {}), ReconstructionError);
  const Mask mask = Mask::fromGrid(geometry.size, std::vector<std::uint8_t>(27, 1));
  McsdParameters p;
  p.smoothing = -1;
  EXPECT_THROW(reconstructMcsd(mask, geometry, p), UsageError);
  p.smoothing = 1;
  EXPECT_THROW(reconstructMcsd(mask, geometry, p), UsageError);
  p.filter = SmoothingFilter::Laplacian;
  EXPECT_NO_THROW(reconstructMcsd(mask, geometry, p));
  p = {};
  p.decimation = 1.0;
  EXPECT_THROW(reconstructMcsd(mask, geometry, p), UsageError);
}

TEST(Mcsd, ACancelDuringAnyFilterEndsIt) {
  const Index3 size{60, 60, 60};
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0]) * 60 * 60, 0);
  std::mt19937 random(7);
  for (auto& v : values) {
    v = random() % 100 < 20 ? 1 : 0;
  }
  const Mask mask = Mask::fromGrid(size, values);
  ImageGeometry geometry;
  geometry.size = size;
  for (const std::string_view phaseToStop : {"marching cubes", "decimation", "smoothing"}) {
    std::chrono::steady_clock::time_point asked;
    std::unique_ptr<ExecutionContext> context;
    context = std::make_unique<ExecutionContext>([&](double, std::string_view phase) {
      if (phase == phaseToStop && !context->isCancelled()) {
        asked = std::chrono::steady_clock::now();
        context->cancel();
      }
    });
    EXPECT_THROW(reconstructMcsd(mask, geometry, {}, *context), Cancelled) << phaseToStop;
    const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count();
    RecordProperty("seconds in " + std::string(phaseToStop), std::to_string(seconds));
  }
}

}  // namespace
}  // namespace glisson
