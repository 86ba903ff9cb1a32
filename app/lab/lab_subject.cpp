#include "app/lab/lab_subject.h"

#include "reconstruction/image/liver_voxels.h"

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

}  // namespace glisson::lab
