// What several patients say together: on the paper's six as published, and on hand-made ones.

#include "reconstruction/evaluation/cohort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "published_tables.h"

namespace glisson {
namespace {

using test::kPublished;
using test::PublishedModel;
using test::PublishedPatient;

ModelFigures figures(const PublishedModel& model, double curvature, double seconds) {
  return {.triangles = 1000 * model.kiloTriangles,
          .meanErrorMm = model.meanErrorMm,
          .score = model.score,
          .gaussianCurvaturePerMm2 = 1e-3 * curvature,
          .seconds = seconds};
}

/// Of other depths than the best the paper prints scores and curvatures alone.
PatientFigures figures(const PublishedPatient& published) {
  PatientFigures patient;
  for (std::size_t n = 0; n < published.psrScores.size(); ++n) {
    const int depth = 5 + static_cast<int>(n);
    patient.psr[depth] = {.score = published.psrScores[n], .gaussianCurvaturePerMm2 = 1e-3 * published.psrCurvatures[n]};
    if (!patient.bestDepth || patient.psr[depth].score < patient.psr[*patient.bestDepth].score) {
      patient.bestDepth = depth;
    }
  }
  ModelFigures& best = patient.psr.at(*patient.bestDepth);
  best.triangles = 1000 * published.bestPsr.kiloTriangles;
  best.meanErrorMm = published.bestPsr.meanErrorMm;
  best.seconds = published.seconds[0];
  patient.mostSimilarMcsd = figures(published.mostSimilar, published.similarCurvature, published.seconds[1]);
  patient.bestMcsd = figures(published.bestMcsd, published.bestMcsdCurvature, published.seconds[2]);
  return patient;
}

std::vector<PatientFigures> publishedPatients() {
  std::vector<PatientFigures> patients;
  for (const PublishedPatient& published : kPublished) {
    patients.push_back(figures(published));
  }
  return patients;
}

// ---- the paper's six patients

TEST(PublishedCohort, DepthSevenIsTheBestOfAllSixTimesOfSix) {
  const CohortStatistics cohort = statisticsOf(publishedPatients());
  EXPECT_EQ(cohort.patients, 6U);
  ASSERT_EQ(cohort.depths.size(), 4U);
  for (const DepthDistributions& depth : cohort.depths) {
    EXPECT_EQ(depth.bestOfPsr, depth.depth == 7 ? 6U : 0U) << depth.depth;
    EXPECT_EQ(depth.bestOfAll, depth.depth == 7 ? 6U : 0U) << depth.depth;
    EXPECT_EQ(depth.models.score.patients, 6U);
  }
  EXPECT_EQ(cohort.mcsdBestOfAll, 0U);
}

TEST(PublishedCohort, ScoresHaveTheMeanAndSpreadOfTheSecondTable) {
  const CohortStatistics cohort = statisticsOf(publishedPatients());
  const std::vector<double> means{1.0, 2.374 / 6, 1.058 / 6, 2.386 / 6};  // sums of the columns
  for (std::size_t n = 0; n < means.size(); ++n) {
    EXPECT_EQ(cohort.depths[n].depth, 5 + static_cast<int>(n));
    EXPECT_NEAR(cohort.depths[n].models.score.mean, means[n], 1e-12);
  }
  EXPECT_EQ(cohort.depths[0].models.score.deviation, 0.0);
  const Distribution& seven = cohort.depths[2].models.score;
  EXPECT_EQ(seven.least, 0.148);
  EXPECT_EQ(seven.greatest, 0.248);
  EXPECT_NEAR(*seven.deviation, 0.0373, 5e-5);
}

TEST(PublishedCohort, TheBestPsrSavesEightyPercentOfTheTrianglesAtEqualSmoothness) {
  const CohortStatistics cohort = statisticsOf(publishedPatients());
  const Distribution& reduction = cohort.againstMostSimilar.fewerTrianglesPercent;
  EXPECT_NEAR(reduction.mean, 79.59, 0.15);  // from rounded thousands 79.68
  EXPECT_NEAR(*reduction.deviation, 11.51, 0.005);
  EXPECT_NEAR(reduction.least, 63.77, 0.005);
  EXPECT_NEAR(reduction.greatest, 90.49, 0.005);
  EXPECT_NEAR(cohort.bestPsr.triangles.mean, 72.0e3, 1.0);  // the text has 72.4 K from unrounded numbers
  EXPECT_NEAR(cohort.mostSimilarMcsd.triangles.mean, 460e3, 500);
  EXPECT_NEAR(cohort.againstMostSimilar.meanErrorDifferenceMm.mean, 6.13 / 6 - 4.84 / 6, 1e-12);
}

TEST(PublishedCohort, TimesAreThoseOfTheFifthTable) {
  const CohortStatistics cohort = statisticsOf(publishedPatients());
  EXPECT_NEAR(cohort.bestPsr.seconds.mean, 14.5, 0.05);
  EXPECT_NEAR(*cohort.bestPsr.seconds.deviation, 1.24, 0.1);
  EXPECT_NEAR(cohort.mostSimilarMcsd.seconds.mean, 12.05, 0.005);
  EXPECT_NEAR(cohort.bestMcsd.seconds.mean, 14.08, 0.005);
}

TEST(PublishedCohort, IsTheSameInAnyOrderOfPatientsUpToRounding) {
  std::vector<PatientFigures> patients = publishedPatients();
  const CohortStatistics before = statisticsOf(patients);
  std::reverse(patients.begin(), patients.end());
  const CohortStatistics after = statisticsOf(patients);
  EXPECT_EQ(before.depths[2].bestOfAll, after.depths[2].bestOfAll);
  EXPECT_NEAR(before.againstMostSimilar.fewerTrianglesPercent.mean, after.againstMostSimilar.fewerTrianglesPercent.mean, 1e-12);
  EXPECT_EQ(before.againstMostSimilar.fewerTrianglesPercent.greatest, after.againstMostSimilar.fewerTrianglesPercent.greatest);
}

// ---- hand-made patients

TEST(Cohort, AModelThatAPatientLacksLeavesTheOthersToCount) {
  PatientFigures whole;
  whole.psr = {{6, {.triangles = 10, .score = 0.5}}, {7, {.triangles = 40, .score = 0.25}}};
  whole.bestDepth = 7;
  whole.bestMcsd = ModelFigures{.triangles = 80, .score = 0.3};
  PatientFigures small;
  small.psr = {{6, {.triangles = 20, .score = 0.7}}};
  small.bestDepth = 6;
  small.bestMcsd = ModelFigures{.triangles = 30, .score = 0.1};
  const CohortStatistics cohort = statisticsOf(std::vector{whole, small});
  ASSERT_EQ(cohort.depths.size(), 2U);
  EXPECT_EQ(cohort.depths[0].models.triangles.patients, 2U);
  EXPECT_EQ(cohort.depths[0].models.triangles.mean, 15);
  EXPECT_EQ(cohort.depths[1].models.triangles.patients, 1U);
  EXPECT_EQ(cohort.depths[1].models.triangles.deviation, std::nullopt);
  EXPECT_EQ(cohort.depths[0].bestOfPsr, 1U);
  EXPECT_EQ(cohort.depths[0].bestOfAll, 0U);
  EXPECT_EQ(cohort.depths[1].bestOfAll, 1U);
  EXPECT_EQ(cohort.mcsdBestOfAll, 1U);
  EXPECT_EQ(cohort.mostSimilarMcsd.score.patients, 0U);
  EXPECT_EQ(cohort.againstMostSimilar.fewerTrianglesPercent.patients, 0U);
  EXPECT_EQ(cohort.againstBestMcsd.fewerTrianglesPercent.mean, (50 + 100.0 / 3) / 2);
}

TEST(Cohort, OfEqualScoresPsrIsTheBestAsInTheExperiment) {
  PatientFigures patient;
  patient.psr = {{7, {.score = 0.25}}};
  patient.bestDepth = 7;
  patient.bestMcsd = ModelFigures{.score = 0.25};
  EXPECT_TRUE(patient.psrIsBestOfAll());
  patient.bestMcsd->score = std::nextafter(0.25, 0.0);
  EXPECT_FALSE(patient.psrIsBestOfAll());
}

TEST(Cohort, OfNobodyIsEmpty) {
  const CohortStatistics cohort = statisticsOf({});
  EXPECT_EQ(cohort.patients, 0U);
  EXPECT_TRUE(cohort.depths.empty());
  EXPECT_EQ(cohort.bestPsr.score.patients, 0U);
}

EvaluatedModel model(const ModelRecipe& recipe, std::size_t triangles, double errorMm, double curvature) {
  EvaluatedModel made;
  made.recipe = recipe;
  made.measures.emplace();
  made.measures->triangles = triangles;
  made.measures->paperErrorMm.mean = errorMm;
  made.measures->curvature.trimmedPerMm2 = curvature;
  made.seconds.solve = 2;
  return made;
}

TEST(Cohort, TakesOfAnEvaluationTheModelsThatItChose) {
  EvaluatedModel lost;
  lost.recipe = {.family = ModelFamily::Psr, .depth = 8};
  lost.failure = "The label is too small.";
  const Evaluation evaluation = evaluated({model({.family = ModelFamily::Psr, .depth = 5}, 100, 3.0, 0.5),
                                           model({.family = ModelFamily::Psr, .depth = 6}, 400, 1.2, 0.3), lost,
                                           model({.family = ModelFamily::Mcsd, .smoothing = 22}, 2000, 1.0, 0.32),
                                           model({.family = ModelFamily::Mcsd, .decimationPercent = 90}, 600, 1.5, 5.0),
                                           model({.family = ModelFamily::SimplifiedPsr, .depth = 8, .divisor = 16}, 50, 1.1, 0.3)});
  const PatientFigures patient = figuresOf(evaluation);
  ASSERT_EQ(patient.psr.size(), 2U);
  EXPECT_EQ(patient.bestDepth, 6);
  EXPECT_EQ(patient.bestPsr()->triangles, 400);
  EXPECT_EQ(patient.bestPsr()->score, evaluation.scores[1]->score);
  EXPECT_EQ(patient.bestPsr()->seconds, 2);
  EXPECT_EQ(patient.mostSimilarMcsd->id, "mcsd_s22_e0");
  EXPECT_EQ(patient.bestMcsd->id, "mcsd_s0_e90");
  EXPECT_EQ(patient.bestSimplified->id, "simplified_16");
  EXPECT_EQ(patient.failures, std::vector<std::string>{"PSR d=8: The label is too small."});
  EXPECT_EQ(patient.psrIsBestOfAll(), evaluation.bestOfAll == evaluation.bestPsr);
  EXPECT_NEAR(againstMostSimilar(patient)->fewerTrianglesPercent, 80.0, 1e-12);
  EXPECT_NEAR(againstMostSimilar(patient)->meanErrorDifferenceMm, 0.2, 1e-12);
}

}  // namespace
}  // namespace glisson
