#include "app/cli/cohort_summary.h"

#include "app/cli/evaluate_summary.h"
#include "app/cli/table.h"
#include "planning/exchange/version.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

Json jsonOf(const Distribution& numbers) {
  if (numbers.patients == 0) {
    return nullptr;
  }
  return {{"patients", numbers.patients},
          {"mean", numbers.mean},
          {"deviation", numbers.deviation ? Json(*numbers.deviation) : Json(nullptr)},
          {"least", numbers.least},
          {"greatest", numbers.greatest}};
}

Json jsonOf(const ModelDistributions& models) {
  return {{"score", jsonOf(models.score)},
          {"meanErrorMm", jsonOf(models.meanErrorMm)},
          {"triangles", jsonOf(models.triangles)},
          {"gaussianCurvaturePerMm2", jsonOf(models.gaussianCurvaturePerMm2)}};
}

Json jsonOf(const ComparisonDistributions& comparison) {
  return {{"fewerTrianglesPercent", jsonOf(comparison.fewerTrianglesPercent)},
          {"meanErrorDifferenceMm", jsonOf(comparison.meanErrorDifferenceMm)}};
}

Json depthsJson(const CohortStatistics& statistics) {
  Json depths = Json::array();
  for (const DepthDistributions& depth : statistics.depths) {
    Json json{{"depth", depth.depth}, {"bestOfPsr", depth.bestOfPsr}, {"bestOfAll", depth.bestOfAll}};
    json.update(jsonOf(depth.models));
    depths.push_back(std::move(json));
  }
  return depths;
}

Json patientsJson(const GatheredCohort& cohort) {
  Json patients = Json::array();
  for (const GatheredPatient& patient : cohort.patients) {
    Json json{{"patient", patient.entry.name},
              {"task", patient.entry.number},
              {"line", patient.entry.line},
              {"state", stateId(patient.state())}};
    if (patient.state() == PatientState::Evaluated) {
      json["failedModels"] = patient.outcome->figures.failures;
    } else {
      json["reason"] = sentenceOf(patient, cohort.list);
    }
    patients.push_back(std::move(json));
  }
  return patients;
}

/// The middle of a table's row: score, error and triangles with their spread.
std::vector<std::string> cellsOf(const ModelDistributions& models) {
  return {std::to_string(models.score.patients), withSpread(models.score, 3), withSpread(models.meanErrorMm, 3),
          withSpread(models.triangles, 0)};
}

}  // namespace

std::string withSpread(const Distribution& numbers, int decimals) {
  if (numbers.patients == 0) {
    return "-";
  }
  return formatNumber(numbers.mean, decimals) +
         (numbers.deviation ? " \u00b1 " + formatNumber(*numbers.deviation, decimals) : std::string());
}

Json cohortJson(const GatheredCohort& cohort) {
  const CohortStatistics& statistics = cohort.statistics;
  Json json;
  json["program"] = "glisson " + std::string(glissonVersion());
  json["list"] = cohort.list;
  json["parameters"] = parametersJson(cohort.options);
  json["listed"] = cohort.patients.size();
  json["evaluated"] = statistics.patients;
  json["failed"] = cohort.count(PatientState::Failed);
  json["missing"] = cohort.count(PatientState::Missing);
  json["depths"] = depthsJson(statistics);
  json["mcsdBestOfAll"] = statistics.mcsdBestOfAll;
  json["bestPsr"] = jsonOf(statistics.bestPsr);
  json["mostSimilarMcsd"] = jsonOf(statistics.mostSimilarMcsd);
  json["bestMcsd"] = jsonOf(statistics.bestMcsd);
  json["bestSimplified"] = jsonOf(statistics.bestSimplified);
  json["others"] = Json::array();
  for (const OtherDistributions& other : statistics.others) {
    Json row{{"model", other.id}};
    row.update(jsonOf(other.models));
    json["others"].push_back(std::move(row));
  }
  json["reductions"] = {{"mostSimilarMcsd", jsonOf(statistics.againstMostSimilar)},
                        {"bestMcsd", jsonOf(statistics.againstBestMcsd)},
                        {"simplified", jsonOf(statistics.simplifiedAgainstPsr)}};
  json["patients"] = patientsJson(cohort);
  json["seconds"] = {{"bestPsr", jsonOf(statistics.bestPsr.seconds)},
                     {"mostSimilarMcsd", jsonOf(statistics.mostSimilarMcsd.seconds)},
                     {"bestMcsd", jsonOf(statistics.bestMcsd.seconds)},
                     {"bestSimplified", jsonOf(statistics.bestSimplified.seconds)}};
  for (const OtherDistributions& other : statistics.others) {
    json["seconds"][other.id] = jsonOf(other.models.seconds);
  }
  return json;
}

std::string cohortText(const GatheredCohort& cohort) {
  const CohortStatistics& statistics = cohort.statistics;
  std::string text = std::to_string(statistics.patients) + " of " + std::to_string(cohort.patients.size()) +
                     " patients evaluated, " + std::to_string(cohort.count(PatientState::Failed)) + " failed, " +
                     std::to_string(cohort.count(PatientState::Missing)) + " without a result\n";
  std::vector<std::vector<std::string>> rows{
      {"", "patients", "score", "mean mm", "triangles", "is best PSR of", "is best of all of"}};
  const auto add = [&](const std::string& heading, const ModelDistributions& models, const std::string& psr,
                       const std::string& all) {
    std::vector<std::string> row = cellsOf(models);
    row.insert(row.begin(), heading);
    row.insert(row.end(), {psr, all});
    rows.push_back(std::move(row));
  };
  for (const DepthDistributions& depth : statistics.depths) {
    add("PSR d=" + std::to_string(depth.depth), depth.models, std::to_string(depth.bestOfPsr), std::to_string(depth.bestOfAll));
  }
  add("best PSR", statistics.bestPsr, "", "");
  add("most similar MCSD", statistics.mostSimilarMcsd, "", "");
  add("best MCSD", statistics.bestMcsd, "", std::to_string(statistics.mcsdBestOfAll));
  add("best simplified", statistics.bestSimplified, "", "");
  for (const OtherDistributions& other : statistics.others) {
    add(other.name, other.models, "", "");
  }
  text += alignedTable(rows);
  const Distribution& reduction = statistics.againstMostSimilar.fewerTrianglesPercent;
  if (reduction.patients > 0) {
    text += "the best PSR has " + withSpread(reduction, 1) + " % fewer triangles than the most similar MCSD (" +
            formatNumber(reduction.least, 1) + " to " + formatNumber(reduction.greatest, 1) + " %, " +
            std::to_string(reduction.patients) + " patients)\n";
  }
  return text;
}

}  // namespace glisson::cli
