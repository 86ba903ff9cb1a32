// Opening what a user points at: a patient's folder, a case, a case whose CT was replaced.
#include "app/gui/open_inputs.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "cube_file.h"
#include "planning/storage/case_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson {
namespace {

class OpenInputsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / ("glisson_open_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    writeSamplePatient(makeSamplePatient(false), folder_);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static OpenedCase open(const std::vector<std::filesystem::path>& paths) { return openInputs({.paths = paths, .options = {}}); }

  static inline std::filesystem::path folder_;
};

TEST_F(OpenInputsTest, ACaseForgetsNeitherTheCtNorWhereItLiesWhenTheFolderChanges) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  const OpenedCase opened = open({"ct.nii.gz", "segmentation.seg.nrrd"});
  std::filesystem::current_path(before);
  EXPECT_EQ(opened.content.ctSource, (folder_ / "ct.nii.gz").string());
  ASSERT_TRUE(readCtOf(opened.content));
}

TEST_F(OpenInputsTest, AReplacedCtIsNotShownUnderTheCaseOfAnother_H2) {
  const auto ct = folder_ / "other" / "ct.nii.gz";
  std::filesystem::create_directories(ct.parent_path());
  std::filesystem::copy_file(folder_ / "ct.nii.gz", ct);
  const auto file = folder_ / "a.glisson";
  const OpenedCase made = open({ct, folder_ / "segmentation.seg.nrrd"});
  { const CaseFile written = CaseFile::create(file, made.content); }
  EXPECT_EQ(open({file}).content.ctSource, ct.string());
  std::filesystem::remove(ct);
  std::filesystem::copy_file(folder_ / "labels.nii.gz", ct);  // the same grid, other values
  const OpenedCase reopened = open({file});
  EXPECT_EQ(reopened.content.ctSource, ct.string()) << "where it was is not forgotten";
  EXPECT_NE(reopened.noCt.find("is not the one this case was made from"), std::string::npos);
}

TEST_F(OpenInputsTest, AnEmbeddedCtIsShownWhereTheOneTheCaseNamesIsMissingOrAnother) {
  const auto ct = folder_ / "sent" / "ct.nii.gz";
  std::filesystem::create_directories(ct.parent_path());
  std::filesystem::copy_file(folder_ / "ct.nii.gz", ct);
  const auto file = folder_ / "sent.glisson";
  const OpenedCase made = open({ct, folder_ / "segmentation.seg.nrrd"});
  { const CaseFile written = CaseFile::create(file, made.content, {}, {.embed = true}); }
  const OpenedCase there = open({file});
  ASSERT_TRUE(there.content.ct);
  EXPECT_EQ(there.content.ct->source, ct.string()) << "the images are where the case says";
  std::filesystem::remove(ct);
  const OpenedCase missing = open({file});
  ASSERT_TRUE(missing.content.ct);
  EXPECT_EQ(missing.content.ct->hounsfield, made.content.ct->hounsfield);
  EXPECT_EQ(missing.content.ct->identity.patientId, made.content.identity.patientId);
  EXPECT_NE(missing.content.ctNotes.back().find("the CT embedded in the case is shown"), std::string::npos);
  std::filesystem::copy_file(folder_ / "labels.nii.gz", ct);
  const OpenedCase other = open({file});
  ASSERT_TRUE(other.content.ct) << "H2";
  EXPECT_EQ(other.content.ct->hounsfield, made.content.ct->hounsfield);
  EXPECT_EQ(other.content.ctSource, ct.string()) << "what it was made from is not forgotten";
}

TEST_F(OpenInputsTest, AnEmbeddedCtIsShownWhereTheOneTheCaseNamesCannotBeRead) {
  const auto ct = folder_ / "unreadable.nii.gz";
  std::ofstream(ct) << "no image";
  const auto file = folder_ / "unreadable.glisson";
  OpenedCase made = open({folder_ / "ct.nii.gz", folder_ / "segmentation.seg.nrrd"});
  made.content.ctSource = ct.string();
  { const CaseFile written = CaseFile::create(file, made.content, {}, {.embed = true}); }
  const OpenedCase opened = open({file});
  ASSERT_TRUE(opened.content.ct);
  EXPECT_EQ(opened.content.ct->hounsfield, made.content.ct->hounsfield);
  EXPECT_EQ(opened.content.ctNotes.back(), "The CT at " + ct.string() + " cannot be read: the CT embedded in the case is shown.");
}

TEST_F(OpenInputsTest, ADamagedEmbeddedCtIsANoteAndTheCaseOpens) {
  const auto file = folder_ / "harmed.glisson";
  OpenedCase made = open({folder_ / "ct.nii.gz", folder_ / "segmentation.seg.nrrd"});
  auto moved = std::make_shared<CtVolume>(*made.content.ct);
  moved->geometry.origin += Vec3(5, 0, 0);
  made.content.ct = moved;
  made.content.ctSource = "/nowhere/ct.nii.gz";
  { const CaseFile written = CaseFile::create(file, made.content, {}, {.embed = true}); }
  const OpenedCase opened = open({file});
  EXPECT_EQ(opened.content.ct, nullptr);
  EXPECT_EQ(opened.content.code, made.content.code);
  EXPECT_NE(opened.content.ctNotes.back().find("holds an embedded CT that is damaged"), std::string::npos);
}

TEST_F(OpenInputsTest, TheBuiltInPatientsCtIsMadeAgainFromItsCaseAndNothingElse) {
  const OpenedCase opened = openInputs({.paths = {}, .sample = true, .options = {}});
  EXPECT_EQ(opened.content.ctSource, kSampleSource);
  EXPECT_TRUE(readCtOf(opened.content));
  Case gone = opened.content;
  gone.ctSource = "/nowhere/ct.nii.gz";
  EXPECT_THROW(readCtOf(gone), InputError);
}

TEST_F(OpenInputsTest, TwoUnknownLabelsOfOneNameEachKeepTheirOwnAnswer) {
  OpenRequest request{.paths = {folder_ / "segmentation.seg.nrrd"}, .options = {}};
  request.readSoFar->segmentation = std::make_shared<Segmentation>(makeSamplePatient(false).segmentation);
  std::vector<LabelledMask>& masks = request.readSoFar->segmentation->structures;
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < masks.size() && unknown.size() < 2; ++i) {
    if (masks[i].kind == StructureKind::PortalVein || masks[i].kind == StructureKind::HepaticVein) {
      masks[i].kind.reset();
      masks[i].name = "label 64";
      unknown.push_back(i);
    }
  }
  ASSERT_EQ(openInputs(request).unknown.size(), 2U);
  request.answeredKinds = {StructureKind::Artery, StructureKind::BileDuct};
  const OpenedCase opened = openInputs(request);
  ASSERT_FALSE(opened.needsKinds());
  EXPECT_EQ(opened.content.segmentation->structures[unknown[0]].kind, StructureKind::Artery);
  EXPECT_EQ(opened.content.segmentation->structures[unknown[1]].kind, StructureKind::BileDuct);
}

TEST_F(OpenInputsTest, AFolderOfMasksBesideTheCtOpensAsOnePatient) {
  const auto patient = folder_ / "patient";
  std::filesystem::create_directories(patient);
  std::filesystem::copy(folder_ / "dicom", patient / "ct");
  std::filesystem::copy_file(folder_ / "segmentation.seg.nrrd", patient / "segmentation.seg.nrrd");
  const OpenedCase opened = open({patient});
  EXPECT_TRUE(opened.content.ct);
  EXPECT_EQ(opened.content.model->structures.size(), 7U);
}

TEST_F(OpenInputsTest, ThePictureOfLabelsThat3DIrcadbShipsIsNoSecondCt) {
  const auto patient = folder_ / "3Dircadb1.1";
  std::filesystem::create_directories(patient);
  std::filesystem::copy(folder_ / "dicom", patient / "PATIENT_DICOM");
  std::filesystem::copy(folder_ / "dicom", patient / "LABELLED_DICOM");
  std::filesystem::copy_file(folder_ / "segmentation.seg.nrrd", patient / "masks.seg.nrrd");
  const OpenedCase opened = open({patient});
  ASSERT_TRUE(opened.content.ct);
  EXPECT_EQ(opened.content.ct->source, (patient / "PATIENT_DICOM").string());
  EXPECT_EQ(opened.content.model->structures.size(), 7U);
}

TEST_F(OpenInputsTest, OrganFilesWithTheirCtBesideThemOpenAsOnePatient) {
  const auto patient = folder_ / "organs";
  test::writeCube<std::int16_t>(patient / "scan.nrrd", 100, -900);
  test::writeCube<std::uint8_t>(patient / "liver.nrrd", 1, 0);
  test::writeCube<std::uint8_t>(patient / "portal_vein.nrrd", 1, 0);
  const OpenedCase opened = open({patient});
  EXPECT_TRUE(opened.content.ct);
  EXPECT_EQ(opened.content.segmentation->structures.size(), 2U);
  EXPECT_TRUE(std::ranges::any_of(opened.content.notes,
                                  [](const std::string& note) { return note.starts_with("Not read as a mask: scan"); }));
}

TEST_F(OpenInputsTest, ACtAloneIsNoCaseAndNamedUntilItsSegmentationIsThere) {
  const auto ct = folder_ / "dicom";
  const OpenedCase alone = open({ct});
  EXPECT_EQ(alone.loneCt, ct);
  EXPECT_FALSE(alone.content.model);
  const OpenedCase both = open({ct, folder_ / "segmentation.seg.nrrd"});
  EXPECT_TRUE(both.loneCt.empty());
  EXPECT_TRUE(both.content.ct);
  EXPECT_TRUE(both.content.model);
}

/// A NIfTI header of side^3 bytes; its qform lies 5 mm beside its sform where `twoPlaces`.
std::string niftiHeader(std::int16_t side, bool twoPlaces) {
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(&header[at], &value, sizeof(value)); };
  put(0, std::int32_t{348});
  for (std::size_t n = 0; n < 4; ++n) {
    put(40 + 2 * n, n == 0 ? std::int16_t{3} : side);
    put(76 + 4 * n, 1.0F);
  }
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  put(108, 352.0F);
  put(252, std::int16_t{1});
  put(254, std::int16_t{1});
  put(268, twoPlaces ? 5.0F : 0.0F);
  for (std::size_t row = 0; row < 3; ++row) {
    put(280 + 20 * row, 1.0F);
  }
  std::memcpy(&header[344], "n+1", 4);
  return header;
}

TEST_F(OpenInputsTest, ARefusedImageWhoseNameSaysNothingIsRefusedForItsOwnReason) {
  const auto said = [&](const char* name, const std::string& bytes) -> std::string {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    try {
      open({folder_ / name});
    } catch (const InputError& refusal) {
      return refusal.what();
    }
    return "accepted";
  };
  EXPECT_NE(said("scan.nii", niftiHeader(8, false) + std::string(100, '\1')).find("is cut off"), std::string::npos);
  EXPECT_NE(said("scan2.nii", niftiHeader(8, true) + std::string(512, '\1')).find("lies in two places"), std::string::npos);
  EXPECT_NE(said("letter.txt", "Dear doctor").find("of no known format"), std::string::npos);
}

}  // namespace
}  // namespace glisson
