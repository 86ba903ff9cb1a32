#include "app/cli/cohort_outcome.h"

#include <array>
#include <set>
#include <system_error>

#include "app/cli/evaluate_summary.h"
#include "app/cli/model_store.h"
#include "planning/exchange/atomic_file.h"
#include "planning/exchange/version.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"

namespace glisson::cli {

namespace {

struct Key {
  const char* name;
  double ModelFigures::*number;
};
constexpr auto kKeys = std::to_array<Key>({{"triangles", &ModelFigures::triangles},
                                           {"meanErrorMm", &ModelFigures::meanErrorMm},
                                           {"score", &ModelFigures::score},
                                           {"gaussianCurvaturePerMm2", &ModelFigures::gaussianCurvaturePerMm2},
                                           {"seconds", &ModelFigures::seconds}});

using Chosen = std::optional<ModelFigures>;
struct ChosenKey {
  const char* name;
  Chosen PatientFigures::*model;
};
constexpr auto kChosenKeys = std::to_array<ChosenKey>({{"mostSimilarMcsd", &PatientFigures::mostSimilarMcsd},
                                                       {"bestMcsd", &PatientFigures::bestMcsd},
                                                       {"bestSimplified", &PatientFigures::bestSimplified}});

Json jsonOf(const ModelFigures& model) {
  Json json{{"model", model.id}};
  for (const Key& key : kKeys) {
    json[key.name] = model.*key.number;
  }
  return json;
}

ModelFigures modelOf(const Json& json) {
  ModelFigures model;
  model.id = json.at("model").get<std::string>();
  for (const Key& key : kKeys) {
    model.*key.number = json.at(key.name).get<double>();
  }
  return model;
}

Json jsonOf(const PatientFigures& figures) {
  Json json;
  json["psr"] = Json::array();
  for (const auto& [depth, model] : figures.psr) {
    json["psr"].push_back({{"depth", depth}, {"figures", jsonOf(model)}});
  }
  json["bestDepth"] = figures.bestDepth ? Json(*figures.bestDepth) : Json(nullptr);
  for (const ChosenKey& key : kChosenKeys) {
    const Chosen& model = figures.*key.model;
    json[key.name] = model ? jsonOf(*model) : Json(nullptr);
  }
  json["others"] = Json::array();
  for (const ModelFigures& model : figures.others) {
    json["others"].push_back(jsonOf(model));
  }
  json["failedModels"] = figures.failures;
  return json;
}

PatientFigures figuresOf(const Json& json) {
  PatientFigures figures;
  for (const Json& model : json.at("psr")) {
    figures.psr[model.at("depth").get<int>()] = modelOf(model.at("figures"));
  }
  if (const Json& depth = json.at("bestDepth"); !depth.is_null() && figures.psr.contains(depth.get<int>())) {
    figures.bestDepth = depth.get<int>();
  }
  for (const ChosenKey& key : kChosenKeys) {
    if (!json.at(key.name).is_null()) {
      figures.*key.model = modelOf(json.at(key.name));
    }
  }
  for (const Json& model : json.at("others")) {
    figures.others.push_back(modelOf(model));
  }
  figures.failures = json.at("failedModels").get<std::vector<std::string>>();
  return figures;
}

/// Those beside the published ones, however the flag named them.
Json otherMethodsOf(const std::vector<ModelRecipe>& recipes) {
  std::set<std::string_view> methods;
  for (const ModelRecipe& recipe : recipes) {
    if (recipe.family == ModelFamily::Other) {
      methods.insert(methodId(recipe));
    }
  }
  return methods;
}

Json jsonOf(const OutcomeSubject& subject) {
  const CohortEntry& entry = subject.entry;
  return {{"program", "glisson " + std::string(glissonVersion())},
          {"models", kModelsVersion},
          {"parameters", parametersJson(subject.options)},
          {"methods", otherMethodsOf(subject.recipes)},
          {"segmentation", entry.listedSegmentation},
          {"label", entry.choice.label ? Json(*entry.choice.label) : Json(nullptr)},
          {"structure", entry.choice.structure},
          {"labels", entry.input.labels},
          {"accept", entry.input.accept},
          {"prefer", entry.input.prefer}};
}

std::filesystem::path fileOf(const std::filesystem::path& folder, const CohortEntry& entry) {
  return folder / entry.name / "outcome.json";
}

}  // namespace

std::optional<PatientOutcome> loadOutcome(const std::filesystem::path& folder, const OutcomeSubject& subject) {
  const std::filesystem::path file = fileOf(folder, subject.entry);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    return std::nullopt;
  }
  try {
    const Json json = Json::parse(readWholeFile(file));
    if (textOf(json.at("of")) != textOf(jsonOf(subject))) {
      return std::nullopt;
    }
    PatientOutcome outcome;
    outcome.failure = json.at("failure").get<std::string>();
    if (outcome.failure.empty()) {
      outcome.figures = figuresOf(json.at("figures"));
    }
    return outcome;
  } catch (const Json::exception&) {
    return std::nullopt;  // cut off, or not ours: the patient is to be evaluated anew
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void removeOutcome(const std::filesystem::path& folder, const CohortEntry& entry) {
  const std::filesystem::path file = fileOf(folder, entry);
  std::error_code error;
  std::filesystem::remove(file, error);
  if (error) {
    throw InputError(file.string() + " cannot be removed (" + error.message() + "); choose another folder");
  }
}

void saveOutcome(const std::filesystem::path& folder, const OutcomeSubject& subject, const PatientOutcome& outcome) {
  const std::filesystem::path file = fileOf(folder, subject.entry);
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) {
    throw InputError(file.parent_path().string() + " cannot be made (" + error.message() + "); choose another folder");
  }
  Json json;
  json["of"] = jsonOf(subject);
  json["failure"] = outcome.failure;
  json["figures"] = outcome.failure.empty() ? jsonOf(outcome.figures) : Json(nullptr);
  writeFileAtomically(file, textOf(json) + "\n");
}

}  // namespace glisson::cli
