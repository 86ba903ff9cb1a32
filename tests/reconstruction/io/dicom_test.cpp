// DICOM series made here slice by slice: order, geometry, rescaling, faults and their consents.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"

namespace glisson {
namespace {

using namespace fixtures;

int expected(int i, int j, int k) { return 100 * k + 10 * j + i - 500; }

void expectRamp(const CtVolume& ct) {
  std::size_t n = 0;
  for (int k = 0; k < ct.geometry.size[2]; ++k) {
    for (int j = 0; j < ct.geometry.size[1]; ++j) {
      for (int i = 0; i < ct.geometry.size[0]; ++i, ++n) {
        ASSERT_EQ(ct.hounsfield[n], expected(i, j, k)) << i << " " << j << " " << k;
      }
    }
  }
}

TEST(Dicom, SlicesAreSortedByPositionNotByNameOrNumberAndLieWhereTheirHeadersSay) {
  const TemporaryFolder folder;
  DicomOptions options;
  options.position = Vec3(-120.5, 33.25, -804.5);
  writeCtSeries(folder.path(), {0, 2, 4, 6, 8}, options);
  const CtVolume ct = readCt(folder.path());
  EXPECT_EQ(ct.geometry.size, (Index3{9, 8, 5}));
  expectRamp(ct);
  EXPECT_LE((ct.geometry.toWorld(Vec3(8, 7, 4)) - Vec3(-120.5 + 8 * 0.75, 33.25 + 7 * 0.5, -796.5)).norm(), 1e-3);
  EXPECT_EQ(ct.identity.patientId, "P1");
  EXPECT_EQ(ct.identity.frameOfReferenceUid, "1.2.3.5");
}

TEST(Dicom, ObliqueSeriesKeepTheirDirection) {
  const TemporaryFolder folder;
  DicomOptions options;
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  options.row = turn.col(0);
  options.column = turn.col(1);
  writeCtSeries(folder.path(), {0, 2.5, 5}, options);
  const CtVolume ct = readCt(folder.path());
  expectRamp(ct);
  EXPECT_LE((ct.geometry.toWorld(Vec3(8, 7, 2)) - turn * Vec3(6, 3.5, 5)).norm(), 1e-3);
}

TEST(Dicom, H3RescalingIsPerSliceAndBitsAndSignsAreRespected) {
  const TemporaryFolder folder;
  for (int k = 0; k < 3; ++k) {
    DicomOptions options;
    options.position = Vec3(0, 0, 2 * k);
    options.instance = k;
    options.isSigned = false;
    options.bitsStored = 12;
    options.slope = k + 1;
    options.intercept = -1024;
    std::vector<std::uint16_t> pixels;
    for (std::uint16_t n = 0; n < 72; ++n) {
      pixels.push_back(static_cast<std::uint16_t>(0xA000U | (n * 20U)));  // overlay bits above the stored twelve
    }
    writeFile(folder / ("s" + std::to_string(k)), dicomSlice(options, bytesOf(pixels)));
  }
  const CtVolume ct = readCt(folder.path());
  for (std::size_t n = 0; n < ct.hounsfield.size(); ++n) {
    ASSERT_EQ(ct.hounsfield[n], static_cast<int>(n % 72) * 20 * static_cast<int>(n / 72 + 1) - 1024);
  }
}

TEST(Dicom, PixelsOf32And8BitsAreRead) {
  const TemporaryFolder folder;
  for (int k = 0; k < 2; ++k) {
    DicomOptions options;
    options.position = Vec3(0, 0, 2 * k);
    options.instance = k;
    options.bits = 32;
    options.bitsStored = 32;
    std::vector<std::int32_t> wide(72);
    for (int n = 0; n < 72; ++n) {
      wide[static_cast<std::size_t>(n)] = (n - 36) * 11;
    }
    writeFile(folder / ("wide/" + std::to_string(k)), dicomSlice(options, bytesOf(wide)));
    options.bits = 8;
    options.bitsStored = 8;
    options.isSigned = false;
    options.intercept = -100;
    std::vector<std::uint8_t> narrow(72);
    for (int n = 0; n < 72; ++n) {
      narrow[static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(3 * n);
    }
    writeFile(folder / ("narrow/" + std::to_string(k)), dicomSlice(options, narrow));
  }
  const CtVolume wide = readCt(folder / "wide");
  const CtVolume narrow = readCt(folder / "narrow");
  for (std::size_t n = 0; n < 144; ++n) {
    ASSERT_EQ(wide.hounsfield[n], (static_cast<int>(n % 72) - 36) * 11);
    ASSERT_EQ(narrow.hounsfield[n], 3 * static_cast<int>(n % 72) - 100);
  }
}

TEST(Dicom, AMissingSliceIsNamedAndResampledOnlyWithConsent) {
  const TemporaryFolder folder;
  writeCtSeries(folder.path(), {0, 2, 4, 8, 10});
  const std::string message = refusalOfCt(folder.path());
  EXPECT_NE(message.find("slice_98 and slice_97"), std::string::npos) << message;
  EXPECT_NE(message.find("4.000 mm instead of 2.000 mm"), std::string::npos) << message;
  EXPECT_NE(message.find("--accept uneven-slices"), std::string::npos) << message;
  const CtVolume ct = readCt(folder.path(), accepting({Consent::UnevenSlices}));
  ASSERT_EQ(ct.geometry.size, (Index3{9, 8, 6}));
  EXPECT_DOUBLE_EQ(ct.geometry.spacing[2], 2);
  const auto at = [&](int k) { return ct.hounsfield[static_cast<std::size_t>(k) * 72]; };
  EXPECT_EQ(at(2), expected(0, 0, 2));
  EXPECT_EQ(at(3), expected(0, 0, 2) + 50);  // half way between its neighbours
  EXPECT_EQ(at(4), expected(0, 0, 3));
  EXPECT_EQ(at(5), expected(0, 0, 4));
  ASSERT_FALSE(ct.notes.empty());
  EXPECT_NE(ct.notes[0].find("consent"), std::string::npos);
}

TEST(Dicom, ADeviationBelowTheToleranceIsNoFault) {
  const TemporaryFolder folder;
  writeCtSeries(folder.path(), {0, 2.03, 4, 5.98, 8});
  EXPECT_EQ(refusalOfCt(folder.path()), "");
  const TemporaryFolder alternating;  // 0.045 mm off their mean each, though neighbours differ by twice as much
  writeCtSeries(alternating.path(), {0, 2.045, 4, 6.045, 8});
  EXPECT_EQ(refusalOfCt(alternating.path()), "");
  const TemporaryFolder other;
  writeCtSeries(other.path(), {0, 2.06, 4, 6, 8});
  EXPECT_NE(refusalOfCt(other.path()), "");
}

TEST(Dicom, ADuplicateSliceIsRefusedAndDroppedWithConsent) {
  const TemporaryFolder folder;
  writeCtSeries(folder.path(), {0, 2, 4, 4, 6});
  EXPECT_NE(refusalOfCt(folder.path()).find("--accept uneven-slices"), std::string::npos);
  EXPECT_EQ(readCt(folder.path(), accepting({Consent::UnevenSlices})).geometry.size[2], 4);
}

TEST(Dicom, TiltIsMeasuredRefusedAndStraightenedWithConsent) {
  const TemporaryFolder folder;
  const double tilt = 10 * 3.14159265358979 / 180;
  for (int k = 0; k < 4; ++k) {  // a rod along z through pixel (4, 3) of the first slice
    DicomOptions options;
    options.column = Vec3(0, std::cos(tilt), -std::sin(tilt));
    options.position = Vec3(0, 0, 3.0 * k);
    options.instance = k;
    std::vector<std::int16_t> pixels(72, -500);
    const Vec3 rod(4 * 0.75, 3 * 0.5, 0);
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 9; ++i) {
        const Vec3 p = options.position + i * 0.75 * options.row + j * 0.5 * options.column;
        if (std::abs(p[0] - rod[0]) < 0.1 && std::abs(p[1] - rod[1]) < 0.26) {
          pixels[static_cast<std::size_t>(9 * j + i)] = 500;
        }
      }
    }
    writeFile(folder / ("s" + std::to_string(k)), dicomSlice(options, bytesOf(pixels)));
  }
  const std::string message = refusalOfCt(folder.path());
  EXPECT_NE(message.find("10.0 degrees"), std::string::npos) << message;
  EXPECT_NE(message.find("--accept tilt"), std::string::npos) << message;
  const CtVolume ct = readCt(folder.path(), accepting({Consent::Tilt}));
  std::size_t found = 0;
  for (std::size_t n = 0; n < ct.hounsfield.size(); ++n) {
    if (ct.hounsfield[n] > 250) {
      ++found;
      const auto size = ct.geometry.size;
      const std::size_t row = n / 9;
      const std::size_t rows = static_cast<std::size_t>(size[1]);
      const std::size_t slice = row / rows;
      const Vec3 p =
          ct.geometry.toWorld(Vec3(static_cast<double>(n % 9), static_cast<double>(row % rows), static_cast<double>(slice)));
      EXPECT_NEAR(p[0], 3.0, 0.01);
      EXPECT_NEAR(p[1], 1.5, 0.6);
    }
  }
  EXPECT_GE(found, 3U);
}

TEST(Dicom, OneSliceAllAtOnePositionAndTimeSeriesAreNoVolume) {
  const TemporaryFolder one;
  writeCtSeries(one.path(), {0});
  EXPECT_NE(refusalOfCt(one.path()).find("single slice"), std::string::npos);
  const TemporaryFolder same;
  writeCtSeries(same.path(), {3, 3, 3});
  EXPECT_NE(refusalOfCt(same.path()).find("not a volume"), std::string::npos);
  const TemporaryFolder time;
  writeCtSeries(time.path(), {0, 0, 2, 2, 4, 4});
  EXPECT_NE(refusalOfCt(time.path()).find("time series"), std::string::npos);
}

TEST(Dicom, LocalizersOtherSeriesAndStrangersAreLeftOutByName) {
  const TemporaryFolder folder;
  writeCtSeries(folder.path(), {0, 2, 4, 6});
  DicomOptions scout;
  scout.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
  scout.row = Vec3::UnitY();
  scout.column = -Vec3::UnitZ();
  writeFile(folder / "scout", dicomSlice(scout, Bytes(144, 1)));
  DicomOptions other;
  other.seriesUid = "9.9.9";
  writeFile(folder / "other", dicomSlice(other, Bytes(144, 1)));
  writeFile(folder / "DICOMDIR", Bytes(500, 7));
  writeFile(folder / "readme.txt", Bytes(20, 'a'));
  const CtVolume ct = readCt(folder.path());
  EXPECT_EQ(ct.geometry.size[2], 4);
  std::string notes;
  for (const std::string& note : ct.notes) {
    notes += note + "\n";
  }
  EXPECT_NE(notes.find("localizer"), std::string::npos) << notes;
  EXPECT_NE(notes.find("9.9.9"), std::string::npos) << notes;
  EXPECT_NE(notes.find("readme.txt"), std::string::npos) << notes;
  EXPECT_EQ(readCt(folder / "slice_99").geometry.size[2], 4);  // one file stands for its series
}

TEST(Dicom, AWholeStudyFolderIsSearchedAndOtherModalitiesAreRefused) {
  const TemporaryFolder folder;
  writeCtSeries(folder / "study/series", {0, 2, 4});
  EXPECT_EQ(readCt(folder.path()).geometry.size[2], 3);
  const TemporaryFolder mr;
  DicomOptions options;
  options.modality = "MR";
  writeCtSeries(mr.path(), {0, 2, 4}, options);
  EXPECT_NE(refusalOfCt(mr.path()).find("modality MR"), std::string::npos);
}

void writeMask(const std::filesystem::path& folder, int firstSet, const std::string& patientId = "") {
  for (int k = 0; k < 3; ++k) {
    DicomOptions options;
    options.patientId = patientId;
    options.frameOfReferenceUid = "";
    options.seriesUid = "1.2." + std::to_string(firstSet);
    options.position = Vec3(5, 6, 7 + 2 * k);
    options.instance = k;
    options.bits = 8;
    options.bitsStored = 8;
    options.isSigned = false;
    Bytes pixels(72, 0);
    if (firstSet >= 0) {
      pixels[static_cast<std::size_t>(firstSet + k)] = 255;
    }
    writeFile(folder / ("image_" + std::to_string(k)), dicomSlice(options, pixels));
  }
}

TEST(Dicom, AFolderOfMaskSeriesGivesOneMaskPerFolderAndSkipsOtherOrgans) {
  const TemporaryFolder folder;
  writeMask(folder / "liver", 10);
  writeMask(folder / "livertumor01", 12);
  writeMask(folder / "artery", -1);
  writeMask(folder / "something", 20);
  writeFile(folder / "spleen/image_0", Bytes(200, 0));
  writeMask(folder / "spleen", 30);
  const Segmentation read = readSegmentation(folder.path());
  ASSERT_EQ(read.structures.size(), 5U);
  EXPECT_EQ(read.structures[0].name, "artery");
  EXPECT_TRUE(read.structures[0].mask->empty());
  EXPECT_EQ(read.structures[1].kind, StructureKind::Liver);
  EXPECT_EQ(read.structures[1].mask->count(), 3U);
  EXPECT_TRUE(read.structures[1].mask->at(2, 1, 1));  // pixel 11 of the second slice
  EXPECT_EQ(read.structures[2].kind, StructureKind::Tumour);
  EXPECT_FALSE(read.structures[3].kind.has_value());
  EXPECT_EQ(read.structures[4].kind, StructureKind::Other);
  EXPECT_EQ(read.structures[4].mask, nullptr);
  EXPECT_LE((read.geometry.origin - Vec3(5, 6, 7)).norm(), 1e-6);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_NE(read.notes[0].find("artery"), std::string::npos);
  EXPECT_EQ(guessInput(folder.path()), InputKind::Segmentation);
}

TEST(Dicom, H2MasksOfDifferentPatientsOrGridsAreRefused) {
  const TemporaryFolder folder;
  writeMask(folder / "liver", 10, "A");
  writeMask(folder / "artery", 12, "B");
  EXPECT_THROW(readSegmentation(folder.path()), InputError);
  EXPECT_NO_THROW(readSegmentation(folder.path(), accepting({Consent::OtherPatient})));
  const TemporaryFolder grids;
  writeMask(grids / "liver", 10);
  writeMask(grids / "artery", 12);
  std::filesystem::remove(grids / "artery/image_2");
  EXPECT_THROW(readSegmentation(grids.path()), InputError);
}

TEST(Dicom, ACtIsNoMaskAndAMaskIsNoCt) {
  const TemporaryFolder folder;
  writeCtSeries(folder / "ct", {0, 2, 4});
  writeMask(folder / "liver", 10);
  EXPECT_THROW(readSegmentation(folder / "ct"), InputError);
  EXPECT_THROW(readCt(folder / "liver"), InputError);
}

}  // namespace
}  // namespace glisson
