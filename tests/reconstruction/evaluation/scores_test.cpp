// The formulas of section 3 of Palomar et al. 2016, on hand-made sets and on numbers derivable from the published tables. Where the
// paper's text and its tables disagree (method.md 4 lists the slips), the tables count.

#include "reconstruction/evaluation/scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "published_tables.h"
#include "reconstruction/evaluation/statistics.h"

namespace glisson {
namespace {

using test::kPublished;
using test::PublishedModel;
using test::PublishedPatient;
using Front = std::vector<bool>;

Objectives objectivesOf(const PublishedModel& model) { return {model.meanErrorMm, 1000 * model.kiloTriangles}; }

template <typename Value>
Spread overPatients(Value value) {
  std::vector<double> values;
  for (const PublishedPatient& patient : kPublished) {
    values.push_back(value(patient));
  }
  return spreadOf(values);
}

// ---- hand-made sets

TEST(Scores, NormalisationPutsTheExtremesAtZeroAndOne) {
  const std::vector<Objectives> models{{1.0, 100}, {3.0, 500}, {1.5, 200}};
  const ObjectiveBounds bounds = boundsOf(models);
  EXPECT_EQ(normalised(models[0], bounds).error, 0.0);
  EXPECT_EQ(normalised(models[1], bounds).error, 1.0);
  EXPECT_EQ(normalised(models[1], bounds).triangles, 1.0);
  EXPECT_DOUBLE_EQ(normalised(models[2], bounds).error, 0.25);
  EXPECT_DOUBLE_EQ(normalised(models[2], bounds).triangles, 0.25);
  EXPECT_DOUBLE_EQ(normalised(models[2], bounds).score(), std::sqrt(0.125));
  EXPECT_THROW(boundsOf(std::vector<Objectives>{}), std::invalid_argument);
}

TEST(Scores, AModelOutsideTheBoundsLeavesTheUnitInterval) {
  const ObjectiveBounds bounds{{1.0, 100}, {2.0, 200}};
  EXPECT_DOUBLE_EQ(normalised({0.5, 300}, bounds).error, -0.5);
  EXPECT_DOUBLE_EQ(normalised({0.5, 300}, bounds).triangles, 2.0);
}

TEST(Scores, OfASingleModelAndOfEqualOnesAreZero) {
  for (const std::size_t count : {1U, 3U}) {
    const std::vector<Objectives> models(count, {0.7, 1000});
    EXPECT_EQ(normalised(models[0], boundsOf(models)).score(), 0.0);
    EXPECT_EQ(onParetoFront(models), Front(count, true));
  }
  // Equal errors alone leave the triangles to decide.
  const std::vector<Objectives> models{{0.7, 100}, {0.7, 300}};
  EXPECT_EQ(normalised(models[0], boundsOf(models)).score(), 0.0);
  EXPECT_EQ(normalised(models[1], boundsOf(models)).score(), 1.0);
  EXPECT_EQ(onParetoFront(models), (Front{true, false}));
}

TEST(Scores, TheFirstOfSeveralEqualOnesIsChosen) {
  EXPECT_EQ(placeOfLeast(std::vector<double>{2, 1, 1, 3}), 1U);
  EXPECT_EQ(placeOfNearest(std::vector<double>{0, 4, 2, 2}, 3), 1U);
  EXPECT_EQ(placeOfNearest(std::vector<double>{5}, -100), 0U);
  EXPECT_EQ(placeOfLeast(std::vector<double>{}), std::nullopt);
}

TEST(ParetoFront, KeepsEqualModelsTogetherAndDropsWhatAnotherBeatsInOne) {
  EXPECT_EQ(onParetoFront(std::vector<Objectives>{{3, 1}, {1, 3}, {2, 2}, {2, 2}, {2, 3}, {3, 2}, {1, 4}}),
            (Front{true, true, true, true, false, false, false}));
  EXPECT_EQ(onParetoFront(std::vector<Objectives>{}), Front{});
}

TEST(ParetoFront, IsThatOfTheDefinitionOnRandomModelsWithTies) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Objectives> models(1 + random() % 30);
    for (Objectives& model : models) {
      model = {static_cast<double>(random() % 8), static_cast<double>(random() % 8)};
    }
    Front expected;
    for (const Objectives& model : models) {
      expected.push_back(std::none_of(models.begin(), models.end(), [&](const Objectives& other) {
        return other.errorMm <= model.errorMm && other.triangles <= model.triangles &&
               (other.errorMm < model.errorMm || other.triangles < model.triangles);
      }));
    }
    EXPECT_EQ(onParetoFront(models), expected);
  }
}

// ---- the published tables

TEST(PublishedScores, TheCoarsestModelScoresOneSinceItHasTheFewestTrianglesAndTheGreatestError) {
  const std::vector<Objectives> models{{3.69, 4000}, {1.89, 16000}, {1.03, 70000}, {0.6, 700000}};
  EXPECT_EQ(normalised(models[0], boundsOf(models)).score(), 1.0);
  for (const PublishedPatient& patient : kPublished) {
    EXPECT_EQ(patient.psrScores[0], 1.0);
  }
}

TEST(PublishedScores, DepthSevenIsTheBestOfAllAndOtherDepthsScoreAboveTheBestMcsd) {
  for (const PublishedPatient& patient : kPublished) {
    std::vector<double> scores(patient.psrScores.begin(), patient.psrScores.end());
    scores.push_back(patient.bestMcsd.score);
    EXPECT_EQ(placeOfLeast(scores), 2U);
    for (const std::size_t other : {0U, 1U, 3U}) {
      EXPECT_GT(patient.psrScores[other], patient.bestMcsd.score);
    }
    // Table 3 cuts the third digit off.
    EXPECT_NEAR(patient.bestPsr.score, patient.psrScores[2], 0.01);
  }
}

TEST(PublishedScores, OfTheFirstPatientFollowFromItsModels) {
  // C_sim has score 1.00: the most triangles and the least error. d=5 has a quarter of a quarter of d=7's triangles and the
  // greatest error, which the score of d=7 gives. Then the score of C_best is no free number any more.
  const PublishedPatient& patient = kPublished[0];
  const double fewest = 1000 * patient.bestPsr.kiloTriangles / 16;
  const double most = 1000 * patient.mostSimilar.kiloTriangles;
  const double triangles = normalised(objectivesOf(patient.bestPsr), {{0, fewest}, {1, most}}).triangles;
  const double error = std::sqrt(patient.psrScores[2] * patient.psrScores[2] - triangles * triangles);
  const double least = patient.mostSimilar.meanErrorMm;
  const double greatest = least + (patient.bestPsr.meanErrorMm - least) / error;
  EXPECT_NEAR(greatest, 3.69, 0.59);  // the median error of d=5 in 4.1

  const ObjectiveBounds bounds{{least, fewest}, {greatest, most}};
  EXPECT_NEAR(normalised(objectivesOf(patient.bestPsr), bounds).score(), 0.184, 1e-12);
  EXPECT_NEAR(normalised(objectivesOf(patient.mostSimilar), bounds).score(), 1.00, 1e-12);
  EXPECT_NEAR(normalised(objectivesOf(patient.bestMcsd), bounds).score(), 0.22, 0.01);
}

TEST(PublishedFront, LosesTheSimilarModelOfTheSecondPatientAndTheBestMcsdOfTheFifth) {
  // 4.1 puts every best MCSD on the front; in Table 3 the fifth patient's has more triangles and a greater error than its best PSR.
  for (std::size_t n = 0; n < kPublished.size(); ++n) {
    const PublishedPatient& patient = kPublished[n];
    const std::vector<Objectives> models{objectivesOf(patient.bestPsr), objectivesOf(patient.mostSimilar),
                                         objectivesOf(patient.bestMcsd)};
    EXPECT_EQ(onParetoFront(models), (Front{true, n != 1, n != 4})) << n;
  }
}

TEST(PublishedCurvature, TheSimilarModelIsNearerToTheBestPsrThanTheBestMcsd) {
  for (const PublishedPatient& patient : kPublished) {
    EXPECT_EQ(placeOfNearest(std::vector<double>{patient.bestMcsdCurvature, patient.similarCurvature}, patient.psrCurvatures[2]),
              1U);
  }
}

TEST(PublishedCurvature, MeansAreThoseOfTheTableNotOfTheText) {
  EXPECT_NEAR(overPatients([](const PublishedPatient& p) { return p.psrCurvatures[2]; }).mean, 30.2, 0.05);  // "0.03"
  EXPECT_NEAR(overPatients([](const PublishedPatient& p) { return p.similarCurvature; }).mean, 16.2, 0.05);  // "9.67"
}

TEST(PublishedReduction, IsTheMeanOfThePatientsReductions) {
  const auto reduction = [](const PublishedPatient& p) {
    return reductionPercent(p.bestPsr.kiloTriangles, p.mostSimilar.kiloTriangles);
  };
  EXPECT_NEAR(reduction(kPublished[0]), 90.08, 1e-9);
  EXPECT_NEAR(overPatients(reduction).mean, 79.59, 0.15);  // from rounded thousands: 79.68
  // Of the mean numbers of triangles it would be another one.
  const auto mean = [](auto value) { return overPatients(value).mean; };
  EXPECT_GT(reductionPercent(mean([](const PublishedPatient& p) { return p.bestPsr.kiloTriangles; }),
                             mean([](const PublishedPatient& p) { return p.mostSimilar.kiloTriangles; })),
            84.0);
  EXPECT_EQ(reductionPercent(3, 0), 0.0);
  EXPECT_EQ(reductionPercent(3, 2), -50.0);
}

TEST(PublishedErrors, MeansOfPsrAndMcsdAreSwappedInTheText) {
  EXPECT_NEAR(overPatients([](const PublishedPatient& p) { return p.bestPsr.meanErrorMm; }).mean, 1.02, 0.005);
  EXPECT_NEAR(overPatients([](const PublishedPatient& p) { return p.bestMcsd.meanErrorMm; }).mean, 1.16, 0.005);
  EXPECT_NEAR(overPatients([](const PublishedPatient& p) { return p.mostSimilar.meanErrorMm; }).mean, 0.81, 0.005);
}

TEST(PublishedTimes, MeansAndDeviationsAreThoseOfTheTable) {
  const auto spread = [](std::size_t column) { return overPatients([=](const PublishedPatient& p) { return p.seconds[column]; }); };
  EXPECT_NEAR(spread(0).mean, 14.5, 0.05);
  EXPECT_NEAR(spread(1).mean, 12.05, 0.005);
  EXPECT_NEAR(spread(2).mean, 14.08, 0.005);  // printed as 14.8
  EXPECT_NEAR(spread(0).deviation, 1.24, 0.1);
  EXPECT_NEAR(spread(1).deviation, 4.06, 0.1);
  EXPECT_NEAR(spread(2).deviation, 4.45, 0.1);
}

// ---- box plots

TEST(BoxPlots, WhiskersEndAtTheLastValueWithinReachOfTheBox) {
  const std::vector<double> values{-10, 1, 2, 3, 4, 5, 6, 7, 8, 9, 40};
  const BoxPlot box = boxPlotOf(values);
  EXPECT_EQ(box.lowQuartile, 2);
  EXPECT_EQ(box.median, 5);
  EXPECT_EQ(box.highQuartile, 8);
  EXPECT_EQ(box.lowWhisker, 1);
  EXPECT_EQ(box.highWhisker, 9);
  EXPECT_EQ(box.outliers, 2U);
}

TEST(BoxPlots, OfOneValueOrNoneAreFlat) {
  const BoxPlot one = boxPlotOf(std::vector<double>{3});
  EXPECT_EQ(one.lowWhisker, 3);
  EXPECT_EQ(one.highWhisker, 3);
  EXPECT_EQ(one.median, 3);
  EXPECT_EQ(one.outliers, 0U);
  EXPECT_EQ(boxPlotOf({}).highWhisker, 0);
  EXPECT_EQ(spreadOf({}).mean, 0);
  EXPECT_EQ(spreadOf(std::vector<double>{4}).deviation, 0);
}

}  // namespace
}  // namespace glisson
