#pragma once
// Purpose: analytic bodies as structures and models, for the views' tests. mm LPS.

#include <cmath>
#include <memory>
#include <numbers>

#include "planning/case/liver_model.h"

namespace glisson::test {

/// A closed sphere of 2 * rings * 2 * rings triangles, counter-clockwise outward.
inline SurfaceMesh sphere(const Vec3& centre, const Vec3& radii, int rings = 24) {
  SurfaceMesh mesh;
  const int sectors = 2 * rings;
  mesh.vertices.emplace_back(centre + Vec3(0, 0, radii.z()));
  for (int r = 1; r < rings; ++r) {
    const double polar = std::numbers::pi * r / rings;
    for (int s = 0; s < sectors; ++s) {
      const double azimuth = 2 * std::numbers::pi * s / sectors;
      mesh.vertices.emplace_back(centre + radii.cwiseProduct(Vec3(std::sin(polar) * std::cos(azimuth),
                                                                  std::sin(polar) * std::sin(azimuth), std::cos(polar))));
    }
  }
  mesh.vertices.emplace_back(centre - Vec3(0, 0, radii.z()));
  const auto at = [&](int ring, int sector) { return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors); };
  const auto south = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (int s = 0; s < sectors; ++s) {
    mesh.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (int r = 1; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
    mesh.triangles.push_back({at(rings - 1, s), south, at(rings - 1, s + 1)});
  }
  return mesh;
}

inline Structure structure(const std::string& id, StructureKind kind, Rgb colour, double opacity, SurfaceMesh mesh) {
  auto made = std::make_shared<Reconstruction>();
  made->mesh = std::move(mesh);
  Structure result;
  result.id = id;
  result.name = id;
  result.kind = kind;
  result.colour = colour;
  result.opacity = opacity;
  result.reconstruction = std::move(made);
  return result;
}

inline constexpr Rgb kLiverColour{221, 130, 101};
inline const Vec3 kLiverRadii(90, 60, 50);

/// A liver-like ellipsoid about the origin with two opaque balls beside it: pure green at the patient's left and head, pure blue
/// at the patient's front and feet. No view of it is the mirror image of another.
inline std::shared_ptr<const LiverModel> asymmetricModel(double liverOpacity = 0.35, int rings = 24) {
  auto model = std::make_shared<LiverModel>();
  model->revision = 1;
  model->structures.push_back(
      structure("parenchyma", StructureKind::Liver, kLiverColour, liverOpacity, sphere(Vec3::Zero(), kLiverRadii, rings)));
  model->structures.push_back(
      structure("tumour_01", StructureKind::Tumour, {0, 255, 0}, 1.0, sphere(Vec3(105, 0, 40), Vec3(12, 12, 12))));
  model->structures.push_back(
      structure("artery", StructureKind::Artery, {0, 0, 255}, 1.0, sphere(Vec3(0, -80, -40), Vec3(12, 12, 12))));
  return model;
}

}  // namespace glisson::test
