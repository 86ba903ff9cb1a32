#include "app/cli/cohort_csv.h"

#include <functional>

#include "reconstruction/csv.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

struct CohortColumn {
  std::string name;
  std::function<std::string(const GatheredPatient&)> text;
};

using Model = std::optional<ModelFigures>;
using ModelOf = std::function<Model(const PatientFigures&)>;

/// Empty where the patient was not evaluated.
CohortColumn figure(std::string name, std::function<std::string(const PatientFigures&)> of) {
  return {std::move(name), [of = std::move(of)](const GatheredPatient& patient) {
            return patient.state() == PatientState::Evaluated ? of(patient.outcome->figures) : std::string();
          }};
}

CohortColumn numberColumn(const std::string& name, const ModelOf& model, double ModelFigures::*value) {
  return figure(name, [model, value](const PatientFigures& figures) {
    const Model of = model(figures);
    return of ? formatExact((*of).*value) : std::string();
  });
}

void addNumbers(std::vector<CohortColumn>& columns, const std::string& prefix, const ModelOf& model) {
  columns.push_back(numberColumn(prefix + "Triangles", model, &ModelFigures::triangles));
  columns.push_back(numberColumn(prefix + "MeanErrorMm", model, &ModelFigures::meanErrorMm));
  columns.push_back(numberColumn(prefix + "Score", model, &ModelFigures::score));
  columns.push_back(numberColumn(prefix + "GaussianCurvaturePerMm2", model, &ModelFigures::gaussianCurvaturePerMm2));
}

void addComparison(std::vector<CohortColumn>& columns, const std::string& suffix,
                   std::optional<Comparison> (*compare)(const PatientFigures&)) {
  const auto add = [&](const std::string& name, double Comparison::*value) {
    columns.push_back(figure(name, [compare, value](const PatientFigures& figures) {
      const auto comparison = compare(figures);
      return comparison ? formatExact((*comparison).*value) : std::string();
    }));
  };
  add("fewerTrianglesPercent" + suffix, &Comparison::fewerTrianglesPercent);
  add("meanErrorDifferenceMm" + suffix, &Comparison::meanErrorDifferenceMm);
}

ModelOf ofDepth(int depth) {
  return [depth](const PatientFigures& figures) {
    const auto found = figures.psr.find(depth);
    return found == figures.psr.end() ? std::nullopt : Model(found->second);
  };
}

const std::vector<std::pair<std::string, ModelOf>> kChosen{
    {"bestPsr", [](const PatientFigures& figures) { return figures.bestPsr(); }},
    {"mostSimilarMcsd", [](const PatientFigures& figures) { return figures.mostSimilarMcsd; }},
    {"bestMcsd", [](const PatientFigures& figures) { return figures.bestMcsd; }},
    {"bestSimplified", [](const PatientFigures& figures) { return figures.bestSimplified; }}};

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += (all.empty() ? "" : " ") + text;
  }
  return all;
}

std::vector<CohortColumn> allColumns(const GatheredCohort& cohort) {
  std::vector<CohortColumn> columns{
      {"patient", [](const GatheredPatient& patient) { return patient.entry.name; }},
      {"task", [](const GatheredPatient& patient) { return std::to_string(patient.entry.number); }},
      {"line", [](const GatheredPatient& patient) { return std::to_string(patient.entry.line); }},
      {"segmentation", [](const GatheredPatient& patient) { return patient.entry.listedSegmentation; }},
      {"state", [](const GatheredPatient& patient) { return std::string(stateId(patient.state())); }}};
  for (const auto& [name, model] : kChosen) {
    columns.push_back(figure(name, [of = model](const PatientFigures& figures) {
      const Model chosen = of(figures);
      return chosen ? chosen->id : std::string();
    }));
  }
  columns.push_back(figure("bestOfAll", [](const PatientFigures& figures) {
    const Model best = figures.psrIsBestOfAll() ? figures.bestPsr() : figures.bestMcsd;
    return best ? best->id : std::string();
  }));
  for (const DepthDistributions& depth : cohort.statistics.depths) {
    addNumbers(columns, "psrD" + std::to_string(depth.depth), ofDepth(depth.depth));
  }
  for (const auto& [name, model] : kChosen) {
    if (name != "bestPsr") {  // it is one of the depths
      addNumbers(columns, name, model);
    }
  }
  for (const OtherDistributions& other : cohort.statistics.others) {
    addNumbers(columns, other.id + "_", [id = other.id](const PatientFigures& figures) { return figures.other(id); });
  }
  addComparison(columns, "BestPsrAgainstMostSimilarMcsd", againstMostSimilar);
  addComparison(columns, "BestPsrAgainstBestMcsd", againstBestMcsd);
  addComparison(columns, "SimplifiedAgainstBestPsr", simplifiedAgainstPsr);
  columns.push_back(figure("failedModels", [](const PatientFigures& figures) { return joined(figures.failures); }));
  columns.push_back(
      {"failure", [](const GatheredPatient& patient) { return patient.outcome ? patient.outcome->failure : std::string(); }});
  for (const auto& [name, model] : kChosen) {
    columns.push_back(numberColumn(name + "Seconds", model, &ModelFigures::seconds));
  }
  for (const OtherDistributions& other : cohort.statistics.others) {
    columns.push_back(numberColumn(
        other.id + "_Seconds", [id = other.id](const PatientFigures& figures) { return figures.other(id); },
        &ModelFigures::seconds));
  }
  return columns;
}

}  // namespace

std::string cohortCsv(const GatheredCohort& cohort) {
  const std::vector<CohortColumn> columns = allColumns(cohort);
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const CohortColumn& column : columns) {
    names.push_back(column.name);
  }
  std::string csv = csvLine(names);
  for (const GatheredPatient& patient : cohort.patients) {
    std::vector<std::string> cells;
    cells.reserve(columns.size());
    for (const CohortColumn& column : columns) {
      cells.push_back(column.text(patient));
    }
    csv += csvLine(cells);
  }
  return csv;
}

}  // namespace glisson::cli
