// 3D-IRCADb-01 case 1, where it is there: four fifths of its portal label lie outside the liver, and its veins hold the cava.

#include <gtest/gtest.h>

#include <chrono>

#include "planning/territories/perfusion.h"
#include "planning/territories/territories.h"
#include "reconstruction/io/read.h"
#include "tests/support/real_data.h"

namespace glisson {
namespace {

class RealTerritories : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test::unpackedIrcadb01Masks();
    if (folder_ == nullptr) {
      GTEST_SKIP() << "skipped: no real data";
    }
    source_ = std::make_unique<Case>(newCase(nullptr, std::make_shared<Segmentation>(readSegmentation(*folder_ / "MASKS_DICOM"))));
  }
  std::unique_ptr<test::TemporaryFolder> folder_;
  std::unique_ptr<Case> source_;
};

TEST_F(RealTerritories, LeftAndRightAreAnatomicalAndThePlanFollowsTheMouse) {
  const LiverPerfusion perfusion(*source_);
  const VesselGraph& portal = perfusion.portal();
  EXPECT_EQ(portal.pieces, 1);
  const TerritoryChoice choice = proposeLeftRight(portal);
  ASSERT_EQ(choice.picks.size(), 2U);
  EXPECT_TRUE(choice.notes.empty());
  const Territories made = territoriesOf(*source_->liver, portal, choice);
  EXPECT_EQ(made.parts[0].rows.voxels + made.parts[1].rows.voxels, source_->liver->liver.count());
  const double left = static_cast<double>(made.parts[0].rows.voxels) / static_cast<double>(source_->liver->liver.count());
  EXPECT_GT(left, 0.2);
  EXPECT_LT(left, 0.4);
  for (const VesselGraph* graph : {&portal, &perfusion.hepatic()}) {
    for (const VesselBranch& branch : graph->branches) {
      EXPECT_TRUE(branch.role != BranchRole::Supplying || branch.inLiverMm > 0);
    }
  }
  const IndexBox& box = source_->liver->liver.box();
  const Vec3 middle(box.first[0] + 0.5 * box.size[0], box.first[1] + 0.5 * box.size[1], box.first[2] + 0.5 * box.size[2]);
  const Vec3 origin = source_->liver->geometry.toWorld(middle);
  double best = 1e9;
  for (int n = 0; n < 20; ++n) {
    const ResectionPlan plan{"Plan 1", {{"Resection 1", {{origin + Vec3(20.0 + n, 0, 0), Vec3::UnitX()}}}}, 10};
    const auto start = std::chrono::steady_clock::now();
    const PerfusionEstimate r = perfusion.effectOf(plan);
    best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    EXPECT_GT(r.perfusedFlrMl, 0);
    EXPECT_LT(r.perfusedFlrMl, r.functionalRemnantMl);
  }
  RecordProperty("millisecondsTimes1000", static_cast<int>(1000 * best));
}

}  // namespace
}  // namespace glisson
