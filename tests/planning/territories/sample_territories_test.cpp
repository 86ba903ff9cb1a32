// The built-in patient: its branch points are known, and its tree divides as a liver's does.

#include <gtest/gtest.h>

#include "planning/case/case.h"
#include "planning/territories/perfusion.h"
#include "planning/territories/territories.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson {
namespace {

class SampleTerritories : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SamplePatient made = makeSamplePatient(false);
    truth_ = std::make_unique<SampleTruth>(made.truth);
    source_ = std::make_unique<Case>(newCase(nullptr, std::make_shared<Segmentation>(std::move(made.segmentation))));
    perfusion_ = std::make_unique<LiverPerfusion>(*source_);
  }
  static void TearDownTestSuite() {
    perfusion_.reset();
    source_.reset();
    truth_.reset();
  }
  /// Share of `points` with a junction within its vessel's radius and two slices.
  static double foundShare(const std::vector<Vec3>& points, const VesselGraph& graph) {
    int found = 0;
    for (const Vec3& point : points) {
      for (const VesselNode& node : graph.nodes) {
        const VesselSite& site = graph.sites[static_cast<std::size_t>(node.site)];
        if (node.kind == NodeKind::Junction && (site.positionMm - point).norm() < site.radiusMm + 5) {
          ++found;
          break;
        }
      }
    }
    return found / static_cast<double>(points.size());
  }

  static std::unique_ptr<SampleTruth> truth_;
  static std::unique_ptr<Case> source_;
  static std::unique_ptr<LiverPerfusion> perfusion_;
};
std::unique_ptr<SampleTruth> SampleTerritories::truth_;
std::unique_ptr<Case> SampleTerritories::source_;
std::unique_ptr<LiverPerfusion> SampleTerritories::perfusion_;

TEST_F(SampleTerritories, BranchPointsOfBothTreesAreFound) {
  EXPECT_GT(foundShare(truth_->portalBranchPoints, perfusion_->portal()), 0.9);
  EXPECT_GT(foundShare(truth_->hepaticBranchPoints, perfusion_->hepatic()), 0.9);
}

TEST_F(SampleTerritories, MainBifurcationIsTheFirstBranchPoint) {
  const VesselGraph& portal = perfusion_->portal();
  EXPECT_EQ(portal.pieces, 1);
  ASSERT_TRUE(portal.mainBifurcation);
  const VesselSite& node =
      portal.sites[static_cast<std::size_t>(portal.nodes[static_cast<std::size_t>(*portal.mainBifurcation)].site)];
  EXPECT_LT((node.positionMm - truth_->portalBranchPoints[0]).norm(), 6.4);  // the trunk's radius
}

TEST_F(SampleTerritories, LeftAndRightHaveTheSidesAndSizesOfALiver) {
  const TerritoryChoice choice = proposeLeftRight(perfusion_->portal());
  ASSERT_EQ(choice.picks.size(), 2U);
  const Territories made = territoriesOf(*source_->liver, perfusion_->portal(), choice);
  const auto volumes = volumesOf(made, {});
  EXPECT_EQ(made.parts[0].rows.voxels + made.parts[1].rows.voxels, source_->liver->liver.count());
  const double left = volumes[0].volumeMl / source_->liver->totalMl();
  EXPECT_GT(left, 0.2);
  EXPECT_LT(left, 0.5);
  const auto centre = [&](const Territory& part) {
    double sum = 0;
    for (const RowRun& run : part.rows.runs) {
      sum += run.n * source_->liver->geometry.toWorld(Vec3(run.i + 0.5 * (run.n - 1), run.j, run.k)).x();
    }
    return sum / static_cast<double>(part.rows.voxels);
  };
  EXPECT_GT(centre(made.parts[0]), centre(made.parts[1]) + 30);
}

TEST_F(SampleTerritories, RemnantIsPartedExactlyForAnyPlane) {
  const Vec3 middle(-10, -40, -1170);
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0.3, 0), Vec3(0.2, 0.1, 1), Vec3(0, -1, 0.4)}) {
    const ResectionPlan plan{"Plan 1", {{"Resection 1", {{middle, normal.normalized()}}}}, 10};
    const PerfusionEstimate r = perfusion_->effectOf(plan);
    EXPECT_GE(*r.devascularisedMl + *r.congestedMl, r.devascularisedOrCongestedMl - 1e-9);
    EXPECT_GE(r.devascularisedOrCongestedMl, std::max(*r.devascularisedMl, *r.congestedMl) - 1e-9);
    EXPECT_LE(r.perfusedFlrMl, r.functionalRemnantMl + 1e-9);
    EXPECT_GE(r.perfusedFlrMl, -1e-9);
    EXPECT_FALSE(r.portalCuts.empty());
  }
}

}  // namespace
}  // namespace glisson
