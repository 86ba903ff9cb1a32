#include "planning/exchange/package_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/exchange/mesh_formats.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr double kToleranceMm = 1e-4;
constexpr int kDecimals = 6;
}  // namespace

MeshFigures figuresOf(const PackageMesh& mesh, const FloatMesh& floats) {
  MeshFigures figures;
  figures.triangles = floats.triangles.size();
  figures.bounds = boundsOf(mesh.named.mesh);
  figures.areaMm2 = areaMm2(mesh.named.mesh);
  figures.closed = mesh.closed;
  figures.volumeMm3 = mesh.closed ? signedVolumeMm3(mesh.named.mesh) : 0.0;
  return figures;
}

double fileToleranceMm(const Bounds& bounds) {
  Vec3 rounding;
  for (int axis = 0; axis < 3; ++axis) {
    const auto farthest = static_cast<float>(std::max(std::abs(bounds.low[axis]), std::abs(bounds.high[axis])));
    const float next = std::nextafter(farthest, std::numeric_limits<float>::max());
    rounding[axis] = 0.5 * (static_cast<double>(next) - static_cast<double>(farthest));
  }
  return std::max(kToleranceMm, rounding.norm());
}

std::string differenceFrom(const MeshFigures& figures, const SurfaceMesh& read) {
  if (read.triangles.size() != figures.triangles) {
    return "has " + std::to_string(read.triangles.size()) + " triangles instead of " + std::to_string(figures.triangles);
  }
  if (read.empty()) {
    return "has no triangles";
  }
  const double tolerance = fileToleranceMm(figures.bounds);
  const Bounds bounds = boundsOf(read);
  const double off =
      std::max((bounds.low - figures.bounds.low).cwiseAbs().maxCoeff(), (bounds.high - figures.bounds.high).cwiseAbs().maxCoeff());
  if (!(off <= tolerance)) {
    return "has bounds that are off by " + formatNumber(off, kDecimals) + " mm";
  }
  const double area = areaMm2(read);
  if (!figures.closed) {
    // Moving every corner by the tolerance changes an area by no more than the edges' lengths; 1e-3 of it is far beyond rounding.
    return std::abs(area - figures.areaMm2) <= 1e-3 * figures.areaMm2 ? "" : "has an area of " + formatNumber(area, 3) + " mm2";
  }
  const double volume = signedVolumeMm3(read);
  if (!(volume > 0)) {
    return "is turned inside out";
  }
  if (!(std::abs(volume - figures.volumeMm3) <= figures.areaMm2 * tolerance)) {
    return "has a volume of " + formatNumber(volume / 1000, kDecimals) + " mL instead of " +
           formatNumber(figures.volumeMm3 / 1000, kDecimals) + " mL";
  }
  return {};
}

std::string differenceFrom(const PackageMesh& original, const FloatMesh& floats, const SurfaceMesh& read) {
  const SurfaceMesh& mesh = original.named.mesh;
  std::string difference = differenceFrom(figuresOf(original, floats), read);
  if (!difference.empty()) {
    return difference;
  }
  const double tolerance = fileToleranceMm(boundsOf(mesh));
  for (std::size_t i = 0; i < floats.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& expected = mesh.vertices[floats.source[floats.triangles[i][k]]];
      const double distance = (read.vertices[read.triangles[i][k]] - expected).norm();
      if (!(distance <= tolerance)) {
        return "has a corner " + formatNumber(distance, kDecimals) + " mm from its place";
      }
    }
  }
  return {};
}

std::string stlHeaderProblem(std::string_view bytes) {
  const std::string_view header = bytes.substr(0, 80);
  if (toLower(header).starts_with("solid")) {
    return "has a header that begins with \"solid\", which some readers take for text";
  }
  if (header.find("SPACE=LPS") == std::string_view::npos) {
    return "does not say SPACE=LPS in its header";
  }
  return header.find("UNIT=mm") == std::string_view::npos ? "does not say UNIT=mm in its header" : "";
}

std::string rootMatrixProblem(const GlbContent& content) {
  constexpr double kSame = 1e-9;
  for (std::size_t i = 0; i < kGlbRootMatrix.size(); ++i) {
    if (!(std::abs(content.rootMatrix[i] - kGlbRootMatrix[i]) <= kSame)) {
      return "has a root matrix that does not take millimetres LPS to metres with +Y up";
    }
  }
  return {};
}

}  // namespace glisson
