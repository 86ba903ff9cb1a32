#include "app/cli/evaluate_html.h"

#include <algorithm>
#include <cmath>

#include "app/cli/evaluate_plots.h"
#include "app/cli/html_table.h"
#include "app/lab/accuracy_svg.h"
#include "app/lab/svg.h"
#include "planning/exchange/version.h"
#include "reconstruction/methods/methods.h"
#include "reconstruction/text.h"

namespace glisson::cli {

using lab::escaped;
using lab::tickText;

namespace {

using Place = std::optional<std::size_t>;

/// The paper's columns, each where there is such a model.
struct Column {
  std::string heading;
  Place place;
  bool competes = true;  ///< for the best value of a row
};

std::string threeDecimals(double value) { return formatNumber(value, 3); }

class Report {
 public:
  Report(const EvaluatedLabel& label, const Evaluation& evaluation) : label_(label), all_(evaluation) {
    for (std::size_t n = 0; n < all_.models.size(); ++n) {
      if (all_.models[n].recipe.family == ModelFamily::Psr) {
        psr_.push_back({all_.models[n].name(), all_.scores[n] ? Place(n) : std::nullopt});
      }
    }
    chosen_ = {{"I best PSR", all_.bestPsr},
               {"II most similar MCSD", all_.mostSimilar},
               {"III best MCSD", all_.bestMcsd},
               {"best simplified *", all_.bestSimplified, false}};
    if (all_.bestOther) {
      chosen_.push_back({"best other method *", all_.bestOther, false});
    }
  }

  [[nodiscard]] std::string html() const {
    const std::string title = label_.chosen.name + ": PSR and MCSD compared";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped(title) +
           "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>" + reportSheet() +
           "</style>\n</head>\n<body>\n<main>\n<h1>" + escaped(title) + "</h1>\n" + facts() + cards() + accuracy() + scores() +
           comparison() + others() + errors() + curvature() + times() + everything() + notes() + "</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] const ModelMeasures& measuresOf(const Place& place) const { return *all_.models[*place].measures; }

  /// A row over `columns`; `value` is of a model that is there.
  template <typename Value, typename Text>
  [[nodiscard]] TableRow row(const std::string& heading, const std::vector<Column>& columns, Value value, Text text) const {
    TableRow made{heading, {}};
    for (const Column& column : columns) {
      made.cells.push_back(column.place ? Cell{text(value(*column.place)), value(*column.place)} : Cell{"-"});
    }
    return made;
  }
  [[nodiscard]] std::vector<std::string> headings(const std::string& first, const std::vector<Column>& columns) const {
    std::vector<std::string> texts{first};
    for (const Column& column : columns) {
      texts.push_back(column.heading);
    }
    return texts;
  }
  [[nodiscard]] TableRow names(const std::vector<Column>& columns) const {
    TableRow made{"Model", {}};
    for (const Column& column : columns) {
      made.cells.push_back({column.place ? all_.models[*column.place].name() : "-"});
    }
    return made;
  }

  [[nodiscard]] std::string facts() const;
  [[nodiscard]] std::string cards() const;
  [[nodiscard]] std::string accuracy() const;
  [[nodiscard]] std::string scores() const;
  [[nodiscard]] std::string comparison() const;
  [[nodiscard]] std::string others() const;
  [[nodiscard]] std::string errors() const;
  [[nodiscard]] std::string curvature() const;
  [[nodiscard]] std::string times() const;
  [[nodiscard]] std::string everything() const;
  [[nodiscard]] std::string notes() const;

  const EvaluatedLabel& label_;
  const Evaluation& all_;
  std::vector<Column> psr_;
  std::vector<Column> chosen_;  ///< those of Table 3, and the best of the families beside them
};

std::string timesText(const Index3& size) {
  return std::to_string(size[0]) + " \u00d7 " + std::to_string(size[1]) + " \u00d7 " + std::to_string(size[2]);
}

std::string Report::facts() const {
  const Vec3& spacing = label_.geometry.spacing;
  return "<p class=\"faint\">" + escaped(label_.file) + " \u00b7 " + timesText(label_.geometry.size) + " voxels of " +
         formatNumber(spacing[0], 2) + " \u00d7 " + formatNumber(spacing[1], 2) + " \u00d7 " + formatNumber(spacing[2], 2) +
         " mm \u00b7 volume " + formatNumber(label_.voxelVolumeMl, 1) + " mL \u00b7 " +
         tickText(static_cast<double>(label_.points)) + " points to measure from \u00b7 glisson " + escaped(glissonVersion()) +
         "</p>\n";
}

std::string Report::cards() const {
  std::string html = "<div class=\"cards\">\n";
  if (all_.bestOfAll) {
    html += htmlCard(all_.models[*all_.bestOfAll].name(), "has the best score of PSR and MCSD");
  }
  if (all_.bestPsr && all_.mostSimilar) {
    const auto count = [&](const Place& place) { return static_cast<double>(measuresOf(place).triangles); };
    const double reduction = reductionPercent(count(all_.bestPsr), count(all_.mostSimilar));
    html += htmlCard(formatNumber(std::abs(reduction), 1) + " %",
                     std::string(reduction < 0 ? "more" : "fewer") + " triangles in the best PSR than in the most similar MCSD");
    const double difference = measuresOf(all_.bestPsr).paperErrorMm.mean - measuresOf(all_.mostSimilar).paperErrorMm.mean;
    html += htmlCard((difference < 0 ? "\u2212" : "+") + formatNumber(std::abs(difference), 3) + " mm",
                     "mean error of the best PSR against the most similar MCSD");
  }
  if (all_.bestPsr) {
    html += htmlCard(formatNumber(measuresOf(all_.bestPsr).paperErrorMm.median, 2) + " mm", "median error of the best PSR");
  }
  return html + "</div>\n";
}

std::string Report::accuracy() const {
  return htmlSection(
      "Accuracy and complexity",
      "As Fig. 7. Each mark is a model; further down and further left is better. No model of a front's families lies "
      "below and left of it.",
      lab::accuracySvg(all_));
}

std::string Report::scores() const {
  std::vector<Column> columns = psr_;
  columns.push_back({"best MCSD", all_.bestMcsd});
  const auto score = [&](std::size_t n) { return all_.scores[n]->score; };
  return htmlSection("Objective score",
                     "As Table 2: distance from the ideal of no error and no triangles, both scaled to 0..1 over all PSR and MCSD "
                     "models. Less is better.",
                     htmlTable(headings("Label", columns), {row(label_.chosen.name, columns, score, threeDecimals)}));
}

std::string Report::comparison() const {
  std::vector<TableRow> rows{names(chosen_)};
  const auto add = [&](const std::string& heading, auto value, const auto& text) {
    TableRow made = row(heading, chosen_, value, text);
    for (std::size_t n = 0; n < chosen_.size(); ++n) {
      if (!chosen_[n].competes) {
        made.cells[n] = {made.cells[n].text};  // nothing in its column stands out
      }
    }
    rows.push_back(std::move(made));
  };
  add(
      "Triangles", [&](std::size_t n) { return static_cast<double>(measuresOf(n).triangles); }, tickText);
  add(
      "Mean error (mm)", [&](std::size_t n) { return measuresOf(n).paperErrorMm.mean; }, threeDecimals);
  add(
      "95th percentile (mm)", [&](std::size_t n) { return measuresOf(n).paperErrorMm.p95; }, threeDecimals);
  add(
      "Greatest error (mm)", [&](std::size_t n) { return measuresOf(n).paperErrorMm.max; }, threeDecimals);
  add(
      "Mean voxel error (mm)", [&](std::size_t n) { return measuresOf(n).voxelErrorMm.mean; }, threeDecimals);
  add(
      "Objective score", [&](std::size_t n) { return all_.scores[n]->score; }, threeDecimals);
  return htmlSection("Best and most similar models",
                     "As Table 3. Most similar is the MCSD model whose mean Gaussian curvature is nearest to that of the best PSR. "
                     "* A model of another family, on the same scale; it takes no part in the comparison.",
                     htmlTable(headings("", chosen_), rows));
}

std::string Report::others() const {
  std::vector<TableRow> rows;
  std::string sources;
  for (const ReconstructionMethod& method : listedMethods()) {
    const std::size_t before = rows.size();
    for (std::size_t n = 0; n < all_.models.size(); ++n) {
      if (all_.models[n].recipe.method != method.id || !all_.scores[n]) {
        continue;
      }
      const ModelMeasures& m = measuresOf(n);
      rows.push_back({all_.models[n].name(),
                      {{tickText(static_cast<double>(m.triangles))},
                       {threeDecimals(m.paperErrorMm.mean)},
                       {threeDecimals(m.paperErrorMm.p95)},
                       {threeDecimals(m.paperErrorMm.max)},
                       {threeDecimals(m.voxelErrorMm.mean)},
                       {m.volumeMl ? formatNumber(100.0 * (*m.volumeMl / label_.voxelVolumeMl - 1.0), 2) + " %" : "open"},
                       {threeDecimals(all_.scores[n]->score)}}});
    }
    if (rows.size() > before) {
      sources += "<p class=\"faint\">" + escaped(method.name + ": " + method.description + " " + method.citation) + "</p>\n";
    }
  }
  if (rows.empty()) {
    return {};
  }
  return htmlSection("Other methods",
                     "Scored on the scale of PSR and MCSD; they change neither it nor the best models nor the front of those two.",
                     htmlTable({"", "Triangles", "Mean error (mm)", "95th percentile (mm)", "Greatest error (mm)",
                                "Mean voxel error (mm)", "Volume", "Objective score"},
                               rows) +
                         sources);
}

std::string Report::errors() const {
  std::vector<std::size_t> places;
  for (const Column& column : psr_) {
    if (column.place) {
      places.push_back(*column.place);
    }
  }
  for (const Place& place : {all_.bestMcsd, all_.mostSimilar, all_.bestSimplified, all_.bestOther}) {
    if (place && std::find(places.begin(), places.end(), *place) == places.end()) {
      places.push_back(*place);
    }
  }
  return htmlSection("Distribution of the error",
                     "As Fig. 5: quartiles and median (its number beside it) of the distance from each voxel centre at the label's "
                     "surface to the model. Whiskers end within 1.5 times the box; points beyond are not drawn.",
                     boxPlots(all_, places));
}

std::string Report::curvature() const {
  std::vector<Column> columns = psr_;
  columns.push_back({"most similar MCSD", all_.mostSimilar});
  columns.push_back({"best MCSD", all_.bestMcsd});
  std::vector<TableRow> rows;
  const auto add = [&](const std::string& heading, auto value) {
    const auto thousandths = [](double number) { return significant(1e3 * number); };
    rows.push_back(plain(row(heading, columns, value, thousandths)));  // near another is what counts, not least
  };
  add("Merged, 5th to 95th percentile", [&](std::size_t n) { return measuresOf(n).curvature.trimmedPerMm2; });
  add("Merged, all vertices", [&](std::size_t n) { return measuresOf(n).curvature.untrimmedPerMm2; });
  add("As shipped, 5th to 95th percentile", [&](std::size_t n) { return measuresOf(n).shipped.curvature.trimmedPerMm2; });
  add("As shipped, all vertices", [&](std::size_t n) { return measuresOf(n).shipped.curvature.untrimmedPerMm2; });
  return htmlSection(
      "Mean Gaussian curvature (10\u207b\u00b3 per mm\u00b2)",
      "As Table 4. Nearer to 0 is smoother. The first row decides what is similar. As shipped, an MCSD model's normals "
      "are split at sharp edges, which takes the mesh apart there.",
      htmlTable(headings("", columns), rows));
}

std::string Report::times() const {
  const auto twoDecimals = [](double value) { return formatNumber(value, 2); };
  const auto total = [&](std::size_t n) { return all_.models[n].seconds.total(); };
  std::vector<TableRow> rows{names(chosen_), row("Total", chosen_, total, twoDecimals)};
  const auto add = [&](const std::string& heading, double ModelSeconds::*stage) {
    const auto orNothing = [&](double seconds) { return seconds > 0 ? twoDecimals(seconds) : std::string(); };
    rows.push_back(plain(row(
        heading, chosen_, [&](std::size_t n) { return all_.models[n].seconds.*stage; }, orNothing)));
  };
  add("points", &ModelSeconds::sample);
  add("solution", &ModelSeconds::solve);
  add("surface", &ModelSeconds::extract);
  add("decimation", &ModelSeconds::decimate);
  add("smoothing", &ModelSeconds::smooth);
  add("simplification", &ModelSeconds::simplify);
  const int timings = label_.options.timings;
  return htmlSection("Processing time (seconds)",
                     "As Table 5. Region of interest " + timesText(label_.chosen.mask->box().size) + " voxels. " +
                         (timings == 1 ? "One run." : "Best of " + std::to_string(timings) + " runs.") +
                         " PSR includes its points and uses all threads; MCSD uses one, beside other models.",
                     "<!-- times -->\n" + htmlTable(headings("", chosen_), rows) + "<!-- end of times -->\n");
}

std::string Report::everything() const {
  std::string html =
      "<section>\n<details>\n<summary>All " + std::to_string(all_.models.size()) + " models</summary>\n<table class=\"all\">\n<tr>";
  for (const char* heading : {"Model", "Triangles", "Mean (mm)", "p95", "Max", "Voxel error", "Volume", "K (10\u207b\u00b3)",
                              "Score", "Front", "Defects"}) {
    html += "<th>" + escaped(heading) + "</th>";
  }
  html += "</tr>\n";
  for (std::size_t n = 0; n < all_.models.size(); ++n) {
    const EvaluatedModel& model = all_.models[n];
    html += "<tr><td>" + escaped(model.name()) + "</td>";
    if (!model.measures || !all_.scores[n]) {
      html += "<td class=\"text\" colspan=\"10\">" + escaped(model.failure) + "</td></tr>\n";
      continue;
    }
    const ModelMeasures& m = *model.measures;
    std::string defects;
    for (const std::string& name : m.defects) {
      defects += (defects.empty() ? "" : "; ") + name;
    }
    const std::string volume =
        m.volumeMl ? formatNumber(100.0 * (*m.volumeMl / label_.voxelVolumeMl - 1.0), 2) + " %" : std::string("open");
    for (const std::string& cell : {tickText(static_cast<double>(m.triangles)), formatNumber(m.paperErrorMm.mean, 3),
                                    formatNumber(m.paperErrorMm.p95, 3), formatNumber(m.paperErrorMm.max, 2),
                                    formatNumber(m.voxelErrorMm.mean, 3), volume, significant(1e3 * m.curvature.trimmedPerMm2),
                                    formatNumber(all_.scores[n]->score, 3), std::string(all_.scores[n]->pareto ? "yes" : "")}) {
      html += "<td>" + escaped(cell) + "</td>";
    }
    html += "<td class=\"text\">" + escaped(defects) + "</td></tr>\n";
  }
  return html + "</table>\n</details>\n</section>\n";
}

std::string Report::notes() const {
  const std::string sampling = label_.options.sampling == Sampling::Paper ? "paper" : "unbiased";
  return htmlSection(
      "What is measured",
      "Errors are the paper error, from the centres of all voxels at the label's surface to the model; it favours surfaces through "
      "voxel centres. The voxel error goes both ways between the model and the surface halfway between voxels; it favours marching "
      "cubes. The true error needs a body that is known exactly, so a label map has none.",
      "<p class=\"faint\">PSR uses " + sampling + " sampling and a cube of " + formatNumber(label_.options.scale, 2) +
          " times the label; MCSD decimates first and smooths by the Laplacian filter. Simplified models are the deepest PSR with "
          "a "
          "share of its triangles; neither they nor other methods' models enter the scale, the best models or the front of PSR and "
          "MCSD.</p>\n"
          "<p class=\"faint\">R. Palomar, F. A. Cheikh, B. Edwin, A. Beghdadi, O. J. Elle: Surface reconstruction for planning and "
          "navigation of liver resections. Computerized Medical Imaging and Graphics, 2016. Not for clinical use.</p>\n");
}

}  // namespace

std::string evaluationHtml(const EvaluatedLabel& label, const Evaluation& evaluation) { return Report(label, evaluation).html(); }

}  // namespace glisson::cli
