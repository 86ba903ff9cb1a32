// A CT inside the case file: the same voxels, proven; its damage is its own and not the case's.

#include "planning/storage/embedded_ct.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "planning/storage/case_file.h"
#include "planning/storage/packing.h"
#include "planning/storage/sha256.h"
#include "planning/storage/table_access.h"
#include "reconstruction/errors.h"
#include "tests/planning/exchange/scratch.h"
#include "tests/planning/storage/run_sql.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson {
namespace {
using namespace test;
namespace fs = std::filesystem;

/// Three parts: 512 x 512 slices, eight of them in one.
Case caseWithCt() {
  const ImageGeometry g = gridOf({512, 512, 20}, Vec3(0.7, 0.7, 2.5), Vec3(-180, -170, 30));
  auto ct = std::make_shared<CtVolume>();
  ct->geometry = g;
  std::mt19937 random(17);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same volume every time
  ct->hounsfield.resize(g.voxelCount());
  for (std::size_t n = 0; n < ct->hounsfield.size(); ++n) {
    ct->hounsfield[n] = static_cast<std::int16_t>(n % 1000 < 990 ? 40 + static_cast<int>(random() % 31) : random());
  }
  ct->hounsfield.front() = -32768;
  ct->hounsfield[1] = 32767;
  ct->hounsfield.back() = -32768;
  ct->source = "/nowhere/ct.nii.gz";
  return newCase(ct, segmentationOf(g, {{"liver", StructureKind::Liver, ball(g.toWorld(Vec3(250, 250, 10)), 15)}}));
}

std::string refusalOf(const fs::path& file) {
  try {
    (void)CaseFile::open(file).embeddedCt();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(PackedVoxels, ComeBackWhateverTheyAreAndNothingElseIsTaken) {
  std::mt19937 random(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same values every time
  std::vector<std::int16_t> values{0, -1, 1, 32767, -32768, 32767, 0, -32768, -32768, 1};
  for (int n = 0; n < 5000; ++n) {
    values.push_back(static_cast<std::int16_t>(random()));
  }
  const Packed packed = packVoxels(values);
  EXPECT_EQ(unpackVoxels(packed.data, values.size()), values);
  EXPECT_TRUE(unpackVoxels(packVoxels({}).data, 0).empty());
  EXPECT_THROW((void)unpackVoxels(packed.data, values.size() - 1), std::runtime_error);
  EXPECT_THROW((void)unpackVoxels(packed.data, values.size() + 1), std::runtime_error);
  EXPECT_THROW((void)unpackVoxels(packed.data, std::size_t{1} << 40), std::runtime_error);
}

TEST(EmbeddedCt, ComesBackVoxelForVoxelWithItsGeometryInAFileOlderProgramsOpen) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const Case source = caseWithCt();
  { CaseFile::create(file, source, {}, {.embed = true}); }
  const CaseFile opened = CaseFile::open(file);
  EXPECT_TRUE(opened.hasEmbeddedCt());
  EXPECT_EQ(opened.load().ct, nullptr) << "the images are read when they are asked for";
  const std::shared_ptr<const CtVolume> ct = opened.embeddedCt();
  ASSERT_TRUE(ct);
  EXPECT_EQ(ct->hounsfield, source.ct->hounsfield);
  EXPECT_EQ(ct->geometry.origin, source.ct->geometry.origin);
  EXPECT_EQ(ct->geometry.spacing, source.ct->geometry.spacing);
  EXPECT_EQ(ct->geometry.size, source.ct->geometry.size);
  EXPECT_NE(ct->source.find("a.glisson"), std::string::npos);
  runSql(file, "PRAGMA user_version=2");
  EXPECT_EQ(CaseFile::open(file).load().code, source.code);
  const double told = static_cast<double>(embeddedCtBytes(*source.ct));
  EXPECT_NEAR(told / static_cast<double>(fs::file_size(file)), 1, 0.1);
  EXPECT_LT(fs::file_size(file), source.ct->hounsfield.size() * 2);
}

TEST(EmbeddedCt, IsThereOnlyWhereItWasAskedForAndNeedsACt) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  Case source = caseWithCt();
  { CaseFile::create(file, source); }
  EXPECT_FALSE(CaseFile::open(file).hasEmbeddedCt());
  EXPECT_EQ(CaseFile::open(file).embeddedCt(), nullptr);
  source.ct = nullptr;
  EXPECT_THROW(CaseFile::create(scratch.path / "b.glisson", source, {}, {.embed = true}), PlanningError);
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(EmbeddedCt, GoesOverIntoTheNextFileWithWhatTheOldOneKnowsOfTheCt) {
  const Scratch scratch;
  const fs::path image = scratch.path / "ct.nii.gz";
  std::ofstream(image) << "the images";
  Case source = caseWithCt();
  source.ctSource = image.string();
  const CaseFile first = CaseFile::create(scratch.path / "a.glisson", source, {}, {.embed = true});
  fs::remove(image);
  const Case read = first.load();  // as on a colleague's computer: no images but those in the file
  const CaseFile second = CaseFile::create(scratch.path / "b.glisson", read, {}, {.earlier = &first});
  EXPECT_EQ(second.embeddedCt()->hounsfield, source.ct->hounsfield);
  EXPECT_FALSE(second.ctUnchanged());
  std::ofstream(image) << "the images";
  EXPECT_TRUE(second.ctUnchanged()) << "what the images were is not forgotten where they cannot be read";
  std::ofstream(image) << "others";
  EXPECT_FALSE(CaseFile::create(scratch.path / "c.glisson", read, {}, {.earlier = &second}).ctUnchanged()) << "H2";
}

TEST(EmbeddedCt, ACopyOfACaseWhoseImagesWereOverwrittenOrAreMissingVouchesForNoOtherImages_H2) {
  const Scratch scratch;
  const fs::path image = scratch.path / "ct.nii.gz";
  std::ofstream(image) << "the images";
  Case source = caseWithCt();
  source.ctSource = image.string();
  const CaseFile first = CaseFile::create(scratch.path / "a.glisson", source, {}, {.embed = true});
  std::ofstream(image) << "another patient";
  const CaseFile copy = CaseFile::create(scratch.path / "b.glisson", source, {}, {.embed = true, .known = first.ctFiles()});
  EXPECT_EQ(copy.ctFiles(), first.ctFiles());
  EXPECT_FALSE(copy.ctUnchanged());
  const CaseFile kept = CaseFile::create(scratch.path / "c.glisson", source, {}, {.embed = true, .earlier = &first});
  EXPECT_FALSE(kept.ctUnchanged());
  fs::remove(image);
  const CaseFile unknown = CaseFile::create(scratch.path / "d.glisson", source, {}, {.embed = true});
  std::ofstream(image) << "another patient";
  const CaseFile later = CaseFile::create(scratch.path / "e.glisson", source, {}, {.earlier = &unknown});
  EXPECT_TRUE(later.ctFiles().empty());
  EXPECT_FALSE(later.ctUnchanged());
}

TEST(EmbeddedCt, DamageIsToldWithTheFilesNameAndTheCaseStillOpens) {
  const Scratch scratch;
  const fs::path whole = scratch.path / "whole.glisson";
  const fs::path file = scratch.path / "a.glisson";
  const Case source = caseWithCt();
  { CaseFile::create(whole, source, {}, {.embed = true}); }
  const std::string swapped =
      "UPDATE part SET key = 'ct/x' WHERE key = 'ct/0'; UPDATE part SET key = 'ct/0' WHERE key = 'ct/1';"
      "UPDATE part SET key = 'ct/1' WHERE key = 'ct/x'";
  for (const std::string& harm :
       {std::string("UPDATE part SET data = zeroblob(5000) WHERE key = 'ct/1'"),
        std::string("UPDATE part SET data = zeroblob(0) WHERE key GLOB 'ct/*'"), std::string("DELETE FROM part WHERE key = 'ct/2'"),
        swapped, std::string("UPDATE document SET json = replace(json, '0.7', '0.8') WHERE key = 'ct'"),
        std::string("UPDATE document SET json = '{}', crc = 2745614147 WHERE key = 'ct'")}) {
    fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
    runSql(file, harm);
    const std::string refusal = refusalOf(file);
    EXPECT_NE(refusal.find(file.string() + " holds an embedded CT that is damaged ("), std::string::npos) << harm << refusal;
    EXPECT_EQ(CaseFile::open(file).load().code, source.code) << harm;
  }
}

TEST(EmbeddedCt, OfAnotherGridOrAnImpossibleSizeIsRefusedBeforeMemoryIsTaken) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  Case source = caseWithCt();
  auto moved = std::make_shared<CtVolume>(*source.ct);
  moved->geometry.origin += Vec3(0, 0, 1);
  source.ct = moved;
  { CaseFile::create(file, source, {}, {.embed = true}); }
  EXPECT_NE(refusalOf(file).find("does not lie on the grid of the labels"), std::string::npos) << refusalOf(file);
  auto endless = std::make_shared<CtVolume>(*source.ct);
  endless->geometry.size = {60000, 60000, 60000};
  source.ct = endless;
  EXPECT_THROW(CaseFile::create(scratch.path / "b.glisson", source, {}, {.embed = true}), InputError);
  EXPECT_EQ(scratch.entries(), 1U) << "nothing is left of it";
}

TEST(EmbeddedCt, OfLargerPartsThanTheProgramMakesIsRefused) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  const Case source = caseWithCt();
  { CaseFile::create(file, source, {}, {.embed = true}); }
  {
    const std::span<const std::int16_t> voxels(source.ct->hounsfield);
    const Database database(file, Database::Mode::ReadWrite);
    auto json = Json::parse(caseTables::documentText(database, "ct"));
    EXPECT_EQ(json["slicesPerPart"], 8);
    json["slicesPerPart"] = 20;
    json["sha256"] = std::vector<std::string>{sha256Hex(std::as_bytes(voxels))};
    caseTables::putDocument(database, "ct", caseTables::textOf(json));
    caseTables::putPart(database, "ct/0", packVoxels(voxels));
  }
  EXPECT_NE(refusalOf(file).find("its size is impossible"), std::string::npos) << refusalOf(file);
}

TEST(EmbeddedCt, BringsNothingAboutThePatientThatTheCaseDoesNotHold_H8) {
  const Scratch scratch;
  const fs::path file = scratch.path / "a.glisson";
  Case source = caseWithCt();
  auto named = std::make_shared<CtVolume>(*source.ct);
  named->identity = {"Canary^Name", "CANARY-ID", "19000101", "19000202", "CANARY-SERIES", "1.2.999"};
  named->notes = {"CANARY-NOTE"};
  named->source = "/CANARY-FOLDER/ct.nii.gz";
  source.ct = named;
  { CaseFile::create(file, source, {}, {.embed = true}); }
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  for (const char* canary : {"Canary", "CANARY", "19000101", "19000202", "1.2.999"}) {
    EXPECT_EQ(bytes.find(canary), std::string::npos) << canary;
  }
  EXPECT_TRUE(CaseFile::open(file).embeddedCt()->identity.patientName.empty());
}

TEST(EmbeddedCt, ACancelLeavesNothing) {
  const Scratch scratch;
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(CaseFile::create(scratch.path / "a.glisson", caseWithCt(), {}, {.embed = true}, context), Cancelled);
  EXPECT_EQ(scratch.entries(), 0U);
}

}  // namespace
}  // namespace glisson
