#pragma once
// A small synthetic patient for the window's tests: an ellipsoid liver of 180 mL with one tumour and a portal vein, off the origin,
// with a CT of the same grid. Built in well under a second.

#include <memory>

#include "planning/case/case.h"

namespace glisson::test {

inline Mask maskWhere(const ImageGeometry& grid, const std::function<bool(const Vec3&)>& inside) {
  std::vector<std::uint8_t> values(grid.voxelCount());
  std::size_t at = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i, ++at) {
        values[at] = inside(grid.toWorld(Vec3(i, j, k))) ? 1 : 0;
      }
    }
  }
  return Mask::fromGrid(grid.size, values);
}

inline ImageGeometry smallGrid() {
  ImageGeometry grid;
  grid.size = {56, 48, 40};
  grid.spacing = Vec3(2, 2, 2.5);
  grid.origin = Vec3(-90, 20, 300);
  return grid;
}

/// The middle of the small liver, mm LPS.
inline Vec3 smallCentre() { return {-34, 68, 350}; }

inline Case smallCase() {
  const ImageGeometry grid = smallGrid();
  const Vec3 centre = smallCentre();
  const auto ball = [](const Vec3& middle, double radius) {
    return [middle, radius](const Vec3& p) { return (p - middle).norm() <= radius; };
  };
  const auto add = [](Segmentation& to, const std::string& name, StructureKind kind, Mask mask) {
    LabelledMask labelled;
    labelled.name = name;
    labelled.label = 1;
    labelled.kind = kind;
    labelled.mask = std::make_shared<const Mask>(std::move(mask));
    to.structures.push_back(std::move(labelled));
  };
  auto segmentation = std::make_shared<Segmentation>();
  segmentation->geometry = grid;
  segmentation->source = "small patient";
  add(*segmentation, "liver", StructureKind::Liver,
      maskWhere(grid, [centre](const Vec3& p) { return (p - centre).cwiseQuotient(Vec3(40, 34, 32)).norm() <= 1.0; }));
  add(*segmentation, "tumour 1", StructureKind::Tumour, maskWhere(grid, ball(centre + Vec3(20, 0, 4), 8)));
  add(*segmentation, "portal vein", StructureKind::PortalVein, maskWhere(grid, [centre](const Vec3& p) {
    const Vec3 d = p - centre;
    return std::hypot(d.y() + 10, d.z() + 6) <= 5 && std::abs(d.x()) <= 24;
  }));
  auto ct = std::make_shared<CtVolume>();
  ct->geometry = grid;
  ct->hounsfield.assign(grid.voxelCount(), 60);
  ct->source = "small patient";
  ct->identity.patientName = "Small^Patient";
  ct->identity.patientId = "SP-17";
  ct->identity.birthDate = "19610203";
  ct->identity.studyDate = "20240506";
  return newCase(ct, segmentation);
}

}  // namespace glisson::test
