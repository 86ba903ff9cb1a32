#pragma once
// Purpose: single mesh files: binary STL, PLY, OBJ, VTP, GLB out; STL, PLY, OBJ, VTP in. All in mm LPS with `SPACE=LPS` said in the
// file. Floats only in the file: writers weld what collapses when rounded, drop degenerate triangles and re-check.

#include <filesystem>
#include <string>
#include <vector>

#include "planning/case/liver_model.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

struct NamedMesh {
  std::string id;  ///< file stem and GLB node name
  std::string name;
  Rgb colour;
  double opacity = 1.0;
  SurfaceMesh mesh;
};

/// The format is the extension: .stl .ply .obj .vtp .glb. Written to a temporary file beside, then renamed. Throws InputError
/// (cannot write), UsageError (unknown extension).
void writeMesh(const NamedMesh& mesh, const std::filesystem::path& path);
/// .stl (binary or ASCII), .ply, .obj, .vtp; vertices of STL are welded. Sizes are checked before allocation. Throws InputError.
SurfaceMesh readMesh(const std::filesystem::path& path);

/// The mesh as floats hold it: vertices rounded to float, equal ones welded, degenerate triangles dropped.
SurfaceMesh roundedToFloat(const SurfaceMesh& mesh);

/// One GLB with a node per mesh: root matrix mm LPS -> m, +Y up (clinical.md), PBR base colour, alphaMode BLEND below 1.
void writeGlb(const std::vector<NamedMesh>& meshes, const std::filesystem::path& path);

}  // namespace glisson
