// 3D-IRCADb-01 case 1, where it is there: a real patient given nested and given exclusive, and the time its numbers take.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "planning/volumetry/assessment.h"
#include "planning/volumetry/margin_plane.h"
#include "planning/volumetry/tumour_measures.h"
#include "reconstruction/io/read.h"
#include "tests/support/real_data.h"

namespace glisson {
namespace {

class RealPatient : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test::unpackedIrcadb01Masks();
    if (folder_ == nullptr) {
      GTEST_SKIP() << "skipped: no real data";
    }
    nested_ = std::make_shared<Segmentation>(readSegmentation(*folder_ / "MASKS_DICOM"));
  }

  /// As one label map would hold it: lesions and vessels cut out of the liver.
  [[nodiscard]] std::shared_ptr<Segmentation> exclusive() const {
    auto flat = std::make_shared<Segmentation>(*nested_);
    for (LabelledMask& liver : flat->structures) {
      if (liver.kind != StructureKind::Liver) {
        continue;
      }
      for (const LabelledMask& other : nested_->structures) {
        if (other.mask && other.kind && (isLesion(*other.kind) || isVessel(*other.kind))) {
          liver.mask = std::make_shared<const Mask>(differenceOf(*liver.mask, *other.mask));
        }
      }
    }
    return flat;
  }

  std::unique_ptr<test::TemporaryFolder> folder_;
  std::shared_ptr<Segmentation> nested_;
};

TEST_F(RealPatient, GivenNestedAndGivenExclusiveHasTheSameNumbers) {
  const Case nested = newCase(nullptr, nested_);
  const Case flat = newCase(nullptr, exclusive());
  EXPECT_EQ(nested.liver->totalMl(), flat.liver->totalMl());
  EXPECT_EQ(nested.liver->tumourMl(), flat.liver->tumourMl());
  EXPECT_EQ(nested.liver->functionalMl(), flat.liver->functionalMl());
  for (const LabelledMask& structure : nested_->structures) {
    if (structure.kind == StructureKind::Liver) {
      EXPECT_NEAR(nested.liver->totalMl(), volumeMl(*structure.mask, nested_->geometry), 0.001 * nested.liver->totalMl());
    }
  }
  const IndexBox& box = nested.liver->liver.box();
  const Vec3 middle(box.first[0] + 0.5 * box.size[0], box.first[1] + 0.5 * box.size[1], box.first[2] + 0.5 * box.size[2]);
  ResectionPlan plan{"Plan 1", {{"Resection 1", {{nested_->geometry.toWorld(middle), Vec3(1, 0.3, 0.5).normalized()}}}}, 10};
  const PlanAssessor a(nested);
  const PlanAssessor b(flat);
  EXPECT_EQ(toJson(a.assess(plan)), toJson(b.assess(plan)));
  EXPECT_EQ(a.volumes(plan).resectedMl + a.volumes(plan).remnantMl, a.volumes(plan).totalMl);
}

TEST_F(RealPatient, VolumesFollowTheMouse) {
  const Case made = newCase(nullptr, nested_);
  const PlanAssessor assessor(made);
  const IndexBox& box = made.liver->liver.box();
  const Vec3 middle(box.first[0] + 0.5 * box.size[0], box.first[1] + 0.5 * box.size[1], box.first[2] + 0.5 * box.size[2]);
  const ResectionPlan plan{"Plan 1", {{"Resection 1", {{nested_->geometry.toWorld(middle), Vec3(1, 1, 1).normalized()}}}}, 10};
  double best = 1e9;
  for (int n = 0; n < 20; ++n) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_GT(assessor.volumes(plan).resectedMl, 0);
    best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  RecordProperty("millisecondsTimes1000", static_cast<int>(1000 * best));
}

TEST_F(RealPatient, EveryTumourGetsAPlaneThatKeepsItsMarginOrNone) {
  const Case made = newCase(nullptr, nested_);
  const PlanAssessor assessor(made);
  std::size_t found = 0;
  const std::vector<TumourMeasures> tumours = tumourMeasures(made);
  for (std::size_t n = 0; n < tumours.size(); n += test::longRuns() ? 1 : 3) {
    const TumourMeasures& tumour = tumours[n];
    const auto start = std::chrono::steady_clock::now();
    const MarginProposal proposal = proposeMarginPlane(made, tumour.id, 10);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    RecordProperty("milliseconds_" + tumour.id, static_cast<int>(ms));
    RecordProperty("resectedMlTimes1000_" + tumour.id, static_cast<int>(1000 * proposal.resectedFunctionalMl));
    EXPECT_GE(tumour.longestDiameterMm, 2 * std::cbrt(tumour.volumeMl * 1000 * 3 / (4 * 3.14159265358979))) << tumour.id;
    if (!proposal.plane) {
      EXPECT_FALSE(proposal.reason.empty());
      continue;
    }
    ++found;
    const PlanAssessment r = assessor.assess({"Plan", {{"Resection 1", {*proposal.plane}}}, 10});
    for (const TumourAssessment& assessed : r.tumours) {
      if (assessed.id == tumour.id) {
        EXPECT_EQ(assessed.state, TumourState::Removed);
        EXPECT_GE(assessed.marginAtLeastMm.value(), 10.0);
      }
    }
    for (const VesselCrossing& vessel : proposal.vessels) {
      EXPECT_GE(vessel.diameterMm, kListedVesselMm);
    }
  }
  EXPECT_GT(found, 0U);
}

}  // namespace
}  // namespace glisson
