#pragma once
// Purpose: reads back the GLB files of this program without the library that wrote them, to prove axes, units, colours and
// geometry. Private to planning/exchange.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

struct GlbNode {
  std::string id;
  SurfaceMesh mesh;                    ///< vertices as in the file: mm LPS, before the root's matrix
  std::array<double, 4> baseColour{};  ///< linear
  std::string alphaMode;
  bool doubleSided = false;
};

struct GlbContent {
  std::array<double, 16> rootMatrix{};  ///< column-major
  std::vector<GlbNode> nodes;           ///< the root's children
};

/// `file` is for the message. Throws InputError on anything that is not such a GLB.
GlbContent parseGlb(std::string_view bytes, const std::string& file);

/// A point of the file in the scene's frame: metres, +Y up.
Vec3 toScene(const std::array<double, 16>& matrix, const Vec3& point);

}  // namespace glisson
