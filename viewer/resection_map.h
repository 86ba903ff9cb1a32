#pragma once
// Purpose: one plane of the plan as it is drawn: where it cuts the liver, how near the tumours are, which vessels it crosses. Drawn
// in 3D (section_actors.h) and flat (resectogram.h) from the same numbers and the same picture. Frame: mm LPS.

#include <QColor>
#include <QImage>
#include <optional>
#include <utility>
#include <vector>

#include "planning/volumetry/tumour_distance.h"
#include "reconstruction/image/structure_kind.h"
#include "viewer/plane_section.h"

namespace glisson {

struct ResectionMap {
  ResectionPlane plane;
  std::vector<Loop> outline;           ///< where it cuts the liver
  std::vector<ResectionPlane> within;  ///< the other planes of its resection: what lies outside of them is no resection surface
  /// The planes of each other resection: what lies inside of them all is resected on both sides, and no resection surface.
  std::vector<std::vector<ResectionPlane>> others;
  std::optional<MarginMap> margins;  ///< over the outline's rectangle; nothing where there is no tumour
  double safetyMarginMm = 10;
  std::vector<std::pair<Rgb, Loop>> vessels;  ///< crossed inside the liver, each in its structure's colour
};

/// A point of the plane is inside another resection where this far before it, away from its own resected side, all is resected.
inline constexpr double kBeforeMm = 1e-3;

inline constexpr double kIsoLineMm = 5.0;            ///< between two iso lines of the distance
inline constexpr double kFarthestMm = 40.0;          ///< no iso line beyond
inline constexpr QColor kMarginRed(255, 0, 0);       ///< nearer than the safety margin
inline constexpr QColor kMarginYellow(255, 255, 0);  ///< at the margin as measured, but its lower bound is not

/// The rectangle around the outline, in steps of `stepMm`; no points where there is no outline.
PlaneGrid gridOver(const std::vector<Loop>& outline, const HalfSpace& plane, double stepMm);

/// The map's rectangle in colour, transparent where the margin is kept: red and hatched where the distance is below the safety
/// margin, yellow where only its lower bound is, dark iso lines every kIsoLineMm. Row 0 is the grid's row 0; `pixels` for one step.
QImage marginPicture(const MarginMap& map, double safetyMarginMm, int pixels);

}  // namespace glisson
