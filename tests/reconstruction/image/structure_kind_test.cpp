#include "reconstruction/image/structure_kind.h"

#include <gtest/gtest.h>

#include "reconstruction/image/label_tables.h"

namespace glisson {
namespace {

TEST(StructureKind, NamesOfTheThreeSourcesAreRecognisedInAnySpelling) {
  const std::vector<std::pair<const char*, StructureKind>> rows{{"liver", StructureKind::Liver},
                                                                {"Liver", StructureKind::Liver},
                                                                {"portalvein", StructureKind::PortalVein},
                                                                {"Portal vein", StructureKind::PortalVein},
                                                                {"portal_vein_and_splenic_vein", StructureKind::PortalVein},
                                                                {"venoussystem", StructureKind::HepaticVein},
                                                                {"Hepatic vein", StructureKind::HepaticVein},
                                                                {"hepatic_vein", StructureKind::HepaticVein},
                                                                {"inferior_vena_cava", StructureKind::VenaCava},
                                                                {"Inferior vena cava", StructureKind::VenaCava},
                                                                {"artery", StructureKind::Artery},
                                                                {"aorta", StructureKind::Artery},
                                                                {"livertumor01", StructureKind::Tumour},
                                                                {"livertumors", StructureKind::Tumour},
                                                                {"Tumor 1", StructureKind::Tumour},
                                                                {"TUMOUR_12", StructureKind::Tumour},
                                                                {"Mass", StructureKind::Tumour},
                                                                {"Neoplasm", StructureKind::Tumour},
                                                                {"liverkyst", StructureKind::Cyst},
                                                                {"livercyst02", StructureKind::Cyst},
                                                                {"gallbladder", StructureKind::Gallbladder},
                                                                {"Gall bladder", StructureKind::Gallbladder},
                                                                {"Bile duct", StructureKind::BileDuct},
                                                                {"spleen", StructureKind::Other},
                                                                {"rightkidney", StructureKind::Other},
                                                                {"rib_left_3", StructureKind::Other},
                                                                {"vertebrae_T12", StructureKind::Other},
                                                                {"skin", StructureKind::Other}};
  for (const auto& [name, kind] : rows) {
    EXPECT_EQ(recogniseKind(name), kind) << name;
  }
}

TEST(StructureKind, WhatIsNotKnownIsNeverGuessed) {
  for (const char* name :
       {"", "64", "label 5", "Segment_1", "liver_vessels", "liver_segment_1", "vessel", "not liver", "lesion", "L1"}) {
    EXPECT_FALSE(recogniseKind(name).has_value()) << name;
  }
}

TEST(StructureKind, IdsRoundTripAndTheirCommonSpellingsAreTaken) {
  for (const StructureKind kind : kAllStructureKinds) {
    EXPECT_EQ(kindFromId(kindId(kind)), kind);
  }
  EXPECT_EQ(kindFromId("liver"), StructureKind::Liver);
  EXPECT_EQ(kindFromId("tumor"), StructureKind::Tumour);
  EXPECT_FALSE(kindFromId("spaceship").has_value());
}

TEST(StructureKind, TablesHoldTheirPublishedClasses) {
  const auto v2 = labelTableNames("totalsegmentator");
  EXPECT_EQ(v2.size(), 117U);
  EXPECT_EQ(v2.at(4), "gallbladder");
  EXPECT_EQ(v2.at(5), "liver");
  EXPECT_EQ(v2.at(52), "aorta");
  EXPECT_EQ(v2.at(63), "inferior_vena_cava");
  EXPECT_EQ(v2.at(64), "portal_vein_and_splenic_vein");
  EXPECT_EQ(v2.at(117), "costal_cartilages");
  const auto v1 = labelTableNames("totalsegmentator-v1");
  EXPECT_EQ(v1.size(), 104U);
  EXPECT_EQ(v1.at(8), "inferior_vena_cava");
  EXPECT_EQ(v1.at(9), "portal_vein_and_splenic_vein");
  EXPECT_EQ(v1.at(63), "rib_left_6");
  EXPECT_EQ(v1.at(104), "urinary_bladder");
  const auto mr = labelTableNames("totalsegmentator-mr");
  EXPECT_EQ(mr.at(24), "inferior_vena_cava");
  EXPECT_EQ(mr.at(25), "portal_vein_and_splenic_vein");
  EXPECT_TRUE(labelTableNames("something").empty());
  for (const auto& table : {v2, v1, mr}) {
    for (const auto& [number, name] : table) {
      EXPECT_TRUE(recogniseKind(name).has_value()) << name;
    }
  }
}

TEST(StructureKind, VesselsAndLesionsAreToldApart) {
  EXPECT_TRUE(isVessel(StructureKind::VenaCava));
  EXPECT_FALSE(isVessel(StructureKind::BileDuct));
  EXPECT_TRUE(isLesion(StructureKind::Cyst));
  EXPECT_FALSE(isLesion(StructureKind::Liver));
  EXPECT_EQ(defaultColour(StructureKind::Liver), (Rgb{221, 130, 101}));
}

}  // namespace
}  // namespace glisson
