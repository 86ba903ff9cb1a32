// Every format and orientation lands at the same place in the world (hazards H1, H3).

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <clocale>
#include <cstdlib>

#include "reconstruction/errors.h"
#include "reconstruction/io/child_process.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"
#include "tests/support/paths.h"

namespace glisson {
namespace {

using namespace fixtures;

constexpr const char* kRas = "right-anterior-superior";
constexpr const char* kLas = "left-anterior-superior";

std::int16_t rampValue(std::size_t n) { return static_cast<std::int16_t>(static_cast<int>(n) * 3 - 700); }

std::vector<double> ramp(const ImageGeometry& geometry) {
  std::vector<double> values;
  for (std::size_t n = 0; n < geometry.voxelCount(); ++n) {
    values.push_back(rampValue(n));
  }
  return values;
}

template <typename T>
Bytes asType(const std::vector<double>& values, double shift, bool bigEndian) {
  std::vector<T> typed;
  for (const double value : values) {
    typed.push_back(static_cast<T>(value + shift));
  }
  return bytesOf(typed, bigEndian);
}

TEST(Import, TheChildIsFoundBesideTheProgram) {
  EXPECT_EQ(findImporter(), std::filesystem::path(test::programFolder()) / "glisson-import");
}

TEST(Import, H1AllAxisOrdersFlipsAndObliqueDirectionsOfEveryFormatKeepTheBodyWhereItIs) {
  const TemporaryFolder folder;
  for (int code = 0; code < 48; ++code) {
    const ImageGeometry geometry = permutedGrid(code, code % 3 == 0 ? 0 : 7.5 * code);
    const std::vector<std::uint8_t> body = asymmetricBody(geometry);
    const char* space = code % 3 == 0 ? kLps : (code % 3 == 1 ? kRas : kLas);
    NiftiOptions form;
    form.sform = code % 2 == 0;
    form.qform = code % 4 != 0;
    writeFile(folder / "a.nii", nifti(geometry, body, form));
    writeFile(folder / "a.nii.gz", gzip(nifti(geometry, body, form)));
    writeFile(folder / "a.nrrd", nrrd(geometry, body, "uchar", space, code % 2 == 0));
    writeFile(folder / "a.mha", metaImage(geometry, body, "MET_UCHAR", code % 2 == 0));
    for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"}) {
      SCOPED_TRACE(std::string(name) + " with axes of code " + std::to_string(code));
      EXPECT_EQ(faultOfBody(readSegmentation(folder / name), geometry), "");
    }
  }
}

TEST(Import, H3EveryNumberTypeAndByteOrderGivesTheSameHounsfieldUnits) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(13, 20);
  const std::vector<double> values = ramp(geometry);
  struct Row {
    std::int16_t code;
    std::int16_t bits;
    const char* nrrdType;
    Bytes (*make)(const std::vector<double>&, double, bool);
    double shift;
  };
  const std::vector<Row> rows{{4, 16, "short", asType<std::int16_t>, 0},
                              {512, 16, "ushort", asType<std::uint16_t>, 1024},
                              {8, 32, "int", asType<std::int32_t>, 0},
                              {768, 32, "uint", asType<std::uint32_t>, 1024},
                              {16, 32, "float", asType<float>, 0},
                              {64, 64, "double", asType<double>, 0},
                              {1024, 64, "longlong", asType<std::int64_t>, 0}};
  for (const Row& row : rows) {
    for (const bool bigEndian : {false, true}) {
      SCOPED_TRACE(std::string(row.nrrdType) + (bigEndian ? " big endian" : ""));
      NiftiOptions options;
      options.datatype = row.code;
      options.bitpix = row.bits;
      options.bigEndian = bigEndian;
      options.slope = row.shift > 0 ? 1 : 0;
      options.intercept = -row.shift;
      writeFile(folder / "ct.nii", nifti(geometry, row.make(values, row.shift, bigEndian), options));
      writeFile(folder / "ct.nrrd", nrrd(geometry, row.make(values, 0, bigEndian), row.nrrdType, kLps, true, "", bigEndian));
      const CtVolume ct = readCt(folder / "ct.nii");
      for (std::size_t n = 0; n < values.size(); ++n) {
        ASSERT_EQ(ct.hounsfield[n], rampValue(n));
      }
      if (row.shift == 0) {
        EXPECT_EQ(readCt(folder / "ct.nrrd").hounsfield, ct.hounsfield);
      }
    }
  }
}

TEST(Import, ScaledNiftiIsRescaledAndEightBitAndSignedBytesAreRead) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  std::vector<std::int8_t> bytes(geometry.voxelCount());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    bytes[n] = static_cast<std::int8_t>(static_cast<int>(n % 200) - 100);
  }
  NiftiOptions options;
  options.datatype = 256;
  options.slope = 10;
  options.intercept = -24;
  writeFile(folder / "ct.nii", nifti(geometry, bytesOf(bytes), options));
  const CtVolume ct = readCt(folder / "ct.nii");
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    ASSERT_EQ(ct.hounsfield[n], bytes[n] * 10 - 24);
  }
}

TEST(Import, FloatLabelsAreReadOnlyWhereTheyAreWhole) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  std::vector<float> labels(geometry.voxelCount(), 0);
  labels[5] = 3;
  NiftiOptions options;
  options.datatype = 16;
  options.bitpix = 32;
  writeFile(folder / "labels.nii", nifti(geometry, bytesOf(labels), options));
  const Segmentation read = readSegmentation(folder / "labels.nii");
  ASSERT_EQ(read.structures.size(), 1U);
  EXPECT_EQ(read.structures[0].label, 3);
  EXPECT_EQ(read.structures[0].name, "label 3");
  EXPECT_FALSE(read.structures[0].kind.has_value());
  labels[6] = 2.5F;
  writeFile(folder / "labels.nii", nifti(geometry, bytesOf(labels), options));
  EXPECT_THROW(readSegmentation(folder / "labels.nii"), InputError);
}

TEST(Import, SegmentsKeepNamesColoursOrderAndOverlap) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(21, 33);
  std::vector<std::uint8_t> layers(2 * geometry.voxelCount(), 0);
  const auto set = [&](std::size_t voxel, std::size_t layer, std::uint8_t label) { layers[2 * voxel + layer] = label; };
  for (std::size_t n = 0; n < 40; ++n) {
    set(n, 0, 1);
  }
  set(7, 1, 1);
  set(100, 0, 2);
  const std::string extra =
      "dimension: 4\nsizes: 2 9 8 7\nkinds: list domain domain domain\n"
      "Segment0_ID:=s0\nSegment0_Name:=Liver\nSegment0_Color:=0.866667 0.509804 "
      "0.396078\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
      "Segment1_ID:=s1\nSegment1_Name:=Tumor 1\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n"
      "Segment2_ID:=s2\nSegment2_Name:=Gef\xC3\xA4\xC3\x9F\nSegment2_LabelValue:=2\nSegment2_Layer:=0\n"
      "Segment3_ID:=s3\nSegment3_Name:=Cyst\nSegment3_LabelValue:=9\nSegment3_Layer:=0\n";
  writeFile(folder / "a.seg.nrrd", nrrd(geometry, layers, "uchar", kRas, true, extra));
  const Segmentation read = readSegmentation(folder / "a.seg.nrrd");
  ASSERT_EQ(read.structures.size(), 4U);
  EXPECT_LE(read.geometry.cornerDistance(geometry), 1e-3);
  EXPECT_EQ(read.structures[0].kind, StructureKind::Liver);
  EXPECT_EQ(read.structures[0].colour, (Rgb{221, 130, 101}));
  EXPECT_EQ(read.structures[0].mask->count(), 40U);
  EXPECT_EQ(read.structures[1].name, "Tumor 1");
  EXPECT_EQ(read.structures[1].kind, StructureKind::Tumour);
  EXPECT_TRUE(read.structures[1].mask->at(7, 0, 0));
  EXPECT_TRUE(read.structures[0].mask->at(7, 0, 0));
  EXPECT_EQ(read.structures[2].name, "Gef\xC3\xA4\xC3\x9F");
  EXPECT_FALSE(read.structures[2].kind.has_value());
  EXPECT_TRUE(read.structures[3].mask->empty());
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_NE(read.notes[0].find("\"Cyst\" is empty"), std::string::npos);
}

TEST(Import, EmbeddedLabelNamesAndTheNamedTableGiveKindsAndBareNumbersNone) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  std::vector<std::uint8_t> labels(geometry.voxelCount(), 0);
  labels[3] = 5;
  labels[9] = 64;
  NiftiOptions options;
  writeFile(folder / "x.nii", nifti(geometry, labels, options));
  const Segmentation bare = readSegmentation(folder / "x.nii");
  ASSERT_EQ(bare.structures.size(), 2U);
  EXPECT_FALSE(bare.structures[0].kind || bare.structures[1].kind);
  ReadOptions table;
  parseLabels("totalsegmentator", table);
  const Segmentation named = readSegmentation(folder / "x.nii", table);
  EXPECT_EQ(named.structures[0].kind, StructureKind::Liver);
  EXPECT_EQ(named.structures[1].kind, StructureKind::PortalVein);
  EXPECT_EQ(named.structures[1].name, "portal_vein_and_splenic_vein");
  ReadOptions chosen;
  parseLabels("5=tumour, label 64=cyst", chosen);
  const Segmentation byUser = readSegmentation(folder / "x.nii", chosen);
  EXPECT_EQ(byUser.structures[0].kind, StructureKind::Tumour);
  EXPECT_EQ(byUser.structures[1].kind, StructureKind::Cyst);
  options.extension = R"(<LabelTable><Label Key="5" Red="0"><![CDATA[liver]]></Label></LabelTable>)";
  writeFile(folder / "x.nii", nifti(geometry, labels, options));
  EXPECT_EQ(readSegmentation(folder / "x.nii").structures[0].kind, StructureKind::Liver);
}

TEST(Import, AChosenLabelOrNameThatIsNotThereIsRefusedNamingItAndWhatIsThere) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  std::vector<std::uint8_t> labels(geometry.voxelCount(), 0);
  labels[3] = 5;
  labels[9] = 64;
  writeFile(folder / "x.nii", nifti(geometry, labels));
  writeFile(folder / "organs/liver.nii", nifti(geometry, asymmetricBody(geometry)));
  writeFile(folder / "organs/thing.nii", nifti(geometry, asymmetricBody(geometry)));
  const auto message = [&](const char* file, const char* choices) {
    ReadOptions options;
    parseLabels(choices, options);
    try {
      readSegmentation(folder / file, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("x.nii", "5=liver,LABEL 64=portal_vein"), "");
  const std::string number = message("x.nii", "5=liver,7=tumour");
  EXPECT_NE(number.find("no label 7 "), std::string::npos) << number;
  EXPECT_NE(number.find("5, 64."), std::string::npos) << number;
  const std::string name = message("x.nii", "Metastasis=tumour");
  EXPECT_NE(name.find("\"Metastasis\""), std::string::npos) << name;
  EXPECT_NE(name.find("label 5, label 64."), std::string::npos) << name;
  EXPECT_EQ(message("organs", "thing=tumour"), "");
  EXPECT_NE(message("organs", "thang=tumour").find("\"thang\""), std::string::npos);
  EXPECT_NE(message("organs", "1=tumour").find("NAME=KIND"), std::string::npos);
}

TEST(Import, AFolderOfOneOrganFilesGivesOneMaskPerFile) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(5, 0);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  writeFile(folder / "liver.nii.gz", gzip(nifti(geometry, body)));
  writeFile(folder / "portal_vein.nii.gz", gzip(nifti(geometry, body)));
  writeFile(folder / "rib_left_3.nii.gz", Bytes{1, 2, 3});  // another organ: listed, never opened
  const Segmentation read = readSegmentation(folder.path());
  ASSERT_EQ(read.structures.size(), 3U);
  EXPECT_EQ(read.structures[0].kind, StructureKind::Liver);
  EXPECT_EQ(read.structures[1].kind, StructureKind::PortalVein);
  EXPECT_EQ(read.structures[2].kind, StructureKind::Other);
  EXPECT_EQ(read.structures[2].mask, nullptr);
  EXPECT_EQ(guessInput(folder.path()), InputKind::Segmentation);
  writeFile(folder / "tumor.nii.gz", gzip(nifti(permutedGrid(6, 0), body)));
  EXPECT_THROW(readSegmentation(folder.path()), InputError);
}

TEST(Import, DetachedHeadersReadTheirDataFileAndOnlyBesideThem) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(11, 12);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  const Bytes whole = nrrd(geometry, {}, "uchar", kLps, false, "data file: a.raw\n");
  writeFile(folder / "a.nhdr", whole);
  writeFile(folder / "a.raw", body);
  EXPECT_EQ(faultOfBody(readSegmentation(folder / "a.nhdr"), geometry), "");
  std::filesystem::remove(folder / "a.raw");
  EXPECT_THROW(readSegmentation(folder / "a.nhdr"), InputError);
  writeFile(folder / "a.nhdr", nrrd(geometry, {}, "uchar", kLps, false, "data file: /etc/passwd\n"));
  EXPECT_THROW(readSegmentation(folder / "a.nhdr"), InputError);
}

TEST(Import, PathsWithBlanksAndUtf8Work) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(30, 5);
  const auto path = folder / "Leber Gef\xC3\xA4\xC3\x9F\xE2\x80\x94\xE8\x82\x9D '1'" / "la bel.nii.gz";
  writeFile(path, gzip(nifti(geometry, asymmetricBody(geometry))));
  EXPECT_EQ(faultOfBody(readSegmentation(path), geometry), "");
}

TEST(Import, ADecimalCommaLocaleChangesNothing) {
  setenv("LOCPATH", test::localesFolder().c_str(), 1);
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(17, 41);
  writeFile(folder / "a.nrrd", nrrd(geometry, asymmetricBody(geometry), "uchar", kRas, true));
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "tr_TR.UTF-8"}) {
    setenv("LC_ALL", name, 1);
    ASSERT_NE(std::setlocale(LC_ALL, name), nullptr) << name << " is missing: install the package locales";
    EXPECT_EQ(faultOfBody(readSegmentation(folder / "a.nrrd"), geometry), "");
  }
  std::setlocale(LC_ALL, "C");
  unsetenv("LC_ALL");
}

TEST(Import, GuessTellsCtFromLabelsAndCases) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  NiftiOptions shorts;
  shorts.datatype = 4;
  shorts.bitpix = 16;
  writeFile(folder / "a.nii", nifti(geometry, asType<std::int16_t>(ramp(geometry), 0, false), shorts));
  writeFile(folder / "b.nii", nifti(geometry, asymmetricBody(geometry)));
  writeFile(folder / "c.glisson", {1});
  writeFile(folder / "d.txt", {1});
  EXPECT_EQ(guessInput(folder / "a.nii"), InputKind::Ct);
  EXPECT_EQ(guessInput(folder / "b.nii"), InputKind::Segmentation);
  EXPECT_EQ(guessInput(folder / "c.glisson"), InputKind::Case);
  EXPECT_EQ(guessInput(folder / "d.txt"), InputKind::Unknown);
  EXPECT_EQ(guessInput(folder / "nothing"), InputKind::Unknown);
}

TEST(Import, ACtWhoseFirstSlicesArePaddingIsNoSegmentation) {
  const TemporaryFolder folder;
  ImageGeometry geometry;
  geometry.size = {128, 64, 100};  // more than the first look reads
  std::vector<std::uint8_t> values(2 * geometry.voxelCount(), 0);
  values.back() = 4;  // 1024 HU in the last voxel
  NiftiOptions shorts;
  shorts.datatype = 4;
  shorts.bitpix = 16;
  writeFile(folder / "scan.nii", nifti(geometry, values, shorts));
  EXPECT_EQ(guessInput(folder / "scan.nii"), InputKind::Ct);
}

}  // namespace
}  // namespace glisson
