#include "planning/report/decisive_tumour.h"

#include <gtest/gtest.h>

namespace glisson {
namespace {

TumourAssessment tumour(const std::string& id, TumourState state, std::optional<double> mm) {
  TumourAssessment result;
  result.id = id;
  result.state = state;
  if (state == TumourState::Left) {
    result.distanceMm = mm;
  } else if (mm) {
    result.marginMm = mm;
    result.marginAtLeastMm = *mm - 0.5;
  }
  return result;
}

std::string decisiveOf(std::vector<TumourAssessment> tumours) {
  PlanAssessment assessment;
  assessment.tumours = std::move(tumours);
  const TumourAssessment* decisive = decisiveTumour(assessment);
  return decisive == nullptr ? "none" : decisive->id;
}

TEST(DecisiveTumour, ACutOneComesBeforeEveryMarginEvenWhereItsOwnIsNotMeasured) {
  const auto removed = tumour("removed", TumourState::Removed, 0.2);
  const auto left = tumour("left", TumourState::Left, 0.1);
  EXPECT_EQ(decisiveOf({removed, tumour("cut", TumourState::Cut, -0.1), left}), "cut");
  EXPECT_EQ(decisiveOf({removed, tumour("cut", TumourState::Cut, -0.1), tumour("deeper", TumourState::Cut, -4)}), "deeper");
  EXPECT_EQ(decisiveOf({tumour("deep", TumourState::Cut, -4), tumour("unmeasured", TumourState::Cut, std::nullopt)}), "unmeasured");
}

TEST(DecisiveTumour, IsTheLeastMarginOfTheRemovedAndOneThatIsLeftOnlyWhereNoneIs) {
  const auto near = tumour("near", TumourState::Left, 1);
  const auto far = tumour("far", TumourState::Left, 30);
  EXPECT_EQ(decisiveOf({near, tumour("wide", TumourState::Removed, 40), tumour("narrow", TumourState::Removed, 7)}), "narrow");
  EXPECT_EQ(decisiveOf({far, near, tumour("farthest", TumourState::Left, std::nullopt)}), "near");
  EXPECT_EQ(decisiveOf({}), "none");
}

TEST(DecisiveTumour, ACystDecidesNothingAndIsNotCounted) {
  TumourAssessment cyst = tumour("cyst", TumourState::Cut, -3);
  cyst.isCyst = true;
  EXPECT_EQ(decisiveOf({cyst, tumour("tumour", TumourState::Removed, 12)}), "tumour");
  EXPECT_EQ(decisiveOf({cyst}), "none");
  PlanAssessment assessment;
  assessment.tumours = {cyst, tumour("tumour", TumourState::Removed, 12)};
  EXPECT_EQ(tumourCounts(assessment).all(), 1U);
  EXPECT_EQ(tumourCounts(assessment).cut, 0U);
}

TEST(DecisiveTumour, CountsEachStateOfItsTumours) {
  PlanAssessment assessment;
  assessment.tumours = {tumour("a", TumourState::Left, 1), tumour("b", TumourState::Cut, -1), tumour("c", TumourState::Left, 2),
                        tumour("d", TumourState::Removed, 3)};
  const TumourCounts counts = tumourCounts(assessment);
  EXPECT_EQ(counts.left, 2U);
  EXPECT_EQ(counts.cut, 1U);
  EXPECT_EQ(counts.removed, 1U);
  EXPECT_EQ(counts.all(), 4U);
}

}  // namespace
}  // namespace glisson
