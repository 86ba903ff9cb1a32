#pragma once
// Purpose: one plane of the plan in 3D: fill, grid and margin colours lie in the model's renderer, the outlines of liver and
// crossed vessels in the overlay, where nothing hides them. Only the part that bounds the plan's region is drawn. Frame: mm LPS.

#include <QImage>
#include <memory>

#include "viewer/resection_map.h"

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
  /// `margins`: marginPicture() of the map; null where there is none.
  void setSection(const ResectionMap& map, const QImage& margins);

 private:
  void setFill(const ResectionMap& map);
  void setGrid(const ResectionMap& map);
  void setMargins(const ResectionMap& map, const QImage& margins);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
