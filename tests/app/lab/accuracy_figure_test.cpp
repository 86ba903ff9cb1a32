// The accuracy figure: where models and fronts stand, and the same as SVG.

#include "app/lab/accuracy_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/lab/accuracy_svg.h"

namespace glisson::lab {
namespace {

EvaluatedModel model(const ModelRecipe& recipe, std::size_t triangles, double errorMm) {
  EvaluatedModel made;
  made.recipe = recipe;
  made.usedDepth = recipe.depth;
  made.measures.emplace();
  made.measures->triangles = triangles;
  made.measures->paperErrorMm.mean = errorMm;
  return made;
}

/// Two PSR models and one MCSD model on the published front, one MCSD model behind it, two simplified ones on theirs, one failed.
Evaluation someModels() {
  EvaluatedModel failed;
  failed.recipe = {.family = ModelFamily::Psr, .depth = 8};
  failed.failure = "too small";
  return evaluated({model({.family = ModelFamily::Psr, .depth = 5}, 1000, 1.0),
                    model({.family = ModelFamily::Psr, .depth = 6}, 10000, 0.25), failed,
                    model({.family = ModelFamily::Mcsd, .smoothing = 22}, 3000, 0.5),
                    model({.family = ModelFamily::Mcsd, .smoothing = 90}, 30000, 0.75),
                    model({.family = ModelFamily::SimplifiedPsr, .depth = 8, .divisor = 4}, 8000, 0.2),
                    model({.family = ModelFamily::SimplifiedPsr, .depth = 8, .divisor = 16}, 2000, 0.3)});
}

constexpr PlotArea kArea{100, 500, 20, 320};

TEST(AccuracyFigure, StandsLogarithmicallyInTrianglesAndLinearlyInError) {
  const AccuracyFigure figure = accuracyFigure(someModels(), kArea);
  ASSERT_EQ(figure.marks.size(), 6U);
  EXPECT_EQ(figure.markOf(2), nullptr) << "a model that failed has no mark";
  const double decade = figure.markOf(1)->at.x - figure.markOf(0)->at.x;
  EXPECT_NEAR(figure.markOf(4)->at.x - figure.markOf(3)->at.x, decade, 1e-9) << "3,000 to 30,000 as 1,000 to 10,000";
  EXPECT_GT(decade, 0);
  const auto heightOf = [&](std::size_t place) { return kArea.bottom - figure.markOf(place)->at.y; };
  EXPECT_NEAR(heightOf(0), 4 * heightOf(1), 1e-9);
  for (const FigureMark& mark : figure.marks) {
    EXPECT_GE(mark.at.x, kArea.left);
    EXPECT_LE(mark.at.x, kArea.right);
    EXPECT_GE(mark.at.y, kArea.top);
    EXPECT_LE(mark.at.y, kArea.bottom);
  }
}

TEST(AccuracyFigure, ModelsBesideHaveAPlaceOnTheAxesAndNoPartInFronts) {
  const AccuracyFigure alone = accuracyFigure(someModels(), kArea);
  const std::vector<ModelMeasures> beside{*model({}, 3000000, 0.05).measures, *model({}, 10000, 0.25).measures};
  const AccuracyFigure figure = accuracyFigure(someModels(), kArea, beside);
  ASSERT_EQ(figure.beside.size(), 2U);
  EXPECT_GT(figure.beside[0].x, figure.markOf(4)->at.x);
  EXPECT_LE(figure.beside[0].x, kArea.right);
  EXPECT_LE(figure.beside[0].y, kArea.bottom);
  EXPECT_NEAR(figure.beside[1].x, figure.markOf(1)->at.x, 1e-9);
  EXPECT_NEAR(figure.beside[1].y, figure.markOf(1)->at.y, 1e-9);
  EXPECT_EQ(figure.marks.size(), alone.marks.size());
  EXPECT_EQ(figure.publishedFront.size(), alone.publishedFront.size());
  EXPECT_EQ(figure.markAt(figure.beside[0], 1), nullptr) << "it cannot be chosen as a model of the experiment";
  const AccuracyFigure only = accuracyFigure({}, kArea, beside);
  EXPECT_TRUE(only.marks.empty());
  EXPECT_EQ(only.beside.size(), 2U);
  EXPECT_FALSE(only.triangles.empty());
}

TEST(AccuracyFigure, FrontsAreStairsFromModelToModel) {
  const AccuracyFigure figure = accuracyFigure(someModels(), kArea);
  ASSERT_EQ(figure.publishedFront.size(), 5U) << "three models and two corners";
  const auto expectAt = [&](std::size_t corner, double x, double y) {
    EXPECT_DOUBLE_EQ(figure.publishedFront[corner].x, x);
    EXPECT_DOUBLE_EQ(figure.publishedFront[corner].y, y);
  };
  const Pixel first = figure.markOf(0)->at;
  const Pixel second = figure.markOf(3)->at;
  const Pixel third = figure.markOf(1)->at;
  expectAt(0, first.x, first.y);
  expectAt(1, second.x, first.y);
  expectAt(2, second.x, second.y);
  expectAt(3, third.x, second.y);
  expectAt(4, third.x, third.y);
  EXPECT_EQ(figure.simplifiedFront.size(), 3U);
}

TEST(AccuracyFigure, FindsTheNearestMarkWithinReach) {
  const AccuracyFigure figure = accuracyFigure(someModels(), kArea);
  const Pixel at = figure.markOf(1)->at;
  ASSERT_NE(figure.markAt({at.x + 3, at.y - 2}, 8), nullptr);
  EXPECT_EQ(figure.markAt({at.x + 3, at.y - 2}, 8)->place, 1U);
  EXPECT_EQ(figure.markAt({at.x, at.y - 60}, 8), nullptr);
}

TEST(AccuracyFigure, IsEmptyWithoutMeasuredModels) {
  EXPECT_TRUE(accuracyFigure({}, kArea).marks.empty());
  EvaluatedModel failed;
  failed.failure = "no surface";
  const AccuracyFigure figure = accuracyFigure(evaluated({failed}), kArea);
  EXPECT_TRUE(figure.marks.empty());
  EXPECT_TRUE(figure.errors.empty());
}

TEST(AccuracyFigure, ShowsTheThirdFamilyAlone) {
  const AccuracyFigure figure =
      accuracyFigure(evaluated({model({.family = ModelFamily::SimplifiedPsr, .depth = 8, .divisor = 4}, 8000, 0.2)}), kArea);
  EXPECT_EQ(figure.marks.size(), 1U) << "no published model bounds the scores, yet it was measured";
}

TEST(AccuracyFigure, FamiliesDifferInShape) {
  std::vector<Mark> shapes;
  for (const ModelFamily family : familiesOf(allRecipes())) {
    EXPECT_EQ(std::count(shapes.begin(), shapes.end(), lookOf(family).mark), 0) << lookOf(family).name;
    shapes.push_back(lookOf(family).mark);
  }
  EXPECT_EQ(shapes.size(), 4U);
}

TEST(AccuracySvg, HasAMarkWithATooltipForEachMeasuredModel) {
  const std::string svg = accuracySvg(someModels());
  std::size_t titles = 0;
  for (std::size_t at = svg.find("<title>"); at != std::string::npos; at = svg.find("<title>", at + 1)) {
    ++titles;
  }
  EXPECT_EQ(titles, 6U);
  EXPECT_NE(svg.find("PSR d=6: 10\u202f000 triangles, mean error 0.250 mm"), std::string::npos);
}

TEST(AccuracySvg, ShowsScoresAndChoicesOnceTheyAreFinal) {
  Evaluation evaluation = someModels();
  const std::string before = accuracySvg(evaluation);
  evaluation.publishedComplete = true;
  const std::string after = accuracySvg(evaluation);
  for (const char* word : {", score ", "best PSR", "front of PSR and MCSD"}) {
    EXPECT_EQ(before.find(word), std::string::npos) << word;
    EXPECT_NE(after.find(word), std::string::npos) << word;
  }
  EXPECT_NE(before.find("front so far"), std::string::npos);
}

TEST(AccuracySvg, AFileCarriesItsNamespaceAndStyle) {
  const std::string picture = accuracySvg(someModels());
  const std::string file = svgFile(picture);
  EXPECT_EQ(file.find("<?xml version=\"1.0\""), 0U);
  EXPECT_NE(file.find("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 920 520\""), std::string::npos);
  EXPECT_NE(file.find("<style>"), std::string::npos);
  EXPECT_EQ(file.substr(file.size() - 40), picture.substr(picture.size() - 40));
}

}  // namespace
}  // namespace glisson::lab
