// Edits of a plan and of the list of plans as values: what they change, what they keep, what they refuse, what they are called.

#include "planning/resection/plan_edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/resection/plan_list.h"
#include "reconstruction/errors.h"

namespace glisson {
namespace {

const HalfSpace kX{Vec3(1, 2, 3), Vec3::UnitX()};
const HalfSpace kZ{Vec3(4, 5, 6), Vec3::UnitZ()};

ResectionPlan wedgeAndSlab() { return {"Plan 1", {{"Resection 1", {kX, kZ}}, {"Left", {kZ}}}, 10}; }

std::vector<std::string> namesOf(const Plans& plans) {
  std::vector<std::string> names;
  for (const ResectionPlan& plan : plans) {
    names.push_back(plan.name);
  }
  return names;
}
using Names = std::vector<std::string>;

TEST(PlanEdit, AddedResectionGetsTheNextFreeNameAndUnitNormals) {
  ResectionPlan plan{"Plan 1", {}, 10};
  plan = apply(plan, AddResection{{"", {{Vec3::Zero(), Vec3(0, 3, 4)}}}});
  plan = apply(plan, AddResection{{"Tip", {kX, kZ}}});
  plan = apply(plan, AddResection{{"", {kX}}});
  ASSERT_EQ(plan.resections.size(), 3U);
  EXPECT_EQ(plan.resections[0].name, "Resection 1");
  EXPECT_NEAR((plan.resections[0].planes[0].normal - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(plan.resections[1].name, "Tip");
  EXPECT_EQ(plan.resections[1].planes.size(), 2U);
  EXPECT_EQ(plan.resections[2].name, "Resection 2");
  plan = apply(plan, RemoveResection{0});
  EXPECT_EQ(apply(plan, AddResection{{"", {kX}}}).resections.back().name, "Resection 1");
}

TEST(PlanEdit, PlanesAreAddedAndRemovedAndALastPlaneTakesItsResectionAlong) {
  const ResectionPlan before = wedgeAndSlab();
  ResectionPlan plan = apply(before, AddPlane{1, {Vec3::Zero(), Vec3(0, 2, 0)}});
  EXPECT_EQ(plan.resections[1].planes.size(), 2U);
  EXPECT_EQ(plan.resections[1].planes[1].normal, Vec3::UnitY());
  plan = apply(plan, RemovePlane{0, 0});
  ASSERT_EQ(plan.resections[0].planes.size(), 1U);
  EXPECT_EQ(plan.resections[0].planes[0].normal, Vec3::UnitZ()) << "the other plane stays";
  plan = apply(plan, RemovePlane{0, 0});
  ASSERT_EQ(plan.resections.size(), 1U);
  EXPECT_EQ(plan.resections[0].name, "Left");
  EXPECT_EQ(before.resections.size(), 2U) << "the plan before is kept for undo";
}

TEST(PlanEdit, MarginIslandsAndMeasuresFollow) {
  ResectionPlan plan = apply(wedgeAndSlab(), SetSafetyMargin{0});
  EXPECT_EQ(plan.safetyMarginMm, 0);
  plan = apply(plan, AssignIsland{{Vec3(1, 1, 1), PlanSide::Resected}});
  plan = apply(plan, AssignIsland{{Vec3(2, 2, 2), PlanSide::Remnant}});
  plan = apply(plan, AssignIsland{{Vec3(1, 1, 1), PlanSide::Remnant}});
  ASSERT_EQ(plan.islands.size(), 2U);
  EXPECT_EQ(plan.islands[0].to, PlanSide::Remnant);
  plan = apply(plan, ReleaseIsland{{0}});
  ASSERT_EQ(plan.islands.size(), 1U);
  EXPECT_EQ(plan.islands[0].point, Vec3(2, 2, 2));
  plan = apply(plan, AddMeasure{{"", Vec3(0, 0, 0), Vec3(3, 4, 12)}});
  ASSERT_EQ(plan.measures.size(), 1U);
  EXPECT_EQ(plan.measures[0].name, "Distance 1");
  EXPECT_EQ(plan.measures[0].mm(), 13);
  EXPECT_TRUE(apply(plan, RemoveMeasure{0}).measures.empty());
}

TEST(PlanEdit, WhatDoesNotExistOrIsNotFiniteIsRefused) {
  const ResectionPlan plan = wedgeAndSlab();
  const Vec3 bad(0, NAN, 0);
  for (const PlanEdit& edit : std::initializer_list<PlanEdit>{MovePlane{2, 0, kX},
                                                              MovePlane{1, 1, kX},
                                                              MovePlane{0, 0, {bad, Vec3::UnitX()}},
                                                              MovePlane{0, 0, {Vec3::Zero(), bad}},
                                                              MovePlane{0, 0, {Vec3::Zero(), Vec3::Zero()}},
                                                              AddResection{{"", {}}},
                                                              AddResection{{"", {kX, {bad, Vec3::UnitX()}}}},
                                                              AddResection{{"Left", {kX}}},
                                                              AddResection{{"  ", {kX}}},
                                                              RemoveResection{2},
                                                              RenameResection{2, "a"},
                                                              RenameResection{0, " "},
                                                              RenameResection{0, "Left"},
                                                              AddPlane{2, kX},
                                                              AddPlane{0, {Vec3::Zero(), Vec3::Zero()}},
                                                              RemovePlane{0, 2},
                                                              RemovePlane{9, 0},
                                                              SetSafetyMargin{-0.1},
                                                              SetSafetyMargin{NAN},
                                                              SetSafetyMargin{INFINITY},
                                                              AssignIsland{{bad, PlanSide::Remnant}},
                                                              ReleaseIsland{{0}},
                                                              AddMeasure{{"", bad, Vec3::Zero()}},
                                                              AddMeasure{{"", Vec3::Zero(), bad}},
                                                              RemoveMeasure{0}}) {
    EXPECT_THROW(apply(plan, edit), PlanningError) << edit.what.index() << " " << nameOf(plan, edit);
  }
}

TEST(PlanEdit, NamesSayWhatUndoWillUndo) {
  const ResectionPlan one{"Plan 1", {{"Resection 1", {kX}}}, 10};
  const ResectionPlan wedge{"Plan 1", {{"Resection 1", {kX, kZ}}}, 10};
  EXPECT_EQ(nameOf(one, MovePlane{0, 0, kX}), "move plane");
  EXPECT_EQ(nameOf(wedge, MovePlane{0, 1, kX}), "move plane 2");
  EXPECT_EQ(nameOf(wedgeAndSlab(), MovePlane{1, 0, kX}), "move plane 1 of Left");
  EXPECT_EQ(nameOf(wedge, RemovePlane{0, 1}), "remove plane 2");
  EXPECT_EQ(nameOf(one, AddPlane{0, kX}), "add plane");
  EXPECT_EQ(nameOf(wedgeAndSlab(), AddPlane{1, kX}), "add plane to Left");
  EXPECT_EQ(nameOf(wedgeAndSlab(), RemoveResection{1}), "remove Left");
}

TEST(PlanEdit, RenamingKeepsNamesApartAndTakesBlanksAway) {
  EXPECT_EQ(apply(wedgeAndSlab(), RenameResection{0, "  Right side\n"}).resections[0].name, "Right side");
  EXPECT_EQ(apply(wedgeAndSlab(), RenameResection{1, "Left"}).resections[1].name, "Left") << "its own name is not taken";
}

TEST(PlanList, CopiesStandBehindTheirPlanUnderNamesOfTheirOwn) {
  Plans plans{wedgeAndSlab()};
  plans = withDuplicate(plans, 0);
  plans = withDuplicate(plans, 0);
  plans = withDuplicate(plans, 0, "Atypical");
  EXPECT_EQ(namesOf(plans), (Names{"Plan 1", "Atypical", "Plan 1 copy 2", "Plan 1 copy"}));
  EXPECT_EQ(plans[1].resections.size(), 2U);
  EXPECT_EQ(plans[1].resections[0].planes[1].origin, kZ.origin);
  plans = withNew(plans);
  EXPECT_EQ(plans.back().name, "Plan 2");
  EXPECT_TRUE(plans.back().resections.empty());
  EXPECT_EQ(withNew(plans, "Hemihepatectomy").back().name, "Hemihepatectomy");
}

TEST(PlanList, DuplicateThenDeleteIsTheListBefore) {
  const Plans before{wedgeAndSlab(), {"Plan 2", {}, 5}};
  const Plans after = without(withDuplicate(before, 0), 1);
  EXPECT_EQ(namesOf(after), namesOf(before));
  EXPECT_EQ(after[1].safetyMarginMm, 5);
}

TEST(PlanList, NamesThatAreEmptyOrTakenAndPlansThatDoNotExistAreRefused) {
  const Plans plans{wedgeAndSlab(), {"Plan 2", {}, 10}};
  EXPECT_THROW(withRenamed(plans, 0, "Plan 2"), PlanningError);
  EXPECT_THROW(withRenamed(plans, 0, "\t "), PlanningError);
  EXPECT_THROW(withRenamed(plans, 2, "x"), PlanningError);
  EXPECT_EQ(withRenamed(plans, 0, "Plan 1")[0].name, "Plan 1");
  EXPECT_THROW(withDuplicate(plans, 0, "Plan 2"), PlanningError);
  EXPECT_THROW(withDuplicate(plans, 2), PlanningError);
  EXPECT_THROW(withNew(plans, "Plan 1"), PlanningError);
  EXPECT_THROW(without(plans, 2), PlanningError);
  EXPECT_THROW(without({wedgeAndSlab()}, 0), PlanningError) << "the last plan stays";
}

}  // namespace
}  // namespace glisson
