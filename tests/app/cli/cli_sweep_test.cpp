// Several surfaces of one call: depths of psr, smoothings and decimations of mcsd, and the depth that the samples carry.

#include <cctype>
#include <random>

#include "tests/app/cli/cli_fixture.h"

namespace glisson::test {
namespace {

using Keys = std::vector<std::string>;

std::vector<std::string> mcsd(const std::string& segmentation, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"reconstruct", segmentation, "--method", "mcsd"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// "name: 12 things"
bool isCounted(const std::string& defect) {
  const std::size_t number = defect.find_first_not_of("abcdefghijklmnopqrstuvwxyz-");
  if (number == 0 || number == std::string::npos || defect.compare(number, 2, ": ") != 0) {
    return false;
  }
  const std::size_t unit = defect.find(' ', number + 2);
  return unit != std::string::npos && std::atoi(defect.c_str() + number + 2) > 0 &&
         std::islower(static_cast<unsigned char>(defect[unit + 1])) != 0;
}

/// A MetaImage of 10 x 10 x 10 voxels of noise, which is no anatomy: decimation breaks its surface.
std::string noise(const TemporaryFolder& folder) {
  std::mt19937 random(3);
  std::string values(1000, 0);
  for (char& value : values) {
    value = random() % 100 < 25 ? 1 : 0;
  }
  std::ofstream(folder / "noise.mha", std::ios::binary)
      << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
         "Offset = 0 0 0\nElementSpacing = 1 1 1\nDimSize = 10 10 10\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
      << values;
  return folder / "noise.mha";
}

/// A PLY file behind its header, which holds the file's name.
std::string surfaceIn(const std::string& file) {
  const std::string bytes = bytesOf(file);
  const std::size_t end = bytes.find("end_header");
  EXPECT_NE(end, std::string::npos) << file;
  return bytes.substr(std::min(end, bytes.size()));
}

TEST(CliSweep, WritesEverySmoothingWithEveryDecimationTheSameBytesAsOneByOne) {
  const TemporaryFolder folder;
  const Finished finished =
      cli(mcsd(sampleSegmentation(), {"--structure", "gallbladder", "--filter", "laplacian", "--smoothing", "0,22", "--decimation",
                                      "0.1,0.125", "-o", folder / "g.ply", "--report", folder / "g.json"}));
  ASSERT_EQ(finished.exitCode, 0) << finished.err;
  EXPECT_EQ(namesIn(folder.path()), (Keys{"g_s0_e10.json", "g_s0_e10.ply", "g_s0_e12.5.json", "g_s0_e12.5.ply", "g_s22_e10.json",
                                          "g_s22_e10.ply", "g_s22_e12.5.json", "g_s22_e12.5.ply"}));
  for (const char* smoothing : {"0", "22"}) {
    for (const auto& [decimation, percent] : {std::pair("0.1", "10"), std::pair("0.125", "12.5")}) {
      const TemporaryFolder alone;
      ASSERT_EQ(cli(mcsd(sampleSegmentation(), {"--structure", "gallbladder", "--filter", "laplacian", "--smoothing", smoothing,
                                                "--decimation", decimation, "-o", alone / "g.ply"}))
                    .exitCode,
                0);
      EXPECT_EQ(namesIn(alone.path()), Keys{"g.ply"});
      const std::string name = std::string("g_s") + smoothing + "_e" + percent;
      EXPECT_EQ(surfaceIn(folder / (name + ".ply")), surfaceIn(alone / "g.ply")) << name;
      const Json report = Json::parse(bytesOf(folder / (name + ".json")));
      EXPECT_EQ(report["parameters"]["smoothing"].dump(), smoothing);
      EXPECT_EQ(report["parameters"]["decimation"].dump(), decimation);
    }
  }
}

TEST(CliSweep, OneValueKeepsTheNameAndValuesGivenTwiceCountOnce) {
  const TemporaryFolder folder;
  ASSERT_EQ(cli(mcsd(sampleSegmentation(),
                     {"--structure", "gallbladder", "--smoothing", "10,10", "--decimation", "0.5,0.50", "-o", folder / "g.stl"}))
                .exitCode,
            0);
  EXPECT_EQ(namesIn(folder.path()), Keys{"g.stl"});
}

TEST(CliSweep, TheReportNamesWhatDecimationBrokeAndHowOften) {
  const TemporaryFolder folder;
  const Finished finished = cli(mcsd(noise(folder), {"--labels", "1=tumour", "--label", "1", "--smoothing", "0,10", "--decimation",
                                                     "0,0.9", "-o", folder / "n.ply", "--report", folder / "n.json"}));
  EXPECT_EQ(finished.exitCode, 4) << finished.err;
  EXPECT_EQ(Json::parse(bytesOf(folder / "n_s0_e0.json"))["defects"], Json::array());
  for (const char* name : {"n_s0_e90", "n_s10_e90"}) {
    const Json defects = Json::parse(bytesOf(folder / (std::string(name) + ".json")))["defects"];
    ASSERT_FALSE(defects.empty()) << name;
    for (const std::string& defect : defects.get<std::vector<std::string>>()) {
      EXPECT_TRUE(isCounted(defect)) << defect;
    }
    EXPECT_NE(finished.err.find(std::string(name) + ".ply was written, but its surface has defects"), std::string::npos);
  }
}

TEST(CliMethods, AListedMethodWritesItsUsualVariantOrThoseThatAreNamed) {
  const TemporaryFolder folder;
  const std::vector<std::string> common{"reconstruct", sampleSegmentation(), "--label", "5", "--method", "psr_knn"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return cli(more);
  };
  const Finished usual = with({"-o", folder / "t.ply", "--report", folder / "t.json"});
  ASSERT_EQ(usual.exitCode, 0) << usual.err;
  EXPECT_NE(usual.out.find("PSR, k-NN normals d=7"), std::string::npos) << usual.out;
  const Finished two = with({"--variant", "d5,d7", "--simplify", "1000", "-o", folder / "v.ply", "--report", folder / "v.json"});
  ASSERT_EQ(two.exitCode, 0) << two.err;
  EXPECT_EQ(namesIn(folder.path()), (Keys{"t.json", "t.ply", "v_d5.json", "v_d5.ply", "v_d7.json", "v_d7.ply"}));
  const Json report = Json::parse(bytesOf(folder / "t.json"));
  EXPECT_EQ(report["parameters"]["method"], "psr_knn");
  EXPECT_EQ(report["parameters"]["variant"], "d7");
  EXPECT_EQ(report["defects"], Json::array());
  EXPECT_NEAR(report["volumeMl"].get<double>() / report["voxelVolumeMl"].get<double>(), 1, 0.05);
  EXPECT_LE(Json::parse(bytesOf(folder / "v_d7.json"))["triangles"], 1000);
}

TEST(CliDepth, AutoIsTheDeepestThatTheSamplesCarryAndCanBeSimplified) {
  const TemporaryFolder folder;
  const std::vector<std::string> common{"reconstruct", sampleSegmentation(), "--structure", "portal_vein"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return cli(more);
  };
  const Finished automatic =
      with({"--depth", "auto", "--simplify", "0.1mm", "-o", folder / "p.ply", "--report", folder / "p.json"});
  ASSERT_EQ(automatic.exitCode, 0) << automatic.err;
  const Json report = Json::parse(bytesOf(folder / "p.json"));
  EXPECT_EQ(report["parameters"]["depth"], "auto");
  EXPECT_EQ(report["parameters"]["simplify"], (Json{{"distanceMm", 0.1}}));
  const int used = report["usedDepth"].get<int>();
  EXPECT_GE(used, 7);
  ASSERT_EQ(with({"--depth", std::to_string(used) + ",auto", "-o", folder / "q.ply"}).exitCode, 0);
  EXPECT_EQ(surfaceIn(folder / ("q_d" + std::to_string(used) + ".ply")), surfaceIn(folder / "q_dauto.ply"));
}

}  // namespace
}  // namespace glisson::test
