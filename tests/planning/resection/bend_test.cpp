// The bend of a plane as a height field: Bezier's surface, its bounds, what moving and swapping sides do to it, what is refused.

#include "planning/resection/bend.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "planning/resection/plan_edit.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {

const HalfSpace kOblique{Vec3(10, -20, 300), Vec3(1, -2, 2) / 3};

Bend randomBend(const HalfSpace& plane, unsigned seed, double mm = 20) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(-mm, mm);
  Bend bend = flatBend(plane, 60);
  for (double& h : bend.heightsMm) {
    h = height(random);
  }
  return bend;
}

Vec3 randomPoint(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> at(-reach, reach);
  return {at(random), at(random), at(random)};
}

/// Where beside a square of half size 60 the cubic is taken: by a parabola that stands still 80 mm from the middle.
double eased(double x) {
  const double from = std::min(std::abs(x), 80.0) - 60;
  return from > 0 ? std::copysign(60 + from - from * from / 40, x) : x;
}

/// De Casteljau, as the books have it; beyond the square too.
double casteljau(const Bend& bend, double u, double v) {
  const double s = 0.5 + 0.5 * eased(u) / bend.halfSizeMm;
  const double t = 0.5 + 0.5 * eased(v) / bend.halfSizeMm;
  std::array<double, 16> h = bend.heightsMm;
  for (int left = 3; left > 0; --left) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < left; ++i) {
        double& at = h[static_cast<std::size_t>(4 * j + i)];
        at += s * (h[static_cast<std::size_t>(4 * j + i + 1)] - at);
      }
    }
  }
  for (int left = 3; left > 0; --left) {
    for (int j = 0; j < left; ++j) {
      double& at = h[static_cast<std::size_t>(4 * j)];
      at += t * (h[static_cast<std::size_t>(4 * j + 4)] - at);
    }
  }
  return h[0];
}

TEST(Bend, FlatOneIsThePlane) {
  const ResectionPlane bent(kOblique, flatBend(kOblique, 60));
  std::mt19937 random(1);
  for (int n = 0; n < 100; ++n) {
    const Vec3 p = kOblique.origin + randomPoint(random, 150);
    EXPECT_NEAR(heightAbove(bent, p), heightAbove(ResectionPlane(kOblique), p), 1e-12);
  }
}

TEST(Bend, HeightIsThatOfDeCasteljauAndGoesOnBesideTheSquare) {
  std::mt19937 random(2);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Bend bend = randomBend(kOblique, seed);
    const BendShape shape(bend);
    for (int n = 0; n < 50; ++n) {
      const Vec3 p = randomPoint(random, 90);
      EXPECT_NEAR(shape.height(p[0], p[1]), casteljau(bend, p[0], p[1]), 1e-12);
      EXPECT_EQ(shape.at(p[0], p[1]).height, shape.height(p[0], p[1]));
    }
    EXPECT_EQ(shape.height(500, 3), shape.height(80, 3));
    EXPECT_EQ(shape.height(-7, -90), shape.height(-7, -80));
    EXPECT_NEAR(shape.height(-60, -60), bend.heightsMm[0], 1e-12);
    EXPECT_NEAR(shape.height(60, -60), bend.heightsMm[3], 1e-12);
    EXPECT_NEAR(shape.height(-60, 60), bend.heightsMm[12], 1e-12);
  }
}

/// Whether a step `d` around x crosses a place where the second derivative jumps.
bool nearJump(double x, double d) { return std::abs(std::abs(x) - 60) < 2 * d || std::abs(std::abs(x) - 80) < 2 * d; }

TEST(Bend, SlopesAndCurvaturesAreThoseOfDifferencesAndWithinTheBounds) {
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BendShape shape(randomBend(kOblique, seed));
    constexpr double d = 1e-4;
    for (int n = 0; n < 100; ++n) {
      const Vec3 p = randomPoint(random, n % 2 == 0 ? 59 : 90);
      if (nearJump(p[0], d) || nearJump(p[1], d)) {
        continue;
      }
      const BendShape::Local local = shape.at(p[0], p[1]);
      EXPECT_NEAR(local.du, (shape.height(p[0] + d, p[1]) - shape.height(p[0] - d, p[1])) / (2 * d), 1e-6);
      EXPECT_NEAR(local.dv, (shape.height(p[0], p[1] + d) - shape.height(p[0], p[1] - d)) / (2 * d), 1e-6);
      EXPECT_NEAR(local.duu, (shape.at(p[0] + d, p[1]).du - shape.at(p[0] - d, p[1]).du) / (2 * d), 1e-6);
      EXPECT_NEAR(local.duv, (shape.at(p[0], p[1] + d).du - shape.at(p[0], p[1] - d).du) / (2 * d), 1e-6);
      EXPECT_NEAR(local.dvv, (shape.at(p[0], p[1] + d).dv - shape.at(p[0], p[1] - d).dv) / (2 * d), 1e-6);
      EXPECT_GE(local.du, shape.slopesU().low);
      EXPECT_LE(local.du, shape.slopesU().high);
      EXPECT_GE(local.dv, shape.slopesV().low);
      EXPECT_LE(local.dv, shape.slopesV().high);
      const double curved = std::max(std::abs(local.duu), std::abs(local.dvv)) + std::abs(local.duv);
      EXPECT_LE(curved, shape.mostCurved());
      if (n % 2 == 0) {
        EXPECT_GE(local.height, shape.heights().low);
        EXPECT_LE(local.height, shape.heights().high);
        EXPECT_LE(curved, shape.mostCurvedInside());
      }
    }
    const BendShape::Local beside = shape.at(85, 5);
    EXPECT_EQ(beside.du, 0);
    EXPECT_EQ(beside.duu, 0);
    EXPECT_EQ(beside.duv, 0);
  }
}

TEST(Bend, HasNoKinkAtTheBorderOfItsSquare) {
  std::mt19937 random(8);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BendShape shape(randomBend(kOblique, seed));
    constexpr double d = 1e-7;
    for (const double border : {-80.0, -60.0, 60.0, 80.0}) {
      const double along = randomPoint(random, 90)[0];
      const BendShape::Local before = shape.at(border - d, along);
      const BendShape::Local behind = shape.at(border + d, along);
      EXPECT_NEAR(before.height, behind.height, 1e-6);
      EXPECT_NEAR(before.du, behind.du, 1e-6);
      EXPECT_NEAR(before.dv, behind.dv, 1e-6);
      EXPECT_NEAR(shape.at(along, border - d).dv, shape.at(along, border + d).dv, 1e-6);
    }
  }
}

TEST(Bend, SwappedSidesSwapEveryPoint) {
  std::mt19937 random(4);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const ResectionPlane bent(kOblique, randomBend(kOblique, seed));
    const ResectionPlane other = flipped(bent);
    for (int n = 0; n < 100; ++n) {
      const Vec3 p = kOblique.origin + randomPoint(random, 100);
      EXPECT_NEAR(heightAbove(other, p), -heightAbove(bent, p), 1e-12);
    }
    EXPECT_EQ(flipped(other), bent) << "bit for bit";
    EXPECT_EQ(movedTo(bent, flipped(static_cast<const HalfSpace&>(bent))), other) << "the editor's way to swap sides";
  }
}

TEST(Bend, OppositeNormalTypedWithThreeDecimalsSwapsTheSidesToo) {
  const ResectionPlane bent(kOblique, randomBend(kOblique, 7));
  const Vec3 typed = (Vec3(-0.333, 0.667, -0.667)).normalized();
  ASSERT_GT((typed + kOblique.normal).norm(), 1e-4);
  const ResectionPlane other = movedTo(bent, HalfSpace{kOblique.origin, typed});
  EXPECT_EQ(other.bend->heightsMm, flipped(bent).bend->heightsMm);
  EXPECT_EQ(other.normal, typed);
  EXPECT_NEAR(other.bend->u.dot(typed), 0, 1e-12);
  std::mt19937 random(7);
  for (int n = 0; n < 100; ++n) {
    const Vec3 p = kOblique.origin + randomPoint(random, 60);
    EXPECT_NEAR(heightAbove(other, p), -heightAbove(bent, p), 0.5);
  }
}

TEST(Bend, GoesAlongWithItsPlaneAsARigidBody) {
  const ResectionPlane bent(kOblique, randomBend(kOblique, 5));
  std::mt19937 random(5);
  for (int n = 0; n < 50; ++n) {
    const Vec3 normal = randomPoint(random, 1).normalized();
    const HalfSpace to{randomPoint(random, 50), normal};
    const ResectionPlane moved = movedTo(bent, to);
    EXPECT_NEAR(moved.bend->u.norm(), 1, 1e-12);
    EXPECT_NEAR(moved.bend->u.dot(normal), 0, 1e-12);
    EXPECT_EQ(moved.bend->heightsMm, bent.bend->heightsMm);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(kOblique.normal, normal);
    const Vec3 p = randomPoint(random, 80);
    EXPECT_NEAR(heightAbove(moved, to.origin + turn * p), heightAbove(bent, kOblique.origin + p), 1e-9);
  }
  const ResectionPlane shifted = movedTo(bent, movedAlongNormal(bent, 3));
  EXPECT_EQ(shifted.bend, bent.bend) << "a shift leaves every bit";
}

TEST(Bend, ControlPointsStandWhereHeightsSay) {
  const ResectionPlane bent(kOblique, randomBend(kOblique, 6));
  const BentSurface surface(bent);
  for (const std::size_t corner : {0U, 3U, 12U, 15U}) {
    EXPECT_NEAR(surface.above(controlPoint(bent, corner)), 0, 1e-9) << "the surface goes through its corners";
  }
  EXPECT_NEAR((controlPoint(bent, 5) - bent.origin).dot(bent.normal), bent.bend->heightsMm[5], 1e-9);
  EXPECT_NEAR((controlPoint(bent, 5) - bent.origin).dot(bent.bend->u), -20, 1e-9);
  EXPECT_NEAR((controlPoint(bent, 7) - bent.origin).dot(bent.normal.cross(bent.bend->u)), -20, 1e-9);
}

TEST(Bend, GroupsAreCornersEdgesAndInnerPoints) {
  const auto count = [](const std::array<bool, 16>& members) { return std::count(members.begin(), members.end(), true); };
  EXPECT_EQ(count(groupOf(0)), 4);
  EXPECT_EQ(count(groupOf(1)), 8);
  EXPECT_EQ(count(groupOf(10)), 4);
  for (std::size_t n = 0; n < 16; ++n) {
    EXPECT_TRUE(groupOf(n)[n]);
  }
  EXPECT_EQ(groupOf(12), groupOf(3));
  EXPECT_EQ(groupOf(8), groupOf(2));
}

TEST(Bend, SurfaceInAnImagesFrameIsTheSame) {
  ImageGeometry g;
  g.size = {10, 10, 10};
  g.origin = Vec3(5, 6, 7);
  g.direction = (Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix() * Vec3(1, 1, -1).asDiagonal()).eval();
  const BentSurface world(ResectionPlane(kOblique, randomBend(kOblique, 7)));
  const BentSurface image = world.inFrame(g);
  std::mt19937 random(7);
  for (int n = 0; n < 50; ++n) {
    const Vec3 p = kOblique.origin + randomPoint(random, 90);
    EXPECT_NEAR(image.above(g.direction.transpose() * (p - g.origin)), world.above(p), 1e-9);
  }
}

TEST(Bend, ReachBoundsABox) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Vec3 half(0.5, 0.4, 1.25);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const BentSurface surface(ResectionPlane(kOblique, randomBend(kOblique, seed, 60)));
    for (int n = 0; n < 100; ++n) {
      const Vec3 centre = kOblique.origin + randomPoint(random, 90);
      const Vec3 p = centre + half.cwiseProduct(Vec3(unit(random), unit(random), unit(random)));
      EXPECT_LE(std::abs(surface.above(p) - surface.above(centre)), surface.reach(half) + 1e-9);
    }
  }
}

TEST(Bend, WhatIsNoSurfaceIsRefusedAndThePlanStays) {
  const ResectionPlan plan{"Plan 1", {{"Resection 1", {kOblique}}}, 10};
  const auto refused = [&](const auto& spoil) {
    Bend bend = flatBend(kOblique, 60);
    spoil(bend);
    EXPECT_THROW(apply(plan, BendPlane{0, 0, bend}), PlanningError);
    EXPECT_THROW(apply(plan, AddResection{{"", {ResectionPlane(kOblique, bend)}}}), PlanningError);
  };
  for (const double wrong : {0.0, -60.0, 9.9, 1001.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    refused([&](Bend& bend) { bend.halfSizeMm = wrong; });
  }
  for (const double wrong : {-1001.0, 1e300, static_cast<double>(NAN), static_cast<double>(-INFINITY)}) {
    refused([&](Bend& bend) { bend.heightsMm[7] = wrong; });
  }
  refused([&](Bend& bend) { bend.u = kOblique.normal; });
  refused([&](Bend& bend) { bend.u = Vec3::Zero(); });
  refused([&](Bend& bend) { bend.u[1] = NAN; });
  EXPECT_THROW(apply(plan, BendPlane{0, 1, flatBend(kOblique, 60)}), PlanningError);
  EXPECT_THROW(apply(plan, FlattenPlane{1, 0}), PlanningError);
  EXPECT_THROW(BentSurface(ResectionPlane(kOblique)), PlanningError);
}

TEST(Bend, SpinningTurnsTheSurfaceAboutTheNormalThroughAPointAndLeavesAFlatPlane) {
  const ResectionPlane bent(kOblique, randomBend(kOblique, 5));
  const Vec3 pivot = kOblique.origin + 12 * bent.bend->u + 30 * kOblique.normal;
  const double angle = 0.7;
  const ResectionPlane turned = spun(bent, pivot, angle);
  const Eigen::AngleAxisd turn(angle, kOblique.normal);
  std::mt19937 random(3);
  for (int n = 0; n < 50; ++n) {
    const Vec3 p = kOblique.origin + randomPoint(random, 80);
    EXPECT_NEAR(heightAbove(turned, pivot + turn * (p - pivot)), heightAbove(bent, p), 1e-9);
  }
  const ResectionPlane back = spun(turned, pivot, -angle);
  EXPECT_NEAR((back.origin - bent.origin).norm(), 0, 1e-12);
  EXPECT_NEAR((back.bend->u - bent.bend->u).norm(), 0, 1e-12);
  EXPECT_EQ(spun(kOblique, pivot, angle), ResectionPlane(kOblique));
}

TEST(Bend, ASpinIsAnEditOfABentPlaneOnly) {
  const ResectionPlane bent(kOblique, randomBend(kOblique, 5));
  const ResectionPlane turned = spun(bent, kOblique.origin + 9 * bent.bend->u, -1.2);
  const ResectionPlan plan{"Plan 1", {{"Resection 1", {bent, kOblique}}}, 10};
  const SpinPlane edit{0, 0, turned.bend->u, turned.origin};
  EXPECT_EQ(nameOf(plan, edit), "spin plane 1");
  const ResectionPlane made = apply(plan, edit).resections[0].planes[0];
  EXPECT_NEAR((made.origin - turned.origin).norm(), 0, 1e-12);
  EXPECT_NEAR((made.bend->u - turned.bend->u).norm(), 0, 1e-12);
  EXPECT_EQ(made.bend->heightsMm, bent.bend->heightsMm);
  EXPECT_THROW(apply(plan, SpinPlane{0, 1, turned.bend->u, turned.origin}), PlanningError);
  EXPECT_THROW(apply(plan, SpinPlane{0, 0, kOblique.normal, turned.origin}), PlanningError);
  EXPECT_THROW(apply(plan, SpinPlane{0, 0, turned.bend->u, Vec3::Constant(NAN)}), PlanningError);
}

TEST(Bend, EditsBendMoveAndFlattenUnderTheirNames) {
  ResectionPlan plan{"Plan 1", {{"Resection 1", {kOblique, HalfSpace()}}}, 10};
  const Bend bend = randomBend(kOblique, 9);
  EXPECT_EQ(nameOf(plan, BendPlane{0, 1, bend}), "bend plane 2");
  EXPECT_EQ(nameOf(plan, FlattenPlane{0, 1}), "flatten plane 2");
  EXPECT_EQ(nameOf({"", {{"Resection 1", {kOblique}}}}, BendPlane{0, 0, bend}), "bend plane");
  EXPECT_EQ(nameOf({"", {{"A", {kOblique}}, {"B", {kOblique}}}}, FlattenPlane{1, 0}), "flatten plane 1 of B");
  plan = apply(plan, BendPlane{0, 0, bend});
  EXPECT_TRUE(hasBends(plan));
  EXPECT_EQ(plan.resections[0].planes[0].bend, bend);
  EXPECT_FALSE(plan.resections[0].planes[1].bend);
  plan = apply(plan, MovePlane{0, 0, movedAlongNormal(kOblique, 2)});
  EXPECT_EQ(plan.resections[0].planes[0].bend, bend);
  const Vec3 beside = kOblique.origin + Vec3(5, 6, 7);
  const ResectionPlane slid = apply(plan, BendPlane{0, 0, bend, beside}).resections[0].planes[0];
  EXPECT_NEAR((slid.origin - plan.resections[0].planes[0].origin).dot(kOblique.normal), 0, 1e-12);
  EXPECT_NEAR((slid.origin - beside).cross(kOblique.normal).norm(), 0, 1e-12);
  plan = apply(plan, FlattenPlane{0, 0});
  EXPECT_FALSE(hasBends(plan));
}

}  // namespace
}  // namespace glisson
