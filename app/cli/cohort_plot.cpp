#include "app/cli/cohort_plot.h"

#include <algorithm>

#include "app/lab/svg.h"
#include "reconstruction/text.h"

namespace glisson::cli {

using lab::Axis;
using lab::kPlotLeft;
using lab::kPlotRight;
using lab::kPlotWidth;
using lab::Mark;
using lab::Pixel;
using lab::svgGridLine;
using lab::svgMark;
using lab::svgPath;
using lab::svgPicture;
using lab::svgText;

namespace {

constexpr double kPlotHeight = 340;
constexpr double kPlotTop = 30;
constexpr double kPlotBottom = kPlotHeight - 40;

class Plot {
 public:
  explicit Plot(const GatheredCohort& cohort) : cohort_(cohort), score_(0, greatestScore(), kPlotBottom, kPlotTop) {}

  [[nodiscard]] std::string content() const {
    std::string lines;
    std::string marks;
    for (const GatheredPatient& patient : cohort_.patients) {
      if (patient.state() == PatientState::Evaluated) {
        add(patient, lines, marks);
      }
    }
    return axes() + lines + marks;  // marks above the lines of all patients
  }

 private:
  [[nodiscard]] const std::vector<DepthDistributions>& depths() const { return cohort_.statistics.depths; }

  [[nodiscard]] double greatestScore() const {
    double greatest = cohort_.statistics.bestMcsd.score.greatest;
    for (const DepthDistributions& depth : depths()) {
      greatest = std::max(greatest, depth.models.score.greatest);
    }
    return greatest > 0 ? greatest : 1;
  }

  /// Of the depths in turn, and of MCSD behind them.
  [[nodiscard]] double columnAt(std::size_t column) const {
    return kPlotLeft + (kPlotRight - kPlotLeft) * (static_cast<double>(column) + 0.5) / (static_cast<double>(depths().size()) + 1);
  }

  [[nodiscard]] std::string axes() const {
    std::string content = svgText({kPlotLeft - 48, kPlotTop - 12}, "score", "start", "axis");
    for (const double tick : score_.ticks(5)) {
      content += svgGridLine(score_.at(tick), tick);
    }
    for (std::size_t n = 0; n < depths().size(); ++n) {
      content += svgText({columnAt(n), kPlotBottom + 24}, "PSR d=" + std::to_string(depths()[n].depth), "middle", "tick");
    }
    return content + svgText({columnAt(depths().size()), kPlotBottom + 24}, "best MCSD", "middle", "tick");
  }

  void add(const GatheredPatient& patient, std::string& lines, std::string& marks) const {
    const PatientFigures& figures = patient.outcome->figures;
    const auto tooltip = [&](const ModelFigures& model) {
      return patient.entry.name + ", " + model.id + ": " + formatNumber(model.score, 3);
    };
    std::vector<Pixel> corners;
    for (std::size_t n = 0; n < depths().size(); ++n) {
      if (const auto found = figures.psr.find(depths()[n].depth); found != figures.psr.end()) {
        corners.push_back({columnAt(n), score_.at(found->second.score)});
        marks += svgMark(Mark::Diamond, corners.back(), 4, "psr", tooltip(found->second));
      }
    }
    if (corners.size() > 1) {
      lines += svgPath(corners, "patient");
    }
    if (figures.bestMcsd) {
      marks += svgMark(Mark::Circle, {columnAt(depths().size()), score_.at(figures.bestMcsd->score)}, 4, "mcsd",
                       tooltip(*figures.bestMcsd));
    }
  }

  const GatheredCohort& cohort_;
  Axis score_;
};

}  // namespace

std::string scorePlot(const GatheredCohort& cohort) {
  return svgPicture(kPlotWidth, kPlotHeight, "Objective score over depth", Plot(cohort).content());
}

}  // namespace glisson::cli
