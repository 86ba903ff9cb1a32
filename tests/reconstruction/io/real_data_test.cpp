// Real files as their sources ship them (found through GLISSON_TEST_DATA); skipped by name where they are not there.

#include "tests/support/real_data.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"

namespace glisson {
namespace {

using namespace fixtures;
namespace fs = std::filesystem;

#define REQUIRE_REAL_DATA(path)              \
  if (!fs::exists(path)) {                   \
    GTEST_SKIP() << "skipped: no real data"; \
  }                                          \
  static_assert(true)

TEST(RealData, Ircadb01IsReadAsItIsWithItsPublishedVolumes) {
  const fs::path data = test::realPatient("ircadb01");
  REQUIRE_REAL_DATA(data);
  const TemporaryFolder folder;
  const std::string unpack = "tar -xJf '" + (data / "PATIENT_DICOM.tar.xz").string() + "' -C '" + folder.path().string() +
                             "' && unzip -q '" + (data / "MASKS_DICOM.zip").string() + "' -d '" + folder.path().string() + "'";
  ASSERT_EQ(std::system(unpack.c_str()), 0) << "tar or unzip is missing";
  const auto begin = std::chrono::steady_clock::now();
  const CtVolume ct = readCt(folder / "PATIENT_DICOM");
  const Segmentation labels = matchToCt(readSegmentation(folder / "MASKS_DICOM"), ct);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_EQ(ct.geometry.size, (Index3{512, 512, 129}));
  EXPECT_NEAR(ct.geometry.spacing[0], 0.57, 1e-6);
  EXPECT_NEAR(ct.geometry.spacing[2], 1.6, 1e-6);
  EXPECT_EQ(ct.hounsfield.front(), -1024);
  const std::map<std::string, double> published{{"liver", 1489.41},    {"portalvein", 53.82},  {"venoussystem", 74.43},
                                                {"artery", 59.7},      {"livertumor01", 84.4}, {"livertumor02", 7.5},
                                                {"livertumor03", 3.7}, {"livertumor04", 2.5},  {"livertumor05", 10.1},
                                                {"livertumor06", 0.4}, {"livertumor07", 2.7}};
  std::size_t found = 0;
  for (const LabelledMask& structure : labels.structures) {
    EXPECT_TRUE(structure.kind.has_value()) << structure.name;
    EXPECT_EQ(structure.mask == nullptr, structure.kind == StructureKind::Other) << structure.name;
    if (const auto volume = published.find(structure.name); volume != published.end()) {
      ++found;
      const double ml = static_cast<double>(structure.mask->count()) * labels.geometry.voxelVolumeMm3() / 1000;
      EXPECT_NEAR(ml, volume->second, 0.06) << structure.name;
    }
    if (structure.name == "liver") {
      EXPECT_EQ(structure.mask->count(), 2865131U);
    }
    if (structure.name == "liverkyst") {
      EXPECT_EQ(structure.mask->count(), 108U);
      EXPECT_EQ(structure.kind, StructureKind::Cyst);
    }
  }
  EXPECT_EQ(found, published.size());
  EXPECT_EQ(guessInput(folder / "PATIENT_DICOM"), InputKind::Ct);
  EXPECT_EQ(guessInput(folder / "MASKS_DICOM"), InputKind::Segmentation);
}

TEST(RealData, TotalSegmentatorsCtAndLabelsMatchAndNameThemselves) {
  const fs::path data = test::realPatient("totalsegmentator");
  REQUIRE_REAL_DATA(data);
  const CtVolume ct = readCt(data / "example_ct.nii.gz");
  const Segmentation labels = matchToCt(readSegmentation(data / "example_seg_fast_force_split.nii.gz"), ct);
  EXPECT_EQ(ct.geometry.size, (Index3{122, 101, 112}));
  EXPECT_NEAR(ct.geometry.origin[0], 177.95633, 1e-3);  // RAS in the file, LPS here
  std::map<std::string, std::pair<std::optional<StructureKind>, std::size_t>> found;
  for (const LabelledMask& structure : labels.structures) {
    found[structure.name] = {structure.kind, structure.mask->count()};
  }
  EXPECT_EQ(found["liver"].first, StructureKind::Liver);
  EXPECT_EQ(found["liver"].second, 41692U);
  EXPECT_EQ(found["inferior_vena_cava"].first, StructureKind::VenaCava);
  EXPECT_EQ(found["portal_vein_and_splenic_vein"].first, StructureKind::PortalVein);
  EXPECT_EQ(found["gallbladder"].first, StructureKind::Gallbladder);
  EXPECT_EQ(found["spleen"].first, StructureKind::Other);
}

TEST(RealData, TotalSegmentatorsJpeg2000SeriesIsReadAndItsMirroredLabelsLieOnIt) {
  const fs::path data = test::realPatient("totalsegmentator");
  REQUIRE_REAL_DATA(data);
  const CtVolume ct = readCt(data / "example_ct_dicom");
  EXPECT_EQ(ct.geometry.size, (Index3{512, 512, 20}));
  const Segmentation labels = matchToCt(readSegmentation(data / "example_seg_dicom.nii.gz"), ct);
  double liver = 0;
  double lungOrAir = 0;
  std::size_t voxels = 0;
  for (const LabelledMask& structure : labels.structures) {
    if (structure.kind != StructureKind::Liver) {
      continue;
    }
    const IndexBox& box = structure.mask->box();
    std::size_t n = 0;
    for (int k = 0; k < box.size[2]; ++k) {
      for (int j = 0; j < box.size[1]; ++j) {
        for (int i = 0; i < box.size[0]; ++i, ++n) {
          if (structure.mask->values()[n] != 0) {
            const std::size_t at =
                static_cast<std::size_t>(box.first[0] + i) +
                512U * (static_cast<std::size_t>(box.first[1] + j) + 512U * static_cast<std::size_t>(box.first[2] + k));
            liver += ct.hounsfield[at];
            lungOrAir += ct.hounsfield[at] < -200 ? 1 : 0;
            ++voxels;
          }
        }
      }
    }
  }
  ASSERT_EQ(voxels, 366708U);
  EXPECT_GT(liver / static_cast<double>(voxels), 40);  // liver tissue under the liver's label: not mirrored
  EXPECT_LT(liver / static_cast<double>(voxels), 200);
  EXPECT_LT(lungOrAir / static_cast<double>(voxels), 0.01);
}

TEST(RealData, EachFolderOfDicomFaultsIsAnsweredWithItsReasonOrCorrectedWithConsent) {
  const fs::path data = test::realPatient("dicom-faults");
  REQUIRE_REAL_DATA(data);
  EXPECT_NE(refusalOfCt(data / "gantrytilting/001").find("14.0 degrees; accept resampling it to a regular grid with --accept tilt"),
            std::string::npos);
  EXPECT_NE(refusalOfCt(data / "notavolume/001").find("not a volume"), std::string::npos);
  EXPECT_NE(refusalOfCt(data / "sliceincrement/001").find("10.000 mm instead of 5.000 mm"), std::string::npos);
  EXPECT_NE(refusalOfCt(data / "sliceincrement/002").find("--accept tilt,uneven-slices"), std::string::npos);
  EXPECT_EQ(refusalOfCt(data / "gantrytilting/001", accepting({Consent::Tilt})), "");
  EXPECT_NE(refusalOfCt(data / "notavolume/001", accepting({Consent::Tilt, Consent::UnevenSlices})), "");
  EXPECT_EQ(readCt(data / "sliceincrement/001", accepting({Consent::UnevenSlices})).geometry.size[2], 5);
  EXPECT_NE(refusalOfCt(data / "sliceincrement/002", accepting({Consent::Tilt})), "");
  const CtVolume both = readCt(data / "sliceincrement/002", accepting({Consent::Tilt, Consent::UnevenSlices}));
  EXPECT_EQ(both.geometry.size, (Index3{512, 514, 5}));
}

TEST(RealData, DcmqisCtAndNrrdLabelsLieOnOneGrid) {
  const fs::path data = test::realPatient("dcmqi");
  REQUIRE_REAL_DATA(data);
  const CtVolume ct = readCt(data / "ct-3slice");
  const Segmentation liver = matchToCt(readSegmentation(data / "liver_seg.nrrd"), ct);
  ASSERT_EQ(liver.structures.size(), 1U);
  EXPECT_EQ(liver.structures[0].mask->count(), 107098U);
  EXPECT_FALSE(liver.structures[0].kind.has_value());
  const Segmentation two = readSegmentation(data / "liver_spine_gapped_seg.nrrd");
  ASSERT_EQ(two.structures.size(), 2U);
  EXPECT_EQ(two.structures[1].label, 5);
  EXPECT_THROW(readSegmentation(data / "liver.dcm"), InputError);
}

}  // namespace
}  // namespace glisson
