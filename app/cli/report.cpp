#include "app/cli/report.h"

#include <cmath>

#include "planning/case/parameters_json.h"

namespace glisson::cli {

namespace {

Json parametersOf(const ReconstructionParameters& parameters, int threads) {
  Json json = usedParametersJson(parameters);
  json["threads"] = threads;
  return json;
}

}  // namespace

std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json toJson(const ErrorSummary& errors) {
  return {{"mean", errors.mean}, {"median", errors.median}, {"p95", errors.p95}, {"max", errors.max}};
}

Json toJson(const std::optional<ErrorSummary>& errors) { return errors ? toJson(*errors) : Json(nullptr); }

Json toJson(const Reconstruction& result, const ReconstructReport& report) {
  const Seconds& seconds = result.seconds;
  Json json;
  // MCSD's decimation and smoothing belong to the extraction.
  json["seconds"] = {{"load", report.loadSeconds},
                     {"sample", seconds.sample},
                     {"solve", seconds.solve},
                     {"extract", seconds.extract + seconds.decimate + seconds.smooth},
                     {"simplify", seconds.simplify},
                     {"check", seconds.check},
                     {"selfIntersection", seconds.selfIntersection},
                     {"write", report.writeSeconds}};
  json["triangles"] = result.mesh.triangles.size();
  json["vertices"] = result.mesh.vertices.size();
  json["volumeMl"] = number(result.meshVolumeMl);
  json["voxelVolumeMl"] = number(result.voxelVolumeMl);
  json["paperErrorMm"] = toJson(report.paperErrorMm);
  json["voxelErrorMm"] = toJson(report.voxelErrorMm);
  json["usedDepth"] = result.usedDepth > 0 ? Json(result.usedDepth) : Json(nullptr);
  json["defects"] = result.defects.names();
  Json notes = result.notes;
  for (const std::string& deviation : result.deviations) {
    notes.push_back(deviation);
  }
  json["notes"] = std::move(notes);
  json["peakGrowthMb"] = report.peakGrowthMb ? Json(*report.peakGrowthMb) : Json(nullptr);
  json["parameters"] = parametersOf(result.parameters, report.threads);
  return json;
}

}  // namespace glisson::cli
