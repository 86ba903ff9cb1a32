#include "app/gui/start_rating.h"

#include "app/gui/rating_window.h"
#include "planning/case/liver_model.h"
#include "reconstruction/evaluation/model_mesh.h"

namespace glisson {

namespace {

std::vector<ModelRecipe> ratedRecipes() {
  std::vector<ModelRecipe> recipes;
  for (int depth = 5; depth <= kDeepestPublished; ++depth) {
    recipes.push_back({.family = ModelFamily::Psr, .depth = depth});
  }
  // one of each smoothing, from nearly raw to strongly reduced
  for (const auto& [smoothing, percent] : {std::pair(22, 20), std::pair(45, 40), std::pair(67, 60), std::pair(90, 80)}) {
    recipes.push_back({.family = ModelFamily::Mcsd, .smoothing = smoothing, .decimationPercent = percent});
  }
  return recipes;
}

std::vector<RatedSurface> makeSurfaces(const Case& content, const ExecutionContext& context) {
  const Mask& mask = content.liver->liver;
  const ImageGeometry& geometry = content.liver->geometry;
  const std::vector<ModelRecipe> recipes = ratedRecipes();
  const RatedSurroundings surroundings = surroundingsOf(*content.model);
  std::vector<RatedSurface> surfaces;
  for (std::size_t n = 0; n < recipes.size(); ++n) {
    const auto at = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(recipes.size()); };
    const ExecutionContext share = context.range(at(n), at(n + 1));
    ModelMesh made = makeModelMesh(mask, geometry, recipes[n], {}, share);
    if (made.usedDepth < recipes[n].depth) {
      continue;  // the voxels carry no more: it would be the last one again
    }
    const std::string method = recipes[n].family == ModelFamily::Mcsd ? "MCSD" : "PSR";
    surfaces.push_back(
        ratedSurface({content.code + "/" + modelId(recipes[n]), method, content.code}, std::move(made.mesh), surroundings));
  }
  return surfaces;
}

}  // namespace

void startRating(JobRunner& jobs, const Case& content, const QString& folder, QWidget& parent,
                 std::function<void(const std::exception&)> fail) {
  JobRequest request{.key = "rating", .title = RatingWindow::tr("Models for the blind rating"), .heavy = true};
  request.fail = std::move(fail);
  submitFor<std::vector<RatedSurface>>(
      jobs, std::move(request), [content](const ExecutionContext& context) { return makeSurfaces(content, context); },
      [folder, &parent](std::vector<RatedSurface> surfaces) { (new RatingWindow(std::move(surfaces), folder, &parent))->show(); });
}

}  // namespace glisson
