#include "reconstruction/evaluation/model_json.h"

#include "reconstruction/json.h"

namespace glisson {

namespace {

/// Names of a struct's numbers, for writing and for reading alike.
template <typename Value>
struct Key {
  const char* name;
  double Value::*number;
};

constexpr auto kErrorKeys = std::to_array<Key<ErrorSummary>>(
    {{"mean", &ErrorSummary::mean}, {"median", &ErrorSummary::median}, {"p95", &ErrorSummary::p95}, {"max", &ErrorSummary::max}});
constexpr auto kBoxKeys = std::to_array<Key<BoxPlot>>({{"lowWhisker", &BoxPlot::lowWhisker},
                                                       {"lowQuartile", &BoxPlot::lowQuartile},
                                                       {"median", &BoxPlot::median},
                                                       {"highQuartile", &BoxPlot::highQuartile},
                                                       {"highWhisker", &BoxPlot::highWhisker}});
constexpr auto kCurvatureKeys = std::to_array<Key<CurvatureSummary>>(
    {{"trimmedPerMm2", &CurvatureSummary::trimmedPerMm2}, {"untrimmedPerMm2", &CurvatureSummary::untrimmedPerMm2}});
constexpr auto kSecondsKeys = std::to_array<Key<ModelSeconds>>({{"sample", &ModelSeconds::sample},
                                                                {"solve", &ModelSeconds::solve},
                                                                {"extract", &ModelSeconds::extract},
                                                                {"decimate", &ModelSeconds::decimate},
                                                                {"smooth", &ModelSeconds::smooth},
                                                                {"simplify", &ModelSeconds::simplify},
                                                                {"measure", &ModelSeconds::measure}});

template <typename Value, std::size_t count>
Json numbersOf(const Value& value, const std::array<Key<Value>, count>& keys) {
  Json json;
  for (const Key<Value>& key : keys) {
    json[key.name] = value.*key.number;
  }
  return json;
}

template <typename Value, std::size_t count>
Value readNumbers(const Json& json, const std::array<Key<Value>, count>& keys) {
  Value value;
  for (const Key<Value>& key : keys) {
    value.*key.number = json.at(key.name).template get<double>();
  }
  return value;
}

Json jsonOf(const CurvatureSummary& curvature) {
  Json json = numbersOf(curvature, kCurvatureKeys);
  json["tinyTriangles"] = curvature.tinyTriangles;
  return json;
}

CurvatureSummary curvatureOf(const Json& json) {
  CurvatureSummary curvature = readNumbers(json, kCurvatureKeys);
  json.at("tinyTriangles").get_to(curvature.tinyTriangles);
  return curvature;
}

Json jsonOf(const ModelMeasures& measures) {
  Json json;
  json["triangles"] = measures.triangles;
  json["vertices"] = measures.vertices;
  json["paperErrorMm"] = numbersOf(measures.paperErrorMm, kErrorKeys);
  json["paperErrorBoxMm"] = numbersOf(measures.paperErrorBoxMm, kBoxKeys);
  json["paperErrorBoxMm"]["outliers"] = measures.paperErrorBoxMm.outliers;
  json["voxelErrorMm"] = numbersOf(measures.voxelErrorMm, kErrorKeys);
  json["meshToVoxelsMm"] = numbersOf(measures.meshToVoxelsMm, kErrorKeys);
  json["voxelsToMeshMm"] = numbersOf(measures.voxelsToMeshMm, kErrorKeys);
  json["volumeMl"] = measures.volumeMl ? Json(*measures.volumeMl) : Json(nullptr);
  json["curvature"] = jsonOf(measures.curvature);
  json["curvatureAsShipped"] = jsonOf(measures.shipped.curvature);
  json["verticesAsShipped"] = measures.shipped.vertices;
  json["defects"] = measures.defects;
  return json;
}

ModelMeasures measuresOf(const Json& json) {
  ModelMeasures measures;
  json.at("triangles").get_to(measures.triangles);
  json.at("vertices").get_to(measures.vertices);
  measures.paperErrorMm = readNumbers(json.at("paperErrorMm"), kErrorKeys);
  measures.paperErrorBoxMm = readNumbers(json.at("paperErrorBoxMm"), kBoxKeys);
  json.at("paperErrorBoxMm").at("outliers").get_to(measures.paperErrorBoxMm.outliers);
  measures.voxelErrorMm = readNumbers(json.at("voxelErrorMm"), kErrorKeys);
  measures.meshToVoxelsMm = readNumbers(json.at("meshToVoxelsMm"), kErrorKeys);
  measures.voxelsToMeshMm = readNumbers(json.at("voxelsToMeshMm"), kErrorKeys);
  if (!json.at("volumeMl").is_null()) {
    measures.volumeMl = json.at("volumeMl").get<double>();
  }
  measures.curvature = curvatureOf(json.at("curvature"));
  measures.shipped.curvature = curvatureOf(json.at("curvatureAsShipped"));
  json.at("verticesAsShipped").get_to(measures.shipped.vertices);
  measures.defects = json.at("defects").get<std::vector<std::string>>();
  return measures;
}

}  // namespace

std::string jsonOf(const EvaluatedModel& model, std::string_view key) {
  Json json;
  json["key"] = key;
  json["model"] = modelId(model.recipe);
  json["usedDepth"] = model.usedDepth;
  json["measures"] = model.measures ? jsonOf(*model.measures) : Json(nullptr);
  json["failure"] = model.failure;
  json["seconds"] = numbersOf(model.seconds, kSecondsKeys);
  json["peakMemoryMb"] = model.peakMemoryMb ? Json(*model.peakMemoryMb) : Json(nullptr);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<EvaluatedModel> modelOfJson(std::string_view text, std::string_view key, const ModelRecipe& recipe) {
  try {
    const Json json = Json::parse(text);
    if (json.at("key").get<std::string>() != key || json.at("model").get<std::string>() != modelId(recipe)) {
      return std::nullopt;
    }
    EvaluatedModel model;
    model.recipe = recipe;
    json.at("usedDepth").get_to(model.usedDepth);
    if (!json.at("measures").is_null()) {
      model.measures = measuresOf(json.at("measures"));
    }
    model.failure = json.at("failure").get<std::string>();
    model.seconds = readNumbers(json.at("seconds"), kSecondsKeys);
    if (!json.at("peakMemoryMb").is_null()) {
      model.peakMemoryMb = json.at("peakMemoryMb").get<double>();
    }
    return model;
  } catch (const Json::exception&) {
    return std::nullopt;  // cut off, or not ours: the model is made anew
  }
}

}  // namespace glisson
