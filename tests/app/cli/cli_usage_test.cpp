// The contract of the command line: exit codes, one line on stderr, JSON keys, nothing written on failure.

#include "tests/app/cli/cli_fixture.h"
#include "tests/app/cli/evaluated_labels.h"

namespace glisson::test {
namespace {

using Keys = std::vector<std::string>;

TEST(CliUsage, HelpAndVersionAreNoFailure) {
  EXPECT_EQ(cli({"--help"}).exitCode, 0);
  const Finished version = cli({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(version.out.rfind("glisson-cli ", 0), 0U) << version.out;
}

TEST(CliUsage, HelpNamesEveryCommandAndNoneThatIsMissing) {
  const std::string help = cli({"--help"}).out;
  for (const char* command : {"sample", "info", "reconstruct", "measure", "evaluate", "model", "plan", "export", "verify"}) {
    EXPECT_NE(help.find(std::string("\n  ") + command + " "), std::string::npos) << command;
  }
  EXPECT_EQ(help.find("cohort"), std::string::npos);
}

TEST(CliUsage, AWordThatIsNoCommandIsNamed) {
  expectRefusal(cli({"bogus"}), 2, "no command bogus");
  expectRefusal(cli({"bogus", "-x", "--json"}), 2, "no command bogus");
  expectRefusal(cli({}), 2, "command");
}

class WrongUsage : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(WrongUsage, EndsWithTwoAndOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = GetParam();
  for (std::string& argument : arguments) {
    if (argument == "SEG") {
      argument = sampleSegmentation();
    }
    if (argument.rfind("OUT", 0) == 0) {
      argument = folder / argument;
    }
  }
  expectRefusal(cli(arguments), 2, "");
  EXPECT_EQ(namesIn(folder.path()), Keys{});
}

INSTANTIATE_TEST_SUITE_P(
    Cli, WrongUsage,
    testing::Values(
        Keys{}, Keys{"paint"}, Keys{"sample"}, Keys{"evaluate", "SEG"}, Keys{"evaluate", "SEG", "-o", "OUT", "--label", "99"},
        Keys{"evaluate", "SEG", "-o", "OUT", "--threads", "-1"}, Keys{"evaluate", "SEG", "-o", "OUT", "--sampling", "dense"},
        Keys{"reconstruct", "SEG"}, Keys{"reconstruct", "SEG", "-o", "OUT.doc"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--depth", "11"}, Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--depth", "7,x"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--depth", "0"}, Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--depth", "deep"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "magic"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mpu", "--variant", "d7"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mpu", "--depth", "7"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mpu", "--smoothing", "7"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "psr_knn", "--variant", "d7,"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--variant", "d7"}, Keys{"evaluate", "SEG", "-o", "OUT", "--methods", "magic"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--simplify", "10000cm"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--scale", "1,1"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--scale", "nan"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--decimation", "1"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--decimation", "0.1,1"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--decimation", "0.1,"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--decimation", ""},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--smoothing", "10,x"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--smoothing", "1.5"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--smoothing", "0,1"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "psr", "--smoothing", "0,22"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--method", "mcsd", "--depth", "7"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--label", "99"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--structure", "spleen"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--accept", "everything"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--prefer", "xform"},
        Keys{"reconstruct", "SEG", "-o", "OUT.stl", "--labels", "1=spoon"}, Keys{"model", "SEG", "-o", "OUT.stl"},
        Keys{"export", "SEG", "-o", "OUT", "--formats", "doc"}, Keys{"plan", "SEG", "--plane", "1,2,3"},
        Keys{"plan", "SEG", "--confirm-territories"}, Keys{"plan", "SEG", "--territory", "left=1"},
        Keys{"plan", "SEG", "--territories", "--territory", "left"}, Keys{"plan", "SEG", "--territories", "--territory", "left=a"},
        Keys{"plan", "SEG", "--territories", "--territory", "left="},
        Keys{"plan", "SEG", "--territories", "--confirm-territories", "--segments", "SEG"},
        Keys{"plan", "SEG", "--plane", "0,0,0,0,0,0"}, Keys{"plan", "SEG", "--plane", "0,0,0,0,nan,1"},
        Keys{"plan", "SEG", "--points", "1,2,3"}, Keys{"plan", "SEG", "--flip"},
        Keys{"plan", "SEG", "--bend", "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0"}, Keys{"plan", "SEG", "--bend-plane", "1,2"},
        Keys{"plan", "SEG", "--flatten-plane", "0"}, Keys{"plan", "SEG", "--flatten-plane", "one"},
        Keys{"plan", "SEG", "--plane", "0,0,0,0,0,1", "--bend", "1,2"}, Keys{"plan", "SEG", "--condition", "fine"},
        Keys{"plan", "SEG", "--island", "1,2,3,up"}, Keys{"plan", "SEG", "--margin", "wide"}));

TEST(CliRefusal, OfAMissingFileEndsWithThreeAndWritesNothing) {
  const TemporaryFolder folder;
  expectRefusal(cli({"info", folder / "nothing.nrrd"}), 3, "nothing.nrrd");
  expectRefusal(cli({"reconstruct", folder / "nothing.nrrd", "-o", folder / "out.stl"}), 3, "nothing.nrrd");
  expectRefusal(cli({"measure", folder / "nothing.stl"}), 3, "nothing.stl");
  expectRefusal(cli({"model", folder / "nothing.nrrd", "-o", folder / "out.glisson"}), 3, "nothing.nrrd");
  expectRefusal(cli({"plan", folder / "nothing.glisson", "--plane", "0,0,0,0,0,1"}), 3, "nothing.glisson");
  expectRefusal(cli({"export", folder / "nothing.glisson", "-o", folder / "out"}), 3, "nothing.glisson");
  expectRefusal(cli({"verify", folder / "nothing"}), 3, "nothing");
  EXPECT_EQ(namesIn(folder.path()), Keys{});
}

TEST(CliRefusal, OfAMissingOutputFolderIsSaidBeforeTheWork) {
  const TemporaryFolder folder;
  expectRefusal(cli({"reconstruct", sampleSegmentation(), "-o", folder / "missing/out.stl"}), 3, "missing");
  expectRefusal(cli({"model", sampleSegmentation(), "-o", folder / "missing/out.glisson"}), 3, "missing");
}

TEST(CliRefusal, OfAFullFolderLeavesTheSamplePatientUnwritten) {
  const TemporaryFolder folder;
  std::ofstream(folder / "mine.txt") << "keep";
  EXPECT_EQ(cli({"sample", folder.path().string()}).exitCode, 3);
  EXPECT_EQ(namesIn(folder.path()), Keys{"mine.txt"});
}

TEST(CliRefusal, OfATruncatedSegmentationKeepsTheOldOutput) {
  const TemporaryFolder folder;
  const std::string whole = bytesOf(sampleSegmentation());
  std::ofstream(folder / "cut.seg.nrrd", std::ios::binary) << whole.substr(0, whole.size() * 2 / 3);
  std::ofstream(folder / "out.stl") << "old";
  expectRefusal(cli({"reconstruct", folder / "cut.seg.nrrd", "-o", folder / "out.stl"}), 3, "cut.seg.nrrd");
  EXPECT_EQ(bytesOf(folder / "out.stl"), "old");
  EXPECT_EQ(namesIn(folder.path()), (Keys{"cut.seg.nrrd", "out.stl"}));
}

/// A MetaImage of 4 x 4 x 4 voxels of one value, with no word about what they are.
std::string tinyLabels(const TemporaryFolder& folder, const std::string& name, char value) {
  std::ofstream(folder / name, std::ios::binary)
      << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
         "Offset = 0 0 0\nElementSpacing = 1 1 1\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
      << std::string(64, value);
  return folder / name;
}

TEST(CliRefusal, OfAnInputWithoutALiverEndsWithThree) {
  const TemporaryFolder folder;
  const std::string labels = tinyLabels(folder, "labels.mha", 1);
  expectRefusal(cli({"reconstruct", labels, "--labels", "1=tumour", "--structure", "parenchyma", "-o", folder / "out.stl"}), 3,
                "no liver");
  expectRefusal(cli({"model", labels, "--labels", "1=tumour", "-o", folder / "out.glisson"}), 3, "no liver");
  expectRefusal(cli({"model", tinyLabels(folder, "empty.mha", 0), "-o", folder / "out.glisson"}), 3, "empty.mha");
  EXPECT_EQ(namesIn(folder.path()), (Keys{"empty.mha", "labels.mha"}));
}

TEST(CliInfo, NamesTheFlagForAFolderOfMasksByName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  tinyLabels(folder, "masks/liver.mha", 1);
  tinyLabels(folder, "masks/thing.mha", 1);
  const Finished finished = cli({"info", folder / "masks"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_NE(finished.out.find("--labels \"thing=KIND\""), std::string::npos) << finished.out;
}

TEST(CliInfo, KnowsTheSamplePatientsStructuresAndVolumes) {
  const Finished finished = cli({"info", sampleSegmentation(), "--json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json json = Json::parse(finished.out);
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["holds"], "segmentation");
  Keys kinds;
  for (const Json& structure : json[0]["structures"]) {
    kinds.push_back(structure["kind"].get<std::string>());
  }
  for (const char* kind : {"parenchyma", "portal_vein", "hepatic_vein", "tumour", "gallbladder"}) {
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << kind;
  }
  const Json truth = Json::parse(bytesOf(samplePatient() / "truth.json"));
  EXPECT_NEAR(json[0]["totalMl"].get<double>(), truth["liverMl"].get<double>(), 0.002 * truth["liverMl"].get<double>());
}

TEST(CliInfo, DescribesTheCtInEveryFormatAlike) {
  const Finished dicom = cli({"info", (samplePatient() / "dicom").string(), "--json"});
  const Finished nifti = cli({"info", (samplePatient() / "ct.nii.gz").string(), "--json"});
  ASSERT_EQ(dicom.exitCode, 0) << dicom.err;
  ASSERT_EQ(nifti.exitCode, 0) << nifti.err;
  const Json a = Json::parse(dicom.out)[0];
  const Json b = Json::parse(nifti.out)[0];
  EXPECT_EQ(a["holds"], "ct");
  EXPECT_EQ(a["geometry"]["size"], b["geometry"]["size"]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(a["geometry"]["originMm"][axis].get<double>(), b["geometry"]["originMm"][axis].get<double>(), 1e-3);
    EXPECT_NEAR(a["geometry"]["spacingMm"][axis].get<double>(), b["geometry"]["spacingMm"][axis].get<double>(), 1e-4);
  }
  EXPECT_EQ(a["lowestHu"], b["lowestHu"]);
  EXPECT_EQ(a["highestHu"], b["highestHu"]);
}

TEST(CliReconstruct, ReportHoldsExactlyTheKeysOfTheContract) {
  const TemporaryFolder folder;
  const Finished finished = cli({"reconstruct", sampleSegmentation(), "--structure", "parenchyma", "--method", "psr", "--depth",
                                 "6", "-o", folder / "liver.stl", "--report", folder / "liver.json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json json = Json::parse(bytesOf(folder / "liver.json"));
  EXPECT_EQ(keysOf(json), (Keys{"seconds", "triangles", "vertices", "volumeMl", "voxelVolumeMl", "paperErrorMm", "voxelErrorMm",
                                "usedDepth", "defects", "notes", "peakGrowthMb", "parameters"}));
  EXPECT_EQ(keysOf(json["seconds"]),
            (Keys{"load", "sample", "solve", "extract", "simplify", "check", "selfIntersection", "write"}));
  for (const char* error : {"paperErrorMm", "voxelErrorMm"}) {
    EXPECT_EQ(keysOf(json[error]), (Keys{"mean", "median", "p95", "max"}));
    EXPECT_GT(json[error]["mean"].get<double>(), 0);
    EXPECT_LE(json[error]["median"].get<double>(), json[error]["p95"].get<double>());
    EXPECT_LE(json[error]["p95"].get<double>(), json[error]["max"].get<double>());
  }
  EXPECT_EQ(json["defects"], Json::array());
  EXPECT_EQ(json["parameters"]["depth"], 6);
  EXPECT_NEAR(json["volumeMl"].get<double>(), json["voxelVolumeMl"].get<double>(), 0.005 * json["voxelVolumeMl"].get<double>());
}

TEST(CliReconstruct, WritesOneFilePerDepth) {
  const TemporaryFolder folder;
  const Finished finished = cli({"reconstruct", sampleSegmentation(), "--structure", "gallbladder", "--depth", "5,6", "-o",
                                 folder / "g.ply", "--report", folder / "g.json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_EQ(namesIn(folder.path()), (Keys{"g_d5.json", "g_d5.ply", "g_d6.json", "g_d6.ply"}));
}

TEST(CliReconstruct, SimplifiesToANumberOfTrianglesOrADistance) {
  const TemporaryFolder folder;
  for (const char* target : {"2000", "0.5mm"}) {
    const Finished finished = cli({"reconstruct", sampleSegmentation(), "--structure", "gallbladder", "--depth", "7", "--simplify",
                                   target, "-o", folder / "g.ply", "--report", folder / "g.json"});
    ASSERT_EQ(finished.exitCode, 0) << finished.err;
    const Json json = Json::parse(bytesOf(folder / "g.json"));
    EXPECT_LE(json["triangles"], 2000) << target;
    EXPECT_GT(json["seconds"]["simplify"], 0.0);
    EXPECT_EQ(json["defects"], Json::array());
    EXPECT_EQ(json["parameters"]["simplify"],
              std::string(target) == "2000" ? (Json{{"triangles", 2000}}) : (Json{{"distanceMm", 0.5}}));
    EXPECT_NEAR(json["volumeMl"].get<double>(), json["voxelVolumeMl"].get<double>(), 0.005 * json["voxelVolumeMl"].get<double>());
  }
}

TEST(CliReconstruct, AVoxelByItselfHasASurfaceAndNoPaperError) {
  const TemporaryFolder folder;
  const std::string labels = ellipsoidAndSpeck(folder / "labels.mha");
  const Finished finished = cli({"reconstruct", labels, "--label", "2", "--labels", "1=liver,2=tumour", "--depth", "5,6", "-o",
                                 folder / "speck.stl", "--report", folder / "speck.json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json report = Json::parse(bytesOf(folder / "speck_d6.json"));
  EXPECT_TRUE(report["paperErrorMm"].is_null());
  EXPECT_GT(report["voxelErrorMm"]["mean"], 0.0);
  const Finished measured =
      cli({"measure", folder / "speck_d5.stl", "--reference", labels, "--label", "2", "--labels", "1=liver,2=tumour", "--json"});
  ASSERT_EQ(measured.exitCode, 0) << measured.err;
  EXPECT_TRUE(Json::parse(measured.out)["paperErrorMm"].is_null());
}

TEST(CliMeasure, FindsTheVolumeOfWhatReconstructWrote) {
  const TemporaryFolder folder;
  ASSERT_EQ(cli({"reconstruct", sampleSegmentation(), "--structure", "parenchyma", "--depth", "6", "-o", folder / "liver.stl",
                 "--report", folder / "liver.json"})
                .exitCode,
            0);
  const Finished finished =
      cli({"measure", folder / "liver.stl", "--reference", sampleSegmentation(), "--structure", "parenchyma", "--json"});
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  const Json measured = Json::parse(finished.out);
  EXPECT_EQ(keysOf(measured), (Keys{"triangles", "vertices", "areaMm2", "volumeMl", "defects", "notes", "eulerCharacteristic",
                                    "components", "meanGaussianCurvaturePerMm2", "paperErrorMm", "voxelErrorMm"}));
  const Json report = Json::parse(bytesOf(folder / "liver.json"));
  EXPECT_NEAR(measured["volumeMl"].get<double>(), report["volumeMl"].get<double>(), 1e-3);
  EXPECT_NEAR(measured["paperErrorMm"]["mean"].get<double>(), report["paperErrorMm"]["mean"].get<double>(), 1e-4);
  EXPECT_NEAR(measured["voxelErrorMm"]["mean"].get<double>(), report["voxelErrorMm"]["mean"].get<double>(), 1e-4);
}

TEST(CliMeasure, OfAnOpenMeshEndsWithFourAndGivesNoVolume) {
  const TemporaryFolder folder;
  std::ofstream(folder / "open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  const Finished finished = cli({"measure", folder / "open.obj", "--json"});
  expectRefusal(finished, 4, "open");
  EXPECT_TRUE(Json::parse(finished.out)["volumeMl"].is_null());
}

TEST(CliMeasure, OfTrianglesThatDisagreeAboutOutsideEndsWithFourAndGivesJsonWithoutAVolume) {
  const TemporaryFolder folder;
  std::ofstream(folder / "turned.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 4 3\n";
  const Finished finished = cli({"measure", folder / "turned.obj", "--json"});
  expectRefusal(finished, 4, "defects");
  const Json measured = Json::parse(finished.out);
  EXPECT_TRUE(measured["volumeMl"].is_null());
  EXPECT_EQ(measured["triangles"], 4);
  EXPECT_EQ(measured["notes"].size(), 1U);
  EXPECT_EQ(cli({"measure", folder / "turned.obj"}).exitCode, 4);
}

TEST(CliReconstruct, OfAnEmptyMaskNamesTheFileAndTheLabel) {
  const TemporaryFolder folder;
  const std::string file = folder / "speck.seg.nrrd";
  std::ofstream(file, std::ios::binary)
      << "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 4 4\n"
         "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\nSegment0_ID:=1\n"
         "Segment0_Name:=speck\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment1_ID:=2\nSegment1_Name:=other\n"
         "Segment1_LabelValue:=2\nSegment1_Layer:=0\n\n"
      << '\2' << std::string(63, '\0');
  const Finished finished = cli({"reconstruct", file, "--structure", "speck", "-o", folder / "a.stl"});
  expectRefusal(finished, 3, "speck.seg.nrrd, speck: the mask is empty");
}

}  // namespace
}  // namespace glisson::test
