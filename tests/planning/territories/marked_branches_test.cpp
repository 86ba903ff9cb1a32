// What the user said about the territories, from branches to points and back.
#include "planning/territories/marked_branches.h"

#include <gtest/gtest.h>

#include "fork.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {
using namespace test;

bool sameBranches(const TerritoryChoice& a, const TerritoryChoice& b) {
  return std::ranges::equal(a.picks, b.picks, [](const TerritoryPick& p, const TerritoryPick& q) {
    return p.name == q.name && p.branches == q.branches;
  });
}

TEST(MarkedBranches, EveryBranchOfAPickIsFoundAgain) {
  const VesselGraph portal = portalOf(forkCase(Vec3(0.8, 0.8, 2.5)));
  ASSERT_GT(portal.branches.size(), 2U);
  TerritoryChoice choice;
  choice.confirmed = true;
  for (std::size_t b = 0; b < portal.branches.size(); ++b) {  // trunk and all
    choice.picks.push_back({"Territory " + std::to_string(b), {static_cast<std::int32_t>(b)}});
  }
  const TerritoryMarks marks = marksOf(choice, portal);
  EXPECT_FALSE(marks.proposed);
  const TerritoryChoice again = choiceOf(marks, portal);
  EXPECT_TRUE(sameBranches(again, choice));
  EXPECT_EQ(again.source, TerritorySource::Picked);
  EXPECT_TRUE(again.confirmed);
  EXPECT_EQ(marksOf(again, portal), marks);
}

TEST(MarkedBranches, AProposalIsKeptOnceItIsConfirmed) {
  const VesselGraph portal = portalOf(forkCase());
  TerritoryChoice proposal = proposeLeftRight(portal);
  EXPECT_EQ(marksOf(proposal, portal), TerritoryMarks());
  EXPECT_FALSE(choiceOf({}, portal).confirmed);
  EXPECT_TRUE(sameBranches(choiceOf({}, portal), proposal));
  proposal.confirmed = true;
  const TerritoryChoice again = choiceOf(marksOf(proposal, portal), portal);
  EXPECT_TRUE(again.confirmed);
  EXPECT_EQ(again.source, TerritorySource::Proposal);
  EXPECT_TRUE(sameBranches(again, proposal));
}

TEST(MarkedBranches, AMarkWithoutItsBranchIsNotMovedToAnotherOne) {
  const VesselGraph portal = portalOf(forkCase());
  TerritoryMarks marks = marksOf(choiceOf({{{"arm", {Vec3(20, -10, 20)}}}, false}, portal), portal);
  ASSERT_EQ(marks.marks.size(), 1U);  // the right arm of the fork
  marks.marks[0].pointsMm[0].x() += 30;
  const TerritoryChoice moved = choiceOf(marks, portal);
  EXPECT_FALSE(moved.confirmed);
  EXPECT_EQ(moved.source, TerritorySource::Proposal);
  EXPECT_NE(moved.notes.back().find("proposed anew"), std::string::npos);
  const Vec3 arm(20, -10, 20);
  EXPECT_FALSE(choiceOf({{{"a", {arm}}, {"b", {arm}}}, false}, portal).confirmed) << "one branch for two marks";
}

TEST(MarkedBranches, WhatIsNoMarkIsRefused) {
  EXPECT_THROW(validate(TerritoryMarks{{{"", {Vec3(0, 0, 0)}}}, false}), PlanningError);
  EXPECT_THROW(validate(TerritoryMarks{{{"a", {}}}, false}), PlanningError);
  EXPECT_THROW(validate(TerritoryMarks{{{"a", {Vec3(0, std::numeric_limits<double>::infinity(), 0)}}}, false}), PlanningError);
  EXPECT_THROW(validate(TerritoryMarks{{{"a", {Vec3(1, 2, 3)}}}, false, SegmentMapFile{"/a.nii", ""}}), PlanningError);
  EXPECT_THROW(validate(TerritoryMarks{{}, false, SegmentMapFile{}}), PlanningError);
  EXPECT_NO_THROW(validate(TerritoryMarks{{}, false, SegmentMapFile{"/a.nii", ""}}));
  EXPECT_NO_THROW(validate(TerritoryMarks()));
  const std::vector<Vec3> many(100, Vec3(1, 2, 3));
  TerritoryMarks most{std::vector<TerritoryMark>(100, {"a", many}), false};
  EXPECT_NO_THROW(validate(most));
  most.marks.push_back({"b", {Vec3(0, 0, 0)}});
  EXPECT_THROW(validate(most), PlanningError) << "a foreign file must not hang the window";
  EXPECT_THROW(validate(TerritoryMarks{{{"a", std::vector<Vec3>(101, Vec3(1, 2, 3))}}, false}), PlanningError);
}

}  // namespace
}  // namespace glisson
