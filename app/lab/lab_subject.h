#pragma once
// Purpose: the structure that methods are compared on, with what its models are measured against. Shared between jobs.

#include <array>
#include <memory>
#include <mutex>

#include "reconstruction/evaluation/measures.h"
#include "reconstruction/poisson/samples.h"

namespace glisson::lab {

/// A mask's boundary, sampled once for PSR of all depths.
struct LabSamples {
  OrientedPoints points;
  double seconds = 0;  ///< what sampling took
};

class LabSubject {
 public:
  LabSubject(std::shared_ptr<const Mask> mask, ImageGeometry geometry);

  [[nodiscard]] const Mask& mask() const { return *mask_; }
  [[nodiscard]] const ImageGeometry& geometry() const { return geometry_; }
  [[nodiscard]] double voxelVolumeMl() const;
  /// Made by the first who asks, which takes about a second; others wait for it. Any thread. Throws as EvaluationReference's
  /// constructor; then the next one tries again.
  const EvaluationReference& reference(const ExecutionContext& context = {}) const;
  /// Likewise; a few hundredths of a second. Throws as sampleBoundary().
  const LabSamples& samples(Sampling sampling, const ExecutionContext& context = {}) const;

 private:
  std::shared_ptr<const Mask> mask_;
  ImageGeometry geometry_;
  mutable std::mutex making_;
  mutable std::unique_ptr<const EvaluationReference> reference_;
  mutable std::mutex sampling_;
  mutable std::array<std::unique_ptr<const LabSamples>, 2> samples_;  ///< by Sampling
};

}  // namespace glisson::lab
