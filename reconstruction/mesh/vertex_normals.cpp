#include "reconstruction/mesh/vertex_normals.h"

#include <Eigen/Geometry>

namespace glisson {

std::vector<Vec3> vertexNormals(const SurfaceMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 area = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    for (const std::uint32_t corner : t) {
      normals[corner] += area;
    }
  }
  normalise(normals);
  return normals;
}

void normalise(std::vector<Vec3>& normals) {
  for (Vec3& normal : normals) {
    const double length = normal.norm();
    normal = length > 0 ? Vec3(normal / length) : Vec3(Vec3::UnitZ());
  }
}

}  // namespace glisson
