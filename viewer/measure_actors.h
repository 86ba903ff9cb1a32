#pragma once
// Purpose: the distances that a plan keeps, each a line with its length, in the overlay, where nothing hides them. Frame: mm LPS.

#include <memory>
#include <vector>

#include "planning/resection/resection_plan.h"

class vtkRenderer;

namespace glisson {

class MeasureActors {
 public:
  explicit MeasureActors(vtkRenderer* overlay);
  ~MeasureActors();

  /// What is not among them any more goes.
  void setMeasures(const std::vector<Measure>& measures);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
