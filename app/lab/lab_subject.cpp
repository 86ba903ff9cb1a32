#include "app/lab/lab_subject.h"

#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/stopwatch.h"

namespace glisson::lab {

LabSubject::LabSubject(std::shared_ptr<const Mask> mask, ImageGeometry geometry)
    : mask_(std::move(mask)), geometry_(std::move(geometry)) {}

double LabSubject::voxelVolumeMl() const { return volumeMl(*mask_, geometry_); }

const EvaluationReference& LabSubject::reference(const ExecutionContext& context) const {
  const std::lock_guard lock(making_);
  if (reference_ == nullptr) {
    reference_ = std::make_unique<const EvaluationReference>(*mask_, geometry_, context);
  }
  return *reference_;
}

const LabSamples& LabSubject::samples(Sampling sampling, const ExecutionContext& context) const {
  const std::lock_guard lock(sampling_);
  std::unique_ptr<const LabSamples>& kept = samples_[static_cast<std::size_t>(sampling)];
  if (kept == nullptr) {
    const Stopwatch stopwatch;
    LabSamples made{sampleBoundary(*mask_, geometry_, sampling, context), 0};
    made.seconds = stopwatch.seconds();
    kept = std::make_unique<const LabSamples>(std::move(made));
  }
  return *kept;
}

}  // namespace glisson::lab
