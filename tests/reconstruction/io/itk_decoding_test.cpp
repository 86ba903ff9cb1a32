// ITK decodes the voxels after our own check, as the file means them and not as ITK alone would take them; where it reads the place
// otherwise than we do, the file is refused (hazards H1, H3).

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"

namespace glisson {
namespace {

using namespace fixtures;

/// The bytes with one text in them exchanged.
Bytes exchanged(const Bytes& bytes, std::string_view from, std::string_view to) {
  const auto at = std::search(bytes.begin(), bytes.end(), from.begin(), from.end());
  if (at == bytes.end()) {
    throw std::runtime_error("fixture without " + std::string(from));
  }
  Bytes result(bytes.begin(), at);
  result.insert(result.end(), to.begin(), to.end());
  result.insert(result.end(), at + static_cast<std::ptrdiff_t>(from.size()), bytes.end());
  return result;
}

Bytes joined(Bytes first, const Bytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

constexpr int kPeriod = 101;

template <typename T>
Bytes sawtooth(std::size_t count, bool bigEndian) {
  std::vector<T> values;
  for (std::size_t n = 0; n < count; ++n) {
    values.push_back(static_cast<T>(n % kPeriod));
  }
  return bytesOf(values, bigEndian);
}

struct TypeRow {
  std::int16_t nifti;
  std::int16_t bits;
  const char* nrrd;
  const char* meta;
  Bytes (*make)(std::size_t, bool);
};

TEST(ItkDecoding, H3EveryTypeAndByteOrderOfEveryFormatPlainAndCompressedComesOutAsItWentIn) {
  const std::vector<TypeRow> rows{{2, 8, "uchar", "MET_UCHAR", sawtooth<std::uint8_t>},
                                  {256, 8, "signed char", "MET_CHAR", sawtooth<std::int8_t>},
                                  {512, 16, "ushort", "MET_USHORT", sawtooth<std::uint16_t>},
                                  {4, 16, "short", "MET_SHORT", sawtooth<std::int16_t>},
                                  {768, 32, "uint32_t", "MET_UINT", sawtooth<std::uint32_t>},
                                  {8, 32, "int", "MET_INT", sawtooth<std::int32_t>},
                                  {768, 32, "uint", "MET_ULONG", sawtooth<std::uint32_t>},  // four bytes in a file, eight in memory
                                  {8, 32, "signed int", "MET_LONG", sawtooth<std::int32_t>},
                                  {1280, 64, "ulonglong", "MET_ULONG_LONG", sawtooth<std::uint64_t>},
                                  {1024, 64, "int64", "MET_LONG_LONG", sawtooth<std::int64_t>},
                                  {16, 32, "float", "MET_FLOAT", sawtooth<float>},
                                  {64, 64, "double", "MET_DOUBLE", sawtooth<double>}};
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(22, 35);
  for (const TypeRow& row : rows) {
    for (const bool bigEndian : {false, true}) {
      const Bytes voxels = row.make(geometry.voxelCount(), bigEndian);
      NiftiOptions options;
      options.datatype = row.nifti;
      options.bitpix = row.bits;
      options.bigEndian = bigEndian;
      writeFile(folder / "a.nii", nifti(geometry, voxels, options));
      writeFile(folder / "b.nii.gz", gzip(nifti(geometry, voxels, options)));
      writeFile(folder / "c.nrrd", nrrd(geometry, voxels, row.nrrd, kLps, false, "", bigEndian));
      writeFile(folder / "d.nrrd", nrrd(geometry, voxels, row.nrrd, kLps, true, "", bigEndian));
      const std::string order = bigEndian ? "OrderMSB = True" : "OrderMSB = False";
      writeFile(folder / "e.mha", exchanged(metaImage(geometry, voxels, row.meta, false), "OrderMSB = False", order));
      writeFile(folder / "f.mha", exchanged(metaImage(geometry, voxels, row.meta, true), "OrderMSB = False", order));
      for (const char* name : {"a.nii", "b.nii.gz", "c.nrrd", "d.nrrd", "e.mha", "f.mha"}) {
        SCOPED_TRACE(std::string(row.meta) + " " + name + (bigEndian ? " big endian" : ""));
        const CtVolume ct = readCt(folder / name);
        EXPECT_LE(ct.geometry.cornerDistance(geometry), 1e-3);
        for (std::size_t n = 0; n < ct.hounsfield.size(); ++n) {
          ASSERT_EQ(ct.hounsfield[n], static_cast<int>(n % kPeriod));
        }
      }
    }
  }
}

TEST(ItkDecoding, H3ScaledNumbersAreNotRoundedToFloatsAndAnInterceptWithoutSlopeIsNoScale) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  std::vector<std::int32_t> labels(geometry.voxelCount(), -1);
  labels[7] = 16777217;  // the first whole number that a float cannot hold
  NiftiOptions options;
  options.datatype = 8;
  options.bitpix = 32;
  options.slope = 1;
  options.intercept = 1;
  writeFile(folder / "a.nii", nifti(geometry, bytesOf(labels), options));
  const Segmentation read = readSegmentation(folder / "a.nii");
  ASSERT_EQ(read.structures.size(), 1U);
  EXPECT_EQ(read.structures[0].label, 16777218);
  options.slope = 0;
  options.intercept = -1000;
  writeFile(folder / "b.nii", nifti(geometry, sawtooth<std::int32_t>(geometry.voxelCount(), false), options));
  EXPECT_EQ(readCt(folder / "b.nii").hounsfield[5], 5);
}

TEST(ItkDecoding, LayersAreToldApartWhetherTheirAxisComesFirstOrLast) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(9, 15);
  const std::size_t voxels = geometry.voxelCount();
  const std::string segments = "Segment0_Name:=Liver\nSegment0_Layer:=0\nSegment1_Name:=Tumor 1\nSegment1_Layer:=1\n";
  Bytes first(2 * voxels, 0);
  Bytes last(2 * voxels, 0);
  for (const std::size_t n : {3U, 4U, 5U}) {
    first[2 * n] = last[n] = 1;
  }
  first[2 * 77 + 1] = last[voxels + 77] = 1;
  writeFile(folder / "first.seg.nrrd", nrrd(geometry, first, "uchar", kLps, true,
                                            "dimension: 4\nsizes: 2 9 8 7\nkinds: list domain domain domain\n" + segments));
  const Bytes swapped = exchanged(
      nrrd(geometry, last, "uchar", kLps, true, "dimension: 4\nsizes: 9 8 7 2\nkinds: domain domain domain list\n" + segments),
      "directions: none ", "directions: ");
  writeFile(folder / "last.seg.nrrd", exchanged(swapped, "\nspace:", " none\nspace:"));
  for (const char* name : {"first.seg.nrrd", "last.seg.nrrd"}) {
    SCOPED_TRACE(name);
    const Segmentation read = readSegmentation(folder / name);
    EXPECT_LE(read.geometry.cornerDistance(geometry), 1e-3);
    ASSERT_EQ(read.structures.size(), 2U);
    EXPECT_EQ(read.structures[0].mask->count(), 3U);
    EXPECT_TRUE(read.structures[0].mask->at(4, 0, 0));
    EXPECT_EQ(read.structures[1].mask->count(), 1U);
    EXPECT_TRUE(read.structures[1].mask->at(77 % 9, 77 / 9 % 8, 77 / 72));
  }
}

TEST(ItkDecoding, NamesMembersAndFieldsThatItkAloneRefusesOrTripsOverAreRead) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(44, 12);
  const Bytes body = asymmetricBody(geometry);
  const Bytes plain = nifti(geometry, body);
  writeFile(folder / "A.NII", plain);
  writeFile(folder / "b.Nii.Gz", gzip(plain));
  const auto half = plain.begin() + static_cast<std::ptrdiff_t>(plain.size() / 2);
  writeFile(folder / "members.nii.gz", joined(gzip(Bytes(plain.begin(), half)), gzip(Bytes(half, plain.end()))));
  Bytes matrix = plain;
  constexpr std::int16_t kGeneralMatrix = 1004;
  std::memcpy(&matrix[68], &kGeneralMatrix, sizeof kGeneralMatrix);
  writeFile(folder / "intent.nii", matrix);
  const std::string longText(300, 'A');
  writeFile(folder / "C.Nrrd", nrrd(geometry, body, "uchar", kLps, true, "content: " + longText + "\nodd field: 1\nkey:=value\n"));
  const Bytes meta = metaImage(geometry, body, "MET_UCHAR", true);
  writeFile(folder / "D.MHA", exchanged(meta, "NDims", "Comment = " + longText + "\nName = " + longText + "\nNDims"));
  for (const char* name : {"A.NII", "b.Nii.Gz", "members.nii.gz", "intent.nii", "C.Nrrd", "D.MHA"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(faultOfBody(readSegmentation(folder / name), geometry), "");
  }
}

TEST(ItkDecoding, H1ANiftiWhoseVoxelSizeContradictsItsSformIsRefusedUntilOneIsChosen) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  Bytes bytes = nifti(geometry, asymmetricBody(geometry));
  const float wider = 2;
  std::memcpy(&bytes[80], &wider, sizeof wider);
  writeFile(folder / "a.nii", bytes);
  const std::string message = refusalOfCt(folder / "a.nii");
  EXPECT_NE(message.find("a.nii has a header that ITK reads otherwise: a corner lies 10.00 mm"), std::string::npos) << message;
  EXPECT_NE(message.find("--prefer sform"), std::string::npos) << message;
  ReadOptions prefer;
  prefer.niftiFrame = NiftiFrame::SForm;
  EXPECT_EQ(faultOfBody(readSegmentation(folder / "a.nii", prefer), geometry), "");
}

TEST(ItkDecoding, H1ANiftiInMetresLiesWhereItDoesInMillimetres) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(21, 33);
  ImageGeometry metres = geometry;
  metres.spacing /= 1000;
  metres.origin /= 1000;
  constexpr std::uint8_t kMetres = 1;
  Bytes bytes = nifti(metres, asymmetricBody(geometry));
  bytes[123] = kMetres;
  writeFile(folder / "a.nii", bytes);
  EXPECT_EQ(faultOfBody(readSegmentation(folder / "a.nii"), geometry), "");
}

TEST(ItkDecoding, VoxelsThatAreNotFiniteAreRefusedInEveryFormat) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  NiftiOptions floats;
  floats.datatype = 16;
  floats.bitpix = 32;
  for (const float broken : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    std::vector<float> values(geometry.voxelCount(), 10);
    values[3] = 5;
    values[100] = broken;
    writeFile(folder / "a.nii", nifti(geometry, bytesOf(values), floats));
    writeFile(folder / "b.nrrd", nrrd(geometry, bytesOf(values, true), "float", kLps, true, "", true));
    writeFile(folder / "c.mha", metaImage(geometry, bytesOf(values), "MET_FLOAT", false));
    for (const char* name : {"a.nii", "b.nrrd", "c.mha"}) {
      const std::string message = refusalOfCt(folder / name);
      EXPECT_NE(message.find(std::string(name) + " holds voxels that are not finite numbers"), std::string::npos) << message;
    }
  }
}

TEST(ItkDecoding, NoFileStaysBehindInTheTemporaryFolderNorBesideTheInput) {
  const TemporaryFolder folder;
  const TemporaryFolder temporary;
  const ImageGeometry geometry = permutedGrid(0, 0);
  const Bytes body = asymmetricBody(geometry);
  writeFile(folder / "a.nii.gz", gzip(nifti(geometry, body)));
  writeFile(folder / "b.nrrd", nrrd(geometry, body, "uchar", kLps, false));
  writeFile(folder / "c.mha", metaImage(geometry, Bytes(body.begin() + 1, body.end()), "MET_UCHAR", false));
  setenv("TMPDIR", temporary.path().c_str(), 1);
  EXPECT_EQ(faultOfBody(readSegmentation(folder / "a.nii.gz"), geometry), "");
  EXPECT_EQ(faultOfBody(readSegmentation(folder / "b.nrrd"), geometry), "");
  EXPECT_NE(refusalOfCt(folder / "c.mha"), "");
  unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 3);
}

}  // namespace
}  // namespace glisson
