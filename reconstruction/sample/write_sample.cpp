#include <unistd.h>

#include <string>
#include <system_error>

#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/sample/gzip_file.h"
#include "reconstruction/sample/sample_patient.h"
#include "reconstruction/sample/volume_writers.h"

namespace glisson {

namespace {

namespace fs = std::filesystem;

/// A folder beside the target that is gone at the end, whatever happens, unless it was handed over.
class DraftFolder {
 public:
  explicit DraftFolder(const fs::path& target)
      : path_(target.parent_path() / ("." + target.filename().string() + ".part-" + std::to_string(getpid()))) {
    std::error_code failure;
    fs::create_directories(path_, failure);
    if (failure) {
      throw InputError(target.string() + " cannot be made (" + failure.message() + "); choose a folder that can be written to.");
    }
  }
  ~DraftFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Json pointJson(const Vec3& p) { return {p[0], p[1], p[2]}; }

Json pointsJson(const std::vector<Vec3>& points) {
  auto list = Json::array();
  for (const Vec3& p : points) {
    list.push_back(pointJson(p));
  }
  return list;
}

std::string truthText(const SamplePatient& patient) {
  const SampleTruth& truth = patient.truth;
  const ImageGeometry& geometry = patient.ct.geometry;
  Json json;
  json["frame"] = "LPS";
  json["sizeVoxels"] = geometry.size;
  json["spacingMm"] = pointJson(geometry.spacing);
  json["originMm"] = pointJson(geometry.origin);
  json["liverMl"] = truth.liverMl;
  json["portalVeinMl"] = truth.portalVeinMl;
  json["hepaticVeinMl"] = truth.hepaticVeinMl;
  json["gallbladderMl"] = truth.gallbladderMl;
  json["tumourMl"] = truth.tumourMl;
  json["portalBranchPointsMm"] = pointsJson(truth.portalBranchPoints);
  json["hepaticBranchPointsMm"] = pointsJson(truth.hepaticBranchPoints);
  return json.dump(1) + "\n";
}

fs::path checkedTarget(const fs::path& directory) {
  std::error_code failure;
  fs::path target = fs::weakly_canonical(fs::absolute(directory), failure);
  if (failure || target.filename().empty()) {
    throw InputError(directory.string() + " is no folder the sample patient can be written to; choose another one.");
  }
  const bool there = fs::exists(target, failure);
  if (there && !fs::is_directory(target, failure)) {
    throw InputError(directory.string() + " is a file; choose a new or empty folder for the sample patient.");
  }
  if (there && !fs::is_empty(target, failure)) {
    throw InputError(directory.string() + " is not empty; choose a new or empty folder for the sample patient.");
  }
  if (failure) {
    throw InputError(directory.string() + " cannot be looked into (" + failure.message() + "); choose another folder.");
  }
  return target;
}

void writeAll(const SamplePatient& patient, const fs::path& folder, const ExecutionContext& context) {
  const bool thin = patient.ct.geometry.spacing[2] < 1;
  fs::create_directory(folder / "dicom");
  sample::writeDicomSeries(folder / "dicom", patient.ct, thin ? 2 : 1, context.range(0.0, 0.4));
  context.report(0.4, "NIfTI");
  sample::writeNifti(folder / "ct.nii.gz", patient.ct.geometry, std::span<const std::int16_t>(patient.ct.hounsfield));
  context.report(0.7, "labels");
  const std::vector<std::uint8_t> labels = sample::exclusiveLabels(patient.segmentation);
  sample::writeNifti(folder / "labels.nii.gz", patient.segmentation.geometry, std::span<const std::uint8_t>(labels));
  context.report(0.8, "segmentation");
  sample::writeSegNrrd(folder / "segmentation.seg.nrrd", patient.segmentation);
  sample::writeFile(folder / "truth.json", sample::bytesOf(truthText(patient)));
  context.report(1.0, "sample patient");
}

}  // namespace

void writeSamplePatient(const SamplePatient& patient, const fs::path& directory, const ExecutionContext& context) {
  const fs::path target = checkedTarget(directory);
  const DraftFolder draft(target);
  writeAll(patient, draft.path(), context);
  std::error_code failure;
  if (!fs::exists(target)) {
    fs::rename(draft.path(), target, failure);
  } else {
    // An empty folder stays the folder it is (someone may stand in it); its content arrives in one go per entry.
    for (const auto& entry : fs::directory_iterator(draft.path())) {
      fs::rename(entry.path(), target / entry.path().filename(), failure);
      if (failure) {
        break;
      }
    }
  }
  if (failure) {
    throw Error(target.string() + " could not be put in place (" + failure.message() + "); choose another folder.");
  }
}

}  // namespace glisson
