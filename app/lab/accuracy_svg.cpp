#include "app/lab/accuracy_svg.h"

#include <algorithm>

#include "app/lab/accuracy_figure.h"
#include "reconstruction/text.h"

namespace glisson::lab {

namespace {

constexpr double kHeight = 520;
constexpr double kTop = 44;
constexpr double kBottom = kHeight - 48;

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
    return box.left >= kPlotLeft && box.right <= right_ && box.top >= kTop && box.bottom <= bottom_ &&
           std::none_of(texts_.begin(), texts_.end(), meets) &&
           (!clearOfMarks || std::none_of(marks_.begin(), marks_.end(), meets));
  }

  double right_;
  double bottom_;
  std::vector<Box> texts_;
  std::vector<Box> marks_;
};

std::string tooltipOf(const EvaluatedModel& model, const ModelScore* score) {
  return model.name() + ": " + tickText(static_cast<double>(model.measures->triangles)) + " triangles, mean error " +
         formatNumber(model.measures->paperErrorMm.mean, 3) + " mm" +
         (score != nullptr ? ", score " + formatNumber(score->score, 3) + (score->pareto ? ", on the front" : "") : std::string());
}

std::string legend(const Evaluation& evaluation) {
  std::string content;
  double x = kPlotLeft + 130;
  const double y = kTop - 22;
  std::vector<ModelRecipe> shown;
  for (const EvaluatedModel& model : evaluation.models) {
    if (model.measures) {
      shown.push_back(model.recipe);
    }
  }
  for (const ModelFamily family : familiesOf(shown)) {
    const FamilyLook look = lookOf(family);
    content += svgMark(look.mark, {x, y}, 5, look.style, "") + svgText({x + 11, y + 4}, look.name, "start", "tick");
    x += 44 + 5.8 * static_cast<double>(std::string_view(look.name).size());
  }
  const char* front = evaluation.publishedComplete ? "front of PSR and MCSD" : "front so far";
  for (const auto& [style, name] : {std::pair("front", front), std::pair("front2", "of simplified PSR")}) {
    content += svgLine({x, y}, {x + 24, y}, style) + svgText({x + 30, y + 4}, name, "start", "tick");
    x += 50 + 6.4 * static_cast<double>(std::string_view(name).size());
  }
  return content;
}

std::string axes(const AccuracyFigure& figure) {
  std::string content;
  for (const AxisTick& tick : figure.errors) {
    content += svgGridLine(tick.at, tick.value);
  }
  content += svgText({kPlotLeft - 48, kTop - 18}, "error (mm)", "start", "axis");
  for (const AxisTick& tick : figure.triangles) {
    content += svgLine({tick.at, kTop}, {tick.at, kBottom}, "grid");
    if (tick.numbered) {
      content += svgText({tick.at, kBottom + 18}, tickText(tick.value), "middle", "tick");
    }
  }
  return content + svgText({kPlotRight, kBottom + 38}, "triangles (logarithmic)", "end", "axis");
}

}  // namespace

std::string accuracySvg(const Evaluation& evaluation) {
  const AccuracyFigure figure = accuracyFigure(evaluation, {kPlotLeft, kPlotRight, kTop, kBottom});
  std::string content = axes(figure) + legend(evaluation);
  for (const auto& [front, style] : {std::pair(&figure.publishedFront, "front"), {&figure.simplifiedFront, "front2"}}) {
    content += front->empty() ? std::string() : svgPath(*front, style);
  }
  Labels labels(kPlotRight, kBottom);
  for (const FigureMark& mark : figure.marks) {
    content += svgMark(mark.look.mark, mark.at, mark.radius, mark.look.style,
                       tooltipOf(evaluation.models[mark.place], evaluation.finalScore(mark.place)));
    labels.avoid(mark.at);
  }
  for (const auto& [role, place] : {std::pair("best PSR", evaluation.bestPsr),
                                    {"best MCSD", evaluation.bestMcsd},
                                    {"most similar", evaluation.mostSimilar},
                                    {"best simplified", evaluation.bestSimplified},
                                    {"best other", evaluation.bestOther}}) {
    if (place && evaluation.publishedComplete) {
      const Pixel at = figure.markOf(*place)->at;
      content += svgMark(Mark::Circle, at, 10, "ring", "");
      content += labels.place(at, std::string(role) + ": " + evaluation.models[*place].name());
    }
  }
  return svgPicture(kPlotWidth, kHeight, "Mean error over triangles of all models", content);
}

}  // namespace glisson::lab
