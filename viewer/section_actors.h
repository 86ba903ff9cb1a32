#pragma once
// Purpose: where one plane of the plan cuts the liver: fill and grid lie in the model's renderer, the outline in the overlay, where
// nothing hides it. Only the part of the plane that bounds its resection is drawn. Frame: mm LPS.

#include <memory>
#include <vector>

#include "viewer/plane_section.h"

class vtkRenderer;

namespace glisson {

inline constexpr double kGridMm = 10.0;

class SectionActors {
 public:
  /// `strong`: the plane that is worked on; the others are drawn thinner.
  SectionActors(vtkRenderer* model, vtkRenderer* overlay, bool strong);
  ~SectionActors();
  SectionActors(const SectionActors&) = delete;
  SectionActors& operator=(const SectionActors&) = delete;

  void setVisible(bool visible);
  /// `within`: the other planes of the same resection; what lies outside of them is not drawn.
  void setSection(const HalfSpace& plane, const std::vector<Loop>& loops, const std::vector<HalfSpace>& within);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
