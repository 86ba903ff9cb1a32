#include "app/lab/accuracy_figure.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace glisson::lab {

namespace {

constexpr double kNumberWidth = 56;
constexpr int kErrorTicks = 6;

struct Axes {
  Axis triangles;
  Axis error;

  [[nodiscard]] Pixel at(const ModelMeasures& measures) const {
    return {triangles.at(static_cast<double>(measures.triangles)), error.at(measures.paperErrorMm.mean)};
  }
};

Axes axesOf(const Evaluation& evaluation, const PlotArea& area, const std::vector<ModelMeasures>& beside) {
  double least = 1e300;
  double most = 1;
  double highest = 0;
  const auto hold = [&](const ModelMeasures& measures) {
    least = std::min(least, static_cast<double>(measures.triangles));
    most = std::max(most, static_cast<double>(measures.triangles));
    highest = std::max(highest, measures.paperErrorMm.mean);
  };
  for (const EvaluatedModel& model : evaluation.models) {
    if (model.measures) {
      hold(*model.measures);
    }
  }
  std::for_each(beside.begin(), beside.end(), hold);
  return {Axis(0.8 * least, 1.25 * most, area.left, area.right, true),
          Axis(0, highest > 0 ? 1.08 * highest : 1.0, area.bottom, area.top)};
}

/// A front bounds what no model reaches: from each of its models with that number of triangles to the next.
std::vector<Pixel> frontOf(const Evaluation& evaluation, const Axes& axes, const std::function<bool(ModelFamily)>& belongs) {
  std::vector<Pixel> marks;
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    if (belongs(evaluation.models[n].recipe.family) && evaluation.scores[n] && evaluation.scores[n]->pareto) {
      marks.push_back(axes.at(*evaluation.models[n].measures));
    }
  }
  std::sort(marks.begin(), marks.end(), [](const Pixel& a, const Pixel& b) { return a.x < b.x; });
  std::vector<Pixel> stairs;
  for (const Pixel& mark : marks) {
    if (!stairs.empty()) {
      stairs.push_back({mark.x, stairs.back().y});
    }
    stairs.push_back(mark);
  }
  return stairs.size() > 1 ? stairs : std::vector<Pixel>();
}

std::vector<FigureMark> marksOf(const Evaluation& evaluation, const Axes& axes) {
  std::vector<FigureMark> marks;
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    const EvaluatedModel& model = evaluation.models[n];
    if (model.measures) {
      marks.push_back({n, axes.at(*model.measures), lookOf(model.recipe.family), 6});
    }
  }
  const auto countOf = [&](const FigureMark& mark) {
    return std::count_if(marks.begin(), marks.end(), [&](const FigureMark& other) { return other.look.style == mark.look.style; });
  };
  std::vector<std::ptrdiff_t> counts(evaluation.models.size());
  for (FigureMark& mark : marks) {
    counts[mark.place] = countOf(mark);
    mark.radius = counts[mark.place] > 10 ? 4 : 6;
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [&](const FigureMark& a, const FigureMark& b) { return counts[a.place] > counts[b.place]; });
  return marks;
}

}  // namespace

FamilyLook lookOf(ModelFamily family) {
  switch (family) {
    case ModelFamily::Psr:
      return {Mark::Diamond, "psr", "#ff7f63", "PSR"};
    case ModelFamily::Mcsd:
      return {Mark::Circle, "mcsd", "#6fa8ea", "MCSD"};
    case ModelFamily::SimplifiedPsr:
      return {Mark::Triangle, "simplified", "#63cd8d", "simplified PSR"};
    case ModelFamily::Other:
      break;
  }
  return {Mark::Square, "other", "#c99be0", "other methods"};
}

std::vector<ModelFamily> familiesOf(const std::vector<ModelRecipe>& recipes) {
  std::vector<ModelFamily> families;
  for (const ModelRecipe& recipe : recipes) {
    if (std::find(families.begin(), families.end(), recipe.family) == families.end()) {
      families.push_back(recipe.family);
    }
  }
  return families;
}

const FigureMark* AccuracyFigure::markOf(std::size_t place) const {
  const auto found = std::find_if(marks.begin(), marks.end(), [&](const FigureMark& mark) { return mark.place == place; });
  return found == marks.end() ? nullptr : &*found;
}

const FigureMark* AccuracyFigure::markAt(const Pixel& pixel, double reach) const {
  const FigureMark* nearest = nullptr;
  double least = reach;
  for (const FigureMark& mark : marks) {
    const double distance = std::hypot(mark.at.x - pixel.x, mark.at.y - pixel.y);
    if (distance <= least) {  // of marks that lie on one another, the one drawn last
      least = distance;
      nearest = &mark;
    }
  }
  return nearest;
}

AccuracyFigure accuracyFigure(const Evaluation& evaluation, const PlotArea& area, const std::vector<ModelMeasures>& beside) {
  AccuracyFigure figure;
  figure.area = area;
  if (evaluation.failed() == evaluation.models.size() && beside.empty()) {
    return figure;
  }
  const Axes axes = axesOf(evaluation, area, beside);
  for (const ModelMeasures& measures : beside) {
    figure.beside.push_back(axes.at(measures));
  }
  double lastNumber = -1e9;
  for (const double tick : axes.triangles.ticks(0)) {
    const double at = axes.triangles.at(tick);
    const bool numbered = at - lastNumber > kNumberWidth;
    lastNumber = numbered ? at : lastNumber;
    figure.triangles.push_back({at, tick, numbered});
  }
  for (const double tick : axes.error.ticks(kErrorTicks)) {
    figure.errors.push_back({axes.error.at(tick), tick, true});
  }
  figure.marks = marksOf(evaluation, axes);
  figure.publishedFront = frontOf(evaluation, axes, isPublished);
  figure.simplifiedFront = frontOf(evaluation, axes, [](ModelFamily family) { return family == ModelFamily::SimplifiedPsr; });
  return figure;
}

}  // namespace glisson::lab
