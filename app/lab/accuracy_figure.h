#pragma once
// Purpose: Fig. 7 of Palomar et al. 2016 as values: the mean paper error (mm) over the number of triangles (logarithmic) of all
// models, with both Pareto fronts as stairs. Where everything stands, in pixels, y downwards; the SVG and the window draw it.

#include <string>
#include <vector>

#include "app/lab/svg.h"
#include "reconstruction/evaluation/evaluation.h"

namespace glisson::lab {

/// How a family is told apart: by its shape as well as by its colour.
struct FamilyLook {
  Mark mark = Mark::Circle;
  const char* style = "";   ///< class of plotSheet()
  const char* onDark = "";  ///< its colour on a dark ground, "#rrggbb"
  const char* name = "";    ///< English
};
FamilyLook lookOf(ModelFamily family);
/// Every family of `recipes` once, in their order.
std::vector<ModelFamily> familiesOf(const std::vector<ModelRecipe>& recipes);

/// The area of the axes, pixels.
struct PlotArea {
  double left = 0;
  double right = 1;
  double top = 0;
  double bottom = 1;
};

struct AxisTick {
  double at = 0;  ///< x or y
  double value = 0;
  bool numbered = true;  ///< false where its number would meet the one before
};

struct FigureMark {
  std::size_t place = 0;  ///< in the evaluation
  Pixel at;
  FamilyLook look;
  double radius = 4;
};

struct AccuracyFigure {
  PlotArea area;
  std::vector<AxisTick> triangles;
  std::vector<AxisTick> errors;
  std::vector<Pixel> beside;          ///< models that are no part of the evaluation, in the order given
  std::vector<FigureMark> marks;      ///< in the order to draw them: the many first, so that the few stand on top
  std::vector<Pixel> publishedFront;  ///< corners; empty where fewer than two models are on it
  std::vector<Pixel> simplifiedFront;

  [[nodiscard]] const FigureMark* markOf(std::size_t place) const;
  /// The mark nearest to a pixel, nothing where none is within `reach`.
  [[nodiscard]] const FigureMark* markAt(const Pixel& pixel, double reach) const;
};

/// Models without measures are left out; without any the figure is empty. `beside`: of models that have a place on the axes, but no
/// part in scores and fronts.
AccuracyFigure accuracyFigure(const Evaluation& evaluation, const PlotArea& area, const std::vector<ModelMeasures>& beside = {});

}  // namespace glisson::lab
