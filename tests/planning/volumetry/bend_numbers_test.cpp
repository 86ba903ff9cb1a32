// Numbers of bent planes against closed forms, flat planes and brute force.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "planning/territories/perfusion.h"
#include "planning/volumetry/assessment.h"
#include "planning/volumetry/bend_over.h"
#include "planning/volumetry/flat_stretches.h"
#include "planning/volumetry/near_surface.h"
#include "planning/volumetry/side_pieces.h"
#include "planning/volumetry/tumour_depth.h"
#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/parallel.h"
#include "tests/planning/voxel_bodies.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {
using namespace test;

const Vec3 kTurnedSpacing(0.8, 0.7, 2.5);

/// A box of liver, 80 x 70 x 75 mm about the origin, in an oblique and mirrored grid where asked.
ImageGeometry boxGrid(bool oblique = false) {
  ImageGeometry g = gridOf({100, 100, 30}, kTurnedSpacing);
  if (oblique) {
    g.direction = Eigen::AngleAxisd(0.4, Vec3(1, -2, 1).normalized()).toRotationMatrix() * Vec3(1, 1, -1).asDiagonal();
  }
  g.origin = -(g.direction * (0.5 * kTurnedSpacing.cwiseProduct(Vec3(99, 99, 29))));
  return g;
}

VoxelRows allRows(const ImageGeometry& g) {
  return rowsOf(*voxelised(g, [](const Vec3&) { return true; }));
}

ResectionPlane bentRandomly(const HalfSpace& plane, std::mt19937& random, double mm, double halfSize = 70) {
  std::uniform_real_distribution<double> height(-mm, mm);
  ResectionPlane bent(plane, flatBend(plane, halfSize));
  for (double& h : bent.bend->heightsMm) {
    h = height(random);
  }
  return bent;
}

/// Heights of a quadric a U^2 + b U V + c V^2, which a cubic Bezier surface has exactly.
void setQuadric(Bend& bend, double a, double b, double c) {
  const double s = bend.halfSizeMm;
  const std::array<double, 4> square{s * s, -s * s / 3, -s * s / 3, s * s};  // blossom of x^2 on [-s, s]
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = s * (2.0 * static_cast<double>(i) / 3 - 1);
      const double y = s * (2.0 * static_cast<double>(j) / 3 - 1);
      bend.heightsMm[4 * j + i] = a * square[i] + b * x * y + c * square[j];
    }
  }
}

Resected counted(const ImageGeometry& g, const ResectionPlan& plan) { return resect(allRows(g), g.spacing, toImage(plan, g)); }
double volumeMm3(const ImageGeometry& g, const Resected& taken) {
  return static_cast<double>(taken.totalUnits()) / kUnitsPerVoxel * g.voxelVolumeMm3();
}

/// A ball of liver with one tumour, about the origin.
Case liverWith(const Vec3& tumour, double radius) {
  const ImageGeometry g = gridOf({112, 112, 36}, Vec3(0.8, 0.8, 2.5), -0.5 * Vec3(0.8, 0.8, 2.5).cwiseProduct(Vec3(111, 111, 35)));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3::Zero(), 40)},
                                             {"tumour", StructureKind::Tumour, ball(tumour, radius)}}));
}

TEST(BendNumbers, FlatBendGivesThePlanesNumbers) {
  std::mt19937 random(1);
  for (int n = 0; n < trials(20); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const HalfSpace plane{10 * randomDirection(random), randomDirection(random)};
    const Resected flat = counted(g, planOf({{plane}}));
    const Resected bent = counted(g, planOf({{ResectionPlane(plane, flatBend(plane, 30))}}));
    EXPECT_NEAR(volumeMm3(g, bent), volumeMm3(g, flat), 1e-9 * volumeMm3(g, flat));
    EXPECT_NEAR(bent.cutAreaMm2[0], flat.cutAreaMm2[0], 1e-6 * flat.cutAreaMm2[0]);
  }
}

TEST(BendNumbers, LinearHeightsAreATiltedPlane) {
  std::mt19937 random(2);
  for (int n = 0; n < trials(20); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const HalfSpace plane{10 * randomDirection(random), randomDirection(random)};
    ResectionPlane bent(plane, flatBend(plane, 90));
    const double alongU = 0.3;
    const double alongV = -0.2;
    const Vec3 v = plane.normal.cross(bent.bend->u);
    for (std::size_t p = 0; p < 16; ++p) {
      const Vec3 at = controlPoint(bent, p) - plane.origin;
      bent.bend->heightsMm[p] = 4 + alongU * at.dot(bent.bend->u) + alongV * at.dot(v);
    }
    const HalfSpace tilted{plane.origin + 4 * plane.normal, (plane.normal - alongU * bent.bend->u - alongV * v).normalized()};
    const Resected flat = counted(g, planOf({{tilted}}));
    EXPECT_NEAR(volumeMm3(g, counted(g, planOf({{bent}}))), volumeMm3(g, flat), 1e-9 * volumeMm3(g, flat));
  }
}

TEST(BendNumbers, ParaboloidThroughABoxTakesItsIntegral) {
  // Along each axis of the grid and obliquely to it, the paraboloid leaves through the same four faces.
  const ImageGeometry g = boxGrid();
  const Vec3 size = kTurnedSpacing.cwiseProduct(Vec3(100, 100, 30));
  for (int axis = 0; axis < 3; ++axis) {
    const HalfSpace plane{Vec3::Zero(), Vec3::Unit(axis)};
    ResectionPlane bent(plane, flatBend(plane, 60));
    const double a = 0.011;
    const double b = 0.004;
    const double c = -0.007;
    setQuadric(*bent.bend, a, b, c);
    // The mean height over the rectangle of the other two sides; the mixed term has none.
    const double wide = size.dot(bent.bend->u.cwiseAbs());
    const double high = size.dot(plane.normal.cross(bent.bend->u).cwiseAbs());
    const double mean = (a * wide * wide + c * high * high) / 12;
    const double expected = wide * high * (0.5 * size[axis] - mean);
    const Resected taken = counted(g, planOf({{bent}}));
    EXPECT_NEAR(volumeMm3(g, taken), expected, 1e-4 * expected) << axis;
    EXPECT_NEAR(volumeMm3(g, taken), expected, 1e-6 * expected) << axis << ": of fourth order";
  }
}

TEST(BendNumbers, SaddleThroughABallIsTheIntegralByFineSlices) {
  // Resected is what lies above the surface in a ball of voxels: against a count on a grid nine times as fine along the normal.
  const ImageGeometry g = boxGrid(true);
  const auto inside = ball(Vec3(1, 2, -1), 30);
  const VoxelRows rows = rowsOf(*voxelised(g, inside));
  const HalfSpace plane{Vec3(2, 0, 1), Vec3(1, 2, -2) / 3};
  ResectionPlane bent(plane, flatBend(plane, 50));
  setQuadric(*bent.bend, 0.012, 0.006, -0.012);
  const BentSurface surface = BentSurface(bent).inFrame(g);
  double fine = 0;
  constexpr int kParts = 9;
  for (const RowRun& run : rows.runs) {
    for (int i = run.i; i < run.i + run.n; ++i) {
      const Box box = boxOf({i, run.j, run.k, 1}, g.spacing);
      if (std::abs(surface.above(box.centre)) > surface.reach(box.half)) {
        fine += surface.above(box.centre) > 0 ? 1 : 0;
        continue;
      }
      int above = 0;
      for (int p = 0; p < kParts * kParts * kParts; ++p) {
        const int layer = p / kParts / kParts;
        const Vec3 share = Vec3(p % kParts, p / kParts % kParts, layer) * (2.0 / kParts) - Vec3::Constant(1 - 1.0 / kParts);
        above += surface.above(box.centre + box.half.cwiseProduct(share)) > 0 ? 1 : 0;
      }
      fine += static_cast<double>(above) / (kParts * kParts * kParts);
    }
  }
  const double taken = static_cast<double>(resect(rows, g.spacing, toImage(planOf({{bent}}), g)).totalUnits()) / kUnitsPerVoxel;
  EXPECT_NEAR(taken, fine, 1e-4 * fine);
}

TEST(BendNumbers, SwappedSidesAreTheRest) {
  std::mt19937 random(3);
  for (int n = 0; n < trials(20); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const ResectionPlane bent = bentRandomly({5 * randomDirection(random), randomDirection(random)}, random, 25);
    const VoxelRows rows = allRows(g);
    const std::int64_t total = static_cast<std::int64_t>(rows.voxels) << 32;
    const std::int64_t one = counted(g, planOf({{bent}})).totalUnits();
    const std::int64_t other = counted(g, planOf({{flipped(bent)}})).totalUnits();
    EXPECT_NEAR(static_cast<double>(one + other) / static_cast<double>(total), 1, 1e-9);
  }
}

TEST(BendNumbers, MovedByATenthOfAMillimetreTheVolumeChangesByTheAreaSeenAlongTheNormal) {
  std::mt19937 random(4);
  for (int n = 0; n < trials(20); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const ResectionPlane bent = bentRandomly({5 * randomDirection(random), randomDirection(random)}, random, 15);
    const ResectionPlane moved = movedTo(bent, movedAlongNormal(bent, 0.1));
    const double change = volumeMm3(g, counted(g, planOf({{bent}}))) - volumeMm3(g, counted(g, planOf({{moved}})));
    double projected = 0;
    for (const CutPiece& piece : cutSurface(allRows(g), g.spacing, toImage(planOf({{bent}}), g))) {
      projected += areaOf(piece.polygon) * piece.normal.dot(g.direction.transpose() * bent.normal);
    }
    EXPECT_NEAR(change, 0.1 * projected, 0.01 * std::abs(change));
  }
}

TEST(BendNumbers, StretchesLeaveNothingOut) {
  // Voxel by voxel without steps gives the same units.
  std::mt19937 random(5);
  for (int n = 0; n < trials(20); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const ResectionPlan plan = planOf({{bentRandomly({5 * randomDirection(random), randomDirection(random)}, random, 40),
                                        ResectionPlane(10 * randomDirection(random), randomDirection(random))},
                                       {bentRandomly({15 * randomDirection(random), randomDirection(random)}, random, 40)}});
    VoxelRows single;
    for (const RowRun& run : allRows(g).runs) {
      for (int i = run.i; i < run.i + run.n; ++i) {
        single.runs.push_back({i, run.j, run.k, 1});
      }
      single.voxels += static_cast<std::size_t>(run.n);
    }
    const auto image = toImage(plan, g);
    const Resected fast = resect(allRows(g), g.spacing, image);
    const Resected slow = resect(single, g.spacing, image);
    for (std::size_t r = 0; r < plan.resections.size(); ++r) {
      EXPECT_NEAR(static_cast<double>(fast.units[r]), static_cast<double>(slow.units[r]), kUnitsPerVoxel * 1e-3) << n;
      EXPECT_NEAR(fast.cutAreaMm2[r], slow.cutAreaMm2[r], 1e-6 * slow.cutAreaMm2[r] + 1e-6);
    }
  }
}

TEST(BendNumbers, BlocksLeaveNothingOut) {
  std::mt19937 random(11);
  for (int n = 0; n < trials(30); ++n) {
    const ImageGeometry g = boxGrid(n % 2 == 1);
    const VoxelRows rows = rowsOf(*voxelised(g, ball(5 * randomDirection(random), 35)));
    const RowBlocks blocks(rows, g.spacing);
    const double size = n % 3 == 0 ? 15 : 70;
    const auto bentSomewhere = [&] {
      return bentRandomly({15 * randomDirection(random), randomDirection(random)}, random, 40, size);
    };
    const auto alone = toImage(planOf({{bentSomewhere()}}), g);
    EXPECT_EQ(resect(blocks, g.spacing, alone).units, resect(rows, g.spacing, alone).units) << "to the unit";
    const std::vector<CutPiece> byBlock = cutSurface(blocks, g.spacing, alone);
    const std::vector<CutPiece> byRow = cutSurface(rows, g.spacing, alone);
    ASSERT_EQ(byBlock.size(), byRow.size());
    for (std::size_t piece = 0; piece < byRow.size(); ++piece) {
      ASSERT_EQ(byBlock[piece].polygon, byRow[piece].polygon);
      ASSERT_EQ(byBlock[piece].run, byRow[piece].run);
    }
    const auto several = toImage(
        planOf({{bentSomewhere(), ResectionPlane(10 * randomDirection(random), randomDirection(random))}, {bentSomewhere()}}), g);
    for (const auto& plan : {alone, several}) {
      const Resected fast = resect(blocks, g.spacing, plan);
      const Resected slow = resect(rows, g.spacing, plan);
      for (std::size_t r = 0; r < plan.size(); ++r) {
        EXPECT_NEAR(static_cast<double>(fast.units[r]), static_cast<double>(slow.units[r]), kUnitsPerVoxel * 1e-3) << n;
        EXPECT_NEAR(fast.cutAreaMm2[r], slow.cutAreaMm2[r], 1e-6 * slow.cutAreaMm2[r] + 1e-6);
      }
    }
  }
}

TEST(BendNumbers, PiecesNearATumourGiveTheMarginOfAll) {
  std::mt19937 random(12);
  const std::vector<Vec3> seats{Vec3(12, 3, -2), Vec3(-30, 5, 8), Vec3(0, 33, 0)};
  std::size_t made = 0;
  std::size_t ofAll = 0;
  for (int n = 0; n < trials(30); ++n) {
    const Case liver = liverWith(seats[static_cast<std::size_t>(n) % 3], 5);
    const ImageGeometry& g = liver.segmentation->geometry;
    const VoxelRows rows = rowsOf(liver.liver->liver);
    const RowBlocks blocks(rows, g.spacing);
    const NearSurface around(rowsOf(liver.liver->tumour), rows, blocks, g.spacing);
    const double size = n % 2 == 0 ? 15 : 50;
    std::vector<ResectionPlane> planes{bentRandomly({12 * randomDirection(random), randomDirection(random)}, random, 20, size)};
    if (n % 3 == 0) {
      planes.emplace_back(10 * randomDirection(random), randomDirection(random));
    }
    const std::vector<ResectionPlane> flat{HalfSpace(planes[0]),
                                           ResectionPlane(10 * randomDirection(random), randomDirection(random))};
    for (const auto& plan : {toImage(planOf({planes}), g), toImage(planOf({{flat[0]}, planes}), g), toImage(planOf({{flat[0]}}), g),
                             toImage(planOf({flat, {flat[1]}}), g)}) {
      const std::vector<CutPiece> all = cutSurface(rows, g.spacing, plan);
      const std::vector<CutPiece> near = around.pieces(cutBlocks(blocks, g.spacing, plan), plan);
      ASSERT_EQ(near.empty(), all.empty());
      const Margin slow = marginOf(around.tumour(), g.spacing, CutDistance(all));
      const Margin fast = marginOf(around.tumour(), g.spacing, CutDistance(near));
      if (!all.empty()) {
        EXPECT_NEAR(fast.mm, slow.mm, 1e-9) << n;
        if (slow.mm > 1e-3 && (fast.to - slow.to).norm() < 1e-6) {  // of equally short ways another one may be found
          EXPECT_NEAR(fast.atLeast, slow.atLeast, 1e-6) << n;
        }
        made += near.size();
        ofAll += all.size();
      }
    }
  }
  EXPECT_LT(2 * made, ofAll);
}

TEST(BendNumbers, DoNotDependOnTheThreads) {
  std::mt19937 random(6);
  const ImageGeometry g = boxGrid();
  const ResectionPlan plan = planOf({{bentRandomly({Vec3::Zero(), Vec3(2, 1, 2) / 3}, random, 25)}});
  std::vector<Resected> results;
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    results.push_back(counted(g, plan));
  }
  for (const Resected& other : results) {
    EXPECT_EQ(other.units, results[0].units);
    EXPECT_EQ(other.cutAreaMm2, results[0].cutAreaMm2);
  }
}

/// Brute force: the least distance of the tumour's voxel boxes to points of the surface, `step` apart.
double sampledDistance(const Case& source, const ResectionPlane& plane, double step) {
  const ImageGeometry& g = source.segmentation->geometry;
  const BentSurface surface = BentSurface(plane).inFrame(g);
  const VoxelRows rows = rowsOf(source.liver->tumour);
  double least = 1e9;
  for (double u = -40; u <= 40; u += step) {
    for (double v = -40; v <= 40; v += step) {
      const Vec3 p = surface.foot(surface.origin() + u * surface.u() + v * surface.v());
      if ((g.origin + g.direction * p).norm() > 38) {
        continue;
      }
      for (const RowRun& run : rows.runs) {
        const Box box = boxOf(run, g.spacing);
        least = std::min(least, ((p - box.centre).cwiseAbs() - box.half).cwiseMax(0.0).norm());
      }
    }
  }
  return least;
}

TEST(BendNumbers, MarginIsTheWayToTheSurface) {
  const Case liver = liverWith(Vec3(12, 3, -2), 6);
  for (const double a : {0.01, -0.012}) {
    const HalfSpace plane{Vec3(-5, 0, 0), Vec3(1, 0.2, 0.1).normalized()};
    ResectionPlane bent(plane, flatBend(plane, 50));
    setQuadric(*bent.bend, a, 0.003, a);
    const TumourAssessment t = PlanAssessor(liver).assess(planOf({{bent}})).tumours.at(0);
    ASSERT_EQ(t.state, TumourState::Removed);
    EXPECT_NEAR(t.marginMm.value(), sampledDistance(liver, bent, 0.25), 0.1);
    EXPECT_LT(t.marginAtLeastMm.value(), t.marginMm.value());
    const TumourAssessment left = PlanAssessor(liver).assess(planOf({{flipped(bent)}})).tumours.at(0);
    EXPECT_EQ(left.state, TumourState::Left);
    EXPECT_NEAR(left.distanceMm.value(), t.marginMm.value(), 1e-6);
  }
}

TEST(BendNumbers, MarginIsAtLeastWhatItSaysBesideAStronglyBentPlane) {
  const Case liver = liverWith(Vec3(12, 3, -2), 6);
  const ImageGeometry& g = liver.segmentation->geometry;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> border(-30, 0);
  std::uniform_real_distribution<double> inner(15, 30);
  for (int n = 0; n < trials(6); ++n) {
    const HalfSpace plane{Vec3(-20, 0, 0), (Vec3::UnitX() + 0.1 * randomDirection(random)).normalized()};
    ResectionPlane bent(plane, flatBend(plane, kLeastBendHalfSizeMm));
    for (std::size_t p = 0; p < 16; ++p) {
      bent.bend->heightsMm[p] = groupOf(5)[p] ? inner(random) : border(random);
    }
    const CutDistance cut(cutSurface(rowsOf(liver.liver->liver), g.spacing, toImage(planOf({{bent}}), g)));
    const Margin margin = marginOf(TumourBoxes(rowsOf(liver.liver->tumour), g.spacing), g.spacing, cut);
    ASSERT_GT(margin.mm, 0);
    const double resolution = resolutionMm((margin.to - margin.from).normalized(), g.spacing);
    EXPECT_LE(margin.atLeast, sampledDistance(liver, bent, 0.15) - resolution);
  }
}

TEST(BendNumbers, CutTumoursDepthIsTheWayToTheBentRegion) {
  const Case liver = liverWith(Vec3(2, 1, 0), 9);
  const ImageGeometry& g = liver.segmentation->geometry;
  for (const double a : {0.012, -0.02}) {
    const HalfSpace plane{Vec3(3, 0, 0), Vec3(1, 0.1, 0.3).normalized()};
    ResectionPlane bent(plane, flatBend(plane, 50));
    setQuadric(*bent.bend, a, 0.0, 0.5 * a);
    const TumourAssessment t = PlanAssessor(liver).assess(planOf({{bent}})).tumours.at(0);
    ASSERT_EQ(t.state, TumourState::Cut);
    const BentSurface surface = BentSurface(bent).inFrame(g);
    std::vector<Vec3> samples;
    for (double u = -30; u <= 30; u += 0.2) {
      for (double v = -30; v <= 30; v += 0.2) {
        samples.push_back(surface.foot(surface.origin() + u * surface.u() + v * surface.v()));
      }
    }
    double deepest = 0;
    for (const RowRun& run : rowsOf(liver.liver->tumour).runs) {
      const Box box = boxOf(run, g.spacing);
      for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 p = box.centre + box.half.cwiseProduct(Vec3((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                                                               (corner & 4U) != 0 ? 1 : -1));
        if (-surface.above(p) <= deepest) {
          continue;
        }
        double nearest = 1e9;
        for (const Vec3& q : samples) {
          nearest = std::min(nearest, (p - q).norm());
        }
        deepest = std::max(deepest, nearest);
      }
    }
    EXPECT_NEAR(t.marginMm.value(), -deepest, 0.02);
  }
}

TEST(BendNumbers, NoVoxelOutsideAStronglyBentRegionHasDepthZero) {
  std::mt19937 random(10);
  std::uniform_int_distribution<int> at(-25, 25);
  for (int n = 0; n < trials(300); ++n) {
    const ResectionPlane bent = bentRandomly({Vec3::Zero(), randomDirection(random)}, random, 30, kLeastBendHalfSizeMm);
    const ImageGeometry g = gridOf({1, 1, 1}, kTurnedSpacing);
    const auto alone = toImage(planOf({{bent}}), g);
    const auto wedge = toImage(planOf({{bent, ResectionPlane(5 * randomDirection(random), randomDirection(random))}}), g);
    VoxelRows rows;
    rows.runs.push_back({at(random), at(random), at(random), 1});
    rows.voxels = 1;
    const Box box = boxOf(rows.runs[0], kTurnedSpacing);
    double deepest = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3 side((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1);
      deepest = std::max(deepest, -alone[0].bends[0].above(box.centre + box.half.cwiseProduct(side)));
    }
    Vec3 normal;
    const double depth = greatestDepth(rows, kTurnedSpacing, alone, normal);
    EXPECT_LE(depth, deepest + 1e-9) << n;
    EXPECT_EQ(depth > 0, deepest > 0) << n;
    if (deepest > 0) {
      EXPECT_GT(greatestDepth(rows, kTurnedSpacing, wedge, normal), 0) << n;
    }
  }
}

TEST(BendNumbers, VolumesAddUpAndAStrongBendSeparatesAPiece) {
  // A ridge through the ball: what is resected lies on both sides of it.
  const Case liver = liverWith(Vec3(-20, 0, 0), 5);
  const HalfSpace plane{Vec3::Zero(), Vec3::UnitX()};
  ResectionPlane bent(plane, flatBend(plane, 25));
  for (std::size_t n = 0; n < 16; ++n) {
    bent.bend->heightsMm[n] = n % 4 == 1 || n % 4 == 2 ? 60 : 0;
  }
  const PlanAssessment a = PlanAssessor(liver).assess(planOf({{bent}}));
  EXPECT_EQ(a.resectedMl + a.remnantMl, a.totalMl);
  ASSERT_EQ(a.islands.size(), 1U);
  EXPECT_EQ(a.islands[0].side, PlanSide::Resected);
  EXPECT_NEAR(a.islands[0].volumeMl, 0.5 * a.resectedMl, 0.02 * a.resectedMl);
  ResectionPlan given = planOf({{bent}});
  given.islands = {{a.islands[0].point, PlanSide::Remnant}};
  const PlanAssessment without = PlanAssessor(liver).assess(given);
  EXPECT_NEAR(without.resectedMl, a.resectedMl - a.islands[0].volumeMl, 1e-9);
  EXPECT_NEAR(without.resections[0].cutAreaMm2, 0.5 * a.resections[0].cutAreaMm2, 0.02 * a.resections[0].cutAreaMm2);
}

TEST(BendNumbers, WedgeOfABentAndAFlatPlaneIsConserved) {
  std::mt19937 random(8);
  const Case liver = liverWith(Vec3(10, 0, 0), 5);
  const PlanAssessor assessor(liver);
  for (int n = 0; n < trials(10); ++n) {
    const ResectionPlane bent = bentRandomly({5 * randomDirection(random), randomDirection(random)}, random, 20);
    const HalfSpace flat{5 * randomDirection(random), randomDirection(random)};
    // {bent and flat} + {bent and not flat} = {bent}
    const PlanAssessment both = assessor.assess(planOf({{bent, flat}, {bent, flipped(flat)}}));
    const PlanAssessment one = assessor.assess(planOf({{bent}}));
    EXPECT_EQ(both.resectedMl + both.remnantMl, both.totalMl);
    EXPECT_NEAR(both.resectedMl, one.resectedMl, 1e-6 * one.totalMl);
  }
}

TEST(BendNumbers, BendOverAPlaneCoversItsCutAndMovesNothing) {
  const Case liver = liverWith(Vec3(10, 0, 0), 5);
  const Vec3 normal = Vec3(1, 0.2, -0.1).normalized();
  const HalfSpace plane{Vec3(8, 0, 0) + 200 * normal.unitOrthogonal(), normal};
  const ResectionPlane bent = bendOver(*liver.liver, plane);
  EXPECT_NEAR((bent.origin - plane.origin).dot(plane.normal), 0, 1e-9);
  const ImageGeometry& g = liver.segmentation->geometry;
  const BentSurface surface = BentSurface(bent).inFrame(g);
  for (const CutPiece& piece : cutSurface(rowsOf(liver.liver->liver), g.spacing, toImage(planOf({{plane}}), g))) {
    for (const Vec3& p : piece.polygon) {
      EXPECT_LE(std::abs(surface.u().dot(p - surface.origin())), bent.bend->halfSizeMm);
      EXPECT_LE(std::abs(surface.v().dot(p - surface.origin())), bent.bend->halfSizeMm);
    }
  }
  EXPECT_LT(bent.bend->halfSizeMm, 50);
  EXPECT_EQ(bendOver(*liver.liver, {Vec3(900, 0, 0), Vec3::UnitX()}).bend->halfSizeMm, 100);
}

}  // namespace
}  // namespace glisson
