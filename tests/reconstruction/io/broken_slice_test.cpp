// A slice that a broken header would take out of its series is refused by its name, wherever it lies; nothing is left out silently.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"

namespace glisson {
namespace {

using namespace fixtures;
namespace fs = std::filesystem;

constexpr int kSlices = 12;

std::string nameOf(int k) { return "slice_" + std::to_string(100 + k); }

DicomOptions sliceAt(int k) {
  DicomOptions options;
  options.position = Vec3(-12, 7, 2.5 * k);
  options.instance = k + 1;
  return options;
}

void writeSlice(const fs::path& folder, const std::string& name, const DicomOptions& options) {
  std::vector<std::int16_t> pixels;
  for (int n = 0; n < options.rows * options.columns; ++n) {
    pixels.push_back(static_cast<std::int16_t>(n * 10 - 300));
  }
  writeFile(folder / name, dicomSlice(options, bytesOf(pixels)));
}

void writeSeries(const fs::path& folder, const std::function<void(DicomOptions&)>& change = {}, int slices = kSlices) {
  for (int k = 0; k < slices; ++k) {
    DicomOptions options = sliceAt(k);
    if (change) {
      change(options);
    }
    writeSlice(folder, nameOf(k), options);
  }
}

void writeMaskSeries(const fs::path& folder, int broken = -1, const std::function<void(DicomOptions&)>& fault = {}) {
  for (int k = 0; k < kSlices; ++k) {
    DicomOptions options = sliceAt(k);
    options.bits = 8;
    options.bitsStored = 8;
    options.isSigned = false;
    if (k == broken) {
      fault(options);
    }
    writeFile(folder / nameOf(k), dicomSlice(options, Bytes(static_cast<std::size_t>(options.rows * options.columns), 1)));
  }
}

std::string ctRefusal(const fs::path& path) {
  return refusalOfCt(path, accepting({Consent::UnevenSlices, Consent::Tilt}));  // no consent may paper over a broken slice
}

struct Fault {
  const char* fact;  ///< what the refusal has to say
  std::function<void(DicomOptions&)> make;
};

std::vector<Fault> faults() {
  return {{"position", [](DicomOptions& o) { o.positionText = "0\\0\\NaN"; }},
          {"position", [](DicomOptions& o) { o.positionText = " "; }},
          {"position", [](DicomOptions& o) { o.positionText = "-12\\7\\1e30"; }},
          {"position", [](DicomOptions& o) { o.positionText = "-12\\7\\2000"; }},
          {"orientation", [](DicomOptions& o) { o.orientationText = "NaN\\0\\0\\0\\1\\0"; }},
          {"orientation", [](DicomOptions& o) { o.orientationText = "1\\0"; }},
          {"orientation", [](DicomOptions& o) { o.orientationText = "0.995\\0.0998\\0\\-0.0998\\0.995\\0"; }},
          {"spacing", [](DicomOptions& o) { o.pixelSpacingText = "inf\\0.75"; }},
          {"spacing", [](DicomOptions& o) { o.columnSpacing = 0.8; }},
          {"10 rows", [](DicomOptions& o) { o.rows = 10; }},
          {"11 columns", [](DicomOptions& o) { o.columns = 11; }}};
}

TEST(BrokenSlice, ABrokenHeaderAtEitherEndOrInTheMiddleOfASeriesIsRefusedByItsFile) {
  for (const Fault& fault : faults()) {
    for (const int k : {0, kSlices / 2, kSlices - 1}) {
      const TemporaryFolder folder;
      writeSeries(folder.path());
      ASSERT_EQ(ctRefusal(folder.path()), "");
      DicomOptions options = sliceAt(k);
      fault.make(options);
      writeSlice(folder.path(), nameOf(k), options);
      const std::string message = ctRefusal(folder.path());
      EXPECT_NE(message.find(nameOf(k)), std::string::npos) << fault.fact << ": " << message;
      EXPECT_NE(message.find(fault.fact), std::string::npos) << message;
      EXPECT_NE(message.find("export"), std::string::npos) << message;
      EXPECT_TRUE(message.ends_with(".")) << message;
    }
  }
}

TEST(BrokenSlice, WithoutASeriesUidTheFolderIsTheSeries) {
  for (const Fault& fault : faults()) {
    const TemporaryFolder folder;
    writeSeries(folder.path(), [](DicomOptions& o) { o.seriesUid = ""; });
    ASSERT_EQ(ctRefusal(folder.path()), "");
    DicomOptions options = sliceAt(kSlices - 1);
    options.seriesUid = "";
    fault.make(options);
    writeSlice(folder.path(), nameOf(kSlices - 1), options);
    EXPECT_NE(ctRefusal(folder.path()).find(nameOf(kSlices - 1)), std::string::npos) << fault.fact;
  }
}

TEST(BrokenSlice, ABrokenHeaderInAMaskSeriesIsRefusedByItsFile) {
  for (const Fault& fault : faults()) {
    for (const int k : {0, kSlices - 1}) {
      const TemporaryFolder folder;
      writeMaskSeries(folder / "liver", k, fault.make);
      const std::string message = refusal([&] { readSegmentation(folder.path()); });
      EXPECT_NE(message.find(nameOf(k)), std::string::npos) << fault.fact << ": " << message;
    }
  }
  const TemporaryFolder whole;
  writeMaskSeries(whole / "liver");
  EXPECT_EQ(refusal([&] { readSegmentation(whole.path()); }), "");
}

TEST(BrokenSlice, ASliceWhoseBeginningIsOverwrittenIsNoStranger) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  Bytes bytes = readFile(folder / nameOf(0));
  std::fill_n(bytes.begin(), 200, 0);
  writeFile(folder / nameOf(0), bytes);
  EXPECT_NE(ctRefusal(folder.path()).find(nameOf(0)), std::string::npos);
}

TEST(BrokenSlice, LocalizersOfTheSeriesItselfKeepTheirNote) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  DicomOptions unnamed = sliceAt(20);  // told by its direction alone
  unnamed.position = Vec3(0, -140, 300);
  unnamed.row = Vec3::UnitY();
  unnamed.column = -Vec3::UnitZ();
  unnamed.columnSpacing = 1.5;
  writeSlice(folder.path(), "scout_a", unnamed);
  DicomOptions named = sliceAt(21);
  named.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
  named.positionText = " ";
  named.rows = 20;
  writeSlice(folder.path(), "scout_b", named);
  const CtVolume ct = readCt(folder.path());
  EXPECT_EQ(ct.geometry.size[2], kSlices);
  std::string notes;
  for (const std::string& note : ct.notes) {
    notes += note;
  }
  EXPECT_NE(notes.find("scout_a"), std::string::npos) << notes;
  EXPECT_NE(notes.find("scout_b"), std::string::npos) << notes;
}

TEST(BrokenSlice, ASliceTurnedSidewaysWhereTheSeriesGoesOnIsNoLocalizer) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  DicomOptions turned = sliceAt(kSlices - 1);
  turned.row = Vec3::UnitY();
  turned.column = -Vec3::UnitZ();
  writeSlice(folder.path(), nameOf(kSlices - 1), turned);
  EXPECT_NE(ctRefusal(folder.path()).find(nameOf(kSlices - 1)), std::string::npos);
}

TEST(BrokenSlice, ASliceThatFillsItsPlaceUnderAnotherSeriesOrAsALocalizerIsRefused) {
  for (const int k : {0, kSlices / 2, kSlices - 1}) {
    const TemporaryFolder folder;
    writeSeries(folder.path());
    DicomOptions options = sliceAt(k);
    options.seriesUid = "1.2.9";
    writeSlice(folder.path(), nameOf(k), options);
    EXPECT_NE(ctRefusal(folder.path()).find(nameOf(k)), std::string::npos);
    options.seriesUid = "";
    writeSlice(folder.path(), nameOf(k), options);
    EXPECT_NE(ctRefusal(folder.path()).find("to which series"), std::string::npos);
    options = sliceAt(k);
    options.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER";
    writeSlice(folder.path(), nameOf(k), options);
    EXPECT_NE(ctRefusal(folder.path()).find("localizer"), std::string::npos);
  }
}

TEST(BrokenSlice, ACtSliceUnderTheClassOfADocumentIsASliceStill) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  DicomOptions options = sliceAt(0);
  options.sopClass = "1.2.840.10008.5.1.4.1.1.104.1";
  writeSlice(folder.path(), nameOf(0), options);
  EXPECT_EQ(readCt(folder.path()).geometry.size[2], kSlices);
}

TEST(BrokenSlice, H3AHugeRescaleSlopeInOneSliceIsRefusedAndAFewVoxelsBeyondTheRangeAreNot) {
  for (const char* slope : {"1e300", "-1e300", "1000", "1e308"}) {
    const TemporaryFolder folder;
    writeSeries(folder.path());
    DicomOptions options = sliceAt(3);
    options.slopeText = slope;
    writeSlice(folder.path(), nameOf(3), options);
    const std::string message = ctRefusal(folder.path());
    EXPECT_NE(message.find(nameOf(3)), std::string::npos) << slope << ": " << message;
    EXPECT_NE(message.find("rescal"), std::string::npos) << message;
  }
  const TemporaryFolder padded;  // a scanner's padding of -32768 falls below the range with the usual intercept
  writeSeries(padded.path());
  DicomOptions options = sliceAt(3);
  options.intercept = -1024;
  std::vector<std::int16_t> pixels(72, 1000);
  std::fill_n(pixels.begin(), 20, static_cast<std::int16_t>(-32768));
  writeFile(padded / nameOf(3), dicomSlice(options, bytesOf(pixels)));
  EXPECT_EQ(ctRefusal(padded.path()), "");
}

TEST(BrokenSlice, H3ARescaleSlopeOfMoreThanTwiceOrLessThanHalfTheSeriesIsRefusedAndASmallerDifferenceIsObeyedAndTold) {
  for (const char* slope : {"10", "2.1", "0.4", "-1"}) {
    const TemporaryFolder folder;
    writeSeries(folder.path());
    DicomOptions options = sliceAt(3);
    options.slopeText = slope;
    writeSlice(folder.path(), nameOf(3), options);
    const std::string message = ctRefusal(folder.path());
    EXPECT_NE(message.find(nameOf(3) + " has a rescale slope of " + slope + " where its series has 1,"), std::string::npos)
        << message;
  }
  const TemporaryFolder folder;
  writeSeries(folder.path());
  const CtVolume alike = readCt(folder.path());
  EXPECT_TRUE(alike.notes.empty());
  DicomOptions options = sliceAt(3);
  options.slopeText = "1.5";
  writeSlice(folder.path(), nameOf(3), options);
  const CtVolume ct = readCt(folder.path());
  ASSERT_EQ(ct.notes.size(), 1U);
  EXPECT_NE(ct.notes[0].find("rescale slopes of their own, from 1 to 1.5"), std::string::npos) << ct.notes[0];
  const std::size_t slice = static_cast<std::size_t>(3) * 72;
  EXPECT_EQ(ct.hounsfield[slice + 10], std::lround(1.5 * alike.hounsfield[slice + 10]));
}

TEST(BrokenSlice, H3ASliceWithoutTheRescaleValuesOfItsSeriesIsRefusedAndASeriesWithoutThemIsRead) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  DicomOptions options = sliceAt(3);
  options.rescaleIntercept = false;
  writeSlice(folder.path(), nameOf(3), options);
  const std::string message = ctRefusal(folder.path());
  EXPECT_NE(message.find(nameOf(3) + " lacks a rescale slope or intercept"), std::string::npos) << message;
  for (int k = 0; k < kSlices; ++k) {
    options = sliceAt(k);
    options.rescaleIntercept = false;
    writeSlice(folder.path(), nameOf(k), options);
  }
  EXPECT_EQ(ctRefusal(folder.path()), "");
}

TEST(TwoSeries, TwoThatCouldEachBeTheOneAreRefusedNamingBothAndASliceChooses) {
  const TemporaryFolder folder;
  writeSeries(folder / "study/a", [](DicomOptions& o) { o.seriesUid = "1.2.3.10"; });
  writeSeries(
      folder / "study/b", [](DicomOptions& o) { o.seriesUid = "1.2.3.11"; }, 10);
  const std::string message = ctRefusal(folder.path());
  EXPECT_NE(message.find("1.2.3.10"), std::string::npos) << message;
  EXPECT_NE(message.find("1.2.3.11"), std::string::npos) << message;
  EXPECT_EQ(readCt(folder / ("study/b/" + nameOf(2))).geometry.size[2], 10);
  const TemporaryFolder flat;
  writeSeries(flat.path());
  for (int k = 0; k < 9; ++k) {
    DicomOptions options = sliceAt(k);
    options.seriesUid = "1.2.3.12";
    writeSlice(flat.path(), "short_" + std::to_string(k), options);
  }
  EXPECT_EQ(readCt(flat.path()).geometry.size[2], kSlices);  // nine images are an excerpt, which is named in a note
  EXPECT_EQ(readCt(flat / "short_3").geometry.size[2], 9);
}

TEST(TwoSeries, H2SeriesOfTwoPatientsInOneFolderAreRefusedHoweverSmall) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  DicomOptions options = sliceAt(0);
  options.seriesUid = "1.2.3.12";
  options.patientId = "P2";
  writeSlice(folder.path(), "stray", options);
  const std::string message = ctRefusal(folder.path());
  EXPECT_NE(message.find("stray"), std::string::npos) << message;
  EXPECT_NE(message.find("patient"), std::string::npos) << message;
  EXPECT_EQ(message.find("P2"), std::string::npos) << message;
}

}  // namespace
}  // namespace glisson
