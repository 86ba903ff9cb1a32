#include "reconstruction/mesh/simplify.h"

#include <algorithm>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/collapser.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

/// Where a mesh of so few triangles crosses itself, more are kept.
SurfaceMesh simplifyToCount(const SurfaceMesh& mesh, std::size_t triangles, const ExecutionContext& context) {
  for (;;) {
    Collapser collapser(mesh, context);
    if (triangles >= mesh.triangles.size()) {
      return mesh;
    }
    collapser.run({.triangles = triangles}, context.range(0.0, 0.9));
    if (auto simplified = soundMesh(collapser, context)) {
      return *simplified;
    }
    triangles *= 2;
  }
}

/// The greatest distance between the two surfaces that is found: from the vertices of the given one to the simplified one, and
/// from the simplified one's vertices and triangle centres back.
double greatestDistance(const SurfaceMesh& given, const MeshDistance& toGiven, const SurfaceMesh& simplified,
                        const ExecutionContext& context) {
  std::vector<Vec3> back = simplified.vertices;
  back.reserve(back.size() + simplified.triangles.size());
  for (const Triangle& t : simplified.triangles) {
    back.push_back((simplified.vertices[t[0]] + simplified.vertices[t[1]] + simplified.vertices[t[2]]) / 3);
  }
  const auto forth = MeshDistance(simplified, context).to(given.vertices, context);
  const auto distances = toGiven.to(back, context);
  return std::max(*std::ranges::max_element(forth), *std::ranges::max_element(distances));
}

/// Collapses on as long as the measured distance allows, from a limit on the mean that is well on the safe side.
SurfaceMesh simplifyToDistance(const SurfaceMesh& mesh, double distanceMm, const ExecutionContext& context) {
  constexpr double kFirstShare = 0.1;  // the greatest distance is some ten times the mean
  constexpr double kNearEnough = 0.85;
  constexpr int kRestarts = 4;
  double rmsMm = kFirstShare * distanceMm;
  const MeshDistance toGiven(mesh, context);
  for (int restart = 0; restart < kRestarts; ++restart, rmsMm *= 0.25) {
    std::optional<SurfaceMesh> reached;
    Collapser collapser(mesh, context);
    for (double rms = rmsMm;;) {
      collapser.run({.rmsMm = rms}, context.range(0.0, 0.9));
      auto simplified = soundMesh(collapser, context);
      if (!simplified) {
        break;
      }
      const double worst = greatestDistance(mesh, toGiven, *simplified, context);
      if (worst > distanceMm) {
        break;
      }
      const bool stuck = reached && reached->triangles.size() == simplified->triangles.size();
      reached = std::move(simplified);
      if (worst > kNearEnough * distanceMm || stuck) {
        break;
      }
      rms *= std::clamp(0.9 * distanceMm / std::max(worst, 1e-9), 1.1, 2.0);
    }
    if (reached) {
      return *reached;
    }
  }
  return mesh;
}

}  // namespace

void SimplifyTarget::validate() const {
  if (triangles.has_value() == distanceMm.has_value()) {
    throw UsageError("Simplification needs either a number of triangles or a distance.");
  }
  if (triangles && *triangles < 4) {
    throw UsageError("Simplification needs 4 triangles or more, not " + std::to_string(*triangles) + ".");
  }
  if (distanceMm && !(*distanceMm > 0 && std::isfinite(*distanceMm))) {
    throw UsageError("The distance of simplification must be above 0 mm.");
  }
}

SurfaceMesh simplify(const SurfaceMesh& mesh, const SimplifyTarget& target, const ExecutionContext& context) {
  target.validate();
  if (mesh.empty()) {
    return mesh;
  }
  return target.triangles ? simplifyToCount(mesh, *target.triangles, context)
                          : simplifyToDistance(mesh, *target.distanceMm, context);
}

}  // namespace glisson
