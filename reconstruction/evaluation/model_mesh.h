#pragma once
// Purpose: one model of the experiment alone, its surface and its measures, for whoever looks at it: makeModels() keeps no
// surfaces. Frame: mm LPS.

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

struct ModelMesh {
  SurfaceMesh mesh;
  int usedDepth = 0;  ///< PSR families; below the recipe's where the voxels carry no more
  ModelSeconds seconds;
};

/// The same mesh as the one that makeModels() measures for this recipe; a depth that the label is too small for is lowered, not
/// refused. Throws ReconstructionError where the label has no surface, UsageError, Cancelled.
ModelMesh makeModelMesh(const Mask& mask, const ImageGeometry& geometry, const ModelRecipe& recipe,
                        const ExperimentOptions& options, const ExecutionContext& context = {});

/// The same of PSR or simplified PSR from points that are there already: sampled of the mask as options.sampling says. The seconds
/// hold nothing of that.
ModelMesh makeModelMesh(const OrientedPoints& points, const ImageGeometry& geometry, const ModelRecipe& recipe,
                        const ExperimentOptions& options, const ExecutionContext& context = {});

/// Everything that is measured of a model, as shipped too. Throws as EvaluationReference::measure().
ModelMeasures measureModel(const SurfaceMesh& mesh, const ModelRecipe& recipe, const EvaluationReference& reference,
                           const ExecutionContext& context = {});

/// How many triangles a simplified model keeps of `triangles`.
std::size_t simplifiedCount(std::size_t triangles, const ModelRecipe& recipe);

}  // namespace glisson
