#include "planning/case/case.h"

#include <gtest/gtest.h>

#include <mutex>

#include "reconstruction/errors.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;

ImageGeometry grid() { return gridOf({40, 40, 24}, Vec3(1, 1, 1.6), Vec3(-20, 30, 400)); }
const Vec3 kCentre(-0.5, 49.5, 418.4);

std::shared_ptr<Segmentation> patient() {
  return segmentationOf(grid(), {{"tumor b", StructureKind::Tumour, ball(kCentre + Vec3(6, 0, 0), 3)},
                                 {"portal vein left", StructureKind::PortalVein, ball(kCentre + Vec3(0, 6, 0), 3)},
                                 {"Leber", StructureKind::Liver, ball(kCentre, 15)},
                                 {"tumor a", StructureKind::Tumour, ball(kCentre - Vec3(6, 0, 0), 3)},
                                 {"portal vein right", StructureKind::PortalVein, ball(kCentre - Vec3(0, 6, 0), 3)},
                                 {"cyst", StructureKind::Cyst, ball(kCentre + Vec3(0, 0, 8), 2)},
                                 {"spleen", StructureKind::Other, ball(kCentre, 2)},
                                 {"artery", StructureKind::Artery, [](const Vec3&) { return false; }}});
}

std::vector<std::string> idsOf(const LiverModel& model) {
  std::vector<std::string> ids;
  for (const Structure& structure : model.structures) {
    ids.push_back(structure.id);
  }
  return ids;
}

bool mentions(const std::vector<std::string>& notes, const std::string& text) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(NewCase, StructuresHaveAsciiIdsInFileOrderWithTheParenchymaFirst) {
  const Case made = newCase(nullptr, patient());
  EXPECT_EQ(idsOf(*made.model),
            (std::vector<std::string>{"parenchyma", "tumour_01", "portal_vein", "tumour_02", "portal_vein_02", "cyst_01"}));
  EXPECT_EQ(made.model->find("tumour_01")->name, "tumor b");
  EXPECT_EQ(made.model->find("tumour_02")->name, "tumor a");
  EXPECT_EQ(made.model->find("parenchyma")->sourceIndex, 2);
  EXPECT_EQ(made.model->find("spleen"), nullptr);
}

TEST(NewCase, WhatIsNotInTheModelIsSaid) {
  const Case made = newCase(nullptr, patient());
  EXPECT_TRUE(mentions(made.notes, "spleen"));
  EXPECT_TRUE(mentions(made.notes, "artery has no voxels"));
}

TEST(NewCase, StartsWithOnePlanAndAParenchymaOneCanSeeThrough) {
  const Case made = newCase(nullptr, patient());
  ASSERT_EQ(made.plans.size(), 1U);
  EXPECT_EQ(made.plans[0].name, "Plan 1");
  EXPECT_TRUE(made.plans[0].resections.empty());
  EXPECT_EQ(made.plans[0].safetyMarginMm, 10);
  EXPECT_EQ(made.model->find("parenchyma")->opacity, 0.35);
  EXPECT_EQ(made.model->find("portal_vein")->opacity, 1.0);
  EXPECT_EQ(made.model->find("portal_vein")->colour, defaultColour(StructureKind::PortalVein));
  EXPECT_NEAR(made.liver->totalMl(), 14.1, 0.3);
}

TEST(NewCase, CodeIsAPseudonymOfItsOwn) {
  const std::string a = newCase(nullptr, patient()).code;
  const std::string b = newCase(nullptr, patient()).code;
  EXPECT_EQ(a.substr(0, 2) + std::to_string(a.size()), "G-8");
  EXPECT_EQ(a.find_first_not_of("0123456789ABCDEF", 2), std::string::npos) << a;
  EXPECT_NE(a, b);
}

TEST(NewCase, UnknownStructureIsRefusedWithItsNameAndTheFlag) {
  auto segmentation = patient();
  segmentation->structures[6].kind.reset();
  try {
    newCase(nullptr, segmentation);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"spleen\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("--labels"), std::string::npos);
  }
  segmentation->structures[6].name = "label 7";
  try {
    newCase(nullptr, segmentation);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--labels \"7=KIND\""), std::string::npos) << error.what();
  }
}

TEST(NewCase, SegmentationWithoutLiverIsRefused) {
  auto segmentation = patient();
  segmentation->structures.erase(segmentation->structures.begin() + 2);
  EXPECT_THROW(newCase(nullptr, segmentation), InputError);
}

TEST(NewCase, LabelsOffTheCtsGridAreRefused) {
  auto ct = std::make_shared<CtVolume>();
  ct->geometry = grid();
  ct->identity.patientId = "4711";
  ct->source = "ct";
  EXPECT_EQ(newCase(ct, patient()).identity.patientId, "4711");
  ct = std::make_shared<CtVolume>(*ct);
  ct->geometry.origin[0] += 1;
  EXPECT_THROW(newCase(ct, patient()), InputError);
}

TEST(BuildModel, BuildsEveryStructureFromItsOwnVoxelsWhereTheyAre) {
  double last = 0;
  bool falling = false;
  std::mutex mutex;
  const ExecutionContext context([&](double fraction, std::string_view) {
    const std::lock_guard lock(mutex);
    falling = falling || fraction < last;
    last = fraction;
  });
  const Case made = buildModel(newCase(nullptr, patient()), context);
  EXPECT_FALSE(falling);
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(made.model->revision, 1U + made.model->structures.size());
  for (const Structure& structure : made.model->structures) {
    ASSERT_TRUE(structure.reconstruction) << structure.id;
    EXPECT_FALSE(structure.reconstruction->defects.any()) << structure.id;
    const LabelledMask& source = made.segmentation->structures[static_cast<std::size_t>(structure.sourceIndex)];
    if (structure.kind != StructureKind::Liver) {
      const Bounds bounds = boundsOf(structure.reconstruction->mesh);
      const IndexBox& box = source.mask->box();
      const Vec3 middle = grid().toWorld(Vec3(box.first[0] + 0.5 * (box.size[0] - 1), box.first[1] + 0.5 * (box.size[1] - 1),
                                              box.first[2] + 0.5 * (box.size[2] - 1)));
      EXPECT_LT((0.5 * (bounds.low + bounds.high) - middle).norm(), 0.5) << structure.id;
    }
  }
  EXPECT_EQ(made.model->find("parenchyma")->reconstruction->parameters.method, Method::Psr);
  EXPECT_EQ(made.model->find("tumour_01")->reconstruction->parameters.method, Method::Mcsd);
}

TEST(BuildModel, ParenchymaIsMadeFromTheWholeLiver) {
  // Exclusive labels: the tumour is cut out of the liver mask, but not out of the parenchyma.
  auto segmentation = segmentationOf(
      grid(), {{"liver", StructureKind::Liver, ball(kCentre, 15)}, {"tumour", StructureKind::Tumour, ball(kCentre, 6)}});
  segmentation->structures[0].mask =
      std::make_shared<const Mask>(differenceOf(*segmentation->structures[0].mask, *segmentation->structures[1].mask));
  const Case made = newCase(nullptr, segmentation);
  const Structure built = buildStructure(made, *made.model->find("parenchyma"));
  EXPECT_NEAR(built.reconstruction->voxelVolumeMl, made.liver->totalMl(), 1e-9);
  EXPECT_NEAR(built.reconstruction->meshVolumeMl, made.liver->totalMl(), 0.02 * made.liver->totalMl());
}

TEST(BuildModel, CancelLeavesTheCaseAsItWas) {
  const Case made = newCase(nullptr, patient());
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(buildModel(made, context), Cancelled);
  EXPECT_FALSE(made.model->find("parenchyma")->reconstruction);
}

TEST(LiverModel, NewSnapshotLeavesTheOldOneUntouched) {
  const Case made = newCase(nullptr, patient());
  Structure changed = *made.model->find("tumour_02");
  changed.visible = false;
  const auto next = withStructure(*made.model, changed);
  EXPECT_EQ(next->revision, made.model->revision + 1);
  EXPECT_FALSE(next->find("tumour_02")->visible);
  EXPECT_TRUE(made.model->find("tumour_02")->visible);
  changed.id = "tumour_99";
  EXPECT_THROW(withStructure(*made.model, changed), PlanningError);
}

}  // namespace
}  // namespace glisson
