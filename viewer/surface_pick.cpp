#include "viewer/surface_pick.h"

#include <Eigen/Geometry>

namespace glisson {

std::optional<double> firstHit(const SurfaceMesh& mesh, const Ray& ray) {
  // Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
  std::optional<double> nearest;
  for (const auto& triangle : mesh.triangles) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3 ab = mesh.vertices[triangle[1]] - a;
    const Vec3 ac = mesh.vertices[triangle[2]] - a;
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) {
      continue;
    }
    const Vec3 from = ray.origin - a;
    const double u = from.dot(p) / determinant;
    if (u < 0 || u > 1) {
      continue;
    }
    const Vec3 q = from.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    const double along = ac.dot(q) / determinant;
    if (v >= 0 && u + v <= 1 && along > 0 && (!nearest || along < *nearest)) {
      nearest = along;
    }
  }
  return nearest;
}

}  // namespace glisson
