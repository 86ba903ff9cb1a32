#include "app/gui/start_rating.h"

#include "app/gui/rating_window.h"
#include "planning/case/structure_mask.h"
#include "reconstruction/evaluation/model_mesh.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

struct GradedRecipe {
  ModelRecipe recipe;
  std::string grade;
};

/// A depth of PSR and a smoothing of MCSD for each grade, from nearly raw to strongly reduced.
std::vector<GradedRecipe> ratedRecipes() {
  std::vector<GradedRecipe> recipes;
  int depth = kDeepestPublished;
  for (const auto& [smoothing, percent] : {std::pair(22, 20), std::pair(45, 40), std::pair(67, 60), std::pair(90, 80)}) {
    const ModelRecipe psr{.family = ModelFamily::Psr, .depth = depth--};
    const ModelRecipe mcsd{.family = ModelFamily::Mcsd, .smoothing = smoothing, .decimationPercent = percent};
    for (const ModelRecipe& recipe : {psr, mcsd}) {
      recipes.push_back({recipe, modelName(psr) + " / " + modelName(mcsd)});
    }
  }
  return recipes;
}

/// Of the published options nothing is said, so that sessions of earlier versions go on.
std::string idOf(const Case& content, const Structure& structure, const ModelRecipe& recipe, const ExperimentOptions& options) {
  std::string id = content.code + "/";
  id += structure.kind == StructureKind::Liver ? "" : structure.id + "/";
  id += modelId(recipe);
  id += options.sampling == Sampling::Unbiased ? "_unbiased" : "";
  id += options.scale == ExperimentOptions().scale ? "" : "_scale" + formatExact(options.scale);
  return id;
}

std::vector<RatedSurface> makeSurfaces(const Case& content, const Structure& structure, const ExperimentOptions& options,
                                       const ExecutionContext& context) {
  const Mask& mask = maskOf(content, structure);
  const ImageGeometry& geometry = content.segmentation->geometry;
  const std::vector<GradedRecipe> recipes = ratedRecipes();
  LiverModel others = *content.model;
  std::erase_if(others.structures, [&](const Structure& other) { return other.id == structure.id; });
  const RatedSurroundings surroundings = surroundingsOf(others);
  std::vector<RatedSurface> surfaces;
  for (std::size_t n = 0; n < recipes.size(); ++n) {
    const auto at = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(recipes.size()); };
    const ExecutionContext share = context.range(at(n), at(n + 1));
    const auto& [recipe, grade] = recipes[n];
    ModelMesh made = makeModelMesh(mask, geometry, recipe, options, share);
    if (made.usedDepth < recipe.depth) {
      continue;  // the voxels carry no more: it would be the last one again
    }
    const std::string method = recipe.family == ModelFamily::Mcsd ? "MCSD" : "PSR";
    surfaces.push_back(
        ratedSurface({idOf(content, structure, recipe, options), method, content.code, grade}, std::move(made.mesh), surroundings));
  }
  return surfaces;
}

}  // namespace

void startRating(JobRunner& jobs, const Case& content, const Structure& structure, const ExperimentOptions& options,
                 const QString& folder, QWidget& parent, std::function<void(const std::exception&)> fail) {
  JobRequest request{.key = "rating", .title = RatingWindow::tr("Models for the blind rating"), .heavy = true};
  request.fail = std::move(fail);
  submitFor<std::vector<RatedSurface>>(
      jobs, std::move(request),
      [content, structure, options](const ExecutionContext& context) { return makeSurfaces(content, structure, options, context); },
      [structure, folder, &parent](std::vector<RatedSurface> surfaces) {
        (new RatingWindow(std::move(surfaces), structure, folder, &parent))->show();
      });
}

}  // namespace glisson
