// Poisson surface reconstruction against analytic bodies, invariances, hostile masks, threads and cancel.
#include "reconstruction/poisson/poisson.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numbers>
#include <set>
#include <thread>
#include <tuple>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

ImageGeometry gridOf(const Index3& size, const Vec3& spacing) {
  ImageGeometry geometry;
  geometry.size = size;
  geometry.spacing = spacing;
  return geometry;
}

template <typename Inside>
Mask maskWhere(const ImageGeometry& geometry, Inside&& inside) {
  std::vector<std::uint8_t> values(geometry.voxelCount());
  std::size_t n = 0;
  for (int k = 0; k < geometry.size[2]; ++k) {
    for (int j = 0; j < geometry.size[1]; ++j) {
      for (int i = 0; i < geometry.size[0]; ++i, ++n) {
        values[n] = inside(geometry.toWorld(Vec3(i, j, k))) ? 1 : 0;
      }
    }
  }
  return Mask::fromGrid(geometry.size, values);
}

double voxelMm3(const Mask& mask, const ImageGeometry& geometry) {
  return static_cast<double>(mask.count()) * geometry.voxelVolumeMm3();
}

std::uint32_t piecesOf(const SurfaceMesh& mesh) {
  std::uint32_t count = 0;
  componentOfTriangles(mesh, count);
  return count;
}

PoissonResult psr(const Mask& mask, const ImageGeometry& geometry, int depth, Sampling sampling = Sampling::Unbiased,
                  double pointWeight = 0) {
  PoissonParameters parameters;
  parameters.depth = depth;
  parameters.sampling = sampling;
  parameters.pointWeight = pointWeight;
  return reconstructPoisson(mask, geometry, parameters);
}

void expectSound(const SurfaceMesh& mesh, const std::string& what) {
  for (const auto& name : mesh.defects().names()) {
    ADD_FAILURE() << what << ": " << name;
  }
}

/// Area-weighted signed distance of a mesh to a sphere.
double meanSignedDistance(const SurfaceMesh& mesh, const Vec3& centre, double radius) {
  double sum = 0;
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3& b = mesh.vertices[t[1]];
    const Vec3& c = mesh.vertices[t[2]];
    const double twice = (b - a).cross(c - a).norm();
    sum += twice * (((a + b + c) / 3 - centre).norm() - radius);
    area += twice;
  }
  return sum / area;
}

TEST(Samples, OfABoxAreItsFacesWithOutwardUnitNormalsAndItsArea) {
  const ImageGeometry geometry = gridOf({12, 12, 12}, Vec3(1, 2, 3));
  const Mask box = maskWhere(
      geometry, [](const Vec3& p) { return p[0] > 2.5 && p[0] < 8.5 && p[1] > 5 && p[1] < 17 && p[2] > 7.5 && p[2] < 25.5; });
  const OrientedPoints points = sampleBoundary(box, geometry, Sampling::Unbiased);
  EXPECT_EQ(points.positions.size(), 6U * 36U);
  const Vec3 centre(5.5, 11, 16.5);
  double flux = 0;  // divergence theorem: 3 V for exact normals; Sobel normals tilt at edges, the weight takes that out
  for (std::size_t n = 0; n < points.positions.size(); ++n) {
    EXPECT_NEAR(points.normals[n].norm(), 1.0, 1e-12);
    EXPECT_GT(points.normals[n].dot(points.positions[n] - centre), 0.0);
    flux += points.weights[n];
  }
  EXPECT_GT(flux, 0.8 * (2 * (6 * 12 + 6 * 18 + 12 * 18)));
  EXPECT_LE(flux, 2 * (6 * 12 + 6 * 18 + 12 * 18) + 1e-9);
}

TEST(Samples, PaperPointsLieInsideHalfAVoxelBelowTheFaces) {
  const ImageGeometry geometry = gridOf({20, 20, 20}, Vec3(1, 1, 1));
  const Mask slab = maskWhere(geometry, [](const Vec3& p) { return p[2] < 9.5; });
  for (const Vec3& p : sampleBoundary(slab, geometry, Sampling::Paper).positions) {
    EXPECT_TRUE(slab.at(static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])));
  }
}

TEST(Samples, AVoxelAloneHasNoPaperPointAndIsRefusedThereOnly) {
  const ImageGeometry geometry = gridOf({5, 5, 5}, Vec3(1, 1, 1));
  std::vector<std::uint8_t> values(125, 0);
  values[62] = 1;
  const Mask voxel = Mask::fromGrid(geometry.size, values);
  EXPECT_THROW(sampleBoundary(voxel, geometry, Sampling::Paper), ReconstructionError);
  EXPECT_EQ(sampleBoundary(voxel, geometry, Sampling::Unbiased).positions.size(), 6U);
}

TEST(Samples, AnEmptyMaskIsRefused) {
  EXPECT_THROW(sampleBoundary(Mask(), gridOf({4, 4, 4}, Vec3::Ones()), Sampling::Unbiased), ReconstructionError);
}

class PoissonBall : public testing::TestWithParam<double> {};

TEST_P(PoissonBall, MeanSignedDistanceIsBelow3PercentOfTheSpacingAndTheVolumeIsTheVoxels) {
  const double slice = GetParam();
  const ImageGeometry geometry = gridOf({100, 100, static_cast<int>(90 / slice)}, Vec3(0.8, 0.8, slice));
  const Vec3 centre(39.7, 40.1, 43.3);
  const Mask ball = maskWhere(geometry, [&](const Vec3& p) { return (p - centre).norm() < 30; });
  const PoissonResult result = psr(ball, geometry, 7);
  expectSound(result.mesh, "ball");
  EXPECT_EQ(piecesOf(result.mesh), 1U);
  EXPECT_LT(std::abs(meanSignedDistance(result.mesh, centre, 30)), 0.03 * slice);
  EXPECT_NEAR(signedVolumeMm3(result.mesh) / voxelMm3(ball, geometry), 1.0, slice > 4 ? 0.0015 : 0.0005);
}

INSTANTIATE_TEST_SUITE_P(Slices, PoissonBall, testing::Values(0.8, 2.5, 5.0));

TEST(Poisson, VolumeErrorFallsWithTheDepth) {
  const ImageGeometry geometry = gridOf({160, 160, 160}, Vec3(0.5, 0.5, 0.5));
  const Mask torus = maskWhere(geometry, [](const Vec3& p) {
    const Vec3 q = p - Vec3(39.9, 40.2, 39.8);
    return std::hypot(std::hypot(q[0], q[1]) - 24, q[2]) < 9;
  });
  double before = 1;
  for (const int depth : {5, 6, 7}) {
    const PoissonResult result = psr(torus, geometry, depth);
    expectSound(result.mesh, "torus");
    EXPECT_EQ(eulerCharacteristic(result.mesh), 0) << "a torus has one handle";
    const double error = std::abs(signedVolumeMm3(result.mesh) / voxelMm3(torus, geometry) - 1);
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 5e-4);
}

TEST(Poisson, BodiesOf1And8And100And800VoxelsAreOneClosedPieceAtEveryDepth) {
  for (const double slice : {0.8, 2.5, 5.0}) {
    const ImageGeometry geometry = gridOf({24, 24, 24}, Vec3(0.8, 0.8, slice));
    for (const int side : {1, 2}) {
      const Mask cube = maskWhere(geometry, [&](const Vec3& p) {
        const Vec3 i = geometry.toIndex(p);
        return i.minCoeff() > 9.5 && i.maxCoeff() < 9.5 + side;
      });
      ASSERT_EQ(cube.count(), static_cast<std::size_t>(side * side * side));
      for (int depth = 5; depth <= 10; ++depth) {
        const auto mesh = psr(cube, geometry, depth).mesh;
        expectSound(mesh, "cube");
        EXPECT_EQ(piecesOf(mesh), 1U) << side << " " << slice << " " << depth;
      }
    }
    for (const double voxels : {100.0, 800.0}) {
      const double radius = std::cbrt(voxels * 3 / (4 * std::numbers::pi));  // in voxels
      const Mask blob =
          maskWhere(geometry, [&](const Vec3& p) { return (geometry.toIndex(p) - Vec3(11.6, 12.1, 11.9)).norm() < radius; });
      for (int depth = 5; depth <= 10; ++depth) {
        const auto mesh = psr(blob, geometry, depth).mesh;
        expectSound(mesh, "blob");
        EXPECT_EQ(piecesOf(mesh), 1U) << voxels << " " << slice << " " << depth;
      }
    }
  }
}

TEST(Poisson, AMaskThatFillsTheGridIsClosedAllTheSame) {
  const ImageGeometry geometry = gridOf({16, 12, 10}, Vec3(1, 1, 2));
  const Mask full = maskWhere(geometry, [](const Vec3&) { return true; });
  const auto mesh = psr(full, geometry, 6).mesh;
  expectSound(mesh, "full");
  EXPECT_NEAR(signedVolumeMm3(mesh) / voxelMm3(full, geometry), 1.0, 0.01);
}

TEST(Poisson, ObliqueAndLeftHandedGridsGiveTheSameBodyInTheWorld) {
  ImageGeometry straight = gridOf({48, 40, 30}, Vec3(0.7, 0.8, 1.5));
  const auto body = [](const Vec3& i) {
    return (i - Vec3(20, 18, 14)).norm() < 8.95 ||
           (std::abs(i[1] - 18) < 2.7 && std::abs(i[2] - 14) < 2.7 && i[0] > 20 && i[0] < 42);
  };
  std::vector<ImageGeometry> grids(3, straight);
  grids[1].direction = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  grids[1].origin = Vec3(-120, 35, 410);
  grids[2].direction.col(2) *= -1;
  double first = 0;
  for (const auto& geometry : grids) {
    const Mask mask = maskWhere(geometry, [&](const Vec3& p) { return body(geometry.toIndex(p)); });
    const auto mesh = psr(mask, geometry, 6).mesh;
    expectSound(mesh, "oblique");
    const Vec3 centre = geometry.toIndex(centroidOf(mesh));
    EXPECT_GT(centre[0], 20.2) << "the arm points along +i";
    EXPECT_NEAR(centre[1], 18.0, 0.2);
    EXPECT_NEAR(centre[2], 14.0, 0.2);
    const double volume = signedVolumeMm3(mesh);
    EXPECT_NEAR(volume / voxelMm3(mask, geometry), 1.0, 0.01);
    first = first == 0 ? volume : first;
    EXPECT_NEAR(volume / first, 1.0, 0.005);
  }
}

TEST(Poisson, ScreeningPullsTheSurfaceTowardsTheSamples) {
  const ImageGeometry geometry = gridOf({60, 60, 40}, Vec3(0.8, 0.8, 1.2));
  const Mask ball = maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(24, 24, 24)).norm() < 17; });
  const OrientedPoints points = sampleBoundary(ball, geometry, Sampling::Paper);
  const auto spread = [&](const SurfaceMesh& mesh) {  // mean distance of each sample to the nearest vertex
    double sum = 0;
    for (std::size_t n = 0; n < points.positions.size(); n += 20) {
      double best = 1e9;
      for (const Vec3& v : mesh.vertices) {
        best = std::min(best, (v - points.positions[n]).squaredNorm());
      }
      sum += std::sqrt(best);
    }
    return sum;
  };
  const auto plain = psr(ball, geometry, 6, Sampling::Paper);
  const auto screened = psr(ball, geometry, 6, Sampling::Paper, 4.0);
  expectSound(screened.mesh, "screened");
  EXPECT_LT(spread(screened.mesh), spread(plain.mesh));
}

TEST(Parallel, ALimitAboveTheMachinesCoresIsKeptAndMet) {
  const ThreadLimit limit(8);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  std::atomic<int> waiting{0};
  parallelFor(8, 1, [&](std::size_t, std::size_t) {
    // Every piece waits for the others: they come to an end only where eight threads take one each.
    ++waiting;
    for (int n = 0; n < 2000 && waiting < 8; ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen.size(), 8U);
}

TEST(Poisson, TheSameBytesForOneTwoAndEightThreads) {
  // 130 voxels long, so that depth 8 is used and its blocks are a band.
  const ImageGeometry geometry = gridOf({150, 40, 40}, Vec3(0.8, 0.8, 0.9));
  const Mask body = maskWhere(geometry, [](const Vec3& p) {
    return std::hypot(p[1] - 15 - 3 * std::sin(0.1 * p[0]), p[2] - 17) < 6 && p[0] > 6 && p[0] < 114;
  });
  for (const auto& [depth, sampling, weight] : {std::tuple(7, Sampling::Unbiased, 0.0), std::tuple(8, Sampling::Unbiased, 0.0),
                                                std::tuple(8, Sampling::Paper, 0.0), std::tuple(7, Sampling::Unbiased, 4.0)}) {
    const auto reference = psr(body, geometry, depth, sampling, weight);
    EXPECT_EQ(reference.usedDepth, depth);
    for (const int threads : {1, 2, 8}) {
      const ThreadLimit limit(threads);
      const auto mesh = psr(body, geometry, depth, sampling, weight).mesh;
      EXPECT_EQ(mesh.triangles, reference.mesh.triangles);
      EXPECT_TRUE(mesh.vertices == reference.mesh.vertices) << threads << " threads at depth " << depth;
    }
  }
}

TEST(Poisson, AfterAnExceptionTheNextRunIsAsEver) {
  const ImageGeometry geometry = gridOf({40, 40, 40}, Vec3(0.8, 0.8, 0.9));
  const Mask body = maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(16, 16, 17)).norm() < 11; });
  const auto reference = psr(body, geometry, 6).mesh;
  const std::vector<PoissonParameters> sets{{.depth = 5}, {.depth = 6}};
  EXPECT_THROW(reconstructPoissonEach(body, geometry, sets,
                                      [](std::size_t, const PoissonResult&, const ExecutionContext&) { throw std::bad_alloc(); }),
               std::bad_alloc);
  EXPECT_TRUE(psr(body, geometry, 6).mesh.vertices == reference.vertices);
}

TEST(Poisson, ACancelEndsItInEveryPhase) {
  const ImageGeometry geometry = gridOf({80, 80, 50}, Vec3(0.8, 0.8, 1.2));
  const Mask body = maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(32, 32, 30)).norm() < 25; });
  for (const double at : {0.0, 0.1, 0.2, 0.4, 0.6, 0.75}) {
    const ExecutionContext* running = nullptr;
    const ExecutionContext context([&](double fraction, std::string_view) {
      if (fraction >= at) {
        running->cancel();
      }
    });
    running = &context;
    EXPECT_THROW(reconstructPoisson(body, geometry, PoissonParameters{}, context), Cancelled) << at;
  }
}

TEST(Poisson, ACancelFromAnotherThreadEndsIt) {
  const ImageGeometry geometry = gridOf({160, 160, 100}, Vec3(0.8, 0.8, 1.2));
  const Mask body = maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(64, 64, 60)).norm() < 50; });
  PoissonParameters parameters;
  parameters.depth = 8;
  for (const int afterMs : {0, 5, 20, 60}) {  // cancel_latency measures the 100 ms
    const ExecutionContext context;
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(afterMs));
      context.cancel();
    });
    EXPECT_THROW(
        while (true) { reconstructPoisson(body, geometry, parameters, context); }, Cancelled);
    canceller.join();
  }
}

TEST(Poisson, SeveralDepthsFromOneSetOfSamplesAreTheSameBytesAsOneByOne) {
  const ImageGeometry geometry = gridOf({140, 120, 80}, Vec3(0.4, 0.4, 0.8));
  const Mask body =
      maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(28, 24, 32)).norm() < 20 || (p - Vec3(40, 30, 30)).norm() < 12; });
  for (const Sampling sampling : {Sampling::Paper, Sampling::Unbiased}) {
    const std::array depths{7, 5, 6};
    std::array<PoissonParameters, 3> sets;
    for (std::size_t n = 0; n < sets.size(); ++n) {
      sets[n].sampling = sampling;
      sets[n].depth = depths[n];
    }
    std::size_t called = 0;
    reconstructPoissonEach(body, geometry, sets, [&](std::size_t n, const PoissonResult& result, const ExecutionContext&) {
      EXPECT_EQ(n, called++);
      const auto alone = psr(body, geometry, depths[n], sampling);
      EXPECT_EQ(result.usedDepth, alone.usedDepth);
      EXPECT_EQ(result.mesh.triangles, alone.mesh.triangles);
      EXPECT_TRUE(result.mesh.vertices == alone.mesh.vertices);
    });
    EXPECT_EQ(called, depths.size());
  }
}

TEST(Poisson, TheVolumeErrorOfACapsuleTreeFallsWithTheDepth) {
  const ImageGeometry geometry = gridOf({150, 110, 60}, Vec3(0.5, 0.5, 0.8));
  const std::array<std::array<Vec3, 2>, 4> capsules{{{Vec3(8, 28, 24), Vec3(30, 28, 24)},
                                                     {Vec3(30, 28, 24), Vec3(60, 46, 30)},
                                                     {Vec3(30, 28, 24), Vec3(62, 12, 18)},
                                                     {Vec3(45, 37, 27), Vec3(64, 34, 36)}}};
  const Mask tree = maskWhere(geometry, [&](const Vec3& p) {
    for (std::size_t n = 0; n < capsules.size(); ++n) {
      const Vec3 along = capsules[n][1] - capsules[n][0];
      const double t = std::clamp((p - capsules[n][0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      if ((p - capsules[n][0] - t * along).norm() < 4.5 - static_cast<double>(n) * 0.5) {
        return true;
      }
    }
    return false;
  });
  double before = 1;
  for (const int depth : {5, 6, 7}) {
    const auto mesh = psr(tree, geometry, depth).mesh;
    expectSound(mesh, "tree");
    EXPECT_EQ(eulerCharacteristic(mesh), 2);
    const double error = std::abs(signedVolumeMm3(mesh) / voxelMm3(tree, geometry) - 1);
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 5e-3);
}

TEST(Poisson, ProgressNeverFallsAndEndsAtOne) {
  const ImageGeometry geometry = gridOf({30, 30, 30}, Vec3::Ones());
  const Mask ball = maskWhere(geometry, [](const Vec3& p) { return (p - Vec3(15, 15, 15)).norm() < 10; });
  double last = 0;
  const ExecutionContext context([&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  reconstructPoisson(ball, geometry, PoissonParameters{}, context);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(Poisson, ParametersOutsideTheirRangeAreRefused) {
  const auto refused = [](auto change) {
    PoissonParameters parameters;
    change(parameters);
    EXPECT_THROW(parameters.validate(), UsageError);
  };
  refused([](PoissonParameters& p) { p.depth = 4; });
  refused([](PoissonParameters& p) { p.depth = 11; });
  refused([](PoissonParameters& p) { p.pointWeight = -1; });
  refused([](PoissonParameters& p) { p.scale = 1.0; });
}

}  // namespace
}  // namespace glisson
