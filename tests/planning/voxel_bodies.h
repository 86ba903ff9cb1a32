#pragma once
// Purpose: voxelised analytic bodies and cases made of them, for the tests of volumes, cases and storage. mm LPS.

#include <functional>
#include <initializer_list>
#include <random>

#include "planning/case/case.h"

namespace glisson::test {

using Inside = std::function<bool(const Vec3& world)>;

inline ImageGeometry gridOf(const Index3& size, const Vec3& spacing, const Vec3& origin = Vec3::Zero()) {
  ImageGeometry geometry;
  geometry.size = size;
  geometry.spacing = spacing;
  geometry.origin = origin;
  return geometry;
}

/// The voxels whose centre lies inside.
inline std::shared_ptr<const Mask> voxelised(const ImageGeometry& geometry, const Inside& inside) {
  std::vector<std::uint8_t> values(geometry.voxelCount());
  std::size_t at = 0;
  for (int k = 0; k < geometry.size[2]; ++k) {
    for (int j = 0; j < geometry.size[1]; ++j) {
      for (int i = 0; i < geometry.size[0]; ++i) {
        values[at++] = inside(geometry.toWorld(Vec3(i, j, k))) ? 1 : 0;
      }
    }
  }
  return std::make_shared<const Mask>(Mask::fromGrid(geometry.size, values));
}

inline Inside ball(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() <= radius; };
}

/// A cylinder without ends around the line through `point`.
inline Inside tube(const Vec3& point, const Vec3& axis, double radius) {
  const Vec3 unit = axis.normalized();
  return [=](const Vec3& p) { return ((p - point) - unit * unit.dot(p - point)).norm() <= radius; };
}

inline Inside box(const Vec3& low, const Vec3& high) {
  return [=](const Vec3& p) { return (p - low).minCoeff() > 0 && (high - p).minCoeff() > 0; };
}

inline Vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

struct Body {
  std::string name;
  StructureKind kind = StructureKind::Liver;
  Inside inside;
};

inline std::shared_ptr<Segmentation> segmentationOf(const ImageGeometry& geometry, std::initializer_list<Body> bodies) {
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->geometry = geometry;
  segmentation->source = "bodies";
  for (const Body& body : bodies) {
    LabelledMask structure;
    structure.name = body.name;
    structure.label = static_cast<int>(segmentation->structures.size()) + 1;
    structure.kind = body.kind;
    structure.mask = voxelised(geometry, body.inside);
    segmentation->structures.push_back(std::move(structure));
  }
  return segmentation;
}

inline ResectionPlan planOf(std::initializer_list<std::vector<ResectionPlane>> resections) {
  ResectionPlan plan;
  plan.name = "Plan 1";
  for (const auto& planes : resections) {
    plan.resections.push_back({"Resection " + std::to_string(plan.resections.size() + 1), planes});
  }
  return plan;
}

}  // namespace glisson::test
