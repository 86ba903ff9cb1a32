#include "app/gui/start_rating.h"

#include "app/gui/rating_window.h"
#include "planning/case/structure_mask.h"
#include "reconstruction/evaluation/model_mesh.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

/// Of the published options nothing is said, so that sessions of earlier versions go on.
std::string idOf(const Case& content, const Structure& structure, const RatedRecipe& rated, const ExperimentOptions& options) {
  std::string id = content.code + "/";
  id += structure.kind == StructureKind::Liver ? "" : structure.id + "/";
  id += modelId(rated.recipe);
  id += options.sampling == Sampling::Unbiased ? "_unbiased" : "";
  id += options.scale == ExperimentOptions().scale ? "" : "_scale" + formatExact(options.scale);
  id += rated.group.empty() ? "" : "_" + rated.group;
  return id;
}

std::vector<RatedSurface> makeSurfaces(const Case& content, const Structure& structure, const std::vector<RatedRecipe>& recipes,
                                       const ExperimentOptions& options, const ExecutionContext& context) {
  const Mask& mask = maskOf(content, structure);
  const ImageGeometry& geometry = content.segmentation->geometry;
  LiverModel others = *content.model;
  std::erase_if(others.structures, [&](const Structure& other) { return other.id == structure.id; });
  const RatedSurroundings surroundings = surroundingsOf(others);
  std::vector<RatedSurface> surfaces;
  for (std::size_t n = 0; n < recipes.size(); ++n) {
    const auto at = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(recipes.size()); };
    const ExecutionContext share = context.range(at(n), at(n + 1));
    const RatedRecipe& rated = recipes[n];
    ModelMesh made = makeModelMesh(mask, geometry, rated.recipe, options, share);
    if (rated.group.empty() && made.usedDepth < rated.recipe.depth) {
      continue;  // the voxels carry no more: it would be the last one again
    }
    surfaces.push_back(ratedSurface({idOf(content, structure, rated, options), rated.method, content.code, rated.grade},
                                    std::move(made.mesh), surroundings));
  }
  return surfaces;
}

}  // namespace

void startRating(JobRunner& jobs, const Case& content, const Structure& structure, std::vector<RatedRecipe> recipes,
                 const ExperimentOptions& options, const QString& folder, QWidget& parent,
                 std::function<void(const std::exception&)> fail) {
  JobRequest request{.key = "rating", .title = RatingWindow::tr("Models for the blind rating"), .heavy = true};
  request.fail = std::move(fail);
  submitFor<std::vector<RatedSurface>>(
      jobs, std::move(request),
      [content, structure, recipes = std::move(recipes), options](const ExecutionContext& context) {
        return makeSurfaces(content, structure, recipes, options, context);
      },
      [structure, folder, &parent](std::vector<RatedSurface> surfaces) {
        (new RatingWindow(std::move(surfaces), structure, folder, &parent))->show();
      });
}

}  // namespace glisson
