// Hazards H3, H7: a package that was changed on its way, by accident or by a program that means well.
#include <gtest/gtest.h>

#include <fstream>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/manifest.h"
#include "planning/exchange/package.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/exchange/synthetic_case.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

using test::Scratch;

class Verify : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = exportPackage(test::syntheticCase(), scratch_.path, test::stamped()).folder;
    ASSERT_EQ(verifyPackage(folder_), std::vector<std::string>{});
  }
  [[nodiscard]] std::string bytesOf(const std::string& file) const { return readWholeFile(folder_ / file); }
  void put(const std::string& file, const std::string& bytes) const {
    std::ofstream(folder_ / file, std::ios::binary | std::ios::trunc) << bytes;
  }
  /// Changes a file and makes every hash fit again, as a careless tool would not: only the contents can tell now.
  void forge(const std::string& file, const std::string& bytes) const {
    bool intact = false;
    Manifest manifest = parseManifest(bytesOf("manifest.json"), "manifest.json", intact);
    std::string plan = file == "plan.json" ? bytes : bytesOf("plan.json");
    const std::string hash = sha256Hex(std::as_bytes(std::span(bytes)));
    put(file, bytes);
    for (FileEntry& entry : manifest.files) {
      if (entry.file == file && file != "plan.json") {
        plan.replace(plan.find(entry.sha256), entry.sha256.size(), hash);
        entry = {file, hash, bytes.size()};
      }
    }
    put("plan.json", plan);
    for (FileEntry& entry : manifest.files) {
      if (entry.file == "plan.json") {
        entry = {"plan.json", sha256Hex(std::as_bytes(std::span(plan))), plan.size()};
      }
    }
    put("manifest.json", manifestText(manifest));
  }
  void expectOneProblem(const std::string& words) const {
    const std::vector<std::string> problems = verifyPackage(folder_);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems.front().find(words), std::string::npos) << problems.front();
  }

  Scratch scratch_;
  std::filesystem::path folder_;
};

TEST_F(Verify, FindsAChangedByteInEveryFile) {
  const std::size_t kPositions = test::trials(40);
  std::size_t tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string file = entry.path().filename().string();
    const std::string good = bytesOf(file);
    for (std::size_t n = 0; n < kPositions; ++n) {
      const std::size_t at = n * (good.size() - 1) / (kPositions - 1);
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ (1U << n % 8));
      put(file, bad);
      EXPECT_FALSE(verifyPackage(folder_).empty()) << file << " byte " << at;
      ++tried;
    }
    put(file, good);
  }
  EXPECT_EQ(tried, 9 * kPositions);
  EXPECT_EQ(verifyPackage(folder_), std::vector<std::string>{});
}

TEST_F(Verify, NamesAMissingFile) {
  std::filesystem::remove(folder_ / "remnant.stl");
  expectOneProblem("\"remnant.stl\" is missing");
}

TEST_F(Verify, NamesATruncatedFile) {
  const std::string bytes = bytesOf("tumour_01.stl");
  put("tumour_01.stl", bytes.substr(0, bytes.size() - 50));
  expectOneProblem("\"tumour_01.stl\" has been changed");
}

TEST_F(Verify, NamesAnExtraFile) {
  put("tumour_02.stl", bytesOf("tumour_01.stl"));
  expectOneProblem("\"tumour_02.stl\" does not belong");
}

TEST_F(Verify, AFolderWithoutManifestIsNoPackage) {
  std::filesystem::remove(folder_ / "manifest.json");
  EXPECT_THROW(verifyPackage(folder_), InputError);
  EXPECT_THROW(verifyPackage(folder_ / "nowhere"), InputError);
}

TEST_F(Verify, FindsAHeaderOfTheWrongSpaceThoughEveryHashFits) {
  std::string bytes = bytesOf("parenchyma.stl");
  bytes.replace(bytes.find("SPACE=LPS"), 9, "SPACE=RAS");
  forge("parenchyma.stl", bytes);
  expectOneProblem("does not say SPACE=LPS");
}

TEST_F(Verify, FindsAMirroredMeshThoughEveryHashFits) {
  std::string bytes = bytesOf("tumour_01.stl");
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      bytes[at + 12 + 12 * corner + 3] = static_cast<char>(bytes[at + 12 + 12 * corner + 3] ^ 0x80);  // the sign of x
    }
  }
  forge("tumour_01.stl", bytes);
  expectOneProblem("\"tumour_01.stl\" has bounds that are off");
}

TEST_F(Verify, FindsAMeshTurnedInsideOutThoughEveryHashFits) {
  std::string bytes = bytesOf("tumour_01.stl");
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(at + 12), bytes.begin() + static_cast<std::ptrdiff_t>(at + 24),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + 24));
  }
  forge("tumour_01.stl", bytes);
  expectOneProblem("\"tumour_01.stl\" is turned inside out");
}

TEST_F(Verify, FindsAGlbOfOtherAxesOrUnitsThoughEveryHashFits) {
  const std::string good = bytesOf("model.glb");
  std::string bytes = good;
  const std::size_t at = bytes.find("-0.001");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 6, " 0.001");
  forge("model.glb", bytes);
  expectOneProblem("root matrix");
  bytes = good;
  bytes.replace(bytes.find("0.001"), 5, "1.000");
  forge("model.glb", bytes);
  expectOneProblem("root matrix");
}

TEST_F(Verify, FindsAPlanOfOtherUnitsThoughEveryHashFits) {
  std::string plan = bytesOf("plan.json");
  plan.replace(plan.find("\"LPS\""), 5, "\"RAS\"");
  forge("plan.json", plan);
  expectOneProblem("axes LPS");
}

TEST_F(Verify, AManifestThatPointsOutsideIsNotFollowed) {
  bool intact = false;
  Manifest manifest = parseManifest(bytesOf("manifest.json"), "manifest.json", intact);
  EXPECT_TRUE(intact);
  manifest.files.push_back({"../../etc/passwd", std::string(64, '0'), 1});
  put("manifest.json", manifestText(manifest));
  expectOneProblem("outside the package");
}

}  // namespace
}  // namespace glisson
