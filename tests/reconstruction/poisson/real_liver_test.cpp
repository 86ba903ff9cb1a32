// The engine on the liver, a tumour and the vessels of 3D-IRCADb-01's first patient: the errors of the reference codes, volumes,
// and few triangles. Skipped by name where the patient is not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "reconstruction/io/read.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/reconstruct.h"
#include "tests/support/real_data.h"

namespace glisson {
namespace {

/// What the reference code (PoissonRecon 18.75) makes of the same points; mm.
struct Reference {
  int depth;
  double pointWeight;
  double triangles, mean, median, p95, max;
};
constexpr std::array kReferences{
    Reference{5, 0, 5118, 1.114, 0.613, 4.292, 19.79},   Reference{6, 0, 21462, 0.544, 0.418, 1.486, 6.42},
    Reference{7, 0, 88114, 0.378, 0.332, 0.876, 3.69},   Reference{8, 0, 357420, 0.298, 0.266, 0.690, 3.30},
    Reference{9, 0, 1216778, 0.225, 0.201, 0.548, 3.14}, Reference{7, 8, 88874, 0.337, 0.303, 0.776, 3.42},
    Reference{8, 8, 360466, 0.255, 0.235, 0.610, 3.06}};
constexpr double kAsGood = 1.05;  // within five per cent, or better

class RealLiver : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = test::unpackedIrcadb01Masks();
    if (folder_ == nullptr) {
      GTEST_SKIP() << "skipped: no real data";
    }
    segmentation_ = readSegmentation(*folder_ / "MASKS_DICOM");
  }
  [[nodiscard]] const Mask& mask(const std::string& name) const {
    return *std::ranges::find(segmentation_.structures, name, &LabelledMask::name)->mask;
  }
  [[nodiscard]] const ImageGeometry& geometry() const { return segmentation_.geometry; }

 private:
  std::unique_ptr<test::TemporaryFolder> folder_;
  Segmentation segmentation_;
};

TEST_F(RealLiver, PaperPointsGiveTheReferencesErrorsAtEveryDepth) {
  for (const Reference& reference : kReferences) {
    ReconstructionParameters parameters;
    parameters.psr.depth = reference.depth;
    parameters.psr.pointWeight = reference.pointWeight;
    parameters.psr.sampling = Sampling::Paper;
    const Reconstruction made = reconstruct(mask("liver"), geometry(), StructureKind::Liver, parameters);
    const std::string what = parameters.describe();
    EXPECT_EQ(made.samples, 217718U);
    EXPECT_FALSE(made.defects.any()) << what;
    EXPECT_NEAR(static_cast<double>(made.mesh.triangles.size()) / reference.triangles, 1, 0.05) << what;
    const ErrorSummary error = paperError(made.mesh, mask("liver"), geometry()).value();
    EXPECT_LE(error.mean, kAsGood * reference.mean) << what;
    EXPECT_LE(error.median, kAsGood * reference.median) << what;
    EXPECT_LE(error.p95, kAsGood * reference.p95) << what;
    EXPECT_LE(error.max, kAsGood * reference.max) << what;
  }
}

TEST_F(RealLiver, TenThousandTrianglesOfDepth8AreNearerThanDepth7) {
  ReconstructionParameters parameters;
  parameters.psr.depth = 8;
  parameters.psr.sampling = Sampling::Paper;
  const Reconstruction whole = reconstruct(mask("liver"), geometry(), StructureKind::Liver, parameters);
  parameters.simplify = SimplifyTarget{.triangles = 10000};
  const Reconstruction made = reconstruct(mask("liver"), geometry(), StructureKind::Liver, parameters);
  EXPECT_EQ(made.mesh.triangles.size(), 10000U);
  EXPECT_FALSE(made.defects.any());
  EXPECT_EQ(countSelfIntersections(made.mesh), 0U);
  EXPECT_NEAR(made.meshVolumeMl / whole.meshVolumeMl, 1, 0.0005);
  const ErrorSummary error = paperError(made.mesh, mask("liver"), geometry()).value();
  EXPECT_LE(error.mean, 0.309);
  EXPECT_LE(error.p95, 0.74);
  EXPECT_LE(error.max, 3.4);

  parameters.psr.sampling = Sampling::Unbiased;
  const Reconstruction unbiased = reconstruct(mask("liver"), geometry(), StructureKind::Liver, parameters);
  EXPECT_FALSE(unbiased.defects.any());
  EXPECT_NEAR(unbiased.volumeDeviation(), 0, 0.0005);
}

TEST_F(RealLiver, FacesKeepTheVolumeOfLiverAndTumours) {
  const ReconstructionParameters parameters;
  EXPECT_NEAR(reconstruct(mask("liver"), geometry(), StructureKind::Liver, parameters).volumeDeviation(), 0, 0.0003);
  for (int n = 1; n <= 7; ++n) {
    const Reconstruction made = reconstruct(mask("livertumor0" + std::to_string(n)), geometry(), StructureKind::Tumour, parameters);
    EXPECT_FALSE(made.defects.any()) << n;
    EXPECT_NEAR(made.volumeDeviation(), 0, 0.005) << n;
  }
}

TEST_F(RealLiver, VesselsByScreenedPoissonKeepMoreThanDecimatedOnes) {
  for (const auto& [name, kind] :
       {std::pair("portalvein", StructureKind::PortalVein), {"venoussystem", StructureKind::HepaticVein}}) {
    ReconstructionParameters psr;
    psr.autoDepth = true;
    psr.psr.pointWeight = 16;
    psr.simplify = SimplifyTarget{.distanceMm = 0.3};
    const Reconstruction made = reconstruct(mask(name), geometry(), kind, psr);
    const Reconstruction chain = reconstruct(mask(name), geometry(), kind, ReconstructionParameters::defaultsFor(kind));
    EXPECT_FALSE(made.defects.any()) << name;
    EXPECT_LT(std::abs(made.volumeDeviation()), std::abs(chain.volumeDeviation())) << name;
    EXPECT_LT(made.mesh.triangles.size(), chain.mesh.triangles.size()) << name;
    EXPECT_GE(made.centrelineInside.value(), 0.99 * chain.centrelineInside.value()) << name;
  }
}

}  // namespace
}  // namespace glisson
