#include "reconstruction/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/mesh/untangle.h"
#include "tests/reconstruction/mesh/solids.h"

namespace glisson {
namespace {

struct Sphere {
  Vec3 centre;
  double radius;
};

struct Specimen {
  Mask mask;
  ImageGeometry geometry;
};

/// Balls (index coordinates) less hollows on a grid of cubes of 0.8 mm.
Specimen ballsOf(const Index3& size, const std::vector<Sphere>& balls, const std::vector<Sphere>& hollows = {}) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0);
  std::size_t n = 0;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i, ++n) {
        const auto holds = [&](const Sphere& ball) { return (Vec3(i, j, k) - ball.centre).norm() <= ball.radius; };
        if (std::any_of(balls.begin(), balls.end(), holds) && std::none_of(hollows.begin(), hollows.end(), holds)) {
          values[n] = 1;
        }
      }
    }
  }
  Specimen body{Mask::fromGrid(size, values), {}};
  body.geometry.size = size;
  body.geometry.spacing = Vec3::Constant(0.8);
  body.geometry.origin = Vec3(-50, 20, -300);
  return body;
}

bool anyContains(const std::vector<std::string>& texts, std::string_view part) {
  return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// Voxels set by chance, `percent` of them.
Specimen noiseOf(const Index3& size, unsigned percent, std::mt19937& random) {
  Specimen noise;
  noise.geometry.size = size;
  std::vector<std::uint8_t> values(noise.geometry.voxelCount());
  for (auto& v : values) {
    v = random() % 100 < percent ? 1 : 0;
  }
  noise.mask = Mask::fromGrid(size, values);
  return noise;
}

ReconstructionParameters mcsd(int smoothing, double decimation, SmoothingFilter filter = SmoothingFilter::Sinc) {
  ReconstructionParameters parameters;
  parameters.method = Method::Mcsd;
  parameters.mcsd.smoothing = smoothing;
  parameters.mcsd.decimation = decimation;
  parameters.mcsd.filter = filter;
  return parameters;
}

TEST(Reconstruct, DefaultsArePsrForTheParenchymaAndSincMcsdForTheRest) {
  EXPECT_EQ(ReconstructionParameters::defaultsFor(StructureKind::Liver).describe(), "PSR d=7 unbiased");
  EXPECT_EQ(ReconstructionParameters::defaultsFor(StructureKind::PortalVein).describe(), "MCSD sinc 10 decimation 25 %");
  EXPECT_EQ(mcsd(0, 0.0).describe(), "MCSD unsmoothed decimation 0 %");
  EXPECT_EQ(mcsd(22, 0.9, SmoothingFilter::Laplacian).describe(), "MCSD Laplacian 22 decimation 90 %");
}

TEST(Reconstruct, ABallIsSoundByBothMethodsAndKeepsItsVolume) {
  const Specimen ball = ballsOf({48, 48, 48}, {{{23, 24, 25}, 18}});
  for (const auto kind : {StructureKind::Liver, StructureKind::Tumour}) {
    const Reconstruction made = reconstruct(ball.mask, ball.geometry, kind, ReconstructionParameters::defaultsFor(kind));
    EXPECT_EQ(made.defects.names(), std::vector<std::string>{});
    EXPECT_EQ(made.deviations, std::vector<std::string>{});
    EXPECT_FALSE(anyContains(made.notes, "Euler"));
    EXPECT_FALSE(anyContains(made.notes, "piece"));
    EXPECT_EQ(made.maskComponents, 1U);
    EXPECT_EQ(made.meshComponents, 1U);
    EXPECT_NEAR(made.voxelVolumeMl, static_cast<double>(ball.mask.count()) * 0.512e-3, 1e-9);
    EXPECT_LT(std::abs(made.volumeDeviation()), 0.01);
    EXPECT_FALSE(made.centrelineInside.has_value());
  }
}

TEST(Reconstruct, AVolumeDeviationBeyondTheLimitOfItsKindIsNamed) {
  const Specimen ball = ballsOf({30, 30, 30}, {{{15, 15, 15}, 9}});
  const auto parameters = mcsd(90, 0.0, SmoothingFilter::Laplacian);
  const Reconstruction made = reconstruct(ball.mask, ball.geometry, StructureKind::Tumour, parameters);
  ASSERT_EQ(made.deviations.size(), 1U);
  EXPECT_TRUE(made.deviations[0].starts_with("volume -")) << made.deviations[0];
  EXPECT_TRUE(made.deviations[0].ends_with(" % against the voxels")) << made.deviations[0];
}

TEST(Reconstruct, ASmallTumourMayDeviateByATwentiethOfAMillilitre) {
  const Specimen ball = ballsOf({12, 12, 12}, {{{6, 6, 6}, 3}});  // 0.063 mL
  const Reconstruction made = reconstruct(ball.mask, ball.geometry, StructureKind::Tumour, mcsd(10, 0.25));
  EXPECT_GT(std::abs(made.volumeDeviation()), 0.02);
  EXPECT_EQ(made.deviations, std::vector<std::string>{});
  const Reconstruction asVessel = reconstruct(ball.mask, ball.geometry, StructureKind::PortalVein, mcsd(10, 0.25));
  EXPECT_FALSE(asVessel.deviations.empty());
}

TEST(Reconstruct, LostPiecesAreNamedWithTheirVoxelsAndASingleVoxelIsANoteOnly) {
  // 400 rounds of Laplacian smoothing shrink the small ball and the single voxel to nothing much.
  const Specimen balls = ballsOf({60, 40, 40}, {{{20, 20, 20}, 16}, {{50, 20, 20}, 2.3}, {{50, 5, 5}, 0.5}});
  const Reconstruction worn =
      reconstruct(balls.mask, balls.geometry, StructureKind::Tumour, mcsd(400, 0.0, SmoothingFilter::Laplacian));
  EXPECT_EQ(worn.maskComponents, 3U);
  EXPECT_TRUE(anyContains(worn.notes, "2 pieces of 3 lost: 57, 1 voxels"));
  EXPECT_TRUE(anyContains(worn.deviations, "1 piece lost: 57 voxels"));
  ReconstructionParameters psr;
  psr.psr.depth = 6;
  const Reconstruction kept = reconstruct(balls.mask, balls.geometry, StructureKind::Liver, psr);
  EXPECT_TRUE(anyContains(kept.notes, "1 piece of 3 lost: 1 voxel"));
  EXPECT_TRUE(anyContains(kept.notes, "2 pieces in the mesh, 3 in the mask"));
  EXPECT_TRUE(anyContains(kept.notes, "1 piece thinner than three cells"));
  EXPECT_EQ(kept.deviations, std::vector<std::string>{});
}

TEST(Reconstruct, ADepthTheVoxelsDoNotCarryIsLoweredAndNoted) {
  const Specimen ball = ballsOf({24, 24, 24}, {{{12, 12, 12}, 8}});
  ReconstructionParameters psr;
  psr.psr.depth = 9;
  const Reconstruction made = reconstruct(ball.mask, ball.geometry, StructureKind::Liver, psr);
  EXPECT_LT(made.usedDepth, 9);
  EXPECT_TRUE(anyContains(made.notes, "depth " + std::to_string(made.usedDepth) + " used instead of 9"));
}

TEST(Reconstruct, AMaskAtTheBorderIsNotedAndClosed) {
  const Specimen ball = ballsOf({30, 30, 20}, {{{15, 15, 18}, 9}});
  for (const auto kind : {StructureKind::Liver, StructureKind::Cyst}) {
    const Reconstruction made = reconstruct(ball.mask, ball.geometry, kind, ReconstructionParameters::defaultsFor(kind));
    EXPECT_FALSE(made.defects.any());
    EXPECT_TRUE(anyContains(made.notes, "touches the border"));
  }
}

TEST(Reconstruct, ACavityIsRepresentedOrNoted) {
  const Specimen shell = ballsOf({40, 40, 40}, {{{20, 20, 20}, 16}}, {{{20, 20, 20}, 6}});
  const Reconstruction made = reconstruct(shell.mask, shell.geometry, StructureKind::Liver, mcsd(10, 0.25));
  EXPECT_FALSE(anyContains(made.notes, "cavit"));
  EXPECT_FALSE(anyContains(made.notes, "Euler"));
  EXPECT_EQ(made.meshComponents, 1U);
  // Pores of 7 and 1 voxels are too small for cells of 3.8 mm.
  const Specimen pores =
      ballsOf({150, 60, 60}, {{{30, 30, 30}, 26}, {{140, 30, 30}, 6}}, {{{30, 30, 30}, 0.5}, {{20, 30, 30}, 1.2}});
  ReconstructionParameters coarse;
  coarse.psr.depth = 5;
  const Reconstruction filled = reconstruct(pores.mask, pores.geometry, StructureKind::Liver, coarse);
  EXPECT_TRUE(anyContains(filled.notes, "2 cavities of 2 not represented: 7, 1 voxels"));
  EXPECT_TRUE(anyContains(filled.notes, "Euler number"));
}

TEST(Reconstruct, AVesselsCentrelineLiesInsideItsMesh) {
  std::vector<Sphere> tube;
  for (int n = 0; n < 60; ++n) {
    tube.push_back({{8.0 + n, 12.0 + 6.0 * std::sin(n / 12.0), 14.0}, 3.2});
  }
  const Specimen vessel = ballsOf({80, 30, 28}, tube);
  const Reconstruction good = reconstruct(vessel.mask, vessel.geometry, StructureKind::PortalVein, mcsd(10, 0.25));
  ASSERT_TRUE(good.centrelineInside.has_value());
  EXPECT_EQ(*good.centrelineInside, 1.0);
  const Reconstruction worn =
      reconstruct(vessel.mask, vessel.geometry, StructureKind::PortalVein, mcsd(1000, 0.0, SmoothingFilter::Laplacian));
  EXPECT_LT(*worn.centrelineInside, 0.9);
  EXPECT_TRUE(anyContains(worn.notes, "of the centreline lies inside"));
}

TEST(Reconstruct, SelfIntersectionsOfSmoothingAreUndoneWhereTheyAreFew) {
  SurfaceMesh mesh = test::sphere(Vec3(10, 20, 30), 10, 4);
  const Vec3 pushed = mesh.vertices[100] + 1.9 * (Vec3(10, 20, 30) - mesh.vertices[100]);
  mesh.vertices[100] = mesh.vertices[100] + 0.02 * (pushed - mesh.vertices[100]);
  std::swap(mesh.vertices[700], mesh.vertices[mesh.triangles[0][0] == 700 ? 701 : 700]);
  for (std::size_t n = 0; n < 3; ++n) {
    mesh.vertices[mesh.triangles[50][n]] +=
        0.9 * (mesh.vertices[mesh.triangles[50][(n + 1) % 3]] - mesh.vertices[mesh.triangles[50][n]]);
  }
  const Triangle& folded = mesh.triangles[500];
  mesh.vertices[folded[0]] = 2.2 * mesh.vertices[folded[1]] - 1.2 * mesh.vertices[folded[0]];
  const std::size_t before = countSelfIntersections(mesh);
  ASSERT_GT(before, 0U);
  SurfaceMesh left = mesh;
  EXPECT_EQ(untangle(left, before - 1).movedVertices, 0U);
  const Untangled result = untangle(mesh, before);
  EXPECT_EQ(result.before, before);
  EXPECT_EQ(result.after, 0U);
  EXPECT_LT(result.movedVertices, 60U);
  EXPECT_EQ(countSelfIntersections(mesh), 0U);
}

TEST(Reconstruct, UntanglingNeverLeavesMorePairsThanThereWere) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    SurfaceMesh mesh = test::sphere(Vec3(1, 2, 3), 10, 3);
    for (int n = 0; n < 12; ++n) {  // neighbours that change places: some of these cannot be undone by moving them to their mean
      const Triangle& t = mesh.triangles[random() % mesh.triangles.size()];
      std::swap(mesh.vertices[t[0]], mesh.vertices[t[1]]);
    }
    const std::vector<Vec3> given = mesh.vertices;
    const Untangled result = untangle(mesh, 100000);
    EXPECT_LE(result.after, result.before);
    EXPECT_EQ(result.after, countSelfIntersections(mesh));
    EXPECT_EQ(result.after == result.before, mesh.vertices == given);
    EXPECT_EQ(result.movedVertices > 0, result.after < result.before);
  }
}

TEST(Reconstruct, ASimplifiedSurfaceIsJudgedByItsOwnCrossings) {
  // Laplacian smoothing behind decimation leaves thin tubes with triangles that cross; simplification makes sound ones of some.
  std::mt19937 random(3);
  std::size_t crossedBefore = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Specimen noise = noiseOf({14, 13, 12}, 12, random);
    ReconstructionParameters parameters = mcsd(45, 0.5, SmoothingFilter::Laplacian);
    const Reconstruction plain = reconstruct(noise.mask, noise.geometry, StructureKind::Tumour, parameters);
    crossedBefore += plain.defects.selfIntersections > 0 ? 1 : 0;
    parameters.simplify = SimplifyTarget{.triangles = 200};
    const Reconstruction made = reconstruct(noise.mask, noise.geometry, StructureKind::Tumour, parameters);
    EXPECT_EQ(made.defects.selfIntersections, countSelfIntersections(made.mesh)) << trial;
    EXPECT_EQ(made.defects.nonManifoldEdges + made.defects.nonManifoldVertices + made.defects.degenerateTriangles > 0,
              anyContains(made.notes, "not simplified"))
        << trial;
  }
  EXPECT_GT(crossedBefore, 0U);
}

TEST(Reconstruct, ASetThatCannotBeSimplifiedIsNotedAndTheOthersGoOn) {
  std::mt19937 random(2016);
  const Specimen noise = noiseOf({10, 9, 11}, 25, random);
  std::vector<ReconstructionParameters> sets{mcsd(0, 0.9), ReconstructionParameters()};
  for (auto& set : sets) {
    set.simplify = SimplifyTarget{.triangles = 300};
  }
  std::vector<Reconstruction> made(2);
  reconstructEach(noise.mask, noise.geometry, StructureKind::Tumour, sets,
                  [&](std::size_t n, Reconstruction one) { made[n] = std::move(one); });
  ASSERT_GT(made[0].defects.nonManifoldEdges, 0U) << "the body is meant to lose this";
  EXPECT_TRUE(anyContains(made[0].notes, "not simplified"));
  EXPECT_TRUE(anyContains(made[1].notes, "simplified from"));
}

TEST(Reconstruct, AClosedSurfaceWithEdgesThatAreNotManifoldIsComparedWithTheMaskToo) {
  // Decimation leaves edges with four triangles: an inside there is all the same.
  std::mt19937 random(2016);
  const Specimen noise = noiseOf({10, 9, 11}, 25, random);
  const Reconstruction made = reconstruct(noise.mask, noise.geometry, StructureKind::PortalVein, mcsd(0, 0.9));
  ASSERT_GT(made.defects.nonManifoldEdges, 0U);
  ASSERT_EQ(made.defects.openEdges, 0U);
  EXPECT_TRUE(std::isfinite(made.meshVolumeMl));
  EXPECT_TRUE(made.centrelineInside.has_value());
}

TEST(Reconstruct, ThirtyLumpyBodiesAreSoundAndWithoutSelfIntersectionsByTheDefaults) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<Sphere> balls;
    for (int n = 0; n < 5; ++n) {
      balls.push_back({Vec3(8 + 16 * share(random), 8 + 16 * share(random), 8 + 16 * share(random)), 2.0 + 4.0 * share(random)});
    }
    const Specimen body = ballsOf({32, 32, 32}, balls);
    const Reconstruction made = reconstruct(body.mask, body.geometry, StructureKind::Tumour, mcsd(10, 0.25));
    EXPECT_EQ(made.defects.names(), std::vector<std::string>{}) << trial;
    EXPECT_EQ(countSelfIntersections(made.mesh), 0U) << trial;
  }
}

TEST(Reconstruct, NamesEveryInvariantThatDecimationBreaksAndHowOften) {
  std::mt19937 random(2016);
  std::size_t manifoldLost = 0;
  std::size_t crossed = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Specimen noise = noiseOf({10, 9, 11}, 25, random);
    for (const int smoothing : {0, 10}) {
      const Reconstruction made = reconstruct(noise.mask, noise.geometry, StructureKind::Tumour, mcsd(smoothing, 0.9));
      // Counted another way: by a map of undirected edges.
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> uses;
      for (const Triangle& t : made.mesh.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
          ++uses[std::minmax(t[c], t[(c + 1) % 3])];
        }
      }
      const auto edges =
          static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), [](const auto& u) { return u.second > 2; }));
      EXPECT_EQ(made.defects.nonManifoldEdges, edges) << trial;
      EXPECT_EQ(made.defects.selfIntersections, countSelfIntersections(made.mesh)) << trial;
      const std::string text =
          "edge: " + std::to_string(edges) + (edges == 1 ? " edge is not manifold" : " edges are not manifold");
      EXPECT_EQ(anyContains(made.defects.names(), text), edges > 0) << trial;
      EXPECT_EQ(anyContains(made.defects.names(), "self-intersection: "), made.defects.selfIntersections > 0) << trial;
      manifoldLost += edges > 0 ? 1 : 0;
      crossed += made.defects.selfIntersections > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(manifoldLost, 0U);
  EXPECT_GT(crossed, 0U);
}

TEST(Reconstruct, EverySetOfAListIsMadeAsByItself) {
  const Specimen ball = ballsOf({48, 30, 30}, {{{15, 15, 15}, 10}, {{32, 15, 15}, 8.5}});
  std::vector<ReconstructionParameters> sets{mcsd(10, 0.25), ReconstructionParameters(), mcsd(22, 0.5, SmoothingFilter::Laplacian),
                                             mcsd(45, 0.5, SmoothingFilter::Laplacian), mcsd(0, 0.5)};
  sets[1].psr.depth = 6;
  sets[1].simplify = SimplifyTarget{.triangles = 1000};
  sets[2].simplify = SimplifyTarget{.triangles = 500};
  std::vector<Reconstruction> all(sets.size());
  reconstructEach(ball.mask, ball.geometry, StructureKind::PortalVein, sets,
                  [&](std::size_t n, Reconstruction made) { all[n] = std::move(made); });
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const Reconstruction one = reconstruct(ball.mask, ball.geometry, StructureKind::PortalVein, sets[n]);
    EXPECT_EQ(all[n].parameters.describe(), sets[n].describe());
    EXPECT_EQ(all[n].mesh.vertices, one.mesh.vertices) << n;
    EXPECT_EQ(all[n].mesh.triangles, one.mesh.triangles) << n;
    EXPECT_EQ(all[n].notes, one.notes) << n;
    EXPECT_EQ(all[n].deviations, one.deviations) << n;
    EXPECT_EQ(all[n].centrelineInside, one.centrelineInside) << n;
    EXPECT_EQ(all[n].usedDepth, one.usedDepth) << n;
  }
}

TEST(Reconstruct, TheAutomaticDepthHasCellsFromFourToEightFifthsOfTheSmallestSpacing) {
  ReconstructionParameters automatic;
  automatic.autoDepth = true;
  automatic.psr.depth = 5;  // not looked at
  EXPECT_EQ(automatic.describe(), "PSR d=auto unbiased");
  for (const int length : {40, 60, 90, 130}) {  // cells halve from one depth to the next; the lengths do not double
    const Specimen rod = ballsOf({length, 12, 12}, {{{6, 6, 6}, 3}, {{length - 6.0, 6, 6}, 3}});
    const PoissonResult made = reconstructPoisson(rod.mask, rod.geometry, automatic.usedPsr());
    EXPECT_GE(made.cellMm, 0.8 * 0.8) << length;
    EXPECT_LT(made.cellMm, 1.6 * 0.8) << length;
    const Reconstruction checked = reconstruct(rod.mask, rod.geometry, StructureKind::PortalVein, automatic);
    EXPECT_EQ(checked.usedDepth, made.usedDepth);
    EXPECT_FALSE(anyContains(checked.notes, "used instead of"));
    ReconstructionParameters asked;
    asked.psr.depth = made.usedDepth;
    EXPECT_EQ(reconstruct(rod.mask, rod.geometry, StructureKind::PortalVein, asked).mesh.vertices, checked.mesh.vertices);
  }
}

TEST(Reconstruct, AThinTreeKeepsItsBranchesByTheAutomaticDepthWithScreening) {
  std::vector<Sphere> tree;
  for (int n = 0; n < 100; ++n) {
    tree.push_back({{6.0 + n, 40.0, 40.0}, 4.0 - 0.025 * n});
    tree.push_back({{40.0 + 0.5 * n, 40.0 + 0.3 * n, 40.0 + 0.2 * n}, 1.6});
    tree.push_back({{30.0 + 0.4 * n, 40.0 - 0.35 * n, 40.0 - 0.3 * n}, 1.4});
  }
  const Specimen vessel = ballsOf({110, 80, 70}, tree);
  ReconstructionParameters automatic;
  automatic.autoDepth = true;
  automatic.psr.pointWeight = 16;
  automatic.simplify = SimplifyTarget{.distanceMm = 0.16};
  const Reconstruction made = reconstruct(vessel.mask, vessel.geometry, StructureKind::PortalVein, automatic);
  EXPECT_EQ(made.defects.names(), std::vector<std::string>{});
  EXPECT_EQ(made.meshComponents, 1U);
  EXPECT_GE(*made.centrelineInside, 0.99);
  EXPECT_LT(std::abs(made.volumeDeviation()), 0.02);
  EXPECT_EQ(made.deviations, std::vector<std::string>{});
}

TEST(Reconstruct, AnEmptyMaskAndSenselessParametersAreRefused) {
  ImageGeometry geometry;
  geometry.size = {4, 4, 4};
  EXPECT_THROW(reconstruct(Mask(), geometry, StructureKind::Liver, {}), ReconstructionError);
  const Mask mask = Mask::fromGrid(geometry.size, std::vector<std::uint8_t>(64, 1));
  EXPECT_THROW(reconstruct(mask, geometry, StructureKind::Tumour, mcsd(-1, 0.0)), UsageError);
}

TEST(Reconstruct, ProgressNeverFallsAndEndsAtOne) {
  const Specimen ball = ballsOf({30, 30, 30}, {{{15, 15, 15}, 9}});
  for (const auto kind : {StructureKind::Liver, StructureKind::PortalVein}) {
    double last = 0.0;
    const ExecutionContext context([&](double fraction, std::string_view) {
      EXPECT_GE(fraction, last);
      last = fraction;
    });
    reconstruct(ball.mask, ball.geometry, kind, ReconstructionParameters::defaultsFor(kind), context);
    EXPECT_DOUBLE_EQ(last, 1.0);
  }
}

TEST(Reconstruct, ACancelInAnyPhaseEndsIt) {
  const Specimen ball = ballsOf({40, 40, 40}, {{{20, 20, 20}, 16}});
  for (const auto kind : {StructureKind::Liver, StructureKind::PortalVein}) {
    for (const double when : {0.0, 0.2, 0.5, 0.8, 0.85, 0.95}) {
      std::unique_ptr<ExecutionContext> context;
      context = std::make_unique<ExecutionContext>([&](double fraction, std::string_view) {
        if (fraction >= when) {
          context->cancel();
        }
      });
      EXPECT_THROW(reconstruct(ball.mask, ball.geometry, kind, ReconstructionParameters::defaultsFor(kind), *context), Cancelled);
    }
  }
}

}  // namespace
}  // namespace glisson
