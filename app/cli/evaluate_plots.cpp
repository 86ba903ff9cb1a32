#include "app/cli/evaluate_plots.h"

#include <algorithm>

#include "app/lab/accuracy_figure.h"
#include "app/lab/svg.h"
#include "reconstruction/text.h"

namespace glisson::cli {

using lab::Axis;
using lab::kPlotLeft;
using lab::kPlotRight;
using lab::kPlotWidth;
using lab::svgGridLine;
using lab::svgLine;
using lab::svgPicture;
using lab::svgRectangle;
using lab::svgText;
using lab::tickText;

namespace {

constexpr double kTop = 44;

/// Grid lines, numbers and the name of the vertical axis.
std::string errorAxis(const Axis& axis) {
  std::string content;
  for (const double tick : axis.ticks(6)) {
    content += svgGridLine(axis.at(tick), tick);
  }
  return content + svgText({kPlotLeft - 48, kTop - 18}, "error (mm)", "start", "axis");
}

}  // namespace

std::string boxPlots(const Evaluation& evaluation, const std::vector<std::size_t>& places) {
  constexpr double kHeight = 360;
  constexpr double kBottom = kHeight - 52;
  double highest = 0;
  for (const std::size_t place : places) {
    highest = std::max(highest, evaluation.models[place].measures->paperErrorBoxMm.highWhisker);
  }
  if (places.empty()) {
    return {};
  }
  const Axis error(0, highest > 0 ? 1.08 * highest : 1.0, kBottom, kTop);
  std::string content = errorAxis(error);
  const double step = (kPlotRight - kPlotLeft) / static_cast<double>(places.size());
  const double half = std::min(34.0, 0.3 * step);
  for (std::size_t n = 0; n < places.size(); ++n) {
    const EvaluatedModel& model = evaluation.models[places[n]];
    const BoxPlot& box = model.measures->paperErrorBoxMm;
    const double x = kPlotLeft + (static_cast<double>(n) + 0.5) * step;
    const std::string style = lab::lookOf(model.recipe.family).style;
    content += svgLine({x, error.at(box.lowWhisker)}, {x, error.at(box.lowQuartile)}, "whisker");
    content += svgLine({x, error.at(box.highQuartile)}, {x, error.at(box.highWhisker)}, "whisker");
    for (const double end : {box.lowWhisker, box.highWhisker}) {
      content += svgLine({x - 0.5 * half, error.at(end)}, {x + 0.5 * half, error.at(end)}, "whisker");
    }
    content += svgRectangle({x - half, error.at(box.highQuartile)}, 2 * half,
                            error.at(box.lowQuartile) - error.at(box.highQuartile), "box " + style);
    content += svgLine({x - half, error.at(box.median)}, {x + half, error.at(box.median)}, "median");
    content += svgText({x + half + 4, error.at(box.median) + 4}, formatNumber(box.median, 2), "start", "tick");
    content += svgText({x, kBottom + 20}, model.name(), "middle", "tick");
    content += svgText({x, kBottom + 38}, tickText(static_cast<double>(model.measures->triangles)), "middle", "faint");
  }
  content += svgText({kPlotLeft - 48, kBottom + 38}, "triangles", "start", "faint");
  return svgPicture(kPlotWidth, kHeight, "Box plots of the error", content);
}

}  // namespace glisson::cli
