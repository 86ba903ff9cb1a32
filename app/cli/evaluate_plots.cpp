#include "app/cli/evaluate_plots.h"

#include <algorithm>
#include <functional>

#include "app/cli/svg.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

constexpr double kWidth = 920;
constexpr double kLeft = 64;
constexpr double kRight = kWidth - 16;
constexpr double kTop = 44;

/// Grid lines, numbers and the name of the vertical axis.
std::string errorAxis(const Axis& axis) {
  std::string content;
  for (const double tick : axis.ticks(6)) {
    content += svgLine({kLeft, axis.at(tick)}, {kRight, axis.at(tick)}, "grid");
    content += svgText({kLeft - 8, axis.at(tick) + 4}, tickText(tick), "end", "tick");
  }
  return content + svgText({kLeft - 48, kTop - 18}, "error (mm)", "start", "axis");
}

struct Look {
  Mark mark;
  const char* style;
  const char* name;
};
Look lookOf(ModelFamily family) {
  switch (family) {
    case ModelFamily::Psr:
      return {Mark::Diamond, "psr", "PSR"};
    case ModelFamily::Mcsd:
      return {Mark::Circle, "mcsd", "MCSD"};
    case ModelFamily::SimplifiedPsr:
      return {Mark::Triangle, "simplified", "simplified PSR"};
    case ModelFamily::Other:
      break;
  }
  return {Mark::Square, "other", "other methods"};
}

/// Texts beside marks, each in the first place where it covers neither another text nor a mark, or at least no text.
class Labels {
 public:
  Labels(double right, double bottom) : right_(right), bottom_(bottom) {}

  void avoid(const Pixel& mark) { marks_.push_back({mark.x - 6, mark.y - 6, mark.x + 6, mark.y + 6}); }

  std::string place(const Pixel& mark, const std::string& text) {
    for (const bool clearOfMarks : {true, false}) {
      for (const double lift : {-14.0, 22.0, -34.0, 42.0, -54.0, 62.0, -74.0, 82.0, -94.0}) {
        for (const bool toTheRight : {true, false}) {
          const double width = 6.9 * static_cast<double>(text.size());
          const double x = toTheRight ? mark.x + 14 : mark.x - 14 - width;
          const Box box{x, mark.y + lift - 12, x + width, mark.y + lift + 4};
          if (isFree(box, clearOfMarks)) {
            texts_.push_back(box);
            return svgLine(mark, {toTheRight ? x - 2 : box.right + 2, mark.y + lift - 4}, "leader") +
                   svgText({x, mark.y + lift}, text, "start", "label");
          }
        }
      }
    }
    return {};
  }

 private:
  struct Box {
    double left, top, right, bottom;
    [[nodiscard]] bool meets(const Box& other) const {
      return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
  };
  [[nodiscard]] bool isFree(const Box& box, bool clearOfMarks) const {
    const auto meets = [&](const Box& other) { return box.meets(other); };
    return box.left >= kLeft && box.right <= right_ && box.top >= kTop && box.bottom <= bottom_ &&
           std::none_of(texts_.begin(), texts_.end(), meets) &&
           (!clearOfMarks || std::none_of(marks_.begin(), marks_.end(), meets));
  }

  double right_;
  double bottom_;
  std::vector<Box> texts_;
  std::vector<Box> marks_;
};

struct Plot {
  const Evaluation& evaluation;
  Axis triangles;
  Axis error;

  [[nodiscard]] Pixel at(std::size_t place) const {
    const ModelMeasures& measures = *evaluation.models[place].measures;
    return {triangles.at(static_cast<double>(measures.triangles)), error.at(measures.paperErrorMm.mean)};
  }
  /// A front bounds what no model reaches: from each of its models with that number of triangles to the next.
  [[nodiscard]] std::string front(const std::function<bool(ModelFamily)>& belongs, std::string_view style) const {
    std::vector<Pixel> marks;
    for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
      if (belongs(evaluation.models[n].recipe.family) && evaluation.scores[n] && evaluation.scores[n]->pareto) {
        marks.push_back(at(n));
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
    return stairs.size() > 1 ? svgPath(stairs, style) : std::string();
  }
};

std::string tooltipOf(const EvaluatedModel& model, const ModelScore& score) {
  return model.name() + ": " + tickText(static_cast<double>(model.measures->triangles)) + " triangles, mean error " +
         formatNumber(model.measures->paperErrorMm.mean, 3) + " mm, score " + formatNumber(score.score, 3) +
         (score.pareto ? ", on the front" : "");
}

std::string legend(const Evaluation& evaluation) {
  std::string content;
  double x = kLeft + 130;
  const double y = kTop - 22;
  for (const ModelFamily family : {ModelFamily::Psr, ModelFamily::Mcsd, ModelFamily::SimplifiedPsr, ModelFamily::Other}) {
    const auto belongs = [&](const EvaluatedModel& model) { return model.measures && model.recipe.family == family; };
    if (std::any_of(evaluation.models.begin(), evaluation.models.end(), belongs)) {
      const Look look = lookOf(family);
      content += svgMark(look.mark, {x, y}, 5, look.style, "") + svgText({x + 11, y + 4}, look.name, "start", "tick");
      x += 44 + 5.8 * static_cast<double>(std::string_view(look.name).size());
    }
  }
  for (const auto& [style, name] : {std::pair("front", "front of PSR and MCSD"), std::pair("front2", "of simplified PSR")}) {
    content += svgLine({x, y}, {x + 24, y}, style) + svgText({x + 30, y + 4}, name, "start", "tick");
    x += 50 + 6.4 * static_cast<double>(std::string_view(name).size());
  }
  return content;
}

}  // namespace

std::string accuracyPlot(const Evaluation& evaluation) {
  constexpr double kHeight = 520;
  constexpr double kBottom = kHeight - 48;
  double least = evaluation.bounds->least.triangles;
  double most = evaluation.bounds->greatest.triangles;
  double highest = 0;
  for (const EvaluatedModel& model : evaluation.models) {
    if (model.measures) {
      least = std::min(least, static_cast<double>(model.measures->triangles));
      most = std::max(most, static_cast<double>(model.measures->triangles));
      highest = std::max(highest, model.measures->paperErrorMm.mean);
    }
  }
  const Plot plot{evaluation, Axis(0.8 * least, 1.25 * most, kLeft, kRight, true),
                  Axis(0, highest > 0 ? 1.08 * highest : 1.0, kBottom, kTop)};
  std::string content = errorAxis(plot.error);
  double lastNumber = -1e9;
  for (const double tick : plot.triangles.ticks(0)) {
    content += svgLine({plot.triangles.at(tick), kTop}, {plot.triangles.at(tick), kBottom}, "grid");
    if (plot.triangles.at(tick) - lastNumber > 56) {
      lastNumber = plot.triangles.at(tick);
      content += svgText({lastNumber, kBottom + 18}, tickText(tick), "middle", "tick");
    }
  }
  content += svgText({kRight, kBottom + 38}, "triangles (logarithmic)", "end", "axis") + legend(evaluation);
  content += plot.front(isPublished, "front") +
             plot.front([](ModelFamily family) { return family == ModelFamily::SimplifiedPsr; }, "front2");
  // The many first, so that the few stand on top.
  for (const ModelFamily family : {ModelFamily::Mcsd, ModelFamily::Other, ModelFamily::SimplifiedPsr, ModelFamily::Psr}) {
    for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
      if (evaluation.scores[n] && evaluation.models[n].recipe.family == family) {
        const Look look = lookOf(family);
        content += svgMark(look.mark, plot.at(n), family == ModelFamily::Mcsd ? 4 : 6, look.style,
                           tooltipOf(evaluation.models[n], *evaluation.scores[n]));
      }
    }
  }
  Labels labels(kRight, kBottom);
  for (std::size_t n = 0; n < evaluation.models.size(); ++n) {
    if (evaluation.scores[n]) {
      labels.avoid(plot.at(n));
    }
  }
  for (const auto& [role, place] : {std::pair("best PSR", evaluation.bestPsr),
                                    {"best MCSD", evaluation.bestMcsd},
                                    {"most similar", evaluation.mostSimilar},
                                    {"best simplified", evaluation.bestSimplified},
                                    {"best other", evaluation.bestOther}}) {
    if (place) {
      content += svgMark(Mark::Circle, plot.at(*place), 10, "ring", "");
      content += labels.place(plot.at(*place), std::string(role) + ": " + evaluation.models[*place].name());
    }
  }
  return svgPicture(kWidth, kHeight, "Mean error over triangles of all models", content);
}

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
  const double step = (kRight - kLeft) / static_cast<double>(places.size());
  const double half = std::min(34.0, 0.3 * step);
  for (std::size_t n = 0; n < places.size(); ++n) {
    const EvaluatedModel& model = evaluation.models[places[n]];
    const BoxPlot& box = model.measures->paperErrorBoxMm;
    const double x = kLeft + (static_cast<double>(n) + 0.5) * step;
    const std::string style = lookOf(model.recipe.family).style;
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
  content += svgText({kLeft - 48, kBottom + 38}, "triangles", "start", "faint");
  return svgPicture(kWidth, kHeight, "Box plots of the error", content);
}

}  // namespace glisson::cli
