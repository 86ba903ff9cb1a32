// What the 3D view draws follows from what its frames have taken: the window answers within the budget.
#include "viewer/frame_budget.h"

#include <gtest/gtest.h>

namespace glisson {
namespace {

constexpr TriangleCounts kLarge{40000, 200000};
constexpr TriangleCounts kSmall{15000, 15000};

/// Draws resting frames that take what `cost` says until the view asks for no more; the last plan.
template <class Cost>
FramePlan rest(FrameBudget& budget, TriangleCounts triangles, const Cost& cost) {
  FramePlan frame;
  for (int n = 0; n < 20; ++n) {
    frame = budget.plan(FrameQuality::Resting, triangles, true);
    if (!budget.remember(frame, cost(frame))) {
      return budget.plan(FrameQuality::Resting, triangles, true);
    }
  }
  ADD_FAILURE() << "the view never rests";
  return frame;
}

/// Milliseconds in proportion to the triangles that are drawn.
auto proportional(double fullMs, TriangleCounts triangles) {
  return [=](const FramePlan& frame) {
    const std::size_t drawn = frame.detail == Detail::Full ? triangles.full : triangles.reduced;
    const double plain = fullMs * static_cast<double>(drawn) / static_cast<double>(triangles.full);
    return frame.peels ? plain * FrameBudget::kRestingPeels : plain;
  };
}

TEST(FrameBudget, WhatMovingFramesTakeToCompileDoesNotHalveTheirResolution) {
  FrameBudget budget;
  FramePlan frame = budget.plan(FrameQuality::Moving, kLarge, true);
  frame.uploads = true;
  for (int n = 0; n < 5; ++n) {
    EXPECT_FALSE(budget.remember(frame, 70));
  }
  EXPECT_EQ(budget.plan(FrameQuality::Moving, kLarge, true).scale, 1.0);
  frame.uploads = false;
  budget.remember(frame, 70);
  budget.remember(frame, 70);
  EXPECT_EQ(budget.plan(FrameQuality::Moving, kLarge, true).scale, 0.5);
}

TEST(FrameBudget, APeeledFrameThatWasSlowOnceIsTriedAgainAfterSomeFrames) {
  FrameBudget budget;
  const auto draw = [&](double peeledMs) {  // the next resting frame; whether it peels
    const FramePlan frame = budget.plan(FrameQuality::Resting, kSmall, true);
    budget.remember(frame, frame.peels ? peeledMs : 10);
    return frame.peels;
  };
  for (int n = 0; n < 6; ++n) {
    draw(50);
  }
  EXPECT_TRUE(draw(80));  // a job took the processors
  int frames = 0;
  while (!draw(50) && frames < 100) {
    ++frames;
  }
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 30);
  EXPECT_TRUE(draw(50));
}

TEST(FrameBudget, AMovingFrameIsCoarseAndNeverPeels) {
  FrameBudget budget;
  rest(budget, kLarge, proportional(1, kLarge));
  const FramePlan frame = budget.plan(FrameQuality::Moving, kLarge, true);
  EXPECT_EQ(frame.detail, Detail::Coarse);
  EXPECT_FALSE(frame.peels);
}

TEST(FrameBudget, APictureIsFullAndExactWhateverItCosts) {
  FrameBudget budget;
  rest(budget, kLarge, proportional(5000, kLarge));
  const FramePlan frame = budget.plan(FrameQuality::Picture, kLarge, true);
  EXPECT_EQ(frame.detail, Detail::Full);
  EXPECT_TRUE(frame.peels);
  EXPECT_EQ(frame.scale, 1.0);
}

TEST(FrameBudget, AReportLooksTheSameOnEveryMachine) {
  for (const double fullMs : {1.0, 5000.0}) {
    FrameBudget budget;
    rest(budget, kLarge, proportional(fullMs, kLarge));
    const FramePlan frame = budget.plan(FrameQuality::Report, kLarge, true);
    EXPECT_EQ(frame.detail, Detail::Reduced);
    EXPECT_TRUE(frame.peels);
    EXPECT_TRUE(frame.smoothEdges);
    EXPECT_EQ(frame.scale, 1.0);
    EXPECT_FALSE(budget.remember(frame, 10));
  }
}

TEST(FrameBudget, TheFirstRestingFrameOfLargeMeshesIsReduced) {
  EXPECT_EQ(FrameBudget().plan(FrameQuality::Resting, kLarge, true).detail, Detail::Reduced);
  EXPECT_EQ(FrameBudget().plan(FrameQuality::Resting, kSmall, true).detail, Detail::Full);
}

TEST(FrameBudget, AQuickMachineRestsOnFullMeshesWithPeeling) {
  FrameBudget budget;
  const FramePlan frame = rest(budget, kLarge, proportional(4, kLarge));
  EXPECT_EQ(frame.detail, Detail::Full);
  EXPECT_TRUE(frame.peels);
}

TEST(FrameBudget, NoRestingFrameIsPlannedThatWouldMissTheBudget) {
  const double slowest = kFrameBudgetMs * static_cast<double>(kLarge.full) / static_cast<double>(kLarge.reduced);
  for (double fullMs = 1; fullMs < slowest; fullMs *= 1.1) {  // then even reduced meshes miss it
    FrameBudget budget;
    const auto cost = proportional(fullMs, kLarge);
    const auto checked = [&](const FramePlan& frame) {
      EXPECT_TRUE(cost(frame) <= kFrameBudgetMs) << fullMs;
      return cost(frame);
    };
    rest(budget, kLarge, checked);
  }
}

TEST(FrameBudget, WhereMeshesWereUploadedTheTimeIsNotKept) {
  FrameBudget budget;
  for (int n = 0; n < 5; ++n) {
    FramePlan frame = budget.plan(FrameQuality::Resting, kLarge, true);
    frame.uploads = true;
    EXPECT_TRUE(budget.remember(frame, 5000));
  }
  EXPECT_FALSE(budget.restingIsSlow());
  EXPECT_EQ(rest(budget, kLarge, proportional(4, kLarge)).detail, Detail::Full);
}

TEST(FrameBudget, OtherMeshesAndOtherSizesAreMeasuredAnew) {
  FrameBudget budget;
  rest(budget, kLarge, proportional(4, kLarge));
  budget.areaChanged(8);
  EXPECT_EQ(budget.plan(FrameQuality::Resting, kLarge, true).detail, Detail::Full);
  budget.areaChanged(2);
  EXPECT_EQ(budget.plan(FrameQuality::Resting, kLarge, true).detail, Detail::Reduced);
  budget.forget();
  EXPECT_FALSE(budget.plan(FrameQuality::Resting, kSmall, true).peels);
}

TEST(FrameBudget, SlowMovingFramesAreDrawnAtHalfResolutionAndDoNotCount) {
  FrameBudget budget;
  for (int n = 0; n < 2; ++n) {
    budget.remember(budget.plan(FrameQuality::Moving, kLarge, true), 80);
  }
  const FramePlan half = budget.plan(FrameQuality::Moving, kLarge, true);
  EXPECT_EQ(half.scale, 0.5);
  EXPECT_FALSE(budget.remember(half, 10));
  EXPECT_EQ(budget.plan(FrameQuality::Moving, kLarge, true).scale, 0.5);
}

}  // namespace
}  // namespace glisson
