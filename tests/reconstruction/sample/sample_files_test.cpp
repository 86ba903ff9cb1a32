// The sample patient on disk: the same bytes twice, valid DICOM, truth beside the images, and nothing overwritten.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>

#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/sample/sample_patient.h"
#include "reconstruction/sample/volume_writers.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;

class SampleFiles : public testing::Test {
 protected:
  static void SetUpTestSuite() { patient_ = new SamplePatient(makeSamplePatient(false)); }
  static void TearDownTestSuite() {
    delete patient_;
    patient_ = nullptr;
  }
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    // A blank and an umlaut: paths are bytes.
    folder_ = fs::path(testing::TempDir()) / ("glisson sample \xC3\xBC " + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  static std::map<std::string, std::string> filesOf(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files[fs::relative(entry.path(), folder).string()] = contentOf(entry.path());
      }
    }
    return files;
  }

  static SamplePatient* patient_;
  fs::path folder_;
};

SamplePatient* SampleFiles::patient_ = nullptr;

TEST_F(SampleFiles, AreTheSameBytesEveryTime) {
  writeSamplePatient(*patient_, folder_ / "a");
  writeSamplePatient(makeSamplePatient(false), folder_ / "b");
  const auto a = filesOf(folder_ / "a");
  EXPECT_EQ(a.size(), 80U + 4U);
  EXPECT_TRUE(a == filesOf(folder_ / "b"));
}

TEST_F(SampleFiles, NothingIsLeftBesideTheFolder) {
  writeSamplePatient(*patient_, folder_ / "a");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
}

TEST_F(SampleFiles, AnEmptyFolderIsFilled) {
  writeSamplePatient(*patient_, folder_);
  EXPECT_TRUE(fs::exists(folder_ / "truth.json"));
  EXPECT_TRUE(fs::exists(folder_ / "dicom" / "IM0080.dcm"));
}

TEST_F(SampleFiles, AFolderWithContentIsRefusedAndKept) {
  std::ofstream(folder_ / "mine.txt") << "mine";
  EXPECT_THROW(writeSamplePatient(*patient_, folder_), InputError);
  EXPECT_EQ(filesOf(folder_), (std::map<std::string, std::string>{{"mine.txt", "mine"}}));
}

TEST_F(SampleFiles, CancelLeavesNothing) {
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(writeSamplePatient(*patient_, folder_ / "a", context), Cancelled);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(SampleFiles, TruthHoldsVolumesAndBranchPoints) {
  writeSamplePatient(*patient_, folder_ / "a");
  const auto json = Json::parse(contentOf(folder_ / "a" / "truth.json"));
  EXPECT_DOUBLE_EQ(json.at("liverMl").get<double>(), patient_->truth.liverMl);
  EXPECT_EQ(json.at("tumourMl").size(), 3U);
  EXPECT_EQ(json.at("portalBranchPointsMm").size(), patient_->truth.portalBranchPoints.size());
  EXPECT_GE(json.at("hepaticBranchPointsMm").size(), 5U);
}

TEST_F(SampleFiles, DciodvfyFindsNoErrorInAnySlice) {
  if (std::system("command -v dciodvfy > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "skipped: dciodvfy (Debian package dicom3tools) is not installed";
  }
  writeSamplePatient(*patient_, folder_ / "a");
  int checked = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "a" / "dicom")) {
    const std::string command = "dciodvfy '" + entry.path().string() + "' 2>&1";
    std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    ASSERT_NE(pipe, nullptr);
    std::array<char, 512> line{};
    std::string output;
    while (fgets(line.data(), static_cast<int>(line.size()), pipe.get()) != nullptr) {
      output += line.data();
    }
    EXPECT_NE(output.find("CTImage"), std::string::npos) << output;
    EXPECT_EQ(output.find("Error"), std::string::npos) << output;
    ++checked;
  }
  EXPECT_EQ(checked, 80);
}

TEST_F(SampleFiles, ExclusiveLabelsGiveTheVesselsAndTumoursTheirVoxels) {
  const std::vector<std::uint8_t> labels = sample::exclusiveLabels(patient_->segmentation);
  for (const LabelledMask& structure : patient_->segmentation.structures) {
    const auto count =
        static_cast<std::size_t>(std::count(labels.begin(), labels.end(), static_cast<std::uint8_t>(structure.label)));
    if (structure.kind == StructureKind::Liver) {
      EXPECT_LT(count, structure.mask->count());
    } else {
      EXPECT_EQ(count, structure.mask->count()) << structure.name;
    }
  }
}

}  // namespace
}  // namespace glisson
