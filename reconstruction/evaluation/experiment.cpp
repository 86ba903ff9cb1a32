#include "reconstruction/evaluation/experiment.h"

#include <algorithm>
#include <limits>
#include <map>
#include <new>

#include "reconstruction/errors.h"
#include "reconstruction/evaluation/model_mesh.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/parallel.h"
#include "reconstruction/peak_memory.h"
#include "reconstruction/stopwatch.h"

namespace glisson {

namespace {

using Places = std::vector<std::size_t>;

void keepQuicker(std::optional<ModelSeconds>& best, const ModelSeconds& seconds) {
  if (!best || seconds.total() < best->total()) {
    best = seconds;
  }
}

/// A Poisson surface of one depth, or why there is none.
struct Poisson {
  PoissonResult result;
  ModelSeconds seconds;
  std::optional<double> peakMemoryMb;
  std::string failure;
};

/// A listed method's surface, or why there is none.
struct Other {
  SurfaceMesh mesh;
  int usedDepth = 0;
  ModelSeconds seconds;
  std::optional<double> peakMemoryMb;
  std::string failure;
};

/// The solver would make a lower depth of it: the same model twice under two names.
std::string tooSmallFor(int depth, int usedDepth) {
  return "The label is too small for depth " + std::to_string(depth) + ": depth " + std::to_string(usedDepth) +
         " is the deepest that its voxels carry.";
}

/// What fails for one model is said in it; the others go on.
template <typename Work>
void attempt(std::string& failure, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    failure = error.what();
  } catch (const std::bad_alloc&) {
    failure = kNoMemoryForModel;
  }
}

class Experiment {
 public:
  Experiment(const Mask& mask, const ImageGeometry& geometry, const EvaluationReference& reference,
             std::span<const ModelRecipe> recipes, const ExperimentOptions& options, const ModelVisitor& visit)
      : mask_(mask), geometry_(geometry), reference_(reference), recipes_(recipes), options_(options), visit_(visit) {}

  void makePoisson(const ExecutionContext& context) const;
  void makeMcsd(const ExecutionContext& context) const;
  void makeOthers(const ExecutionContext& context) const;

 private:
  [[nodiscard]] Places placesOf(std::initializer_list<ModelFamily> families) const;
  void makeVariants(const Places& places, const ExecutionContext& context) const;
  [[nodiscard]] Other otherOf(const ModelRecipe& recipe, const ExecutionContext& context) const;
  [[nodiscard]] Poisson poissonOfDepth(int depth, const ExecutionContext& context) const;
  /// Sets the quickest run's seconds.
  [[nodiscard]] SurfaceMesh simplified(const SurfaceMesh& mesh, EvaluatedModel& model, const ExecutionContext& context) const;
  void finishPoisson(std::size_t place, const Poisson& poisson, const ExecutionContext& context) const;
  /// Or the failure.
  void measure(const SurfaceMesh& mesh, EvaluatedModel& model, const ExecutionContext& context) const;
  /// The quickest of all runs but the last, which is timed where the models are measured.
  [[nodiscard]] std::vector<std::optional<ModelSeconds>> timedMcsd(std::span<const McsdParameters> sets,
                                                                   const ExecutionContext& context) const;

  const Mask& mask_;
  const ImageGeometry& geometry_;
  const EvaluationReference& reference_;
  std::span<const ModelRecipe> recipes_;
  const ExperimentOptions& options_;
  const ModelVisitor& visit_;
};

Places Experiment::placesOf(std::initializer_list<ModelFamily> families) const {
  Places places;
  for (std::size_t n = 0; n < recipes_.size(); ++n) {
    if (std::find(families.begin(), families.end(), recipes_[n].family) != families.end()) {
      places.push_back(n);
    }
  }
  return places;
}

void Experiment::measure(const SurfaceMesh& mesh, EvaluatedModel& model, const ExecutionContext& context) const {
  const Stopwatch stopwatch;
  attempt(model.failure, [&] { model.measures = measureModel(mesh, model.recipe, reference_, context); });
  model.seconds.measure = stopwatch.seconds();
}

Poisson Experiment::poissonOfDepth(int depth, const ExecutionContext& context) const {
  Poisson made;
  const PeakMemory memory;
  attempt(made.failure, [&] {
    std::optional<ModelSeconds> best;
    for (int run = 0; run < options_.timings; ++run) {
      made.result = reconstructPoisson(mask_, geometry_, poissonOf({.depth = depth}, options_), context);
      keepQuicker(best,
                  {.sample = made.result.sampleSeconds, .solve = made.result.solveSeconds, .extract = made.result.extractSeconds});
    }
    made.seconds = *best;
  });
  made.peakMemoryMb = memory.growthMb();
  return made;
}

SurfaceMesh Experiment::simplified(const SurfaceMesh& mesh, EvaluatedModel& model, const ExecutionContext& context) const {
  SurfaceMesh made;
  double least = std::numeric_limits<double>::max();
  for (int run = 0; run < options_.timings; ++run) {
    const Stopwatch stopwatch;
    made = simplify(mesh, {.triangles = simplifiedCount(mesh.triangles.size(), model.recipe)}, context);
    least = std::min(least, stopwatch.seconds());
  }
  model.seconds.simplify = least;
  return made;
}

void Experiment::finishPoisson(std::size_t place, const Poisson& poisson, const ExecutionContext& context) const {
  EvaluatedModel model;
  model.recipe = recipes_[place];
  model.usedDepth = poisson.result.usedDepth;
  model.seconds = poisson.seconds;
  model.peakMemoryMb = poisson.peakMemoryMb;
  model.failure = poisson.failure;
  const bool simplify = model.recipe.family == ModelFamily::SimplifiedPsr;
  if (model.failure.empty() && !simplify && model.usedDepth != model.recipe.depth) {
    model.failure = tooSmallFor(model.recipe.depth, model.usedDepth);
  }
  const SurfaceMesh* mesh = &poisson.result.mesh;
  SurfaceMesh fewer;
  if (model.failure.empty() && simplify) {
    attempt(model.failure, [&] { fewer = simplified(*mesh, model, context); });
    mesh = &fewer;
  }
  if (model.failure.empty()) {
    measure(*mesh, model, context);
  }
  visit_(place, std::move(model));
}

void Experiment::makePoisson(const ExecutionContext& context) const {
  Places places = placesOf({ModelFamily::Psr, ModelFamily::SimplifiedPsr});
  std::map<int, Poisson> depths;
  for (const std::size_t place : places) {
    const int depth = recipes_[place].depth;
    if (!depths.contains(depth)) {
      const double share = 0.5 * static_cast<double>(depths.size()) / static_cast<double>(places.size());
      depths.emplace(depth, poissonOfDepth(depth, context.range(share, share)));
    }
  }
  // What takes longest first: the simplified ones, then the deepest.
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(isPublished(recipes_[a].family), -recipes_[a].depth) <
           std::pair(isPublished(recipes_[b].family), -recipes_[b].depth);
  });
  parallelFor(places.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto fraction = [&](std::size_t done) {
        return 0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(places.size());
      };
      finishPoisson(places[n], depths.at(recipes_[places[n]].depth), context.range(fraction(n), fraction(n + 1)));
    }
  });
}

std::vector<std::optional<ModelSeconds>> Experiment::timedMcsd(std::span<const McsdParameters> sets,
                                                               const ExecutionContext& context) const {
  std::vector<std::optional<ModelSeconds>> best(sets.size());
  for (int run = 1; run < options_.timings; ++run) {
    sweepMcsd(
        mask_, geometry_, sets,
        [&](std::size_t n, const McsdResult& made, const ExecutionContext& /*share*/) {
          keepQuicker(best[n], {.extract = made.extractSeconds, .decimate = made.decimateSeconds, .smooth = made.smoothSeconds});
        },
        context);
  }
  return best;
}

void Experiment::makeMcsd(const ExecutionContext& context) const {
  const Places places = placesOf({ModelFamily::Mcsd});
  if (places.empty()) {
    return;
  }
  const PeakMemory memory;
  const double timedShare = 0.5 * (options_.timings - 1) / options_.timings;
  std::vector<McsdParameters> sets;
  sets.reserve(places.size());
  for (const std::size_t place : places) {
    sets.push_back(mcsdOf(recipes_[place]));
  }
  std::vector<std::optional<ModelSeconds>> best = timedMcsd(sets, context.range(0.0, timedShare));
  const auto take = [&](std::size_t n, const McsdResult& made, const ExecutionContext& share) {
    EvaluatedModel model;
    model.recipe = recipes_[places[n]];
    keepQuicker(best[n], {.extract = made.extractSeconds, .decimate = made.decimateSeconds, .smooth = made.smoothSeconds});
    model.seconds = *best[n];
    measure(made.mesh, model, share);
    model.peakMemoryMb = memory.growthMb();
    share.report(1.0, "measures");
    visit_(places[n], std::move(model));
  };
  sweepMcsd(mask_, geometry_, sets, take, context.range(timedShare, 1.0));
}

Other Experiment::otherOf(const ModelRecipe& recipe, const ExecutionContext& context) const {
  Other made;
  const PeakMemory memory;
  attempt(made.failure, [&] {
    std::optional<ModelSeconds> best;
    for (int run = 0; run < options_.timings; ++run) {
      ModelMesh model = makeModelMesh(mask_, geometry_, recipe, options_, context);
      keepQuicker(best, model.seconds);
      made.mesh = std::move(model.mesh);
      made.usedDepth = model.usedDepth;
    }
    made.seconds = *best;
    const int wanted = variantOf(listedMethod(recipe.method), recipe.variant).depth;
    if (wanted != 0 && made.usedDepth != wanted) {
      made.failure = tooSmallFor(wanted, made.usedDepth);
    }
  });
  made.peakMemoryMb = memory.growthMb();
  return made;
}

/// The variants of one method: made one after the other, measured several at once.
void Experiment::makeVariants(const Places& places, const ExecutionContext& context) const {
  const auto fraction = [&](std::size_t done) { return 0.5 * static_cast<double>(done) / static_cast<double>(places.size()); };
  std::vector<Other> made;
  for (std::size_t n = 0; n < places.size(); ++n) {
    made.push_back(otherOf(recipes_[places[n]], context.range(fraction(n), fraction(n + 1))));
  }
  parallelFor(places.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      EvaluatedModel model;
      model.recipe = recipes_[places[n]];
      model.usedDepth = made[n].usedDepth;
      model.seconds = made[n].seconds;
      model.peakMemoryMb = made[n].peakMemoryMb;
      model.failure = made[n].failure;
      if (model.failure.empty()) {
        measure(made[n].mesh, model, context.range(0.5 + fraction(n), 0.5 + fraction(n + 1)));
      }
      visit_(places[n], std::move(model));
    }
  });
}

void Experiment::makeOthers(const ExecutionContext& context) const {
  const Places places = placesOf({ModelFamily::Other});
  std::map<std::string, Places> byMethod;
  for (const std::size_t place : places) {
    byMethod[recipes_[place].method].push_back(place);
  }
  const auto fraction = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(places.size()); };
  std::size_t done = 0;
  for (const auto& [method, variants] : byMethod) {
    makeVariants(variants, context.range(fraction(done), fraction(done + variants.size())));
    done += variants.size();
  }
}

}  // namespace

void makeModels(const Mask& mask, const ImageGeometry& geometry, const EvaluationReference& reference,
                std::span<const ModelRecipe> recipes, const ExperimentOptions& options, const ModelVisitor& visit,
                const ExecutionContext& context) {
  options.validate();
  const Experiment experiment(mask, geometry, reference, recipes, options, visit);
  // About what each group takes of a liver.
  const bool others =
      std::any_of(recipes.begin(), recipes.end(), [](const ModelRecipe& r) { return r.family == ModelFamily::Other; });
  const double poissonEnd = others ? 0.1 : 0.15;
  const double mcsdEnd = others ? 0.6 : 1.0;
  experiment.makePoisson(context.range(0.0, poissonEnd));
  experiment.makeMcsd(context.range(poissonEnd, mcsdEnd));
  experiment.makeOthers(context.range(mcsdEnd, 1.0));
}

}  // namespace glisson
