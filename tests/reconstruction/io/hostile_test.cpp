// Broken and hostile files cost one sentence (hazard H9).

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

#include "reconstruction/errors.h"
#include "reconstruction/io/child_process.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"
#include "tests/support/real_data.h"

namespace glisson {
namespace {

using namespace fixtures;

void expectOneSentence(const std::string& message, const std::string& file) {
  EXPECT_NE(message.find(file), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(message.ends_with(".")) << message;
}

/// How many broken forms of a file are tried: more in long runs.
std::size_t tries() { return test::longRuns() ? 120 : 24; }

/// Cuts the file in tries() places; every cut must be refused in one sentence that names it.
void sweep(const std::filesystem::path& path, const Bytes& whole) {
  int silent = 0;
  for (std::size_t n = 0; n < tries(); ++n) {
    const std::size_t size = whole.size() * n / tries();
    writeFile(path, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    const std::string message = refusal([&] { return readSegmentation(path); });
    silent += message.empty() ? 1 : 0;
    if (!message.empty()) {
      expectOneSentence(message, path.filename().string());
    }
  }
  writeFile(path, Bytes(whole.begin(), whole.end() - 1));
  silent += refusal([&] { return readSegmentation(path); }).empty() ? 1 : 0;
  EXPECT_EQ(silent, 0) << path;
  writeFile(path, whole);
  EXPECT_EQ(refusal([&] { return readSegmentation(path); }), "");
}

TEST(HostileInput, H9NoTruncationOfAnImageFileIsAcceptedSilently) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(19, 27);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  sweep(folder / "a.nii", nifti(geometry, body));
  sweep(folder / "a.nii.gz", gzip(nifti(geometry, body)));
  sweep(folder / "a.nrrd", nrrd(geometry, body, "uchar", kLps, false));
  sweep(folder / "b.nrrd", nrrd(geometry, body, "uchar", kLps, true));
  sweep(folder / "a.mha", metaImage(geometry, body, "MET_UCHAR", false));
  sweep(folder / "b.mha", metaImage(geometry, body, "MET_UCHAR", true));
}

TEST(HostileInput, H9NoTruncationOfADicomSliceIsAcceptedSilently) {
  const TemporaryFolder folder;
  writeCtSeries(folder.path(), {0, 2, 4, 6});
  for (const char* name : {"slice_99", "slice_97"}) {
    const Bytes whole = readFile(folder / name);
    int silent = 0;
    for (std::size_t n = 0; n < tries(); ++n) {
      writeFile(folder / name, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * n / tries())));
      silent += refusal([&] { return readCt(folder.path()); }).empty() ? 1 : 0;
    }
    writeFile(folder / name, Bytes(whole.begin(), whole.end() - 1));
    silent += refusal([&] { return readCt(folder.path()); }).empty() ? 1 : 0;
    EXPECT_EQ(silent, 0) << name;
    writeFile(folder / name, whole);
  }
  EXPECT_EQ(refusal([&] { return readCt(folder.path()); }), "");
}

TEST(HostileInput, H9AFlippedBitInCompressedDataIsRefused) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  const Bytes whole = gzip(nifti(geometry, asymmetricBody(geometry)));
  for (std::size_t n = 10; n < whole.size(); n += 7) {
    Bytes broken = whole;
    broken[n] ^= 0x10;
    writeFile(folder / "a.nii.gz", broken);
    EXPECT_NE(refusal([&] { return readSegmentation(folder / "a.nii.gz"); }), "") << n;
  }
}

TEST(HostileInput, H9RandomBytesInHeadersCostOneSentenceAtMost) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(3, 10);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  std::uint32_t state = 12345;
  const auto random = [&] { return (state = state * 1664525U + 1013904223U) >> 8; };
  for (const auto& format : {std::pair<std::string, Bytes>("a.nii", nifti(geometry, body)),
                             {"a.nrrd", nrrd(geometry, body, "uchar", kLps, false)},
                             {"a.mha", metaImage(geometry, body, "MET_UCHAR", false)}}) {
    const std::string& name = format.first;
    for (std::size_t n = 0; n < tries(); ++n) {
      Bytes broken = format.second;
      for (int change = 0; change < 3; ++change) {
        broken[random() % 352] = static_cast<std::uint8_t>(random());
      }
      writeFile(folder / name, broken);
      const std::string message = refusal([&] { return readSegmentation(folder / name); });
      EXPECT_EQ(message.find("decoder failed"), std::string::npos) << name << " " << n;
    }
  }
}

TEST(HostileInput, H9ASizeBombIsRefusedQuicklyAndWithoutMemory) {
  const TemporaryFolder folder;
  ImageGeometry geometry = permutedGrid(0, 0);
  geometry.size = {30000, 30000, 30000};
  writeFile(folder / "a.nii.gz", gzip(nifti(geometry, Bytes(100, 0))));
  writeFile(folder / "a.nrrd", nrrd(geometry, Bytes(100, 0), "uchar", kLps, true,
                                    "dimension: 4\nsizes: 1 30000 30000 30000\nkinds: list domain domain domain\n"));
  writeFile(folder / "a.mha", metaImage(geometry, Bytes(100, 0), "MET_UCHAR", true));
  for (const char* name : {"a.nii.gz", "a.nrrd", "a.mha"}) {
    const std::string message = refusal([&] { return readSegmentation(folder / name); });
    expectOneSentence(message, name);
    EXPECT_NE(message.find("GiB"), std::string::npos) << message;
  }
  geometry.size = {1500, 1500, 1500};  // within the budget, but the file is too short to hold it
  writeFile(folder / "b.nii.gz", gzip(nifti(geometry, Bytes(100, 0))));
  EXPECT_NE(refusal([&] { return readSegmentation(folder / "b.nii.gz"); }).find("cut off"), std::string::npos);
}

TEST(HostileInput, NonFiniteHeadersAndVoxelsAreRefused) {
  const TemporaryFolder folder;
  ImageGeometry geometry = permutedGrid(0, 0);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  geometry.origin[1] = std::numeric_limits<double>::quiet_NaN();
  writeFile(folder / "a.nii", nifti(geometry, body));
  expectOneSentence(refusal([&] { return readSegmentation(folder / "a.nii"); }), "a.nii");
  geometry.origin[1] = 0;
  geometry.direction(0, 0) = std::numeric_limits<double>::infinity();
  for (const char* name : {"b.nii", "b.nrrd", "b.mha"}) {
    const std::string ending = std::filesystem::path(name).extension();
    writeFile(folder / name, ending == ".nii"    ? nifti(geometry, body)
                             : ending == ".nrrd" ? nrrd(geometry, body, "uchar", kLps, true)
                                                 : metaImage(geometry, body, "MET_UCHAR", true));
    expectOneSentence(refusal([&] { return readSegmentation(folder / name); }), name);
  }
  NiftiOptions floats;
  floats.datatype = 16;
  floats.bitpix = 32;
  std::vector<float> values(geometry.voxelCount(), 10);
  values[3] = std::numeric_limits<float>::quiet_NaN();
  writeFile(folder / "c.nii", nifti(permutedGrid(0, 0), bytesOf(values), floats));
  expectOneSentence(refusal([&] { return readCt(folder / "c.nii"); }), "c.nii");
  values[3] = -3;
  floats.slope = 1e30;
  writeFile(folder / "d.nii", nifti(permutedGrid(0, 0), bytesOf(values), floats));
  const std::string scaled = refusal([&] { readCt(folder / "d.nii"); });
  expectOneSentence(scaled, "d.nii");
  EXPECT_NE(scaled.find("no Hounsfield units"), std::string::npos) << scaled;
}

TEST(HostileInput, ANiftiWithNanInItsFormsOrNanOrZeroVoxelSizesSaysSo) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  NiftiOptions both;
  both.qform = true;
  const Bytes whole = nifti(geometry, asymmetricBody(geometry), both);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const auto message = [&](std::size_t offset, float value, NiftiFrame frame = NiftiFrame::Agreeing) {
    Bytes bytes = whole;
    std::memcpy(&bytes[offset], &value, sizeof value);
    writeFile(folder / "a.nii", bytes);
    ReadOptions options;
    options.niftiFrame = frame;
    std::string text = refusal([&] { readSegmentation(folder / "a.nii", options); });
    EXPECT_EQ(text.find("comparable"), std::string::npos) << text;
    if (!text.empty()) {
      expectOneSentence(text, "a.nii");
    }
    return text;
  };
  constexpr std::size_t kSform = 280;
  constexpr std::size_t kPixdim = 80;
  constexpr std::size_t kQoffset = 268;
  for (const std::size_t offset : {kSform, kSform + 12, kSform + 24}) {
    EXPECT_NE(message(offset, kNan).find("its sform holds a number that is not finite (NaN"), std::string::npos);
  }
  EXPECT_EQ(message(kSform, kNan, NiftiFrame::QForm), "");
  EXPECT_NE(message(kQoffset, kNan).find("its qform holds a number that is not finite (NaN"), std::string::npos);
  EXPECT_EQ(message(kQoffset, kNan, NiftiFrame::SForm), "");
  EXPECT_NE(message(kPixdim + 4, kNan).find("(pixdim) holds a number that is not finite (NaN"), std::string::npos);
  EXPECT_NE(message(kPixdim + 8, 0).find("(pixdim) is zero"), std::string::npos);
  EXPECT_EQ(message(kPixdim + 8, 0, NiftiFrame::SForm), "");
}

TEST(HostileInput, TimeSeriesSkewDisagreeingFormsAndMissingOrientationAreRefused) {
  const TemporaryFolder folder;
  const ImageGeometry geometry = permutedGrid(0, 0);
  const std::vector<std::uint8_t> body = asymmetricBody(geometry);
  const auto message = [&](const Bytes& bytes, const ReadOptions& options = {}) {
    writeFile(folder / "a.nii", bytes);
    return refusal([&] { return readSegmentation(folder / "a.nii", options); });
  };
  NiftiOptions time;
  time.timePoints = 2;
  Bytes twice = body;
  twice.insert(twice.end(), body.begin(), body.end());
  EXPECT_NE(message(nifti(geometry, twice, time)).find("time series"), std::string::npos);
  ImageGeometry skewed = geometry;
  skewed.direction(0, 1) += 0.2;
  EXPECT_NE(message(nifti(skewed, body)).find("right angles"), std::string::npos);
  NiftiOptions both;
  both.qform = true;
  both.sformShiftMm = 0.5;
  const std::string apart = message(nifti(geometry, body, both));
  EXPECT_NE(apart.find("--prefer sform"), std::string::npos) << apart;
  ReadOptions prefer;
  prefer.niftiFrame = NiftiFrame::QForm;
  EXPECT_EQ(message(nifti(geometry, body, both), prefer), "");
  EXPECT_LE(readSegmentation(folder / "a.nii", prefer).geometry.cornerDistance(geometry), 1e-3);
  NiftiOptions neither;
  neither.sform = false;
  EXPECT_NE(message(nifti(geometry, body, neither)).find("orientation"), std::string::npos);
  EXPECT_NE(message(nifti(geometry, Bytes(body.size(), 0))).find("no label"), std::string::npos);
}

TEST(HostileInput, AMetaImageFieldNameOfMoreThan255BytesIsRefused) {
  const TemporaryFolder folder;
  Bytes file = metaImage(permutedGrid(0, 0), asymmetricBody(permutedGrid(0, 0)), "MET_UCHAR", false);
  std::string line(300, 'A');
  line.append(" = 1\n");
  file.insert(file.begin(), line.begin(), line.end());
  writeFile(folder / "a.mha", file);
  expectOneSentence(refusal([&] { return readSegmentation(folder / "a.mha"); }), "a.mha");
}

/// Far above what the tests wait for, far below what a test may take.
constexpr std::chrono::seconds kTheChildsSleep{60};

/// Makes a stand-in for glisson-import for the life of the object.
class StandIn {
 public:
  StandIn(const TemporaryFolder& folder, const std::string& script) {
    const std::string text = "#!/bin/sh\n" + script + "\n";
    writeFile(folder / "stand-in", Bytes(text.begin(), text.end()));
    std::filesystem::permissions(folder / "stand-in", std::filesystem::perms::owner_all);
    setenv("GLISSON_IMPORT", (folder / "stand-in").c_str(), 1);
  }
  ~StandIn() { unsetenv("GLISSON_IMPORT"); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;
};

TEST(HostileInput, H9ACrashAHangOrALyingChildCostsOneSentence) {
  const TemporaryFolder folder;
  writeFile(folder / "a.nii", Bytes(10, 0));
  ReadOptions options;
  options.timeLimitSeconds = 1;
  const auto message = [&](const std::string& script) {
    const StandIn standIn(folder, script);
    return refusal([&] { return readCt(folder / "a.nii", options); });
  };
  for (const char* script :
       {"kill -ABRT $$", "kill -SEGV $$", "exit 3", "exit 0", "echo nonsense > \"$2\"", "printf '%0100d' 0 > \"$2\""}) {
    expectOneSentence(message(script), "a.nii");
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_NE(message("sleep 60").find("within 1 seconds"), std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kTheChildsSleep);
}

TEST(HostileInput, ACancelKillsTheChildAndLeavesNoFiles) {
  const TemporaryFolder folder;
  const TemporaryFolder temporary;
  writeFile(folder / "a.nii", Bytes(10, 0));
  const StandIn standIn(folder, "exec sleep 60");
  setenv("TMPDIR", temporary.path().c_str(), 1);
  const ExecutionContext context;
  std::chrono::steady_clock::time_point cancelled;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    cancelled = std::chrono::steady_clock::now();
    context.cancel();
  });
  EXPECT_THROW(readCt(folder / "a.nii", {}, context), Cancelled);
  other.join();
  const auto latency = std::chrono::steady_clock::now() - cancelled;
  EXPECT_LT(latency, kTheChildsSleep);
  RecordProperty("milliseconds", std::to_string(std::chrono::duration<double, std::milli>(latency).count()));
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
  unsetenv("TMPDIR");
}

TEST(HostileInput, WhatAKilledProgramLeftInTheTemporaryFolderGoesWithTheNextReading) {
  const TemporaryFolder folder;
  const TemporaryFolder temporary;
  writeFile(folder / "a.nii", Bytes(10, 0));
  const auto leave = [&](const char* name, std::chrono::minutes age) {
    std::filesystem::path left = temporary / name;
    writeFile(left / "answer", Bytes(10, 0));
    std::filesystem::last_write_time(left, std::filesystem::file_time_type::clock::now() - age);
    return left;
  };
  const auto killed = leave("glisson-import-killed", std::chrono::minutes(5));
  const auto young = leave("glisson-import-young", std::chrono::minutes(0));
  const auto running = leave("glisson-import-running", std::chrono::minutes(5));
  const auto foreign = leave("glisson-package", std::chrono::minutes(5));
  const int lock = open(running.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  setenv("TMPDIR", temporary.path().c_str(), 1);
  EXPECT_THROW(readCt(folder / "a.nii"), InputError);
  unsetenv("TMPDIR");
  close(lock);
  EXPECT_FALSE(std::filesystem::exists(killed));
  for (const std::filesystem::path& stays : {young, running, foreign}) {
    EXPECT_TRUE(std::filesystem::exists(stays / "answer")) << stays;
  }
}

TEST(HostileInput, AMissingChildAndAMissingFileAreNamed) {
  const TemporaryFolder folder;
  writeFile(folder / "a.nii", Bytes(10, 0));
  setenv("GLISSON_IMPORT", "/nonexistent/glisson-import", 1);
  EXPECT_NE(refusal([&] { return readCt(folder / "a.nii"); }).find("install Glisson again"), std::string::npos);
  unsetenv("GLISSON_IMPORT");
  EXPECT_NE(refusal([&] { return readCt(folder / "b.nii"); }).find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace glisson
