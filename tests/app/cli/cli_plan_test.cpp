// Everything a plan is asked for on the command line, on the sample patient.

#include <cmath>

#include "tests/app/cli/cli_fixture.h"

namespace glisson::test {
namespace {

using Keys = std::vector<std::string>;

class CliPlanning : public testing::Test {
 protected:
  CliPlanning() : file_(folder_ / "case.glisson") {
    std::filesystem::copy_file(sampleCase(), file_);
    const Json geometry = Json::parse(cli({"info", file_, "--json"}).out)[0]["geometry"];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle_.push_back(geometry["originMm"][axis].get<double>() +
                        0.5 * geometry["spacingMm"][axis].get<double>() * (geometry["size"][axis].get<double>() - 1));
    }
  }

  /// "x,y,z" of the grid's middle, moved.
  [[nodiscard]] std::string at(double dx, double dy, double dz) const {
    return Json(middle_[0] + dx).dump() + "," + Json(middle_[1] + dy).dump() + "," + Json(middle_[2] + dz).dump();
  }
  [[nodiscard]] Json plan(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"plan", file_, "--json"});
    const Finished finished = cli(arguments);
    EXPECT_EQ(finished.exitCode, 0) << finished.err;
    return finished.exitCode == 0 ? Json::parse(finished.out) : Json();
  }
  [[nodiscard]] Finished refused(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"plan", file_});
    return cli(arguments);
  }

  TemporaryFolder folder_;
  std::string file_;
  std::vector<double> middle_;
};

TEST_F(CliPlanning, FlrCardIsStoredWithTheCaseAndForgottenOnRequest) {
  const Json before = plan({"--plane", at(0, 0, 0) + ",1,0,0"});
  EXPECT_TRUE(before["flrCard"]["slvVautheyMl"].is_null());
  EXPECT_FALSE(before["flrCard"]["reasons"].empty());
  const Json card =
      plan({"--height", "170", "--weight", "70", "--condition", "normal", "--tumour-type", "colorectal-metastases"})["flrCard"];
  EXPECT_NEAR(card["bsaMostellerM2"].get<double>(), 1.8181, 5e-5);
  EXPECT_NEAR(card["slvUrataMl"].get<double>(), 1286.4, 0.05);
  EXPECT_NEAR(card["slvVautheyMl"].get<double>(), 1509.7, 0.05);
  EXPECT_EQ(card["ratios"][2]["ratio"], "flrOfSlvVautheyPercent");
  EXPECT_NEAR(card["ratios"][2]["value"].get<double>() * 15.097, before["functionalRemnantMl"].get<double>(), 0.1);
  EXPECT_EQ(card["ratios"][2]["thresholds"][0]["citation"], "Kishi 2009");
  EXPECT_EQ(card["marginBands"].size(), 2U);
  EXPECT_EQ(plan({})["flrCard"], card) << "kept in the case";
  const Json forgotten = plan({"--condition", "none"})["flrCard"];
  EXPECT_TRUE(forgotten["condition"].is_null());
  EXPECT_EQ(forgotten["heightCm"], 170);
  for (const Json& ratio : forgotten["ratios"]) {
    EXPECT_TRUE(ratio["thresholds"].empty());
  }
}

TEST_F(CliPlanning, FactsThatAreNoneAreRefusedAndStoreNothing) {
  const std::string before = bytesOf(file_);
  expectRefusal(refused({"--height", "tall"}), 2, "--height");
  expectRefusal(refused({"--weight", "-3"}), 2, "positive");
  expectRefusal(refused({"--condition", "fine"}), 2, "long-chemotherapy");
  expectRefusal(refused({"--tumour-type", "big"}), 2, "hepatocellular");
  expectRefusal(refused({"--plane", at(0, 0, 0) + ",1,0,0", "--weight", "0"}), 2, "positive");
  EXPECT_EQ(bytesOf(file_), before);
}

TEST_F(CliPlanning, H6AModelReplacesACaseWithPlansOnlyWhereThatIsSaid) {
  ASSERT_FALSE(plan({"--plane", at(0, 0, 0) + ",1,0,0"}).empty());
  const std::string before = bytesOf(file_);
  expectRefusal(cli({"model", sampleSegmentation(), "-o", file_}), 3, "--replace");
  EXPECT_EQ(bytesOf(file_), before);
  const Finished replaced = cli({"model", sampleSegmentation(), "-o", file_, "--replace"});
  EXPECT_EQ(replaced.exitCode, 0) << replaced.err;
  const Finished again = cli({"model", sampleSegmentation(), "-o", file_});
  EXPECT_EQ(again.exitCode, 0) << "nothing planned: " << again.err;
}

TEST_F(CliPlanning, TheSamePlanePlacedInFourWaysGivesTheSameVolumes) {
  const double typed = plan({"--dry-run", "--plane", at(0, 0, 0) + ",1,0,0"})["resectedMl"].get<double>();
  EXPECT_NEAR(plan({"--dry-run", "--slice", "sagittal," + at(0, 0, 0)})["resectedMl"].get<double>(), typed, 1e-6);
  EXPECT_NEAR(plan({"--dry-run", "--points", at(0, 0, 0) + "," + at(0, 30, 0) + "," + at(0, 0, 20)})["resectedMl"].get<double>(),
              typed, 1e-6);
  EXPECT_NEAR(plan({"--dry-run", "--line", at(0, 9, -20) + "," + at(0, -7, 30) + ",0,1,0"})["resectedMl"].get<double>(), typed,
              1e-6);
  const Json other = plan({"--dry-run", "--slice", "sagittal," + at(0, 0, 0), "--flip"});
  EXPECT_NEAR(other["remnantMl"].get<double>(), typed, 1e-6);
  EXPECT_TRUE(plan({})["resections"].empty()) << "nothing was stored";
}

TEST_F(CliPlanning, GesturesThatGiveNoPlaneAreRefused) {
  expectRefusal(refused({"--points", "0,0,0,1,1,1,2,2,2"}), 2, "one line");
  expectRefusal(refused({"--points", "0,0,0,1,1,1"}), 2, "nine numbers");
  expectRefusal(refused({"--line", "0,0,0,0,5,0,0,1,0"}), 2, "no length");
  expectRefusal(refused({"--slice", "oblique,0,0,0"}), 2, "axial, coronal or sagittal");
  expectRefusal(refused({"--flip"}), 2, "--flip");
  expectRefusal(refused({"--resection", "Resection 1", "--plane", at(0, 0, 0) + ",1,0,0"}), 2, "none");
}

TEST_F(CliPlanning, ResectionsAreAddedWidenedAndRemoved) {
  const Json one = plan({"--plane", at(0, 0, 0) + ",1,0,0"});
  const Json two = plan({"--plane", at(0, 0, 0) + ",0,0,1"});
  ASSERT_EQ(two["resections"].size(), 2U);
  EXPECT_GT(two["resectedMl"].get<double>(), one["resectedMl"].get<double>());
  const Json wedge = plan({"--plane", at(0, 0, 0) + ",0,1,0", "--resection", "Resection 1"});
  ASSERT_EQ(wedge["resections"].size(), 2U);
  EXPECT_LT(wedge["resections"][0]["volumeMl"].get<double>(), two["resections"][0]["volumeMl"].get<double>());
  const Json left = plan({"--remove-resection", "Resection 1"});
  ASSERT_EQ(left["resections"].size(), 1U);
  EXPECT_EQ(left["resections"][0]["name"], "Resection 2");
  expectRefusal(refused({"--remove-resection", "Resection 1"}), 2, "Resection 2");
}

TEST_F(CliPlanning, PlansAreCopiedRenamedComparedAndDeleted) {
  (void)plan({"--plane", at(0, 0, 0) + ",1,0,0"});
  const Json copy = plan({"--duplicate", "Wider", "--margin", "5", "--plane", at(0, 0, 0) + ",0,0,1"});
  EXPECT_EQ(copy["plan"], "Wider");
  EXPECT_EQ(copy["safetyMarginMm"], 5);
  EXPECT_EQ(plan({})["safetyMarginMm"], 10) << "the first plan is as it was";
  const Json compared = plan({"--compare", "Wider"})["comparison"];
  EXPECT_EQ(compared["plans"], (Json{"Plan 1", "Wider"}));
  EXPECT_FALSE(compared["differences"].empty());
  bool marked = false;
  for (const Json& row : compared["rows"]) {
    if (row["row"] == "resectedMl") {
      marked = row["smallest"] == Json{true, false} && row["largest"] == Json{false, true};
    }
  }
  EXPECT_TRUE(marked);
  EXPECT_EQ(plan({"--plan", "Wider", "--rename", "Both"})["plan"], "Both");
  expectRefusal(refused({"--plan", "Both", "--rename", "Plan 1"}), 2, "taken");
  expectRefusal(refused({"--compare", "Wider"}), 2, "Both");
  EXPECT_EQ(plan({"--plan", "Both", "--delete"})["plan"], "Plan 1");
  expectRefusal(refused({"--delete"}), 2, "at least one plan");
}

TEST_F(CliPlanning, ProposedMarginPlaneKeepsTheMarginOfItsTumour) {
  const Json json = plan({"--margin", "3", "--propose-margin", "tumour_01"});
  const Json& proposal = json["marginProposal"];
  ASSERT_TRUE(proposal["plane"].is_object()) << proposal.dump();
  EXPECT_GE(proposal["marginAtLeastMm"], 3.0);
  EXPECT_EQ(json["tumours"][0]["state"], "removed");
  EXPECT_EQ(json["tumours"][0]["marginAtLeastMm"], proposal["marginAtLeastMm"]);
  EXPECT_EQ(json["resections"].size(), 1U);
  EXPECT_NE(proposal["notice"].get<std::string>().find("ignores inflow, outflow and access"), std::string::npos);
  const Json stored = plan({});
  EXPECT_EQ(stored["resectedMl"], json["resectedMl"]);
  const Json none = plan({"--margin", "400", "--propose-margin", "tumour_01"});
  EXPECT_TRUE(none["marginProposal"]["plane"].is_null());
  EXPECT_TRUE(none["marginProposal"]["reason"].is_string());
  EXPECT_EQ(none["resections"].size(), 1U) << "nothing was added";
  expectRefusal(refused({"--propose-margin", "tumour_99"}), 2, "tumour_01");
  const Finished text = cli({"plan", file_, "--margin", "400", "--propose-margin", "tumour_01"});
  EXPECT_NE(text.out.find("margin plane: none"), std::string::npos) << text.out;
}

TEST_F(CliPlanning, TumoursAreMeasuredAndDistancesKept) {
  const Json json = plan({"--measure", "0,0,0,3,4,12"});
  ASSERT_EQ(json["tumourMeasures"].size(), 3U);
  for (const Json& tumour : json["tumourMeasures"]) {
    EXPECT_EQ(keysOf(tumour), (Keys{"id", "name", "volumeMl", "longestDiameterMm", "diameterFromMm", "diameterToMm", "capsuleMm",
                                    "capsuleBeyondImage", "nearestVessel", "vesselMm"}));
    // A body of this volume is no shorter than the ball of it.
    const double ball = 2 * std::cbrt(tumour["volumeMl"].get<double>() * 1000 * 3 / 4 / 3.14159265358979);
    EXPECT_GE(tumour["longestDiameterMm"].get<double>(), ball);
    EXPECT_TRUE(tumour["nearestVessel"].is_string());
  }
  ASSERT_EQ(json["measures"].size(), 1U);
  EXPECT_EQ(json["measures"][0]["distanceMm"], 13);
  EXPECT_EQ(plan({})["measures"], json["measures"]);
}

TEST_F(CliPlanning, StructuresAreAcceptedByNameKeptAndWithdrawn) {
  const auto of = [](const Json& json, const std::string& id) {
    for (const Json& structure : json["structures"]) {
      if (structure["id"] == id) {
        return structure;
      }
    }
    return Json();
  };
  EXPECT_TRUE(of(plan({}), "portal_vein")["acceptedBy"].is_null());
  const Json accepted = plan({"--accept-structure", "portal_vein", "--accept-structure", "tumour 1", "--accepted-by", "Dr. A"});
  EXPECT_EQ(keysOf(accepted["structures"][0]), (Keys{"id", "name", "madeBy", "parameters", "triangles", "voxelVolumeMl",
                                                     "meshVolumeMl", "surfaceSha256", "acceptedBy", "acceptedAt"}));
  EXPECT_EQ(of(accepted, "portal_vein")["acceptedBy"], "Dr. A");
  EXPECT_EQ(of(accepted, "tumour_01")["acceptedBy"], "Dr. A");
  EXPECT_TRUE(of(accepted, "parenchyma")["acceptedAt"].is_null());
  EXPECT_EQ(plan({})["structures"], accepted["structures"]) << "kept in the case";
  const Json dry = plan({"--dry-run", "--withdraw-acceptance", "all"});
  EXPECT_TRUE(of(dry, "portal_vein")["acceptedBy"].is_null());
  EXPECT_EQ(plan({})["structures"], accepted["structures"]) << "nothing was stored";
  const Json all = plan({"--withdraw-acceptance", "portal_vein", "--accept-structure", "parenchyma", "--accepted-by", "B"});
  EXPECT_TRUE(of(all, "portal_vein")["acceptedBy"].is_null());
  EXPECT_EQ(of(all, "parenchyma")["acceptedBy"], "B");
  EXPECT_EQ(of(all, "tumour_01")["acceptedBy"], "Dr. A");
  const std::string text = cli({"plan", file_}).out;
  EXPECT_NE(text.find("accepted: tumour_01 by Dr. A, 20"), std::string::npos) << text;
  EXPECT_NE(text.find("not accepted by anybody: portal_vein, "), std::string::npos) << text;
}

TEST_F(CliPlanning, AnAcceptanceWithoutANameOrAStructureIsRefusedAndStoresNothing) {
  const std::string before = bytesOf(file_);
  expectRefusal(refused({"--accept-structure", "portal_vein"}), 2, "--accepted-by");
  expectRefusal(refused({"--accepted-by", "A"}), 2, "--accept-structure");
  expectRefusal(refused({"--accept-structure", "portal_vein", "--accepted-by", " "}), 2, "needs a name");
  expectRefusal(refused({"--accept-structure", "spleen", "--accepted-by", "A"}), 2, "portal_vein");
  expectRefusal(refused({"--withdraw-acceptance", "nothing"}), 2, "portal_vein");
  EXPECT_EQ(bytesOf(file_), before);
}

TEST_F(CliPlanning, IslandThatIsNoneChangesNothingAndSaysSo) {
  const Json before = plan({"--plane", at(0, 0, 0) + ",1,0,0"});
  const Json after = plan({"--island", at(-400, 0, 0) + ",resected"});
  EXPECT_EQ(after["resectedMl"], before["resectedMl"]);
  EXPECT_NE(after["warning"].get<std::string>().find("no island"), std::string::npos);
  EXPECT_EQ(cli({"export", file_, "-o", folder_ / "out", "--accept-deviations"}).exitCode, 0);
  EXPECT_TRUE(plan({"--island", at(-400, 0, 0) + ",back"})["warning"].is_null());
  expectRefusal(refused({"--island", at(-400, 0, 0) + ",back"}), 2, "no island at that point");
  expectRefusal(refused({"--island", "1,2,3,up"}), 2, "--island");
}

TEST_F(CliPlanning, BendTakesTheIntegralOfItsHeightsAndIsListed) {
  const std::string plane = at(0, 0, 0) + ",1,0,0";
  const Json flat = plan({"--dry-run", "--plane", plane});
  EXPECT_FALSE(flat.contains("bends"));
  const std::string zeros = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
  const Json none = plan({"--dry-run", "--plane", plane, "--bend", zeros});
  EXPECT_NEAR(none["resectedMl"].get<double>(), flat["resectedMl"].get<double>(), 1e-6);
  // All heights alike: the plane moved, whatever the half size.
  const Json moved = plan({"--dry-run", "--plane", at(-3, 0, 0) + ",1,0,0"});
  const Json lifted = plan({"--dry-run", "--plane", plane, "--bend=-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,-3,40"});
  EXPECT_NEAR(lifted["resectedMl"].get<double>(), moved["resectedMl"].get<double>(), 1e-6);
  const Json bent = plan({"--plane", plane, "--bend", "0,0,0,0,0,9,9,0,0,9,9,0,0,0,0,0,70"});
  EXPECT_LT(bent["resectedMl"].get<double>(), flat["resectedMl"].get<double>());
  EXPECT_NEAR(bent["resectedMl"].get<double>() + bent["remnantMl"].get<double>(), bent["totalMl"].get<double>(), 1e-9);
  ASSERT_EQ(bent["bends"].size(), 1U);
  EXPECT_EQ(bent["bends"][0]["resection"], "Resection 1");
  EXPECT_EQ(bent["bends"][0]["plane"], 1);
  EXPECT_EQ(bent["bends"][0]["halfSizeMm"], 70);
  EXPECT_EQ(bent["bends"][0]["heightsMm"][5], 9);
  const Json& u = bent["bends"][0]["u"];
  const Json expected{0.0, -u[2].get<double>(), u[1].get<double>()};  // (1, 0, 0) x u
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bent["bends"][0]["v"][axis].get<double>(), expected[axis].get<double>(), 1e-12);
  }
  EXPECT_EQ(bent["bends"][0]["order"], "[4 j + i]: i along u, j along v");
  EXPECT_EQ(plan({})["bends"], bent["bends"]) << "kept in the case";
  EXPECT_NE(cli({"plan", file_}).out.find("plane 1 of Resection 1 is bent"), std::string::npos);
  const Finished exported = cli({"export", file_, "-o", folder_ / "out", "--accept-deviations"});
  EXPECT_EQ(exported.exitCode, 0) << exported.err;
}

TEST_F(CliPlanning, PlaneThatIsThereIsBentBentAnewAndMadeFlatAgain) {
  const Json flat = plan({"--plane", at(0, 0, 0) + ",1,0,0"});
  const std::string heights = "0,0,0,0,0,9,9,0,0,9,9,0,0,0,0,0";
  const Json placed = plan({"--dry-run", "--duplicate", "Other", "--remove-resection", "Resection 1", "--plane",
                            at(0, 0, 0) + ",1,0,0", "--bend", heights});
  const Json bent = plan({"--bend-plane", "1," + heights});
  EXPECT_EQ(bent["resectedMl"], placed["resectedMl"]) << "as --bend does while it is placed";
  ASSERT_EQ(bent["bends"].size(), 1U);
  EXPECT_EQ(bent["bends"][0]["heightsMm"], placed["bends"][0]["heightsMm"]);
  EXPECT_EQ(bent["bends"][0]["halfSizeMm"], placed["bends"][0]["halfSizeMm"]);
  const Json anew = plan({"--bend-plane", "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,55", "--resection", "Resection 1"});
  EXPECT_EQ(anew["bends"][0]["halfSizeMm"], 55);
  EXPECT_EQ(anew["bends"][0]["originMm"], bent["bends"][0]["originMm"]) << "the square stays where it is";
  EXPECT_EQ(anew["bends"][0]["u"], bent["bends"][0]["u"]);
  const Json again = plan({"--flatten-plane", "1"});
  EXPECT_FALSE(again.contains("bends"));
  EXPECT_NEAR(again["resectedMl"].get<double>(), flat["resectedMl"].get<double>(), 1e-6);
}

TEST_F(CliPlanning, JsonSaysWhatItIsOfAndWithWhat) {
  ASSERT_FALSE(plan({"--plane", at(0, 0, 0) + ",2,0,0", "--plane", at(0, 0, 0) + ",0,0,1"}).is_null());
  const Json json = plan({"--plane", at(60, 0, 0) + ",1,0,0"});
  EXPECT_EQ(json["program"], "Glisson");
  EXPECT_FALSE(json["version"].get<std::string>().empty());
  EXPECT_EQ(json["case"].get<std::string>().substr(0, 2), "G-");
  EXPECT_TRUE(json["ctDate"].is_string());
  EXPECT_NE(json["marginNotice"].get<std::string>().find("breathing, registration and transection"), std::string::npos);
  ASSERT_EQ(json["planes"].size(), 3U);
  const Json& first = json["planes"][0];
  EXPECT_EQ(keysOf(first), (Keys{"resection", "plane", "originMm", "normal"}));
  EXPECT_EQ(first["normal"], Json::parse("[1.0, 0.0, 0.0]"));
  EXPECT_EQ(first["originMm"], Json(middle_));
  EXPECT_EQ(json["planes"][1]["plane"], 2);
  EXPECT_EQ(json["planes"][2]["resection"], "Resection 2");
  EXPECT_EQ(json["structures"][0]["surfaceSha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(json["structures"][0]["parameters"]["method"], "psr");
}

TEST_F(CliPlanning, DeletingAPlanExcludesEditsOfAnother) {
  ASSERT_FALSE(plan({"--plane", at(0, 0, 0) + ",1,0,0"}).is_null());
  ASSERT_FALSE(plan({"--duplicate", "B"}).is_null());
  const std::string before = bytesOf(file_);
  for (const auto& edit : std::vector<std::vector<std::string>>{{"--margin", "3"},
                                                                {"--plane", at(5, 0, 0) + ",1,0,0"},
                                                                {"--remove-resection", "Resection 1"},
                                                                {"--flatten-plane", "1"},
                                                                {"--measure", "0,0,0,1,1,1"},
                                                                {"--rename", "C"}}) {
    std::vector<std::string> call{"--plan", "B", "--delete"};
    call.insert(call.end(), edit.begin(), edit.end());
    expectRefusal(refused(call), 2, "--delete and " + edit.front() + " exclude each other");
  }
  EXPECT_EQ(bytesOf(file_), before);
  EXPECT_EQ(plan({"--plan", "B", "--delete"})["plan"], "Plan 1");
}

TEST_F(CliPlanning, ResectionsThatTakeAllOrNothingBesideOthersAreRefusedAndStoreNothing) {
  ASSERT_FALSE(plan({"--plane", at(0, 0, 0) + ",1,0,0"}).is_null());
  const std::string before = bytesOf(file_);
  expectRefusal(refused({"--plane", at(5, 0, 0) + ",-1,0,0"}), 2, "together take all of the liver");
  expectRefusal(refused({"--plane", at(20, 0, 0) + ",1,0,0"}), 2, "others of the plan already take all that it would");
  EXPECT_EQ(bytesOf(file_), before);
}

TEST_F(CliPlanning, PlaneThatIsNotThereIsNeitherBentNorFlattened) {
  const std::string zeros = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
  expectRefusal(refused({"--bend-plane", "1," + zeros}), 2, "needs --resection");
  ASSERT_FALSE(plan({"--plane", at(0, 0, 0) + ",1,0,0"}).is_null());
  ASSERT_FALSE(plan({"--plane", at(-60, 0, 0) + ",-1,0,0"}).is_null());
  const std::string before = bytesOf(file_);
  expectRefusal(refused({"--flatten-plane", "1"}), 2, "needs --resection");
  expectRefusal(refused({"--flatten-plane", "1", "--resection", "Resection 1"}), 2, "the plane is flat");
  expectRefusal(refused({"--flatten-plane", "2", "--resection", "Resection 1"}), 2, "Resection 1 has 1 plane");
  expectRefusal(refused({"--bend-plane", "2," + zeros, "--resection", "Resection 2"}), 2, "Resection 2 has 1 plane");
  expectRefusal(refused({"--bend-plane", "0," + zeros}), 2, "counted from 1");
  expectRefusal(refused({"--bend-plane", "1,0,0", "--resection", "Resection 1"}), 2, "sixteen heights");
  expectRefusal(refused({"--bend-plane", "1," + zeros + ",-5", "--resection", "Resection 1"}), 2, "half size");
  const std::string away = "500,500,500,500,500,500,500,500,500,500,500,500,500,500,500,500";
  expectRefusal(refused({"--bend-plane", "1," + away, "--resection", "Resection 1"}), 2, "does not divide the liver");
  EXPECT_EQ(bytesOf(file_), before);
}

TEST_F(CliPlanning, BendThatIsNoneIsRefusedAndStoresNothing) {
  const std::string before = bytesOf(file_);
  const std::string plane = at(0, 0, 0) + ",1,0,0";
  const std::string zeros = "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
  expectRefusal(refused({"--bend", zeros}), 2, "--bend needs a placed plane");
  expectRefusal(refused({"--plane", plane, "--bend", "0,0,0"}), 2, "sixteen heights");
  expectRefusal(refused({"--plane", plane, "--bend", zeros + ",50,1"}), 2, "sixteen heights");
  expectRefusal(refused({"--plane", plane, "--bend", zeros + ",x"}), 2, "no number");
  expectRefusal(refused({"--plane", plane, "--bend", zeros + ",-5"}), 2, "half size");
  expectRefusal(refused({"--plane", plane, "--bend", "5000" + zeros.substr(1)}), 2, "at most 1000 mm");
  EXPECT_EQ(bytesOf(file_), before);
}

}  // namespace
}  // namespace glisson::test
