#pragma once
// Purpose: livers with vessels whose territories are known by construction: a box with straight parallel branches that are joined
// outside it, so that the border between two of them is the plane halfway. mm.

#include <Eigen/Geometry>

#include "planning/territories/vessel_graph.h"
#include "tests/planning/voxel_bodies.h"

namespace glisson::test {

/// A tube with round ends.
inline Inside rod(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 way = to - from;
  return [=](const Vec3& p) {
    const double t = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (p - from - t * way).norm() <= radius;
  };
}

inline Inside anyOf(std::vector<Inside> parts) {
  return [parts = std::move(parts)](const Vec3& p) {
    return std::any_of(parts.begin(), parts.end(), [&](const Inside& part) { return part(p); });
  };
}

/// The fork's liver: x -40..40, y -20..20, z -20..40. Portal arms at x = -10 and x = 20 (y = -10), fed from below; hepatic veins at
/// the same x (y = 10), drained to a cava above. Both end 4 mm from the far side. The border between the arms is the plane x = 5.
inline const Vec3 kForkLow(-40, -20, -20);
inline const Vec3 kForkHigh(40, 20, 40);
inline constexpr double kForkBorder = 5;

inline Inside forkPortal() {
  return anyOf({rod({5, -10, -70}, {5, -10, -36}, 5), rod({-10, -10, -36}, {20, -10, -36}, 3),
                rod({-10, -10, -36}, {-10, -10, 36}, 3), rod({20, -10, -36}, {20, -10, 36}, 3)});
}
inline Inside forkVeins() {
  return anyOf({rod({-44, 10, 56}, {44, 10, 56}, 8), rod({-10, 10, 56}, {-10, 10, -16}, 3), rod({20, 10, 56}, {20, 10, -16}, 3)});
}

/// The fork moved by `place` (from the fork's frame to the world), on a grid of `spacing` along `direction`.
inline Case forkCase(const Vec3& spacing, const Eigen::Isometry3d& place = Eigen::Isometry3d::Identity(),
                     const Mat3& direction = Mat3::Identity()) {
  ImageGeometry g;
  g.spacing = spacing;
  g.direction = direction;
  // The grid's box, in its own directions, around the fork's box with all vessels; voxel faces lie on the fork's whole millimetres
  // where nothing is turned.
  const Mat3 turn = direction.transpose() * place.linear();
  const Vec3 low(-60, -24, -80);
  const Vec3 high(60, 24, 70);
  const Vec3 half = turn.cwiseAbs() * (0.5 * (high - low));
  const Vec3 middle = direction.transpose() * (place * Vec3(0.5 * (low + high)));
  for (int a = 0; a < 3; ++a) {
    g.size[static_cast<std::size_t>(a)] = static_cast<int>(std::ceil(2 * half[a] / spacing[a]));
  }
  g.origin = direction * (middle - half + 0.5 * spacing);
  const Eigen::Isometry3d back = place.inverse();
  const auto moved = [back](const Inside& inside) -> Inside { return [=](const Vec3& p) { return inside(back * p); }; };
  return newCase(nullptr, segmentationOf(g, {{"liver", StructureKind::Liver, moved(box(kForkLow, kForkHigh))},
                                             {"portal vein", StructureKind::PortalVein, moved(forkPortal())},
                                             {"hepatic veins", StructureKind::HepaticVein, moved(forkVeins())}}));
}

/// The graph of a fork's portal vein.
inline VesselGraph portalOf(const Case& source) {
  return vesselGraphOf(VesselSystem::Portal, *source.segmentation->structures[1].mask, source.liver->geometry, source.liver->liver);
}

/// The fork where it stands, on voxels of 1 mm.
inline const Case& forkCase() {
  static const Case fork = forkCase(Vec3(1, 1, 1));
  return fork;
}

/// The part of the fork's liver with x > border and low < z < high, as a resection of the fork's frame.
inline std::vector<ResectionPlane> forkSlab(double low, double high) {
  return {{Vec3(kForkBorder, 0, 0), Vec3::UnitX()}, {Vec3(0, 0, low), Vec3::UnitZ()}, {Vec3(0, 0, high), -Vec3::UnitZ()}};
}
/// mL of x > border between two heights.
inline double forkSlabMl(double low, double high) { return (40 - kForkBorder) * 40 * (high - low) * 1e-3; }

inline ResectionPlan moved(ResectionPlan plan, const Eigen::Isometry3d& place) {
  for (Resection& resection : plan.resections) {
    for (HalfSpace& plane : resection.planes) {
      plane = {place * plane.origin, place.linear() * plane.normal};
    }
  }
  return plan;
}

}  // namespace glisson::test
