#pragma once
// Purpose: a small case with everything an export needs: a spherical liver, a tumour, a portal vein, masks and meshes, one plane.

#include "planning/case/case.h"
#include "planning/exchange/package.h"
#include "tests/planning/exchange/bodies.h"

namespace glisson::test {

inline const Vec3 kLiverCentre{-50.0, -20.0, 300.0};
inline constexpr double kLiverRadiusMm = 40.0;
inline const Vec3 kTumourCentre{-65.0, -20.0, 300.0};
inline constexpr double kTumourRadiusMm = 8.0;

inline ImageGeometry syntheticGeometry() {
  ImageGeometry geometry;
  geometry.size = {48, 48, 48};
  geometry.spacing = Vec3::Constant(2.0);
  geometry.origin = kLiverCentre - Vec3::Constant(47.0);
  return geometry;
}

inline std::shared_ptr<const Mask> ballMask(const ImageGeometry& geometry, const Vec3& centre, double radiusMm) {
  std::vector<std::uint8_t> values(geometry.voxelCount());
  std::size_t at = 0;
  for (int k = 0; k < geometry.size[2]; ++k) {
    for (int j = 0; j < geometry.size[1]; ++j) {
      for (int i = 0; i < geometry.size[0]; ++i) {
        values[at++] = (geometry.toWorld(Vec3(i, j, k)) - centre).norm() <= radiusMm ? 1 : 0;
      }
    }
  }
  return std::make_shared<const Mask>(Mask::fromGrid(geometry.size, values));
}

inline Structure withMesh(Structure structure, SurfaceMesh mesh) {
  auto made = std::make_shared<Reconstruction>();
  made->parameters = ReconstructionParameters::defaultsFor(structure.kind);
  made->meshVolumeMl = signedVolumeMm3(mesh) / 1000;
  made->voxelVolumeMl = made->meshVolumeMl;
  made->mesh = std::move(mesh);
  structure.reconstruction = std::move(made);
  return structure;
}

inline void replaceStructure(Case& source, const std::string& id, const std::function<void(Structure&, Reconstruction&)>& change) {
  auto model = std::make_shared<LiverModel>(*source.model);
  for (Structure& structure : model->structures) {
    if (structure.id == id) {
      auto made = structure.reconstruction ? std::make_shared<Reconstruction>(*structure.reconstruction)
                                           : std::make_shared<Reconstruction>();
      change(structure, *made);
      structure.reconstruction = std::move(made);
    }
  }
  ++model->revision;
  source.model = std::move(model);
}

/// One plane 3 mm off the centre, at right angles to x, resecting the side of the tumour.
inline Case syntheticCase() {
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->geometry = syntheticGeometry();
  const ImageGeometry& g = segmentation->geometry;
  segmentation->structures = {{"liver", 1, StructureKind::Liver, std::nullopt, ballMask(g, kLiverCentre, kLiverRadiusMm)},
                              {"livertumor01", 2, StructureKind::Tumour, std::nullopt, ballMask(g, kTumourCentre, kTumourRadiusMm)},
                              {"portalvein", 3, StructureKind::PortalVein, std::nullopt, ballMask(g, kLiverCentre, 5.0)}};
  Case made = newCase(nullptr, segmentation);
  made.code = "G-00C0DE";
  auto model = std::make_shared<LiverModel>(*made.model);
  for (Structure& structure : model->structures) {
    if (structure.id == "parenchyma") {
      structure = withMesh(structure, sphere(kLiverCentre, kLiverRadiusMm, 4));
    } else if (structure.id == "tumour_01") {
      structure = withMesh(structure, sphere(kTumourCentre, kTumourRadiusMm, 3));
    } else {
      structure = withMesh(structure, sphere(kLiverCentre, 5.0, 2));
    }
  }
  made.model = std::move(model);
  made.plans = {{"Left \xC3\xA4/ plan", {{"Resection 1", {{kLiverCentre - Vec3(3, 0, 0), -Vec3::UnitX()}}}}, 10.0}};
  return made;
}

/// A package's folder then has a name that is known beforehand.
inline ExportOptions stamped() {
  ExportOptions options;
  options.timestamp = "20260102-0304";
  return options;
}

}  // namespace glisson::test
