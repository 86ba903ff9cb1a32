#pragma once
// Purpose: planes from what the user clicks and draws. Frame: mm LPS. Every normal is unit and points to the resected side; which
// side that is follows from the gesture, and flipped() gives the other one.
// Throws PlanningError where the gesture gives no plane (points in line, a direction of no length, numbers that are not finite).

#include "planning/resection/resection_plan.h"
#include "reconstruction/image/image_geometry.h"

namespace glisson {

/// The plane as the user sees it: through `point` (the liver's centre for the first plane, or a clicked point), its normal to the
/// right of the picture seen from the camera (perpendicular to view direction and up), so the cut is seen edge-on. In a perspective
/// view the direction is that from the eye to the point, else the plane is not seen edge-on there.
HalfSpace planeFromCamera(const Vec3& point, const Vec3& viewDirection, const Vec3& viewUp);

/// Through three clicked points, the origin in their middle. The side from which a, b, c run counter-clockwise is resected.
HalfSpace planeThroughPoints(const Vec3& a, const Vec3& b, const Vec3& c);

/// A line drawn across the view from `a` to `b`, continued along the view direction: what lies to the right of the stroke is
/// resected, so a stroke drawn upwards resects the right of the picture, as planeFromCamera() does.
HalfSpace planeOfLine(const Vec3& a, const Vec3& b, const Vec3& viewDirection);
/// The same in a perspective view: the plane holds the eye and both points.
HalfSpace planeOfLineFromEye(const Vec3& a, const Vec3& b, const Vec3& eye);

enum class SlicePlane : std::uint8_t { Axial, Coronal, Sagittal };
/// "axial", "coronal", "sagittal".
std::string_view idOf(SlicePlane slice);
/// Parallel to the slices that a view of this name shows: those of the image axis that is nearest to superior, posterior or left.
/// Resected is what lies superior, posterior or left of it.
HalfSpace planeParallelToSlice(const ImageGeometry& geometry, SlicePlane slice, const Vec3& point);

}  // namespace glisson
