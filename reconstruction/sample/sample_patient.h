#pragma once
// Purpose: the built-in synthetic patient: liver with two lobes, fissure and gallbladder bed, portal and hepatic venous trees,
// three tumours, a gallbladder; CT with noise and partial volume. The same bytes every time on every machine. No real patient went
// into it.

#include <filesystem>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/segmentation.h"

namespace glisson {

struct SampleTruth {
  double liverMl = 0;  ///< analytic, by quadrature far finer than the voxels
  std::vector<double> tumourMl;
  double portalVeinMl = 0;
  double hepaticVeinMl = 0;
  double gallbladderMl = 0;
  std::vector<Vec3> portalBranchPoints;  ///< mm LPS
  std::vector<Vec3> hepaticBranchPoints;
};

struct SamplePatient {
  CtVolume ct;
  Segmentation segmentation;  ///< liver nests the tumours; names and colours as in .seg.nrrd
  SampleTruth truth;
};

/// CtVolume::source and Segmentation::source of the built-in patient, which has no file.
inline constexpr const char* kSampleSource = "sample patient";

/// thin: 0.8 mm slices and branches down to 2 mm instead of 2.5 mm and 3 mm.
SamplePatient makeSamplePatient(bool thin, const ExecutionContext& context = {});

/// Writes DIR/dicom/ (CT series), DIR/ct.nii.gz, DIR/segmentation.seg.nrrd, DIR/labels.nii.gz, DIR/truth.json. DIR must be missing
/// or empty, else InputError and nothing is written.
void writeSamplePatient(const SamplePatient& patient, const std::filesystem::path& directory, const ExecutionContext& context = {});

}  // namespace glisson
