// What the sample patient's files say to Glisson's own readers: the same voxels in the same place, in every format.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/io/read.h"
#include "reconstruction/sample/sample_patient.h"
#include "reconstruction/sample/volume_writers.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;

class SampleRoundTrip : public testing::Test {
 protected:
  // Written once, read by every test.
  static void SetUpTestSuite() {
    patient_ = makeSamplePatient(false);
    folder_ = fs::path(testing::TempDir()) / "glisson_round_trip";
    fs::remove_all(folder_);
    writeSamplePatient(patient_, folder_);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static const LabelledMask& structure(const std::string& name) {
    return *std::find_if(patient_.segmentation.structures.begin(), patient_.segmentation.structures.end(),
                         [&](const LabelledMask& one) { return one.name == name; });
  }

  static SamplePatient patient_;
  static fs::path folder_;
};

SamplePatient SampleRoundTrip::patient_;  // NOLINT(cert-err58-cpp): an empty aggregate
fs::path SampleRoundTrip::folder_;        // NOLINT(cert-err58-cpp)

bool sameVoxels(const Mask& a, const Mask& b) {
  return a.box() == b.box() && std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end());
}

TEST_F(SampleRoundTrip, DicomSeriesGivesTheSameCtOfTheSamePatient) {
  const CtVolume ct = readCt(folder_ / "dicom");
  EXPECT_LT(ct.geometry.cornerDistance(patient_.ct.geometry), 1e-6);
  EXPECT_TRUE(ct.hounsfield == patient_.ct.hounsfield);
  EXPECT_EQ(ct.identity.patientId, "GLISSON-SAMPLE");
  EXPECT_EQ(ct.identity.frameOfReferenceUid, patient_.ct.identity.frameOfReferenceUid);
}

TEST_F(SampleRoundTrip, NiftiGivesTheSameCt) {
  const CtVolume ct = readCt(folder_ / "ct.nii.gz");
  EXPECT_LT(ct.geometry.cornerDistance(patient_.ct.geometry), 1e-3);  // NIfTI keeps single precision
  EXPECT_TRUE(ct.hounsfield == patient_.ct.hounsfield);
}

TEST_F(SampleRoundTrip, SegNrrdGivesNamesColoursKindsAndOverlappingMasks) {
  const Segmentation read = readSegmentation(folder_ / "segmentation.seg.nrrd");
  EXPECT_LT(read.geometry.cornerDistance(patient_.ct.geometry), 1e-6);
  ASSERT_EQ(read.structures.size(), patient_.segmentation.structures.size());
  for (const LabelledMask& found : read.structures) {
    const LabelledMask& given = structure(found.name);
    EXPECT_EQ(found.kind, given.kind) << found.name;
    EXPECT_EQ(found.colour, given.colour) << found.name;
    EXPECT_EQ(found.label, given.label) << found.name;
    EXPECT_TRUE(sameVoxels(*found.mask, *given.mask)) << found.name;
  }
}

TEST_F(SampleRoundTrip, ExclusiveLabelsGiveTheSameLiverAsNestedMasks) {
  ReadOptions options;
  for (const LabelledMask& given : patient_.segmentation.structures) {
    options.kindByLabel[given.label] = *given.kind;
  }
  const LiverVoxels nested = liverVoxels(readSegmentation(folder_ / "segmentation.seg.nrrd"));
  const LiverVoxels exclusive = liverVoxels(readSegmentation(folder_ / "labels.nii.gz", options));
  EXPECT_TRUE(sameVoxels(nested.tumour, exclusive.tumour));
  // A vessel that is cut out of the liver where it leaves it cannot be told from one outside.
  EXPECT_NEAR(exclusive.totalMl() / nested.totalMl(), 1, 0.002);
}

}  // namespace
}  // namespace glisson
