// The solver's stages one by one against what is known exactly: sums, linear functions, nesting, spheres and tori.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reconstruction/poisson/density.h"
#include "reconstruction/poisson/extraction.h"
#include "reconstruction/poisson/frame.h"
#include "reconstruction/poisson/iso_value.h"
#include "reconstruction/poisson/solve.h"

namespace glisson::poisson {
namespace {

BlockGrid denseGrid(int level) {
  BlockGrid grid(level);
  grid.markAll();
  grid.number();
  return grid;
}

/// A field with the function's values at the nodes.
template <typename Function>
Field fieldOf(const BlockGrid& grid, const Function& function) {
  Field field(grid.nodeCount());
  for (std::size_t slot = 0; slot < grid.blockCount(); ++slot) {
    const Coord& b = grid.coord(slot);
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        for (int i = 0; i < kBlock; ++i) {
          const auto value = function(Vec3(b[0] * kBlock + i, b[1] * kBlock + j, b[2] * kBlock + k));
          field[slot * kBlockNodes + nodeIndex(i, j, k)] = static_cast<float>(value);
        }
      }
    }
  }
  return field;
}

float at(const BlockGrid& grid, const Field& field, const Coord& node) {
  const auto slot = static_cast<std::size_t>(grid.slot({node[0] / kBlock, node[1] / kBlock, node[2] / kBlock}));
  return field[slot * kBlockNodes + nodeIndex(node[0] % kBlock, node[1] % kBlock, node[2] % kBlock)];
}

double sumOf(const Field& field) {
  double sum = 0;
  for (const float value : field) {
    sum += value;
  }
  return sum;
}

double largest(const Field& field) {
  double most = 0;
  for (const float value : field) {
    most = std::max(most, static_cast<double>(std::abs(value)));
  }
  return most;
}

/// Random values on nodes at least `margin` from the cube's surface, 0 elsewhere.
Field randomField(const BlockGrid& grid, int margin, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  const int side = 1 << grid.level();
  return fieldOf(grid, [&](const Vec3& p) {
    const double v = value(random);
    return p.minCoeff() >= margin && p.maxCoeff() <= side - margin ? v : 0.0;
  });
}

/// Evenly spread points of a sphere in a cube of 2^depth cells, cell 1 mm, each with its share of the area.
OrientedPoints spherePoints(const Vec3& centre, double radius, int count) {
  OrientedPoints points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int n = 0; n < count; ++n) {
    const double z = 1 - (2 * n + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    const Vec3 normal(r * std::cos(turn * n), r * std::sin(turn * n), z);
    points.positions.emplace_back(centre + radius * normal);
    points.normals.push_back(normal);
    points.weights.push_back(4 * std::numbers::pi * radius * radius / count);
  }
  return points;
}

TEST(Splatting, KeepsTheSumOfTheWeightsAndReadsLinearFunctionsExactly) {
  const OrientedPoints points = spherePoints(Vec3(32.3, 31.9, 30.7), 20, 3000);
  const CubeSamples samples = toCube(points, Vec3::Zero(), 1.0, 6, {});
  const BlockGrid grid = denseGrid(6);
  Field density = zeroField(grid.nodeCount());
  splat(samples, samples.weights, grid, 1.0F, density, {});
  EXPECT_NEAR(sumOf(density), 4 * std::numbers::pi * 400, 0.01);

  const Field linear = fieldOf(grid, [](const Vec3& p) { return 3 + 0.5 * p[0] - 0.25 * p[1] + 0.125 * p[2]; });
  const auto values = valuesAt(samples, grid, linear, {});
  for (std::size_t n = 0; n < values.size(); ++n) {
    const auto& p = samples.positions[n];
    EXPECT_NEAR(values[n], 3 + 0.5F * p[0] - 0.25F * p[1] + 0.125F * p[2], 1e-4);
  }
}

TEST(Splatting, NormalsOfAClosedSurfaceSumToNothing) {
  const CubeSamples samples = toCube(spherePoints(Vec3(32, 32, 32), 20, 4000), Vec3::Zero(), 1.0, 6, {});
  const BlockGrid grid = denseGrid(6);
  VectorField v{zeroField(grid.nodeCount()), zeroField(grid.nodeCount()), zeroField(grid.nodeCount())};
  splatNormals(samples, grid, 1.0F, v, {});
  for (const Field& component : v) {
    EXPECT_NEAR(sumOf(component) / (4 * std::numbers::pi * 400), 0.0, 1e-4);
  }
}

TEST(Density, GivesASphereItsAreaFromPointsAlone) {
  for (const int count : {8000, 32000}) {
    CubeSamples samples = toCube(spherePoints(Vec3(64, 64, 64), 40, count), Vec3::Zero(), 1.0, 7, {});
    std::fill(samples.weights.begin(), samples.weights.end(), 1.0F);
    weighByDensity(samples, 6, 2.0, {});
    double area = 0;
    for (const float weight : samples.weights) {
      area += weight;
    }
    EXPECT_NEAR(area / (4 * std::numbers::pi * 1600), 1.0, 0.05) << count;
  }
}

TEST(Density, PointsOfSlicesWeighTheSameWhereTheCellsAreAsWideAsTheSlicesLieApart) {
  OrientedPoints points;  // a plane in cells: 0.5 apart in a slice, 1.6 from slice to slice
  for (double y = 16; y < 112; y += 0.5) {
    for (double z = 16; z < 112; z += 1.6) {
      points.positions.push_back(Vec3(64.3, y, z));
      points.normals.push_back(Vec3(1, 0, 0));
      points.weights.push_back(1);
    }
  }
  const auto worst = [&](int level) {  // of the weights away from the plane's rim, against the area of a point
    CubeSamples samples = toCube(points, Vec3::Zero(), 1.0, 7, {});
    weighByDensity(samples, level, static_cast<double>(1 << (7 - level)), {});
    double most = 0;
    for (std::size_t n = 0; n < samples.weights.size(); ++n) {
      const auto& p = samples.positions[n];
      if (std::min(p[1], p[2]) > 24 && std::max(p[1], p[2]) < 104) {
        most = std::max(most, std::abs(samples.weights[n] / (0.5 * 1.6) - 1.0));
      }
    }
    return most;
  };
  EXPECT_GT(worst(7), 0.25);
  EXPECT_LT(worst(6), 0.25);
}

TEST(Operators, StiffnessOfLinearFunctionsIsNothingAndOfASquareTwo) {
  const BlockGrid grid = denseGrid(5);
  Field out(grid.nodeCount());
  applyStiffness(grid, fieldOf(grid, [](const Vec3& p) { return 2 + p[0] - 3 * p[1] + p[2]; }), out, {});
  EXPECT_NEAR(at(grid, out, {9, 17, 12}), 0.0, 1e-4);
  applyStiffness(grid, fieldOf(grid, [](const Vec3& p) { return p[0] * p[0]; }), out, {});
  EXPECT_NEAR(at(grid, out, {9, 17, 12}), -2.0, 1e-3);  // -h^2 laplace
}

TEST(Operators, TheLargestEigenvalueOfTheStiffnessIsBelowFour) {
  const BlockGrid grid = denseGrid(4);
  Field u = randomField(grid, 1, 3);
  Field out(grid.nodeCount());
  double rayleigh = 0;
  for (int n = 0; n < 300; ++n) {
    applyStiffness(grid, u, out, {});
    double uu = 0;
    double us = 0;
    for (std::size_t m = 0; m < u.size(); ++m) {
      uu += static_cast<double>(u[m]) * u[m];
      us += static_cast<double>(u[m]) * out[m];
    }
    rayleigh = us / uu;
    const auto scale = static_cast<float>(1 / largest(out));
    for (std::size_t m = 0; m < u.size(); ++m) {
      u[m] = scale * out[m];
    }
  }
  EXPECT_GT(rayleigh, 3.7);
  EXPECT_LE(rayleigh, kLargestEigenvalue + 1e-5);
}

TEST(Operators, DivergenceOfAConstantIsNothingAndOfALinearFieldMinusItsSlope) {
  const BlockGrid grid = denseGrid(5);
  Field f(grid.nodeCount());
  const auto constant = [&](double c) { return fieldOf(grid, [c](const Vec3&) { return c; }); };
  divergence(grid, {constant(1), constant(-2), constant(3)}, 1.0F, f, {});
  EXPECT_NEAR(at(grid, f, {9, 17, 12}), 0.0, 1e-5);
  const auto along = [&](int axis, double slope) { return fieldOf(grid, [=](const Vec3& p) { return slope * p[axis]; }); };
  divergence(grid, {along(0, 2), along(1, 3), along(2, -4)}, 2.0F, f, {});
  EXPECT_NEAR(at(grid, f, {9, 17, 12}), -2.0 * (2 + 3 - 4), 1e-4);
}

TEST(Operators, AreNested) {
  const BlockGrid coarse = denseGrid(4);
  const BlockGrid fine = denseGrid(5);
  const Field u = randomField(coarse, 2, 5);
  Field pu(fine.nodeCount());
  prolong(coarse, u, fine, pu, {});
  Field spu(fine.nodeCount());
  applyStiffness(fine, pu, spu, {});
  Field galerkin(coarse.nodeCount());
  restrictTo(fine, spu, coarse, galerkin, 0.5F, {});
  Field direct(coarse.nodeCount());
  applyStiffness(coarse, u, direct, {});
  for (std::size_t n = 0; n < direct.size(); ++n) {
    EXPECT_NEAR(galerkin[n], direct[n], 1e-5);
  }
  const VectorField v{randomField(coarse, 2, 6), randomField(coarse, 2, 7), randomField(coarse, 2, 8)};
  VectorField pv{Field(fine.nodeCount()), Field(fine.nodeCount()), Field(fine.nodeCount())};
  for (std::size_t a = 0; a < 3; ++a) {
    prolong(coarse, v[a], fine, pv[a], {});
  }
  Field stored(fine.nodeCount());
  Field fused(fine.nodeCount());
  divergence(fine, pv, 0.5F, stored, {});
  divergenceOfCoarse(coarse, v, fine, 0.5F, fused, {});
  for (std::size_t n = 0; n < stored.size(); ++n) {
    EXPECT_NEAR(fused[n], stored[n], 1e-6);
  }
}

TEST(Solve, ChebyshevAndConjugateGradientsComeToTheSameSolution) {
  Level level(4);
  level.grid = denseGrid(4);
  const Field truth = randomField(level.grid, 1, 9);
  level.f = Field(level.grid.nodeCount());
  applyStiffness(level.grid, truth, level.f, {});
  level.x = zeroField(level.grid.nodeCount());
  Field other = level.x;
  CubeSamples none;
  none.depth = 4;
  conjugateGradients(none, {}, level, 200, {});
  chebyshev(level.grid, level.f, other, 200, 400.0F, {});
  for (std::size_t n = 0; n < truth.size(); ++n) {
    EXPECT_NEAR(level.x[n], truth[n], 2e-3);
    EXPECT_NEAR(other[n], truth[n], 2e-3);
  }
}

/// The levels solved for a sphere of radius 0.3 of the cube.
std::vector<Level> solvedSphere(int depth, CubeSamples& samples) {
  const double side = 1 << depth;
  samples = toCube(spherePoints(Vec3::Constant(0.5 * side), 0.3 * side, 1 << (2 * depth)), Vec3::Zero(), 1.0, depth, {});
  HierarchyOptions options;
  options.kernelLevel = depth;
  auto levels = makeLevels(samples, options);
  makeRightHandSides(samples, options, levels, {});
  solveLevels(samples, options, levels, {});
  return levels;
}

TEST(Solve, OfASphereIsOneInsideNothingOutsideAndAHalfAtTheSamples) {
  CubeSamples samples;
  const auto levels = solvedSphere(7, samples);
  EXPECT_NEAR(nodeValue(levels, levels.size() - 1, {64, 64, 64}), 1.0, 0.03);
  EXPECT_NEAR(nodeValue(levels, levels.size() - 1, {64, 64, 35}), 1.0, 0.03);
  EXPECT_NEAR(nodeValue(levels, levels.size() - 1, {64, 64, 14}), 0.0, 0.03);
  EXPECT_NEAR(nodeValue(levels, levels.size() - 1, {5, 5, 5}), 0.0, 0.01);
  EXPECT_NEAR(isoValue(samples, levels.back(), {}), 0.5, 0.03);
}

TEST(Solve, TheVolumeErrorOfASphereFallsAtSecondOrder) {
  std::vector<double> errors;
  for (const int depth : {5, 6, 7, 8}) {
    CubeSamples samples;
    auto levels = solvedSphere(depth, samples);
    const auto mesh = extractSurface(levels, isoValue(samples, levels.back(), {}), Vec3::Zero(), 1.0 / (1 << depth), {});
    EXPECT_FALSE(mesh.defects().any());
    errors.push_back(std::abs(signedVolumeMm3(mesh) / (4.0 / 3.0 * std::numbers::pi * std::pow(0.3, 3)) - 1));
  }
  EXPECT_LT(errors[0], 2e-3);
  EXPECT_LT(errors[2], errors[0] / 8) << "two levels";
  EXPECT_LT(errors[3], errors[1] / 8) << "two levels";
}

template <typename Function>
SurfaceMesh extracted(int depth, const Function& function) {
  std::vector<Level> levels;
  for (int level = kCoarsestLevel; level <= depth; ++level) {
    levels.emplace_back(level).grid = denseGrid(level);
    const double cell = 1.0 / (1 << level);
    levels.back().x = fieldOf(levels.back().grid, [&](const Vec3& p) { return p.minCoeff() == 0 ? 0.0 : function(p * cell); });
  }
  return extractSurface(levels, 0.5F, Vec3::Zero(), 1.0 / (1 << depth), {});
}

TEST(Extraction, OfATorusHasOneHandleAndItsVolumeErrorFallsAtSecondOrder) {
  const auto torus = [](const Vec3& p) {
    const Vec3 q = p - Vec3(0.51, 0.49, 0.505);
    return std::clamp(0.5 + 4 * (0.12 - std::hypot(std::hypot(q[0], q[1]) - 0.25, q[2])), 0.0, 1.0);
  };
  const double truth = 2 * std::numbers::pi * std::numbers::pi * 0.25 * 0.12 * 0.12;
  double before = 0;
  for (const int depth : {5, 6, 7}) {
    const SurfaceMesh mesh = extracted(depth, torus);
    EXPECT_FALSE(mesh.defects().any());
    EXPECT_EQ(eulerCharacteristic(mesh), 0);
    const double error = std::abs(signedVolumeMm3(mesh) / truth - 1);
    if (depth > 5) {
      EXPECT_LT(error, before / 3) << "depth " << depth;
    }
    before = error;
  }
}

TEST(Frame, KeepsTheCubeForEveryDepthAndTheCellsFromTheSpacing) {
  OrientedPoints points;
  points.positions = {Vec3(-50, 0, 10), Vec3(50, 30, 60)};
  ImageGeometry geometry;
  geometry.spacing = Vec3(0.8, 0.8, 2.5);
  PoissonParameters parameters;
  for (int depth = 5; depth <= 10; ++depth) {
    parameters.depth = depth;
    const Frame frame = chooseFrame(points, geometry, parameters);
    EXPECT_NEAR(frame.cellMm * (1 << frame.depth), 110.0, 1e-9);
    EXPECT_TRUE((frame.corner - Vec3(-55, -40, -20)).norm() < 1e-9);
    EXPECT_GE(frame.cellMm, 0.4);
    EXPECT_GE(frame.cellMmOf(frame.kernelLevel), 1.25);
    EXPECT_LE(frame.depth, std::min(depth, 8));
    EXPECT_GE(frame.cellMmOf(frame.densityLevel), 2.5);
    EXPECT_LE(frame.densityLevel, frame.kernelLevel);
  }
}

}  // namespace
}  // namespace glisson::poisson
