// From the sample patient to a verified navigation package, by the command line alone.

#include "tests/app/cli/cli_fixture.h"

namespace glisson::test {
namespace {

using Keys = std::vector<std::string>;

/// A plane through the middle of the liver, resecting the left side (+x), from the case's parenchyma.
std::string middlePlane(const std::filesystem::path& caseFile) {
  const Json geometry = Json::parse(cli({"info", caseFile.string(), "--json"}).out)[0]["geometry"];
  std::string plane;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double middle = geometry["originMm"][axis].get<double>() +
                          0.5 * geometry["spacingMm"][axis].get<double>() * (geometry["size"][axis].get<double>() - 1);
    plane += Json(middle).dump() + ",";
  }
  return plane + "1,0,0";
}

std::string copyOfCase(const TemporaryFolder& folder) {
  std::filesystem::copy_file(sampleCase(), folder.path() / "case.glisson");
  return folder / "case.glisson";
}

TEST(CliModel, HoldsEveryStructureWithoutDefects) {
  const Json model = Json::parse(cli({"info", sampleCase().string(), "--json"}).out)[0];
  Keys ids;
  for (const Json& structure : model["structures"]) {
    ids.push_back(structure["id"].get<std::string>());
    EXPECT_EQ(structure["defects"], Json::array()) << structure["id"];
    EXPECT_GT(structure["triangles"], 0) << structure["id"];
  }
  for (const char* id : {"parenchyma", "portal_vein", "hepatic_vein", "tumour_01", "tumour_02", "tumour_03", "gallbladder"}) {
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  }
}

TEST(CliModel, PutsTheCtIntoTheCaseOnlyWhenAskedAndSaysSo) {
  const TemporaryFolder folder;
  expectRefusal(cli({"model", sampleSegmentation(), "--embed-ct", "-o", folder / "a.glisson"}), 2, "--ct");
  EXPECT_EQ(namesIn(folder.path()), Keys{});
  const Finished made = cli(
      {"model", sampleSegmentation(), "--ct", (samplePatient() / "ct.nii.gz").string(), "--embed-ct", "-o", folder / "a.glisson"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  EXPECT_NE(made.out.find("the CT is in it: "), std::string::npos) << made.out;
  EXPECT_EQ(Json::parse(cli({"info", folder / "a.glisson", "--json"}).out)[0]["ctEmbedded"], true);
  EXPECT_EQ(Json::parse(cli({"info", sampleCase().string(), "--json"}).out)[0]["ctEmbedded"], false);
}

TEST(CliPlan, AddsAResectionAndGivesItsNumbers) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  const Finished finished = cli({"plan", file, "--plane", middlePlane(file), "--json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json plan = Json::parse(finished.out);
  for (const char* key : {"totalMl", "tumourMl", "functionalMl", "resectedMl", "remnantMl", "volumeUncertaintyMl",
                          "functionalRemnantMl", "flrPercent", "resections", "tumours", "vesselsCrossed"}) {
    EXPECT_TRUE(plan.contains(key)) << key;
  }
  EXPECT_DOUBLE_EQ(plan["resectedMl"].get<double>() + plan["remnantMl"].get<double>(), plan["totalMl"].get<double>());
  EXPECT_GT(plan["resectedMl"], 0);
  EXPECT_GT(plan["remnantMl"], 0);
  ASSERT_EQ(plan["resections"].size(), 1U);
  EXPECT_EQ(keysOf(plan["resections"][0]), (Keys{"name", "volumeMl", "cutAreaMm2"}));
  EXPECT_EQ(plan["tumours"].size(), 3U);
  const Json again = Json::parse(cli({"plan", file, "--json"}).out);
  EXPECT_EQ(again, plan) << "the stored plan is not the one assessed";
}

TEST(CliPlan, TerritoriesAddUpToTheLiverAndAreConfirmedOnlyByAPerson) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  const Finished finished = cli({"plan", file, "--plane", middlePlane(file), "--territories", "--json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json plan = Json::parse(finished.out);
  const Json& estimates = plan["estimates"];
  EXPECT_EQ(estimates["territoriesFrom"], "proposal");
  EXPECT_EQ(estimates["territoriesConfirmed"], false);
  ASSERT_EQ(estimates["territories"].size(), 2U);
  EXPECT_EQ(keysOf(estimates["territories"][0]), (Keys{"name", "volumeMl", "resectedMl", "remnantMl"}));
  double total = 0;
  double resected = 0;
  for (const Json& part : estimates["territories"]) {
    total += part["volumeMl"].get<double>();
    resected += part["resectedMl"].get<double>();
  }
  EXPECT_NEAR(total, plan["totalMl"].get<double>(), 1e-9);
  EXPECT_NEAR(resected, plan["resectedMl"].get<double>(), 1e-6);
  EXPECT_LE(estimates["perfusedFlrMl"].get<double>(), plan["functionalRemnantMl"].get<double>() + 1e-9);
  const Json confirmed = Json::parse(cli({"plan", file, "--territories", "--confirm-territories", "--json"}).out)["estimates"];
  EXPECT_EQ(confirmed["territoriesConfirmed"], true);
  EXPECT_EQ(confirmed["territories"], estimates["territories"]);
  EXPECT_EQ(Json::parse(cli({"plan", file, "--territories", "--json"}).out)["estimates"], confirmed) << "the case keeps it";
}

TEST(CliPlan, TerritoriesCanBePickedOrReadFromAMapOfSegments) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  const Finished picked = cli({"plan", file, "--territories", "--territory", "whole=0", "--json"});
  ASSERT_EQ(picked.exitCode, 0) << picked.err;
  const Json plan = Json::parse(picked.out);
  EXPECT_EQ(plan["estimates"]["territoriesFrom"], "picked");
  ASSERT_EQ(plan["estimates"]["territories"].size(), 1U);
  EXPECT_EQ(plan["estimates"]["territories"][0]["volumeMl"], plan["totalMl"]);
  EXPECT_EQ(Json::parse(cli({"plan", file, "--territories", "--json"}).out)["estimates"], plan["estimates"]) << "the case keeps it";
  const std::string before = bytesOf(file);
  expectRefusal(cli({"plan", file, "--territories", "--territory", "none=99999"}), 2, "has no branch 99999");
  expectRefusal(cli({"plan", file, "--territories", "--territory", "not picked=0"}), 2, "give another name");
  EXPECT_EQ(cli({"plan", file, "--territories", "--confirm-territories", "--dry-run"}).exitCode, 0);
  EXPECT_EQ(bytesOf(file), before);
  const Finished segments =
      cli({"plan", file, "--territories", "--segments", (samplePatient() / "labels.nii.gz").string(), "--json"});
  ASSERT_EQ(segments.exitCode, 0) << segments.err;  // the patient's labels 1 to 7, taken for segments
  const Json map = Json::parse(segments.out);
  double total = 0;
  for (const Json& part : map["estimates"]["territories"]) {
    total += part["volumeMl"].get<double>();
  }
  EXPECT_NEAR(total, map["totalMl"].get<double>(), 1e-9);
  EXPECT_EQ(Json::parse(cli({"plan", file, "--territories", "--json"}).out)["estimates"], map["estimates"]) << "the case keeps it";
  const TemporaryFolder untouched;
  EXPECT_NE(cli({"plan", copyOfCase(untouched), "--territories"}).out.find("--confirm-territories"), std::string::npos);
}

TEST(CliPlan, UnknownPlanNameIsRefusedAndStoresNothing) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  const std::string before = bytesOf(file);
  expectRefusal(cli({"plan", file, "--plan", "Nobody's", "--plane", middlePlane(file)}), 2, "Plan 1");
  EXPECT_EQ(bytesOf(file), before);
}

TEST(CliPlan, PlaneThatMissesTheLiverIsRefusedAndStoresNothing) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  expectRefusal(cli({"plan", file, "--plane", "0,0,99999,0,0,1"}), 2, "does not divide the liver");
  expectRefusal(cli({"plan", file, "--plane", "0,0,99999,0,0,-1"}), 2, "does not divide the liver");
  EXPECT_EQ(Json::parse(cli({"plan", file, "--json"}).out)["resections"].size(), 0U);
}

TEST(CliExport, PackageIsSoundUntilAByteChangesOrAFileIsMissing) {
  const TemporaryFolder folder;
  const std::string file = copyOfCase(folder);
  ASSERT_EQ(cli({"plan", file, "--plane", middlePlane(file)}).exitCode, 0);
  const Finished exported = cli({"export", file, "-o", folder / "out", "--accept-deviations"});
  ASSERT_EQ(exported.exitCode, 0) << exported.err;
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
  const std::filesystem::path package = *std::filesystem::directory_iterator(folder / "out");
  EXPECT_EQ(cli({"verify", package.string()}).exitCode, 0);

  const std::filesystem::path stl = package / "parenchyma.stl";
  const std::string whole = bytesOf(stl);
  std::string changed = whole;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  std::ofstream(stl, std::ios::binary) << changed;
  expectRefusal(cli({"verify", package.string()}), 4, "parenchyma.stl");
  std::ofstream(stl, std::ios::binary) << whole;
  EXPECT_EQ(cli({"verify", package.string()}).exitCode, 0);
  std::filesystem::remove(stl);
  expectRefusal(cli({"verify", package.string()}), 4, "parenchyma.stl");
}

TEST(CliExport, DeviationsAreRefusedWithTheCaseAndTheFlag) {
  const TemporaryFolder folder;
  const Finished refused = cli({"export", sampleCase().string(), "-o", folder / "out"});
  expectRefusal(refused, 3, "sample.glisson: Structures deviate");
  expectRefusal(refused, 3, "--accept-deviations");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

TEST(CliExport, FormatsAreThoseAskedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(cli({"export", sampleCase().string(), "-o", folder / "out", "--formats", "glb", "--accept-deviations"}).exitCode, 0);
  std::size_t glb = 0;
  for (const std::string& name : namesIn(folder / "out")) {
    EXPECT_FALSE(name.ends_with(".stl")) << name;
    glb += name.ends_with(".glb") ? 1 : 0;
  }
  EXPECT_EQ(glb, 1U);
}

TEST(CliInterrupt, EndsWith130AndWritesNothing) {
  const TemporaryFolder folder;
  const Finished finished = runProgram("glisson-cli", {"model", sampleSegmentation(), "-o", folder / "case.glisson"}, {}, 0.3);
  EXPECT_EQ(finished.exitCode, 130) << finished.err;
  EXPECT_EQ(namesIn(folder.path()), Keys{});
}

}  // namespace
}  // namespace glisson::test
