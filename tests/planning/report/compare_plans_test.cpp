#include "planning/report/compare_plans.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;

Case ballWithMetastasis() {
  const ImageGeometry g = gridOf({70, 70, 30}, Vec3(1, 1, 2.5));
  const Vec3 c(34, 34, 36);
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(c, 30)},
                                             {"met", StructureKind::Tumour, ball(c + Vec3(15, 0, 0), 5)},
                                             {"portal vein", StructureKind::PortalVein, tube(c, Vec3::UnitX(), 4)}}));
}

ResectionPlan at(const std::string& name, double x) {
  ResectionPlan plan = planOf({{{Vec3(x, 34, 36), Vec3::UnitX()}}});
  plan.name = name;
  return plan;
}

const ComparedRow& rowOf(const PlanComparison& comparison, std::string_view id) {
  for (const ComparedRow& row : comparison.rows) {
    if (row.id == id) {
      return row;
    }
  }
  throw std::out_of_range(std::string(id));
}

class ComparePlans : public ::testing::Test {
 protected:
  ComparePlans() : assessor_(ballWithMetastasis()) {}

  /// Assessments live as long as the test.
  AssessedPlan assessed(const ResectionPlan& plan) {
    plans_.push_back(std::make_unique<std::pair<ResectionPlan, PlanAssessment>>(plan, assessor_.assess(plan)));
    return {plans_.back()->first, plans_.back()->second};
  }
  [[nodiscard]] static bool holds(const std::vector<std::string>& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
  }

  PlanAssessor assessor_;
  std::vector<std::unique_ptr<std::pair<ResectionPlan, PlanAssessment>>> plans_;
};

using Marks = std::vector<bool>;

TEST_F(ComparePlans, MarksTheSmallestAndTheLargestOfEachRowAndNothingElse) {
  const std::vector<AssessedPlan> plans{assessed(at("A", 30)), assessed(at("B", 38)), assessed(at("C", 50)), assessed(at("D", 30))};
  const PlanComparison comparison = comparePlans(plans);
  EXPECT_EQ(comparison.names, (std::vector<std::string>{"A", "B", "C", "D"}));
  const ComparedRow& remnant = rowOf(comparison, "functionalRemnantMl");
  EXPECT_EQ(remnant.values[1], plans[1].assessment.functionalRemnantMl);
  EXPECT_EQ(remnant.largest, (Marks{false, false, true, false}));
  EXPECT_EQ(remnant.smallest, (Marks{true, false, false, true})) << "both of the same value";
  EXPECT_EQ(rowOf(comparison, "tumoursCut").values[2], 1.0);
  const ComparedRow& same = rowOf(comparison, "resections");
  EXPECT_EQ(same.smallest, Marks(4, false));
  EXPECT_EQ(same.largest, Marks(4, false));
  const ComparedRow& margin = rowOf(comparison, "leastMarginMm");
  EXPECT_EQ(margin.values[0], plans[0].assessment.tumours[0].marginAtLeastMm);
  EXPECT_LT(margin.values[2].value(), 0) << "cut";
}

TEST_F(ComparePlans, NumbersThatDoNotStandAreLeftOutOfTheMarks) {
  ResectionPlan empty;
  empty.name = "Empty";
  const std::vector<AssessedPlan> plans{assessed(at("A", 30)), assessed(at("Beside", 300)), assessed(empty)};
  const PlanComparison comparison = comparePlans(plans);
  const ComparedRow& resected = rowOf(comparison, "resectedMl");
  EXPECT_FALSE(resected.values[1]);
  EXPECT_EQ(resected.values[2], 0.0);
  EXPECT_EQ(resected.smallest, (Marks{false, false, true}));
  EXPECT_EQ(resected.largest, (Marks{true, false, false}));
  const ComparedRow& margin = rowOf(comparison, "leastMarginMm");
  EXPECT_FALSE(margin.values[1] || margin.values[2]);
  EXPECT_EQ(margin.smallest, Marks(3, false)) << "one value alone is neither smallest nor largest";
}

TEST_F(ComparePlans, TwoToFourPlansAreCompared) {
  const AssessedPlan a = assessed(at("A", 30));
  EXPECT_THROW(comparePlans(std::vector<AssessedPlan>{a}), PlanningError);
  EXPECT_THROW(comparePlans(std::vector<AssessedPlan>{a, a, a, a, a}), PlanningError);
  EXPECT_EQ(comparePlans(std::vector<AssessedPlan>{a, a}).rows.size(), 13U);
}

TEST_F(ComparePlans, DifferenceNamesTurnsShiftsMarginsAndTumours) {
  ResectionPlan other = at("B", 50);
  other.resections[0].planes[0] = turned(other.resections[0].planes[0], Vec3::UnitZ(), 10 * std::numbers::pi / 180);
  other.resections.push_back({"Tip", {{Vec3(34, 34, 60), Vec3::UnitZ()}}});
  other.safetyMarginMm = 5;
  const std::vector<std::string> sentences = differenceOf(assessed(at("A", 30)), assessed(other));
  EXPECT_TRUE(holds(sentences, "Plane 1 of Resection 1 is turned by 10.0 degrees and lies 19.7 mm")) << sentences[0];
  EXPECT_TRUE(holds(sentences, "Tip is in B only."));
  EXPECT_TRUE(holds(sentences, "Safety margin: 10.0 mm in A, 5.0 mm in B."));
  EXPECT_TRUE(holds(sentences, "met: removed in A, cut in B."));
  EXPECT_TRUE(holds(sentences, "Functional remnant: "));
  EXPECT_TRUE(holds(sentences, "Margin of met, at least: "));
}

TEST_F(ComparePlans, DifferenceTheOtherWayRoundNamesTheSameThings) {
  const AssessedPlan a = assessed(at("A", 30));
  ResectionPlan wedge = at("B", 30);
  wedge.resections[0].planes.push_back({Vec3(34, 34, 36), Vec3::UnitZ()});
  const AssessedPlan b = assessed(wedge);
  EXPECT_EQ(differenceOf(a, b).size(), differenceOf(b, a).size());
  EXPECT_TRUE(holds(differenceOf(a, b), "Resection 1 has 1 planes in A and 2 in B."));
  EXPECT_TRUE(holds(differenceOf(b, a), "Resection 1 has 2 planes in B and 1 in A."));
}

TEST_F(ComparePlans, ABentPlaneThatLiesElsewhereWithinItsPlaneIsAnotherOne) {
  const auto bentAt = [](const std::string& name, double y) {
    ResectionPlan plan = at(name, 30);
    ResectionPlane& plane = plan.resections[0].planes[0];
    plane.origin.y() += y;
    plane.bend = Bend{Vec3::UnitY(), 60, {0, 0, 0, 0, 0, 8, 8, 0, 0, 8, 8, 0, 0, 0, 0, 0}};
    return plan;
  };
  const AssessedPlan a = assessed(bentAt("A", 0));
  EXPECT_TRUE(holds(differenceOf(a, assessed(bentAt("B", 12))),
                    "Plane 1 of Resection 1 is turned by 0.0 degrees and lies 12.0 mm from where it was placed in A."));
  EXPECT_EQ(differenceOf(a, assessed(bentAt("B", 0))), (std::vector<std::string>{"A and B are alike."}));
  ResectionPlan flat = at("B", 30);
  flat.resections[0].planes[0].origin.y() += 12;
  EXPECT_FALSE(holds(differenceOf(assessed(at("A", 30)), assessed(flat)), "Plane 1")) << "a flat plane is the same one";
}

TEST_F(ComparePlans, EqualPlansAreAlikeAndOneWithoutVolumesHasNone) {
  EXPECT_EQ(differenceOf(assessed(at("A", 30)), assessed(at("B", 30))), (std::vector<std::string>{"A and B are alike."}));
  EXPECT_TRUE(holds(differenceOf(assessed(at("A", 30)), assessed(at("Beside", 300))), "none in Beside."));
}

TEST_F(ComparePlans, JsonHoldsTheTable) {
  const std::vector<AssessedPlan> plans{assessed(at("A", 30)), assessed(at("Beside", 300))};
  const auto json = Json::parse(toJson(comparePlans(plans), differenceOf(plans[0], plans[1])));
  EXPECT_EQ(json["plans"], (Json{"A", "Beside"}));
  EXPECT_EQ(json["rows"][3]["row"], "resectedMl");
  EXPECT_TRUE(json["rows"][3]["values"][1].is_null());
  EXPECT_FALSE(json["differences"].empty());
}

}  // namespace
}  // namespace glisson
