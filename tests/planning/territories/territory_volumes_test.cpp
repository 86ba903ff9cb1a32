#include <gtest/gtest.h>
#include <unistd.h>

#include "fork.h"
#include "planning/territories/marked_branches.h"
#include "planning/territories/segment_map.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/errors.h"
#include "reconstruction/sample/volume_writers.h"

namespace glisson {
namespace {
using namespace test;

Territories leftRight(const Case& source) {
  const VesselGraph portal = portalOf(source);
  return territoriesOf(*source.liver, portal, proposeLeftRight(portal));
}
std::size_t voxelsOf(const Territories& territories) {
  std::size_t sum = 0;
  for (const Territory& part : territories.parts) {
    sum += part.rows.voxels;
  }
  return sum;
}
const double kLeftMl = (40 - kForkBorder) * 40 * 60 * 1e-3;
const double kRightMl = (40 + kForkBorder) * 40 * 60 * 1e-3;

TEST(TerritoryVolumes, BorderOfParallelBranchesIsThePlaneHalfway) {
  const Case& source = forkCase();
  const Territories made = leftRight(source);
  const auto volumes = volumesOf(made, {});
  ASSERT_EQ(volumes.size(), 2U);
  // One layer of voxels is as near to one arm as to the other, where an arm's middle lies between voxels.
  EXPECT_NEAR(volumes[0].volumeMl, kLeftMl, 0.5 * 40 * 60 * 1e-3 + 1e-9);
  EXPECT_NEAR(volumes[1].volumeMl, kRightMl, 0.5 * 40 * 60 * 1e-3 + 1e-9);
  EXPECT_EQ(voxelsOf(made), source.liver->liver.count());
}

TEST(TerritoryVolumes, AddUpToTheLiverAndFollowTheirShapeInTurnedGrids) {
  const Mat3 grid = Eigen::AngleAxisd(0.4, Vec3(2, 1, -1).normalized()).toRotationMatrix();
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.linear() = Eigen::AngleAxisd(0.3, Vec3(0, 1, 0.4).normalized()).toRotationMatrix();
  place.translation() = Vec3(100, -40, 7);
  for (const Vec3& spacing : {Vec3(1, 1, 1), Vec3(0.8, 0.8, 2.5)}) {
    for (const Mat3& direction : {Mat3(Mat3::Identity()), grid, Mat3(grid * Vec3(1, 1, -1).asDiagonal())}) {
      const Case source = forkCase(spacing, place, direction);
      const Territories made = leftRight(source);
      EXPECT_EQ(voxelsOf(made), source.liver->liver.count());
      const auto volumes = volumesOf(made, {});
      EXPECT_NEAR(volumes[0].volumeMl, kLeftMl, 0.04 * kLeftMl) << spacing.transpose();
      EXPECT_NEAR(volumes[1].volumeMl, kRightMl, 0.04 * kRightMl) << spacing.transpose();
    }
  }
}

TEST(TerritoryVolumes, AreTakenByAPlanAsTheWholeLiverIs) {
  const Case& source = forkCase();
  const Territories made = leftRight(source);
  const PlanAssessor assessor(source);
  const ResectionPlan plan = planOf({{{Vec3(3.3, 2, 1), Vec3(1, 0.3, -0.2).normalized()}}, forkSlab(-10, 3.7)});
  double resected = 0;
  for (const TerritoryVolume& part : volumesOf(made, plan)) {
    EXPECT_NEAR(part.resectedMl + part.remnantMl, part.volumeMl, 1e-9);
    resected += part.resectedMl;
  }
  EXPECT_NEAR(resected, assessor.volumes(plan).resectedMl, 1e-6);
  const auto half = volumesOf(made, planOf({{{Vec3(kForkBorder, 0, 0), Vec3::UnitX()}}}));
  EXPECT_NEAR(half[0].remnantMl, 0, 0.5 * 40 * 60 * 1e-3 + 1e-9);
  EXPECT_NEAR(half[1].resectedMl, 0, 0.5 * 40 * 60 * 1e-3 + 1e-9);
}

TEST(TerritoryVolumes, PickBehindAPickTakesItsPart) {
  const Case& source = forkCase();
  const VesselGraph portal = portalOf(source);
  TerritoryChoice choice;
  choice.picks = {{"all", {0}}, {"one arm", {1}}};
  const Territories made = territoriesOf(*source.liver, portal, choice);
  EXPECT_EQ(voxelsOf(made), source.liver->liver.count());
  const Territories proposed = leftRight(source);
  const bool firstIsLeft = portal.branches[1].centreMm.x() > portal.branches[2].centreMm.x();
  EXPECT_EQ(made.parts[1].rows.voxels, proposed.parts[firstIsLeft ? 0 : 1].rows.voxels);
}

TEST(TerritoryVolumes, BranchesThatAreNotPickedKeepWhatIsNearestToThem) {
  const Case& source = forkCase();
  const VesselGraph portal = portalOf(source);
  const Territories proposed = leftRight(source);
  const TerritoryChoice sides = proposeLeftRight(portal);
  TerritoryChoice choice;
  choice.picks = {{"one arm", sides.picks[0].branches}};
  const Territories made = territoriesOf(*source.liver, portal, choice);
  ASSERT_EQ(made.parts.size(), 2U);
  EXPECT_EQ(made.parts[0].rows.voxels, proposed.parts[0].rows.voxels);
  EXPECT_EQ(made.parts[1].name, kNotPicked);
  EXPECT_EQ(made.parts[1].rows.voxels, proposed.parts[1].rows.voxels);
  EXPECT_EQ(voxelsOf(made), source.liver->liver.count());
  choice.picks.push_back({"the other", sides.picks[1].branches});
  EXPECT_EQ(territoriesOf(*source.liver, portal, choice).parts.size(), 2U) << "nothing is left over";
}

TEST(TerritoryVolumes, PicksThatMakeNoSenseAreRefused) {
  const Case& source = forkCase();
  const VesselGraph portal = portalOf(source);
  const auto refused = [&](std::vector<TerritoryPick> picks) {
    TerritoryChoice choice;
    choice.picks = std::move(picks);
    EXPECT_THROW(territoriesOf(*source.liver, portal, choice), UsageError);
  };
  refused({});
  refused({{"a", {99}}});
  refused({{"a", {-1}}});
  refused({{"a", {1}}, {"b", {1}}});
  refused({{"a", {0}}, {"b", {1}}, {"c", {2}}});  // a is left with the trunk alone
}

TEST(TerritoryVolumes, SegmentMapGivesItsPartsAndWhatItLeavesOut) {
  const Case& source = forkCase();
  const ImageGeometry& g = source.liver->geometry;
  auto map = segmentationOf(g, {{"liver_segment_2", StructureKind::Liver, box(Vec3(0, -20, -20), kForkHigh)},
                                {"segment 8", StructureKind::Liver, box(Vec3(-30, -30, -30), Vec3(10, 20, 40))},
                                {"spleen", StructureKind::Other, box(Vec3(-60, -20, -20), Vec3(-50, 20, 20))}});
  map->structures[2].label = 44;
  const Territories made = segmentTerritories(*source.liver, *map);
  EXPECT_TRUE(made.confirmed);
  const auto volumes = volumesOf(made, {});
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_EQ(volumes[0].name, "segment 2");
  EXPECT_NEAR(volumes[0].volumeMl, 40 * 40 * 60 * 1e-3, 1e-9);
  EXPECT_EQ(volumes[1].name, "segment 8");
  EXPECT_NEAR(volumes[1].volumeMl, 30 * 40 * 60 * 1e-3, 1e-9);
  EXPECT_EQ(volumes[2].name, "unassigned");
  EXPECT_NEAR(volumes[2].volumeMl, 10 * 40 * 60 * 1e-3, 1e-9);
  EXPECT_EQ(voxelsOf(made), source.liver->liver.count());
}

TEST(TerritoryVolumes, AMapThatACaseKeepsIsReadAgainAsLongAsItSaysTheSame) {
  const Case& source = forkCase();
  const VesselGraph portal = portalOf(source);
  const auto folder = std::filesystem::temp_directory_path() / ("glisson_segments_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto map = folder / "liver_segment_4.nii.gz";
  std::vector<std::uint8_t> labels(source.liver->geometry.voxelCount(), 4);
  sample::writeNifti(map, source.liver->geometry, labels);
  for (const auto& path : {map, folder}) {
    const Territories fresh = segmentTerritories(source, path);
    ASSERT_EQ(fresh.parts.size(), 1U);
    EXPECT_EQ(fresh.parts[0].name, "segment 4");
    const SegmentMapFile kept = segmentMapFile(path, fresh);
    const TerritoryChoice choice = choiceOf({.marks = {}, .segments = kept}, portal);
    EXPECT_EQ(marksOf(choice, portal).segments, kept);
    EXPECT_EQ(voxelsOf(territoriesOf(source, portal, choice)), source.liver->liver.count());
  }
  const SegmentMapFile kept = segmentMapFile(map, segmentTerritories(source, map));
  sample::writeNifti(folder / "note.nii.gz", source.liver->geometry, labels);  // nothing of this map
  EXPECT_NO_THROW(territoriesOf(source, portal, segmentChoice(kept)));
  std::fill_n(labels.begin(), labels.size() / 2, std::uint8_t{5});
  sample::writeNifti(map, source.liver->geometry, labels);
  EXPECT_THROW(territoriesOf(source, portal, segmentChoice(kept)), InputError);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(territoriesOf(source, portal, segmentChoice(kept)), InputError);
}

TEST(TerritoryVolumes, SegmentMapOnAnotherGridOrWithoutSegmentsIsRefused) {
  const Case& source = forkCase();
  auto map = std::make_shared<Segmentation>(*source.segmentation);
  map->geometry.origin[0] += 1;
  EXPECT_THROW(segmentTerritories(*source.liver, *map), InputError);
  map->geometry = source.liver->geometry;
  for (LabelledMask& structure : map->structures) {
    structure.label = 9;
  }
  EXPECT_THROW(segmentTerritories(*source.liver, *map), InputError);
}

}  // namespace
}  // namespace glisson
