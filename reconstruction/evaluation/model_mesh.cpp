#include "reconstruction/evaluation/model_mesh.h"

#include <algorithm>

#include "reconstruction/mesh/sharp_edges.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/stopwatch.h"

namespace glisson {

namespace {

bool isMcsd(const ModelRecipe& recipe) { return recipe.family == ModelFamily::Mcsd; }

ModelMesh makeListed(const Mask& mask, const ImageGeometry& geometry, const ModelRecipe& recipe, const ExperimentOptions& options,
                     const ExecutionContext& context) {
  const MethodVariant& variant = variantOf(listedMethod(recipe.method), recipe.variant);
  MethodSurface made = variant.make({mask, geometry, options.sampling, options.scale}, context);
  return {
      std::move(made.mesh),
      made.usedDepth,
      {.sample = made.sampleSeconds, .solve = made.solveSeconds, .extract = made.extractSeconds, .simplify = made.simplifySeconds}};
}

/// `solve` runs PSR as it is told.
template <typename Solve>
ModelMesh makePoisson(const ModelRecipe& recipe, const ExperimentOptions& options, const ExecutionContext& context,
                      const Solve& solve) {
  const double share = recipe.divisor > 1 ? 0.6 : 1.0;
  PoissonResult poisson = solve(poissonOf(recipe, options), context.range(0.0, share));
  ModelMesh made{std::move(poisson.mesh),
                 poisson.usedDepth,
                 {.sample = poisson.sampleSeconds, .solve = poisson.solveSeconds, .extract = poisson.extractSeconds}};
  if (recipe.divisor > 1) {
    const Stopwatch stopwatch;
    made.mesh = simplify(made.mesh, {.triangles = simplifiedCount(made.mesh.triangles.size(), recipe)}, context.range(share, 1.0));
    made.seconds.simplify = stopwatch.seconds();
  }
  return made;
}

}  // namespace

ModelMesh makeModelMesh(const Mask& mask, const ImageGeometry& geometry, const ModelRecipe& recipe,
                        const ExperimentOptions& options, const ExecutionContext& context) {
  if (isMcsd(recipe)) {
    McsdResult made = reconstructMcsd(mask, geometry, mcsdOf(recipe), context);
    return {
        std::move(made.mesh), 0, {.extract = made.extractSeconds, .decimate = made.decimateSeconds, .smooth = made.smoothSeconds}};
  }
  if (recipe.family == ModelFamily::Other) {
    return makeListed(mask, geometry, recipe, options, context);
  }
  return makePoisson(recipe, options, context, [&](const PoissonParameters& parameters, const ExecutionContext& part) {
    return reconstructPoisson(mask, geometry, parameters, part);
  });
}

ModelMesh makeModelMesh(const OrientedPoints& points, const ImageGeometry& geometry, const ModelRecipe& recipe,
                        const ExperimentOptions& options, const ExecutionContext& context) {
  return makePoisson(recipe, options, context, [&](const PoissonParameters& parameters, const ExecutionContext& part) {
    return reconstructPoisson(points, geometry, parameters, part);
  });
}

ModelMeasures measureModel(const SurfaceMesh& mesh, const ModelRecipe& recipe, const EvaluationReference& reference,
                           const ExecutionContext& context) {
  ModelMeasures measures = reference.measure(mesh, context);
  measures.shipped = measureAsShipped(isMcsd(recipe) ? splitAtSharpEdges(mesh) : mesh);
  return measures;
}

std::size_t simplifiedCount(std::size_t triangles, const ModelRecipe& recipe) {
  return std::max<std::size_t>(4, triangles / static_cast<std::size_t>(recipe.divisor));
}

}  // namespace glisson
