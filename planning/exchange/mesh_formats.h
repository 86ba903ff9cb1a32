#pragma once
// Purpose: each mesh format's bytes, between toFloatMesh() and the file. Private to planning/exchange. All mm LPS, said in the
// bytes.

#include <string>
#include <string_view>
#include <vector>

#include "planning/exchange/float_mesh.h"

namespace glisson {

std::string stlBytes(const NamedMesh& mesh, const FloatMesh& floats);
std::string plyBytes(const NamedMesh& mesh, const FloatMesh& floats);
std::string objBytes(const NamedMesh& mesh, const FloatMesh& floats);
std::string vtpBytes(const NamedMesh& mesh, const FloatMesh& floats);
/// `floats` in the order of `meshes`.
std::string glbBytes(const std::vector<NamedMesh>& meshes, const std::vector<FloatMesh>& floats);

/// Root node matrix, column-major: mm LPS -> m, +Y up: x left, y superior, z anterior (clinical.md).
inline constexpr std::array<double, 16> kGlbRootMatrix{0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};

/// Parsers of bytes that may be hostile: counts are checked against the bytes that are there before memory is asked for. `file` is
/// for the message. Throw InputError. STL: three vertices per triangle, not welded.
SurfaceMesh parseStlSoup(std::string_view bytes, const std::string& file);
SurfaceMesh parsePly(std::string_view bytes, const std::string& file);
SurfaceMesh parseObj(std::string_view bytes, const std::string& file);
SurfaceMesh parseVtp(std::string_view bytes, const std::string& file);
/// The axes a header or comment states: `SPACE=RAS` files are turned into LPS (x and y change sign; no mirror).
void turnToLps(SurfaceMesh& mesh, std::string_view header);

}  // namespace glisson
