#include "reconstruction/evaluation/measures.h"

#include <algorithm>
#include <iterator>

#include "reconstruction/errors.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/poisson/samples.h"

namespace glisson {

namespace {

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// A label of single voxels has no gradient anywhere, so there are no points to measure from.
std::vector<Vec3> referencePoints(const Mask& mask, const ImageGeometry& geometry, const ExecutionContext& context) {
  try {
    const OrientedPoints points = sampleBoundary(mask, geometry, Sampling::Paper, context);
    return {points.positions.begin(), points.positions.end()};
  } catch (const ReconstructionError&) {
    throw ReconstructionError(
        "The label has no surface to measure errors from: none of its voxels has a gradient; choose another.");
  }
}

}  // namespace

ShippedMeasures measureAsShipped(const SurfaceMesh& mesh) { return {mesh.vertices.size(), gaussianCurvatureAsShipped(mesh)}; }

EvaluationReference::EvaluationReference(const Mask& mask, const ImageGeometry& geometry, const ExecutionContext& context) {
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  points_ = referencePoints(mask, geometry, context);
  McsdParameters raw;
  raw.smoothing = 0;
  raw.decimation = 0;
  levelSet_ = reconstructMcsd(mask, geometry, raw, context).mesh;
  toLevelSet_.emplace(levelSet_);
  voxelVolumeMl_ = static_cast<double>(mask.count()) * geometry.voxelVolumeMm3() * kMlPerMm3;
}

ModelMeasures EvaluationReference::measure(const SurfaceMesh& mesh, const ExecutionContext& context) const {
  if (mesh.empty()) {
    throw ReconstructionError("The mesh has no triangles and encloses no volume; reconstruct it again.");
  }
  ModelMeasures measures;
  measures.triangles = mesh.triangles.size();
  measures.vertices = mesh.vertices.size();
  MeshDefects defects = mesh.defects();
  defects.selfIntersections = countSelfIntersections(mesh, context);
  measures.defects = defects.names();
  if (defects.openEdges == 0 && defects.orientationEdges == 0) {
    measures.volumeMl = signedVolumeMm3(mesh) * kMlPerMm3;
  }
  measures.curvature = meanGaussianCurvature(mesh);
  context.throwIfCancelled();

  const MeshDistance toMesh(mesh);
  const std::vector<double> paper = sorted(toMesh.to(points_, context));
  measures.paperErrorMm = summarise(paper);
  measures.paperErrorBoxMm = boxPlotOf(paper);
  const std::vector<double> there = sorted(distancesToVoxels(mesh.vertices, context));
  const std::vector<double> back = sorted(toMesh.to(levelSet_.vertices, context));
  measures.meshToVoxelsMm = summarise(there);
  measures.voxelsToMeshMm = summarise(back);
  std::vector<double> pooled;
  pooled.reserve(there.size() + back.size());
  std::merge(there.begin(), there.end(), back.begin(), back.end(), std::back_inserter(pooled));
  measures.voxelErrorMm = summarise(std::move(pooled));
  return measures;
}

std::vector<double> EvaluationReference::distancesToVoxels(std::span<const Vec3> points, const ExecutionContext& context) const {
  return toLevelSet_->to(points, context);
}

}  // namespace glisson
