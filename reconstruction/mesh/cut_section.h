#pragma once
// Purpose: the parts of a cut: where the mesh is cut, how finely the halves are placed, the mesh split in two, and the section that
// closes both. Private to cut.cpp.

#include <functional>
#include <vector>

#include "reconstruction/mesh/cut.h"
#include "reconstruction/mesh/planar_fill.h"

namespace glisson::cutting {

inline constexpr double kOnPlaneMm = 1e-7;

/// The plane that cuts, or the surface over it.
struct Shape {
  HalfSpace plane;
  const std::function<double(const Vec3&)>* above = nullptr;  ///< null: flat
  double lift = 0;                                            ///< of the surface along the normal, mm
  double stepMm = 0;                                          ///< between the section's inner points; 0: it has none

  [[nodiscard]] double height(const Vec3& p) const {
    return above != nullptr ? (*above)(p)-lift : plane.normal.dot(p - plane.origin);
  }
  /// Where the edge from a to b crosses, 0..1; the heights there differ in sign.
  [[nodiscard]] double crossing(const Vec3& a, const Vec3& b, double heightA, double heightB) const;
  [[nodiscard]] Shape movedBy(double mm) const;
};

/// How finely the two halves are placed: exact, or on the places that floats have.
struct Grid {
  double onPlaneMm = kOnPlaneMm;
  bool floats = false;

  [[nodiscard]] Vec3 place(const Vec3& v) const {
    Vec3 placed = v;
    for (int axis = 0; floats && axis < 3; ++axis) {
      // Volatile, because GCC 12 at -O2 drops the way through float where it makes vectors of it.
      const volatile auto narrow = static_cast<float>(v[axis]);
      placed[axis] = static_cast<double>(narrow);
    }
    return placed;
  }
};

/// The mesh split along a plane; both parts and the section index the same vertices.
struct Split {
  std::vector<Vec3> vertices;
  std::vector<bool> onPlane;
  std::vector<Triangle> above;
  std::vector<Triangle> below;
  std::vector<Triangle> section;  ///< facing the plane's normal
};

/// Sides of `triangles` with both ends on the plane, sorted.
std::vector<BorderEdge> sidesOnPlane(const std::vector<Triangle>& triangles, const std::vector<bool>& onPlane);

/// Fills the section; over a plane with the corners of its border only. False where its border cannot be filled.
bool fillSection(Split& split, const Shape& shape, const Grid& grid);

}  // namespace glisson::cutting
