// Islands that are given to the other side in a package: meshes of that side, and no surface where nothing is divided any more.

#include <gtest/gtest.h>

#include <fstream>

#include "planning/exchange/mesh_files.h"
#include "planning/exchange/package.h"
#include "planning/exchange/package_islands.h"
#include "planning/resection/plan_edit.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "tests/planning/exchange/bodies.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;
/// A bar along x with two legs up z at its ends, of 40 and 30 mm: a plane across the legs leaves two pieces above it.
Case archModel() {
  const ImageGeometry g = gridOf({46, 18, 44}, Vec3(1.5, 1.5, 1.5), Vec3(-4, -3, -4));
  const Inside bar = box(Vec3(0, 0, 0), Vec3(60, 20, 15));
  const Inside longLeg = box(Vec3(0, 0, 0), Vec3(15, 20, 55));
  const Inside shortLeg = box(Vec3(45, 0, 0), Vec3(60, 20, 45));
  Case made = newCase(
      nullptr,
      segmentationOf(g, {{"liver", StructureKind::Liver, [=](const Vec3& p) { return bar(p) || longLeg(p) || shortLeg(p); }}}));
  return buildModel(made);
}

const HalfSpace kAcrossWideLegs{Vec3(30, 10, 25.3), Vec3::UnitZ()};

struct Exported {
  std::filesystem::path folder;
  Json plan;
  [[nodiscard]] double mm3(const std::string& id) const { return signedVolumeMm3(readMesh(folder / (id + ".stl"))); }
};

Exported exported(Case source, const ResectionPlan& plan, const std::filesystem::path& folder) {
  source.plans = {plan};
  ExportOptions options;
  options.timestamp = "20260102-0304";
  options.acceptDeviations = true;
  Exported made{exportPackage(source, folder, options).folder, {}};
  std::ifstream(made.folder / "plan.json") >> made.plan;
  EXPECT_EQ(verifyPackage(made.folder), std::vector<std::string>{});
  return made;
}

TEST(IslandsInPackages, AreMeshesOfTheSideTheyAreGivenTo) {
  const Case source = archModel();
  const PlanAssessor assessor(source);
  for (const bool up : {true, false}) {
    const Scratch scratch;
    const ResectionPlan plan = planOf({{up ? kAcrossWideLegs : flipped(kAcrossWideLegs)}});
    const IslandAssessment island = assessor.assess(plan).islands.at(0);
    const PlanSide to = up ? PlanSide::Remnant : PlanSide::Resected;
    const ResectionPlan given = apply(plan, AssignIsland{{island.point, to}});
    const Exported made = exported(source, given, scratch.path);
    const Json& pieces = up ? made.plan["remnant"] : made.plan["resections"][0]["meshes"];
    const std::string stem = up ? "remnant" : "resected_01";
    EXPECT_NE(std::find(pieces.begin(), pieces.end(), stem + "_01"), pieces.end()) << pieces;
    EXPECT_NE(std::find(pieces.begin(), pieces.end(), stem + "_02"), pieces.end()) << pieces;
    EXPECT_NEAR(made.mm3(stem + "_02") * kMlPerMm3 / island.volumeMl, 1, 0.05);
    const double others = up ? made.mm3("resected_01") : made.mm3("remnant");
    const double whole = made.mm3("parenchyma");
    EXPECT_NEAR(made.mm3(stem + "_01") + made.mm3(stem + "_02") + others, whole, 1e-5 * whole);
    const PlanAssessment after = assessor.assess(given);
    EXPECT_NEAR(areaMm2(readMesh(made.folder / "resection_surface_01.stl")) / after.resections[0].cutAreaMm2, 1, 0.05)
        << "the cut of the longer leg alone";
    EXPECT_EQ(made.plan["assessment"]["islands"][0]["assigned"], true);
  }
}

TEST(IslandsInPackages, OneThatIsGivenToNobodyIsPartOfItsSideAsThePlanesLeaveIt) {
  const Scratch scratch;
  const Exported made = exported(archModel(), planOf({{kAcrossWideLegs}}), scratch.path);
  EXPECT_EQ(made.plan["remnant"], Json::array({"remnant"}));
  EXPECT_TRUE(std::filesystem::exists(made.folder / "resected_01.stl"));
}

TEST(IslandsInPackages, OneThatHangsTogetherWithTheRestOnTheSurfaceIsRefused) {
  const auto noArea = [](const SurfaceMesh&, const std::vector<ResectionPlane>&) { return 0.0; };
  IslandAssessment island{PlanSide::Resected, true, 1.5, 1.5, Vec3(0, 0, 0)};
  std::vector<ResectedPart> parts{{{sphere(Vec3(0, 0, 0), 20, 2), sphere(Vec3(100, 0, 0), 20, 2)}, sphere(Vec3(0, 0, 0), 1, 1)}};
  std::vector<SurfaceMesh> remnant;
  EXPECT_THROW(moveIslands({island}, planOf({{kAcrossWideLegs}}), noArea, parts, remnant), PlanningError) << "33 mL around 1.5";
  island.point = Vec3(0, 300, 0);
  EXPECT_THROW(moveIslands({island}, planOf({{kAcrossWideLegs}}), noArea, parts, remnant), PlanningError) << "nothing there";
  island.assigned = false;
  moveIslands({island}, planOf({{kAcrossWideLegs}}), noArea, parts, remnant);
  EXPECT_TRUE(remnant.empty());
}

TEST(IslandsInPackages, ACavityGoesWithItsIsland) {
  const auto noArea = [](const SurfaceMesh&, const std::vector<ResectionPlane>&) { return 0.0; };
  SurfaceMesh both = sphere(Vec3(0, 0, 0), 20, 2);
  for (SurfaceMesh more : {sphere(Vec3(100, 0, 0), 10, 2), sphere(Vec3(103, 0, 0), 4, 2)}) {
    const bool cavity = more.vertices.front().x() > 98 && boundsOf(more).high.x() < 108;
    const auto first = static_cast<std::uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Triangle& t : more.triangles) {
      both.triangles.push_back(cavity ? Triangle{t[0] + first, t[2] + first, t[1] + first}
                                      : Triangle{t[0] + first, t[1] + first, t[2] + first});
    }
  }
  std::vector<ResectedPart> parts{{{both}, sphere(Vec3(0, 0, 0), 1, 1)}};
  std::vector<SurfaceMesh> remnant;
  moveIslands({{PlanSide::Resected, true, 4, 4, Vec3(94, 0, 0)}}, planOf({{kAcrossWideLegs}}), noArea, parts, remnant);
  ASSERT_EQ(remnant.size(), 1U);
  std::uint32_t shells = 0;
  componentOfTriangles(remnant[0], shells);
  EXPECT_EQ(shells, 2U);
  componentOfTriangles(parts[0].pieces[0], shells);
  EXPECT_EQ(shells, 1U);
}

}  // namespace
}  // namespace glisson
