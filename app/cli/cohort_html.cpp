#include "app/cli/cohort_html.h"

#include <algorithm>
#include <cmath>

#include "app/cli/cohort_plot.h"
#include "app/cli/cohort_summary.h"
#include "app/cli/html_table.h"
#include "app/lab/svg.h"
#include "planning/exchange/version.h"
#include "reconstruction/text.h"

namespace glisson::cli {

using lab::escaped;
using lab::tickText;

namespace {

using Model = std::optional<ModelFigures>;

/// Of two, as a person says it: "3 of 4".
std::string ofPatients(std::size_t count, std::size_t all) { return std::to_string(count) + " of " + std::to_string(all); }

/// A folder's name as part of a relative address (RFC 3986).
std::string inAddress(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string address;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    address += plain ? std::string(1, c) : std::string{'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return address;
}

class CohortReport {
 public:
  explicit CohortReport(const GatheredCohort& cohort) : cohort_(cohort), statistics_(cohort.statistics) {
    for (const GatheredPatient& patient : cohort.patients) {
      (patient.state() == PatientState::Evaluated ? evaluated_ : others_).push_back(&patient);
    }
  }

  [[nodiscard]] std::string html() const {
    const std::string title = cohort_.list + ": PSR and MCSD compared on " + std::to_string(statistics_.patients) +
                              (statistics_.patients == 1 ? " patient" : " patients");
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped(title) +
           "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>" + std::string(reportSheet()) +
           "</style>\n</head>\n<body>\n<main>\n<h1>" + escaped(title) + "</h1>\n" + facts() + cards() + missing() + depths() +
           scores() + comparison() + chosen() + others() + times() + notes() + "</main>\n</body>\n</html>\n";
  }

 private:
  [[nodiscard]] const PatientFigures& figuresOf(const GatheredPatient* patient) const { return patient->outcome->figures; }
  [[nodiscard]] std::vector<std::string> depthHeadings(const std::string& first) const {
    std::vector<std::string> headings{first};
    for (const DepthDistributions& depth : statistics_.depths) {
      headings.push_back("PSR d=" + std::to_string(depth.depth));
    }
    headings.emplace_back("best MCSD");
    return headings;
  }

  [[nodiscard]] std::string facts() const;
  [[nodiscard]] std::string cards() const;
  [[nodiscard]] std::string missing() const;
  [[nodiscard]] std::string depths() const;
  [[nodiscard]] std::string scores() const;
  [[nodiscard]] std::string reports() const;
  [[nodiscard]] std::string comparison() const;
  [[nodiscard]] std::string chosen() const;
  [[nodiscard]] std::string others() const;
  [[nodiscard]] std::string times() const;
  [[nodiscard]] std::string notes() const;

  const GatheredCohort& cohort_;
  const CohortStatistics& statistics_;
  std::vector<const GatheredPatient*> evaluated_;
  std::vector<const GatheredPatient*> others_;
};

std::string CohortReport::facts() const {
  const bool paper = cohort_.options.sampling == Sampling::Paper;
  return "<p class=\"faint\">" + ofPatients(statistics_.patients, cohort_.patients.size()) + " patients evaluated, " +
         std::to_string(cohort_.count(PatientState::Failed)) + " failed, " + std::to_string(cohort_.count(PatientState::Missing)) +
         " without a result \u00b7 " + (paper ? "paper" : "unbiased") + " sampling, cube of " +
         formatNumber(cohort_.options.scale, 2) + " times the label \u00b7 glisson " + escaped(glissonVersion()) + "</p>\n";
}

std::string CohortReport::cards() const {
  std::string html = "<div class=\"cards\">\n";
  const auto mostOften =
      std::max_element(statistics_.depths.begin(), statistics_.depths.end(),
                       [](const DepthDistributions& a, const DepthDistributions& b) { return a.bestOfAll < b.bestOfAll; });
  if (mostOften != statistics_.depths.end()) {
    html += htmlCard(ofPatients(mostOften->bestOfAll, statistics_.patients),
                     "patients have their best model of all in PSR d=" + std::to_string(mostOften->depth));
  }
  html += htmlCard(ofPatients(statistics_.mcsdBestOfAll, statistics_.patients), "have it in an MCSD model");
  const ComparisonDistributions& similar = statistics_.againstMostSimilar;
  if (similar.fewerTrianglesPercent.patients > 0) {
    html += htmlCard(withSpread(similar.fewerTrianglesPercent, 1) + " %",
                     "fewer triangles in the best PSR than in the MCSD model that is most similar in smoothness");
    html += htmlCard(withSpread(similar.meanErrorDifferenceMm, 3) + " mm",
                     "mean error of the best PSR less that of the most similar MCSD");
  }
  return html + "</div>\n";
}

std::string CohortReport::missing() const {
  if (others_.empty()) {
    return {};
  }
  std::string list;
  for (const GatheredPatient* patient : others_) {
    list += "<p>" + escaped(sentenceOf(*patient, cohort_.list)) + "</p>\n";
  }
  return htmlSection("Not in these numbers", "Patients of the list that could not be evaluated, or have not been.", list);
}

std::string CohortReport::depths() const {
  std::vector<TableRow> rows;
  const auto add = [&](const std::string& heading, Distribution ModelDistributions::*numbers, int decimals) {
    TableRow row{heading, {}};
    const auto cell = [&](const ModelDistributions& models) {
      return Cell{withSpread(models.*numbers, decimals),
                  (models.*numbers).patients > 0 ? (models.*numbers).mean : std::numeric_limits<double>::quiet_NaN()};
    };
    for (const DepthDistributions& depth : statistics_.depths) {
      row.cells.push_back(cell(depth.models));
    }
    row.cells.push_back(cell(statistics_.bestMcsd));
    rows.push_back(std::move(row));
  };
  add("Objective score", &ModelDistributions::score, 3);
  add("Mean error (mm)", &ModelDistributions::meanErrorMm, 3);
  add("Triangles", &ModelDistributions::triangles, 0);
  TableRow patients{"Patients that have it", {}};
  TableRow bestPsr{"is the best PSR of", {}};
  TableRow bestOfAll{"is the best of all of", {}};
  for (const DepthDistributions& depth : statistics_.depths) {
    patients.cells.push_back({std::to_string(depth.models.score.patients)});
    bestPsr.cells.push_back({std::to_string(depth.bestOfPsr)});
    bestOfAll.cells.push_back({std::to_string(depth.bestOfAll)});
  }
  patients.cells.push_back({std::to_string(statistics_.bestMcsd.score.patients)});
  bestPsr.cells.push_back({""});
  bestOfAll.cells.push_back({std::to_string(statistics_.mcsdBestOfAll)});
  rows.insert(rows.end(), {patients, bestPsr, bestOfAll});
  return htmlSection(
      "Depths",
      "Mean and standard deviation over the patients; a patient whose voxels do not carry a depth does not count there. "
      "The least of a row stands out.",
      htmlTable(depthHeadings(""), rows));
}

std::string CohortReport::scores() const {
  std::vector<TableRow> rows;
  const auto cell = [](const Model& model) { return model ? Cell{formatNumber(model->score, 3), model->score} : Cell{"-"}; };
  for (const GatheredPatient* patient : evaluated_) {
    TableRow row{patient->entry.name, {}};
    for (const DepthDistributions& depth : statistics_.depths) {
      const auto found = figuresOf(patient).psr.find(depth.depth);
      row.cells.push_back(cell(found == figuresOf(patient).psr.end() ? std::nullopt : Model(found->second)));
    }
    row.cells.push_back(cell(figuresOf(patient).bestMcsd));
    rows.push_back(std::move(row));
  }
  return htmlSection(
      "Objective score of each patient",
      "As Table 2: distance from the ideal of no error and no triangles, both scaled to 0..1 over all PSR and MCSD models of "
      "the patient. Less is better.",
      scorePlot(cohort_) + htmlTable(depthHeadings("Patient"), rows) + reports());
}

std::string CohortReport::reports() const {
  std::string links;
  for (const GatheredPatient* patient : evaluated_) {
    links += (links.empty() ? "" : ", ") + ("<a href=\"" + inAddress(patient->entry.name) + "/report.html\">") +
             escaped(patient->entry.name) + "</a>";
  }
  return "<p class=\"faint\">Reports: " + links + "</p>\n";
}

std::string CohortReport::comparison() const {
  std::vector<TableRow> rows;
  const auto triangles = [](const Model& model) { return Cell{model ? tickText(model->triangles) : "-"}; };
  const auto thousandths = [](const Model& model) { return Cell{model ? significant(1e3 * model->gaussianCurvaturePerMm2) : "-"}; };
  for (const GatheredPatient* patient : evaluated_) {
    const PatientFigures& figures = figuresOf(patient);
    const auto comparison = againstMostSimilar(figures);
    rows.push_back({patient->entry.name,
                    {{figures.bestPsr() ? figures.bestPsr()->id : "-"},
                     triangles(figures.bestPsr()),
                     thousandths(figures.bestPsr()),
                     {figures.mostSimilarMcsd ? figures.mostSimilarMcsd->id : "-"},
                     triangles(figures.mostSimilarMcsd),
                     thousandths(figures.mostSimilarMcsd),
                     {comparison ? formatNumber(comparison->fewerTrianglesPercent, 1) + " %" : "-"},
                     {comparison ? formatNumber(comparison->meanErrorDifferenceMm, 3) : "-"}}});
  }
  const ComparisonDistributions& all = statistics_.againstMostSimilar;
  rows.push_back({"Mean",
                  {{""},
                   {withSpread(statistics_.bestPsr.triangles, 0)},
                   {""},
                   {""},
                   {withSpread(statistics_.mostSimilarMcsd.triangles, 0)},
                   {""},
                   {withSpread(all.fewerTrianglesPercent, 1) + (all.fewerTrianglesPercent.patients > 0 ? " %" : "")},
                   {withSpread(all.meanErrorDifferenceMm, 3)}}});
  return htmlSection(
      "Reduction in triangles at equal smoothness",
      "As Tables 3 and 4: the best PSR beside the MCSD model whose mean Gaussian curvature K (10\u207b\u00b3 per mm\u00b2) is "
      "nearest to its own. The mean is that of the patients' reductions.",
      htmlTable({"Patient", "Best PSR", "Triangles", "K", "Most similar MCSD", "Triangles", "K", "Fewer triangles",
                 "Error difference (mm)"},
                rows));
}

std::string CohortReport::chosen() const {
  const std::vector<std::pair<std::string, const ModelDistributions*>> columns{
      {"I best PSR", &statistics_.bestPsr},
      {"II most similar MCSD", &statistics_.mostSimilarMcsd},
      {"III best MCSD", &statistics_.bestMcsd},
      {"best simplified *", &statistics_.bestSimplified}};
  std::vector<std::string> headings{""};
  TableRow score{"Objective score", {}};
  TableRow error{"Mean error (mm)", {}};
  TableRow triangles{"Triangles", {}};
  for (const auto& [heading, models] : columns) {
    headings.push_back(heading);
    score.cells.push_back({withSpread(models->score, 3)});
    error.cells.push_back({withSpread(models->meanErrorMm, 3)});
    triangles.cells.push_back({withSpread(models->triangles, 0)});
  }
  return htmlSection(
      "Best and most similar models",
      "As Table 3, mean and standard deviation over the patients. * A model of the third family, on the same scale; it takes "
      "no part in the comparison.",
      htmlTable(headings, {triangles, error, score}));
}

std::string CohortReport::others() const {
  if (statistics_.others.empty()) {
    return {};
  }
  std::vector<TableRow> rows;
  const auto add = [&](const std::string& heading, const ModelDistributions& models) {
    rows.push_back({heading,
                    {{ofPatients(models.score.patients, statistics_.patients)},
                     {withSpread(models.score, 3)},
                     {withSpread(models.meanErrorMm, 3)},
                     {withSpread(models.triangles, 0)}}});
  };
  add("Best PSR", statistics_.bestPsr);
  add("Best MCSD", statistics_.bestMcsd);
  for (const OtherDistributions& other : statistics_.others) {
    add(other.name, other.models);
  }
  return htmlSection("Other methods",
                     "Mean and standard deviation over the patients that have the model, on each patient's scale of PSR and MCSD; "
                     "they change neither it nor the best models. The best of the published ones stand above.",
                     htmlTable({"", "Patients", "Objective score", "Mean error (mm)", "Triangles"}, rows));
}

std::string CohortReport::times() const {
  const TableRow row{"Mean of the patients",
                     {{withSpread(statistics_.bestPsr.seconds, 2)},
                      {withSpread(statistics_.mostSimilarMcsd.seconds, 2)},
                      {withSpread(statistics_.bestMcsd.seconds, 2)},
                      {withSpread(statistics_.bestSimplified.seconds, 2)}}};
  return htmlSection(
      "Processing time (seconds)", "As Table 5. Times of different machines, or of one that does other work, do not compare.",
      "<!-- times -->\n" + htmlTable({"", "I best PSR", "II most similar MCSD", "III best MCSD", "best simplified"}, {row}) +
          "<!-- end of times -->\n");
}

std::string CohortReport::notes() const {
  std::string failures;
  for (const GatheredPatient* patient : evaluated_) {
    for (const std::string& failure : figuresOf(patient).failures) {
      failures += "<p>" + escaped(patient->entry.name + ", " + failure) + "</p>\n";
    }
  }
  return (failures.empty() ? std::string()
                           : htmlSection("Models that could not be made", "The other models of these patients count.", failures)) +
         "<p class=\"faint\">R. Palomar, F. A. Cheikh, B. Edwin, A. Beghdadi, O. J. Elle: Surface reconstruction for planning and "
         "navigation of liver resections. Computerized Medical Imaging and Graphics, 2016. Not for clinical use.</p>\n";
}

}  // namespace

std::string cohortHtml(const GatheredCohort& cohort) { return CohortReport(cohort).html(); }

}  // namespace glisson::cli
