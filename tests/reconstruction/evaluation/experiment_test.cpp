// Models of a small ellipsoid: measured as the single functions measure them, whatever the number of threads; what fails is said
// and the others go on.

#include "reconstruction/evaluation/experiment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <mutex>
#include <new>
#include <stdexcept>

#include "reconstruction/errors.h"
#include "reconstruction/evaluation/model_json.h"
#include "reconstruction/evaluation/model_mesh.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/mesh/sharp_edges.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

struct ExperimentBody {
  Mask mask;
  ImageGeometry geometry;
};

/// Half axes of 15, 12 and 10 mm on voxels of 0.8 x 0.8 x 1.6 mm: depth 6 is the deepest that they carry.
ExperimentBody ellipsoid() {
  ExperimentBody body;
  body.geometry.size = {44, 36, 18};
  body.geometry.spacing = Vec3(0.8, 0.8, 1.6);
  body.geometry.origin = Vec3(-30, 12, 200);
  std::vector<std::uint8_t> values;
  const Vec3 centre(21.7, 17.6, 8.3);
  for (int k = 0; k < 18; ++k) {
    for (int j = 0; j < 36; ++j) {
      for (int i = 0; i < 44; ++i) {
        const Vec3 at = (Vec3(i, j, k) - centre).cwiseProduct(body.geometry.spacing).cwiseQuotient(Vec3(15, 12, 10));
        values.push_back(at.squaredNorm() <= 1 ? 1 : 0);
      }
    }
  }
  body.mask = Mask::fromGrid(body.geometry.size, values);
  return body;
}

std::vector<EvaluatedModel> make(const ExperimentBody& body, const std::vector<ModelRecipe>& recipes,
                                 const ExperimentOptions& options = {}, const ExecutionContext& context = {}) {
  const EvaluationReference reference(body.mask, body.geometry);
  std::vector<EvaluatedModel> models(recipes.size());
  std::vector<int> visits(recipes.size(), 0);
  std::mutex mutex;
  const auto take = [&](std::size_t n, EvaluatedModel model) {
    const std::lock_guard lock(mutex);
    ++visits[n];
    models[n] = std::move(model);
  };
  makeModels(body.mask, body.geometry, reference, recipes, options, take, context);
  EXPECT_EQ(visits, std::vector<int>(recipes.size(), 1));
  return models;
}

const std::vector<ModelRecipe> kFew{{.family = ModelFamily::Mcsd, .smoothing = 22, .decimationPercent = 50},
                                    {.family = ModelFamily::SimplifiedPsr, .depth = 8, .divisor = 16},
                                    {.family = ModelFamily::Psr, .depth = 5},
                                    {.family = ModelFamily::Mcsd, .smoothing = 0, .decimationPercent = 0},
                                    {.family = ModelFamily::Psr, .depth = 6},
                                    {.family = ModelFamily::Other, .method = "mpu", .variant = "e0.01"},
                                    {.family = ModelFamily::Other, .method = "psr_knn", .variant = "d6"}};

std::string withoutTimes(EvaluatedModel model) {
  model.seconds = {};
  model.peakMemoryMb.reset();
  return jsonOf(model, "");
}

void expectSame(const ErrorSummary& a, const ErrorSummary& b) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.median, b.median);
  EXPECT_EQ(a.p95, b.p95);
  EXPECT_EQ(a.max, b.max);
}

TEST(Experiment, MeasuresEachModelAsTheSingleFunctionsDo) {
  const ExperimentBody body = ellipsoid();
  const std::vector<EvaluatedModel> models = make(body, kFew);
  const auto expectOf = [&](const EvaluatedModel& model, const SurfaceMesh& mesh) {
    ASSERT_TRUE(model.measures) << model.failure;
    const ModelMeasures& measures = *model.measures;
    EXPECT_EQ(measures.triangles, mesh.triangles.size());
    EXPECT_EQ(measures.vertices, mesh.vertices.size());
    expectSame(measures.paperErrorMm, paperError(mesh, body.mask, body.geometry).value());
    expectSame(measures.voxelErrorMm, voxelError(mesh, body.mask, body.geometry));
    EXPECT_EQ(measures.paperErrorBoxMm.median, measures.paperErrorMm.median);
    EXPECT_EQ(measures.volumeMl, volumeMl(mesh));
    EXPECT_EQ(measures.curvature.trimmedPerMm2, meanGaussianCurvature(mesh).trimmedPerMm2);
    MeshDefects defects = mesh.defects();
    defects.selfIntersections = countSelfIntersections(mesh);
    EXPECT_EQ(measures.defects, defects.names());
  };
  expectOf(models[0], reconstructMcsd(body.mask, body.geometry, mcsdOf(kFew[0])).mesh);
  expectOf(models[2], reconstructPoisson(body.mask, body.geometry, poissonOf(kFew[2], {})).mesh);
  expectOf(models[3], reconstructMcsd(body.mask, body.geometry, mcsdOf(kFew[3])).mesh);
  const PoissonResult deepest = reconstructPoisson(body.mask, body.geometry, poissonOf(kFew[1], {}));
  expectOf(models[1], simplify(deepest.mesh, {.triangles = deepest.mesh.triangles.size() / 16}));
  const MethodInput input{body.mask, body.geometry, Sampling::Paper, ExperimentOptions().scale};
  expectOf(models[5], variantOf(listedMethod("mpu"), "e0.01").make(input, {}).mesh);
  expectOf(models[6], variantOf(listedMethod("psr_knn"), "d6").make(input, {}).mesh);
  EXPECT_EQ(models[1].usedDepth, 6);
  EXPECT_EQ(models[1].name(), "PSR d=6, 1/16");
  // Marching cubes lies on the level set: the reference finds no error either way.
  EXPECT_LT(models[3].measures->voxelErrorMm.max, 1e-5);
}

TEST(Experiment, OneModelAloneIsTheOneThatWasMeasured) {
  const ExperimentBody body = ellipsoid();
  const EvaluationReference reference(body.mask, body.geometry);
  const std::vector<EvaluatedModel> models = make(body, kFew);
  for (std::size_t n = 0; n < kFew.size(); ++n) {
    const ModelMesh alone = makeModelMesh(body.mask, body.geometry, kFew[n], {});
    EvaluatedModel model;
    model.recipe = kFew[n];
    model.usedDepth = alone.usedDepth;
    model.measures = measureModel(alone.mesh, kFew[n], reference);
    EXPECT_EQ(withoutTimes(model), withoutTimes(models[n])) << modelName(kFew[n]);
    expectSame(summarise(reference.distancesToVoxels(alone.mesh.vertices)), models[n].measures->meshToVoxelsMm);
    EXPECT_GT(alone.seconds.total(), 0);
  }
}

TEST(Experiment, OneModelAloneOfADepthTooDeepIsMadeAtTheDeepest) {
  const ExperimentBody body = ellipsoid();
  const ModelMesh alone = makeModelMesh(body.mask, body.geometry, {.family = ModelFamily::Psr, .depth = 9}, {});
  EXPECT_EQ(alone.usedDepth, 6);
  EXPECT_FALSE(alone.mesh.empty());
}

TEST(Experiment, OneModelAloneStopsOnCancel) {
  const ExperimentBody body = ellipsoid();
  const ExecutionContext context;
  context.cancel();
  for (const ModelRecipe& recipe : kFew) {
    EXPECT_THROW(makeModelMesh(body.mask, body.geometry, recipe, {}, context), Cancelled) << modelName(recipe);
  }
}

TEST(Experiment, SplitNormalsTakeTheMeshApartAndInflateItsCurvature) {
  const ExperimentBody body = ellipsoid();
  const std::vector<EvaluatedModel> models = make(body, kFew);
  const ModelMeasures& cubes = *models[3].measures;
  const SurfaceMesh split = splitAtSharpEdges(reconstructMcsd(body.mask, body.geometry, mcsdOf(kFew[3])).mesh);
  EXPECT_EQ(cubes.shipped.vertices, split.vertices.size());
  EXPECT_GT(cubes.shipped.vertices, cubes.vertices);
  EXPECT_EQ(cubes.shipped.curvature.trimmedPerMm2, gaussianCurvatureAsShipped(split).trimmedPerMm2);
  EXPECT_GT(cubes.shipped.curvature.trimmedPerMm2, 10 * std::abs(cubes.curvature.trimmedPerMm2));
  const ModelMeasures& psr = *models[2].measures;
  EXPECT_EQ(psr.shipped.vertices, psr.vertices);
  EXPECT_NEAR(psr.shipped.curvature.trimmedPerMm2, psr.curvature.trimmedPerMm2, 1e-12);
}

TEST(Experiment, GivesTheSameNumbersForOneAndManyThreads) {
  const ExperimentBody body = ellipsoid();
  std::vector<std::string> texts;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    std::string text;
    for (const EvaluatedModel& model : make(body, kFew)) {
      text += withoutTimes(model);
    }
    texts.push_back(text);
  }
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_EQ(texts[0], texts[2]);
}

TEST(Experiment, SaysWhichDepthALabelIsTooSmallForAndGoesOn) {
  const ExperimentBody body = ellipsoid();
  const std::vector<EvaluatedModel> models = make(body, {{.family = ModelFamily::Psr, .depth = 8},
                                                         {.family = ModelFamily::Psr, .depth = 6},
                                                         kFew[3],
                                                         {.family = ModelFamily::Other, .method = "psr_knn", .variant = "d8"}});
  EXPECT_FALSE(models[0].measures);
  EXPECT_EQ(models[0].failure, "The label is too small for depth 8: depth 6 is the deepest that its voxels carry.");
  EXPECT_TRUE(models[1].measures);
  EXPECT_TRUE(models[2].measures);
  EXPECT_EQ(models[3].failure, models[0].failure);
}

TEST(Experiment, KeepsTheQuickestOfSeveralRunsAndTheSameNumbers) {
  const ExperimentBody body = ellipsoid();
  const std::vector<EvaluatedModel> once = make(body, kFew);
  const std::vector<EvaluatedModel> thrice = make(body, kFew, {.timings = 3});
  for (std::size_t n = 0; n < kFew.size(); ++n) {
    EXPECT_EQ(withoutTimes(once[n]), withoutTimes(thrice[n]));
    EXPECT_GT(thrice[n].seconds.total(), 0.0);
  }
}

TEST(Experiment, TimesTheSimplificationAsOftenAsTheRest) {
  const ExperimentBody body = ellipsoid();
  const auto simplifications = [&](int timings) {
    int reports = 0;
    const ExecutionContext context([&](double /*done*/, std::string_view phase) { reports += phase == "simplify" ? 1 : 0; });
    const auto models = make(body, {kFew[1]}, {.timings = timings}, context);
    EXPECT_GT(models[0].seconds.simplify, 0.0);
    return reports;
  };
  const int once = simplifications(1);
  EXPECT_GT(once, 0);
  EXPECT_EQ(simplifications(3), 3 * once);
}

TEST(Experiment, AModelsMemoryIsThatOfItsOwnMakingAndNotOfTheOneBefore) {
  if (!std::ofstream("/proc/self/clear_refs")) {
    GTEST_SKIP() << "the system keeps no high-water mark";
  }
  constexpr std::size_t kMuch = 200'000'000;
  bool taken = false;
  const ExecutionContext context([&](double /*done*/, std::string_view /*phase*/) {
    if (!taken) {
      taken = true;
      EXPECT_EQ(std::vector<char>(kMuch, 'x')[kMuch / 2], 'x');
    }
  });
  const std::vector<EvaluatedModel> models = make(ellipsoid(), {kFew[4], kFew[2], kFew[3], kFew[5], kFew[6]}, {}, context);
  EXPECT_GT(models[0].peakMemoryMb.value_or(0), 190);
  for (std::size_t n = 1; n < models.size(); ++n) {
    EXPECT_LT(models[n].peakMemoryMb.value_or(1e9), 150) << modelName(models[n].recipe);
  }
}

using Places = std::vector<std::size_t>;

TEST(Experiment, AModelThatTheMemoryDoesNotSufficeForSaysSoAndTheOthersGoOn) {
  const ExperimentBody body = ellipsoid();
  const std::vector<EvaluatedModel> whole = make(body, kFew);
  const auto failed = [&](const std::string& phase) {
    const ExecutionContext context([&](double /*done*/, std::string_view reached) {
      if (reached == phase) {
        throw std::bad_alloc();
      }
    });
    Places places;
    const std::vector<EvaluatedModel> models = make(body, kFew, {}, context);
    for (std::size_t n = 0; n < models.size(); ++n) {
      if (models[n].failure == kNoMemoryForModel && !models[n].measures) {
        places.push_back(n);
      } else {
        EXPECT_EQ(withoutTimes(models[n]), withoutTimes(whole[n])) << phase << ", " << modelName(kFew[n]);
      }
    }
    return places;
  };
  EXPECT_EQ(failed("simplify"), Places{1});
  EXPECT_EQ(failed("solve"), (Places{1, 2, 4, 5, 6})) << "all but MCSD";
}

TEST(Experiment, NeedsALabelWithASurface) {
  ExperimentBody body = ellipsoid();
  EXPECT_THROW(EvaluationReference(Mask(), body.geometry), ReconstructionError);
  std::vector<std::uint8_t> values(body.geometry.voxelCount(), 0);
  values[values.size() / 2] = 1;
  try {
    const EvaluationReference reference(Mask::fromGrid(body.geometry.size, values), body.geometry);
    FAIL() << "a single voxel was taken";
  } catch (const ReconstructionError& error) {
    EXPECT_NE(std::string(error.what()).find("no surface to measure"), std::string::npos) << error.what();
  }
}

TEST(Experiment, EndsWithWhatTheVisitorThrowsAndOnCancel) {
  const ExperimentBody body = ellipsoid();
  const EvaluationReference reference(body.mask, body.geometry);
  const auto full = [](std::size_t /*n*/, const EvaluatedModel& /*model*/) { throw InputError("the disk is full"); };
  EXPECT_THROW(makeModels(body.mask, body.geometry, reference, kFew, {}, full), InputError);
  const ExecutionContext cancelled;
  cancelled.cancel();
  const auto taken = [](std::size_t /*n*/, const EvaluatedModel& /*model*/) { ADD_FAILURE() << "went on"; };
  EXPECT_THROW(makeModels(body.mask, body.geometry, reference, kFew, {}, taken, cancelled), Cancelled);
  makeModels(body.mask, body.geometry, reference, {}, {}, taken);
}

}  // namespace
}  // namespace glisson
