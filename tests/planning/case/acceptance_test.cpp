// Who accepts a structure, and that it ends with the surface that was looked at.
#include "planning/case/acceptance.h"

#include <gtest/gtest.h>

#include "planning/case/case.h"
#include "reconstruction/errors.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;

Case ballCase() {
  const ImageGeometry g = gridOf({24, 24, 24}, Vec3(1, 1, 1));
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, ball(Vec3(12, 12, 12), 8)},
                                             {"tumour", StructureKind::Tumour, ball(Vec3(12, 12, 12), 3)}}));
}

Structure surfaced(const Case& source, const std::string& id) {
  return withReconstruction(*source.model->find(id), std::make_shared<const Reconstruction>());
}

TEST(Acceptance, KeepsTheNameWithoutBlanksAndTheTimeInUtc) {
  const Acceptance made = acceptedNow("  Dr. M\xC3\xBCller ");
  EXPECT_EQ(made.by, "Dr. M\xC3\xBCller");
  ASSERT_EQ(made.at.size(), 20U);
  EXPECT_EQ(made.at.substr(0, 2), "20");
  EXPECT_EQ(made.at[10], 'T');
  EXPECT_EQ(made.at[19], 'Z');
  EXPECT_NO_THROW(validate(made));
}

TEST(Acceptance, ANameThatIsNoneAndATimeThatIsNoneAreRefused) {
  for (const std::string& name : {std::string(), std::string("   "), std::string("A\nB"), std::string(201, 'x')}) {
    EXPECT_THROW((void)acceptedNow(name), PlanningError) << name;
  }
  for (const char* time : {"", "today", "2026-01-31", "2026-01-31T09:05:00", "2026-01-31T09:05:00+"}) {
    EXPECT_THROW(validate(Acceptance{"A", time}), PlanningError) << time;
  }
}

TEST(Acceptance, IsOfTheStructuresThatWereNamedAndOfNoOther) {
  const Case source = ballCase();
  const auto built = withStructure(*source.model, surfaced(source, "tumour_01"));
  EXPECT_EQ(notAccepted(*built), (std::vector<std::string>{"parenchyma", "tumour_01"}));
  const Acceptance made = acceptedNow("A");
  const auto accepted = withAcceptance(*built, {"tumour_01"}, made);
  EXPECT_EQ(accepted->revision, built->revision + 1);
  EXPECT_EQ(accepted->find("tumour_01")->acceptance, made);
  EXPECT_EQ(notAccepted(*accepted), std::vector<std::string>{"parenchyma"});
  EXPECT_EQ(built->find("tumour_01")->acceptance, std::nullopt) << "a snapshot does not change";
  EXPECT_EQ(withAcceptance(*accepted, {"tumour_01"}, std::nullopt)->find("tumour_01")->acceptance, std::nullopt);
}

TEST(Acceptance, NeedsASurfaceToLookAtAndAStructureThatIsThere) {
  const Case source = ballCase();
  EXPECT_THROW(withAcceptance(*source.model, {"tumour_01"}, acceptedNow("A")), PlanningError);
  EXPECT_THROW(withAcceptance(*source.model, {"tumour_09"}, acceptedNow("A")), PlanningError);
  EXPECT_NO_THROW(withAcceptance(*source.model, {"tumour_01"}, std::nullopt));
}

TEST(Acceptance, EndsWhenTheSurfaceIsMadeAgain_H5) {
  const Case source = ballCase();
  const auto built = withStructure(*source.model, surfaced(source, "tumour_01"));
  const auto accepted = withAcceptance(*built, {"tumour_01"}, acceptedNow("A"));
  EXPECT_EQ(buildStructure(source, *accepted->find("tumour_01")).acceptance, std::nullopt);
  Case again = source;
  again.model = accepted;
  EXPECT_EQ(notAccepted(*buildModel(again).model).size(), 2U);
}

}  // namespace
}  // namespace glisson
