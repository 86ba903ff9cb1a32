// Which models are chosen of made-up measures, and that rows and stored models read back.

#include "reconstruction/evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "csv.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/model_json.h"
#include "reconstruction/evaluation/models_csv.h"
#include "reconstruction/evaluation/rated_recipes.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/text.h"

namespace glisson {
namespace {

EvaluatedModel model(ModelFamily family, double errorMm, std::size_t triangles, double curvature) {
  EvaluatedModel made;
  made.recipe.family = family;
  made.measures.emplace();
  made.measures->paperErrorMm.mean = errorMm;
  made.measures->triangles = triangles;
  made.measures->curvature.trimmedPerMm2 = curvature;
  return made;
}

EvaluatedModel failed(ModelFamily family, const std::string& why) {
  EvaluatedModel made;
  made.recipe.family = family;
  made.failure = why;
  return made;
}

constexpr ModelFamily kPsr = ModelFamily::Psr;
constexpr ModelFamily kMcsd = ModelFamily::Mcsd;
constexpr ModelFamily kThird = ModelFamily::SimplifiedPsr;
constexpr ModelFamily kOther = ModelFamily::Other;

TEST(Recipes, AreThePapersFiftyFourAndAFewMoreEachWithANameOfItsOwn) {
  const std::vector<ModelRecipe> recipes = allRecipes();
  EXPECT_EQ(std::count_if(recipes.begin(), recipes.end(), [](const ModelRecipe& r) { return r.family == kPsr; }), 4);
  EXPECT_EQ(std::count_if(recipes.begin(), recipes.end(), [](const ModelRecipe& r) { return r.family == kMcsd; }), 50);
  EXPECT_EQ(std::count_if(recipes.begin(), recipes.end(), [](const ModelRecipe& r) { return isPublished(r.family); }), 54);
  std::set<std::string> ids;
  std::set<std::string> names;
  for (const ModelRecipe& recipe : recipes) {
    ids.insert(modelId(recipe));
    names.insert(modelName(recipe));
  }
  EXPECT_EQ(ids.size(), recipes.size());
  EXPECT_EQ(names.size(), recipes.size());
  EXPECT_TRUE(ids.contains("psr_d7"));
  EXPECT_TRUE(ids.contains("mcsd_s90_e90"));
  EXPECT_TRUE(ids.contains("simplified_16"));
  EXPECT_EQ(modelName(recipes[57]), "PSR d=8, 1/64");
}

TEST(Recipes, EndWithEveryVariantOfTheListedMethodsNamedByTheList) {
  const std::vector<ModelRecipe> recipes = allRecipes();
  std::size_t place = 58;
  for (const ReconstructionMethod& method : listedMethods()) {
    for (const MethodVariant& variant : method.variants) {
      ASSERT_LT(place, recipes.size());
      const ModelRecipe& recipe = recipes[place++];
      EXPECT_EQ(recipe.family, kOther);
      EXPECT_EQ(methodId(recipe), method.id);
      EXPECT_EQ(modelId(recipe), method.id + "_" + variant.id);
      EXPECT_EQ(modelName(recipe), method.name + " " + variant.name);
    }
  }
  EXPECT_EQ(place, recipes.size());
  EXPECT_EQ(familyId(kOther), "other");
  EXPECT_FALSE(isPublished(kOther));
}

TEST(Recipes, DecimateBeforeTheySmoothByTheLaplacianFilterAndSampleAsThePaper) {
  const McsdParameters mcsd = mcsdOf({.family = kMcsd, .smoothing = 22, .decimationPercent = 90});
  EXPECT_EQ(mcsd.filter, SmoothingFilter::Laplacian);
  EXPECT_EQ(mcsd.order, McsdOrder::DecimateFirst);
  EXPECT_EQ(mcsd.smoothing, 22);
  EXPECT_EQ(mcsd.decimation, 0.9);
  const PoissonParameters psr = poissonOf({.depth = 6}, {.scale = 1.25});
  EXPECT_EQ(psr.sampling, Sampling::Paper);
  EXPECT_EQ(psr.depth, 6);
  EXPECT_EQ(psr.scale, 1.25);
  EXPECT_EQ(psr.pointWeight, 0);
  EXPECT_THROW((ExperimentOptions{.timings = 0}).validate(), UsageError);
  EXPECT_THROW((ExperimentOptions{.scale = 1.0}).validate(), UsageError);
}

TEST(Evaluation, ChoosesTheBestOfEachFamilyAndTheMostSimilarOfMcsd) {
  const Evaluation all = evaluated({model(kPsr, 3.0, 100, 9.0), model(kPsr, 1.2, 400, 2.0), model(kMcsd, 1.0, 2000, 1.5),
                                    model(kMcsd, 1.1, 900, 40.0), model(kMcsd, 2.5, 1100, 2.25)});
  EXPECT_EQ(all.bestPsr, 1U);
  EXPECT_EQ(all.bestMcsd, 3U);
  EXPECT_EQ(all.bestOfAll, 1U);
  EXPECT_EQ(all.mostSimilar, 4U);
  EXPECT_EQ(all.bestSimplified, std::nullopt);
  EXPECT_EQ(all.scores[0]->score, 1.0);
  EXPECT_EQ(all.scores[2]->score, 1.0);
  EXPECT_DOUBLE_EQ(all.scores[1]->normalised.error, 0.1);
  std::vector<bool> front;
  for (const auto& score : all.scores) {
    front.push_back(score->pareto);
  }
  EXPECT_EQ(front, (std::vector<bool>{true, true, true, true, false}));
}

TEST(Evaluation, TheFamiliesBesideThePublishedOnesChangeNothingOfThem) {
  std::vector<EvaluatedModel> models{model(kPsr, 3.0, 100, 9.0), model(kPsr, 1.2, 400, 2.0), model(kMcsd, 1.0, 2000, 1.5)};
  const Evaluation without = evaluated(models);
  models.push_back(model(kThird, 0.5, 50, 2.0));
  models.push_back(model(kThird, 0.6, 60, 2.0));
  models.push_back(model(kOther, 0.4, 70, 2.0));
  models.push_back(model(kOther, 0.7, 80, 2.0));
  const Evaluation with = evaluated(models);
  EXPECT_EQ(with.bestPsr, without.bestPsr);
  EXPECT_EQ(with.bestMcsd, without.bestMcsd);
  EXPECT_EQ(with.bestOfAll, without.bestOfAll);
  EXPECT_EQ(with.mostSimilar, without.mostSimilar);
  for (std::size_t n = 0; n < without.models.size(); ++n) {
    EXPECT_EQ(with.scores[n]->score, without.scores[n]->score);
    EXPECT_EQ(with.scores[n]->pareto, without.scores[n]->pareto);
    EXPECT_FALSE(with.scores[n]->paretoOfAll);
  }
  EXPECT_LT(with.scores[3]->normalised.error, 0.0);
  EXPECT_LT(with.scores[3]->normalised.triangles, 0.0);
  EXPECT_TRUE(with.scores[3]->pareto);
  EXPECT_TRUE(with.scores[3]->paretoOfAll);
  EXPECT_FALSE(with.scores[4]->pareto);
  EXPECT_EQ(with.bestSimplified, 4U);  // the nearest to the ideal of the published scale, not the farthest beyond it
  EXPECT_EQ(without.bestOther, std::nullopt);
  EXPECT_EQ(with.bestOther, 6U);
  EXPECT_TRUE(with.scores[5]->pareto);  // each family has a front of its own
  EXPECT_TRUE(with.scores[5]->paretoOfAll);
  EXPECT_FALSE(with.scores[6]->pareto);
}

TEST(Evaluation, IsFinalOnceEveryPublishedModelIsThereOrFailed) {
  std::vector<EvaluatedModel> models;
  for (const ModelRecipe& recipe : allRecipes()) {
    if (isPublished(recipe.family)) {
      models.push_back(model(recipe.family, 1.0 + static_cast<double>(models.size()), 100 + models.size(), 1.0));
      models.back().recipe = recipe;
    }
  }
  models[3] = failed(kPsr, "too small");
  models[3].recipe = allRecipes()[3];
  const Evaluation all = evaluated(models);
  EXPECT_TRUE(all.publishedComplete);
  EXPECT_EQ(all.finalScore(0), &*all.scores[0]);
  EXPECT_EQ(all.finalScore(3), nullptr);
  models.erase(models.begin() + 20);
  const Evaluation without = evaluated(models);
  EXPECT_FALSE(without.publishedComplete);
  EXPECT_TRUE(without.scores[0]);
  EXPECT_EQ(without.finalScore(0), nullptr);
}

TEST(Evaluation, GoesOnWithoutTheModelsThatFailed) {
  const Evaluation all =
      evaluated({failed(kPsr, "no"), model(kPsr, 2.0, 100, 1.0), model(kMcsd, 1.0, 300, 5.0), failed(kMcsd, "no")});
  EXPECT_EQ(all.failed(), 2U);
  EXPECT_EQ(all.bestPsr, 1U);
  EXPECT_EQ(all.mostSimilar, 2U);
  EXPECT_FALSE(all.scores[0]);
  const Evaluation noPsr = evaluated({failed(kPsr, "no"), model(kMcsd, 1.0, 300, 5.0)});
  EXPECT_EQ(noPsr.bestPsr, std::nullopt);
  EXPECT_EQ(noPsr.mostSimilar, std::nullopt);
  EXPECT_EQ(noPsr.bestOfAll, 1U);
  EXPECT_EQ(noPsr.scores[1]->score, 0.0);
  EXPECT_FALSE(evaluated({failed(kPsr, "no")}).bounds);
  EXPECT_FALSE(evaluated({}).bounds);
}

TEST(ModelsCsv, ReadsBackWithEveryColumnOfTheContract) {
  std::vector<EvaluatedModel> models{model(kPsr, 1.0 / 3.0, 1000000, 2e-4), failed(kMcsd, "a \"quoted\" reason, with a comma")};
  models[0].recipe.depth = 7;
  models[0].usedDepth = 7;
  models[0].measures->volumeMl = 99.0;
  models[0].measures->defects = {"edge: 2 edges are not manifold", "open: 1 edge"};
  models[0].seconds.solve = 0.25;
  models[1].recipe.decimationPercent = 70;
  models.push_back(model(kOther, 0.5, 500, 0));
  models[2].recipe.method = "mpu";
  models[2].recipe.variant = "e0.01";
  Evaluation evaluation = evaluated(models);
  for (const auto& row : test::namedRows(modelsCsv(evaluation, 100.0))) {
    for (const char* name : {"normalisedError", "normalisedTriangles", "score", "pareto", "paretoOfAll", "roles"}) {
      EXPECT_EQ(row.at(name), "") << name << ", before all published models are there";
    }
  }
  evaluation.publishedComplete = true;
  const std::string csv = modelsCsv(evaluation, 100.0);
  const auto header = test::readCsv(csv).front();
  EXPECT_EQ(header, modelsCsvColumns());
  EXPECT_EQ(std::vector<std::string>(header.begin(), header.begin() + 5),
            (std::vector<std::string>{"family", "method", "depth", "smoothing", "decimation"}));
  for (const char* name : {"triangles", "vertices", "meanErrorMm", "medianErrorMm", "p95ErrorMm", "maxErrorMm", "volumeMl",
                           "gaussianCurvaturePerMm2", "score", "pareto", "seconds", "peakMemoryMb"}) {
    EXPECT_EQ(std::count(header.begin(), header.end(), name), 1) << name;
  }
  const auto rows = test::namedRows(csv);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(parseNumber(rows[0].at("meanErrorMm")), 1.0 / 3.0);
  EXPECT_EQ(rows[0].at("triangles"), "1000000");
  EXPECT_EQ(rows[0].at("volumeDeviationPercent"), "-1");
  EXPECT_EQ(rows[0].at("defects"), "edge: 2 edges are not manifold; open: 1 edge");
  EXPECT_EQ(rows[0].at("roles"), "bestPsr bestOfAll");
  EXPECT_EQ(rows[0].at("seconds"), "0.25");
  EXPECT_EQ(rows[0].at("smoothing"), "");
  EXPECT_EQ(rows[1].at("decimation"), "0.7");
  EXPECT_EQ(rows[1].at("depth"), "");
  EXPECT_EQ(rows[1].at("meanErrorMm"), "");
  EXPECT_EQ(rows[1].at("score"), "");
  EXPECT_EQ(rows[1].at("failure"), "a \"quoted\" reason, with a comma");
  EXPECT_EQ(rows[1].at("variant"), "");
  EXPECT_EQ(rows[2].at("family"), "other");
  EXPECT_EQ(rows[2].at("method"), "mpu");
  EXPECT_EQ(rows[2].at("variant"), "e0.01");
  EXPECT_EQ(rows[2].at("depth"), "");
  EXPECT_EQ(rows[2].at("model"), "mpu_e0.01");
  EXPECT_EQ(rows[2].at("roles"), "bestOther");
}

TEST(ModelsCsv, LeavesTheVolumeOfAnOpenMeshEmpty) {
  EXPECT_EQ(test::namedRows(modelsCsv(evaluated({model(kPsr, 1, 10, 0)}), 5.0)).front().at("volumeMl"), "");
}

TEST(StoredModel, ComesBackWithEveryNumberAndCountsForItsKeyAlone) {
  EvaluatedModel made = model(kMcsd, 0.1 + 0.2, 12345, -1e-17);
  made.recipe.smoothing = 45;
  made.measures->paperErrorBoxMm = {0.1, 0.2, 0.3, 0.4, 0.5, 6};
  made.measures->shipped = {99, {1.5, 2.5, 3}};
  made.measures->volumeMl = 1.0 / 7.0;
  made.measures->defects = {"open: 3 edges"};
  made.seconds.smooth = 1.25;
  made.peakMemoryMb = 17.5;
  const std::string text = jsonOf(made, "key");
  const auto read = modelOfJson(text, "key", made.recipe);
  ASSERT_TRUE(read);
  EXPECT_EQ(jsonOf(*read, "key"), text);
  EXPECT_EQ(read->measures->paperErrorMm.mean, 0.1 + 0.2);
  EXPECT_EQ(read->measures->volumeMl, 1.0 / 7.0);
  EXPECT_EQ(modelsCsv(evaluated({*read}), 1.0), modelsCsv(evaluated({made}), 1.0));

  EXPECT_FALSE(modelOfJson(text, "another key", made.recipe));
  EXPECT_FALSE(modelOfJson(text, "key", {.family = kMcsd, .smoothing = 22}));
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    EXPECT_FALSE(modelOfJson(text.substr(0, length), "key", made.recipe)) << length;
  }
  const EvaluatedModel none = failed(kPsr, "too small");
  EXPECT_EQ(modelOfJson(jsonOf(none, "key"), "key", none.recipe)->failure, "too small");
}

/// The experiment with measures by which PSR d=7, MCSD s=0 e=50 % and MCSD s=45 e=0 % are chosen.
std::vector<EvaluatedModel> publishedModels() {
  std::vector<EvaluatedModel> models;
  for (const ModelRecipe& recipe : allRecipes()) {
    if (isPublished(recipe.family)) {
      models.push_back(model(recipe.family, 1.0, 1000, recipe.family == kPsr ? 0.1 : 0.5));
      models.back().recipe = recipe;
    }
  }
  const auto at = [&](const char* id) -> ModelMeasures& {
    return *std::ranges::find(models, id, [](const EvaluatedModel& m) { return modelId(m.recipe); })->measures;
  };
  at("psr_d7").paperErrorMm.mean = 0.1;
  at("mcsd_s0_e50").paperErrorMm.mean = 0.2;
  at("mcsd_s45_e0").curvature.trimmedPerMm2 = 0.11;
  return models;
}

TEST(RatedRecipes, AreThePapersGroupsOfACompleteExperiment) {
  const std::vector<RatedRecipe> rated = ratedRecipes(evaluated(publishedModels()));
  ASSERT_EQ(rated.size(), 3U);
  const std::vector<std::array<std::string, 3>> expected{
      {"psr_d7", "PSR (P_best)", "P_best"}, {"mcsd_s0_e50", "MCSD (C_best)", "C_best"}, {"mcsd_s45_e0", "MCSD (C_sim)", "C_sim"}};
  for (std::size_t n = 0; n < rated.size(); ++n) {
    EXPECT_EQ(modelId(rated[n].recipe), expected[n][0]);
    EXPECT_EQ(rated[n].method, expected[n][1]);
    EXPECT_EQ(rated[n].group, expected[n][2]);
    EXPECT_EQ(rated[n].grade, "");
  }
}

TEST(RatedRecipes, AreFourGradesOfBothMethodsWhereTheExperimentIsNotComplete) {
  std::vector<EvaluatedModel> models = publishedModels();
  models.pop_back();
  for (const Evaluation& experiment : {Evaluation(), evaluated(models)}) {
    const std::vector<RatedRecipe> rated = ratedRecipes(experiment);
    ASSERT_EQ(rated.size(), 8U);
    for (std::size_t n = 0; n < rated.size(); n += 2) {
      EXPECT_EQ(rated[n].method, "PSR");
      EXPECT_EQ(rated[n + 1].method, "MCSD");
      EXPECT_EQ(rated[n].grade, rated[n + 1].grade);
      EXPECT_EQ(rated[n].group, "");
    }
    EXPECT_EQ(modelId(rated[0].recipe), "psr_d8");
    EXPECT_EQ(modelId(rated[7].recipe), "mcsd_s90_e80");
  }
}

}  // namespace
}  // namespace glisson
