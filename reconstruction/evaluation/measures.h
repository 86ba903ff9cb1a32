#pragma once
// Purpose: everything the experiment measures of one surface [Palomar 2016, 3.1 to 3.3; method.md 4]. Units in the names; mm LPS.
// Of the three errors of method.md 4 there are two: the true error needs an analytic body, and a label map has none.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reconstruction/evaluation/statistics.h"
#include "reconstruction/mesh/curvature.h"
#include "reconstruction/mesh/distance.h"

namespace glisson {

/// Of a mesh whose vertices are doubled at sharp edges, as 3D Slicer hands it out; of PSR, which has none, of the mesh itself.
struct ShippedMeasures {
  std::size_t vertices = 0;
  CurvatureSummary curvature;
};
ShippedMeasures measureAsShipped(const SurfaceMesh& mesh);

struct ModelMeasures {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  ErrorSummary paperErrorMm;  ///< from all inside-surface voxel centres to the mesh: the error of scores and tables
  BoxPlot paperErrorBoxMm;
  ErrorSummary voxelErrorMm;       ///< both directions pooled
  ErrorSummary meshToVoxelsMm;     ///< from the mesh's vertices to the mask's 0.5 level set
  ErrorSummary voxelsToMeshMm;     ///< from the level set's vertices to the mesh
  std::optional<double> volumeMl;  ///< nothing where the mesh is open
  CurvatureSummary curvature;      ///< of the mesh with equal vertices merged: decides what is similar
  ShippedMeasures shipped;
  std::vector<std::string> defects;  ///< MeshDefects::names(), self-intersections among them
};

/// What a label's models are measured against: computed once for all of them.
class EvaluationReference {
 public:
  /// Throws ReconstructionError where the mask is empty or has no voxel to measure from. Polls cancel.
  EvaluationReference(const Mask& mask, const ImageGeometry& geometry, const ExecutionContext& context = {});

  /// Points that the paper error is measured from.
  [[nodiscard]] std::size_t pointCount() const { return points_.size(); }
  [[nodiscard]] double voxelVolumeMl() const { return voxelVolumeMl_; }

  /// Everything but `shipped`, self-intersections counted. paperErrorMm and voxelErrorMm are those of paperError() and
  /// voxelError(). Throws ReconstructionError where the mesh has no triangles. Polls cancel.
  [[nodiscard]] ModelMeasures measure(const SurfaceMesh& mesh, const ExecutionContext& context = {}) const;
  /// Of each point to the mask's 0.5 level set, mm: of a mesh's vertices, what meshToVoxelsMm sums up. Polls cancel.
  [[nodiscard]] std::vector<double> distancesToVoxels(std::span<const Vec3> points, const ExecutionContext& context = {}) const;

 private:
  std::vector<Vec3> points_;
  SurfaceMesh levelSet_;
  std::optional<MeshDistance> toLevelSet_;
  double voxelVolumeMl_ = 0;
};

}  // namespace glisson
