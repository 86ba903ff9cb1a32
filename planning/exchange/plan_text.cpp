// plan.json, the sidecar of clinical.md: what a receiver must know that STL and GLB cannot say.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "planning/case/parameters_json.h"
#include "planning/exchange/manifest.h"
#include "planning/exchange/pseudonym.h"
#include "planning/exchange/version.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

std::string frameOfReference(const Case& source) {
  if (!source.identity.frameOfReferenceUid.empty()) {
    return source.identity.frameOfReferenceUid;
  }
  return source.segmentation && !source.segmentation->frameOfReferenceUid.empty() ? source.segmentation->frameOfReferenceUid
                                                                                  : "none";
}

Json parametersOf(const Reconstruction& made) {
  Json json = usedParametersJson(made.parameters);
  if (made.parameters.method == Method::Psr) {
    json["usedDepth"] = made.usedDepth;
  }
  json["summary"] = made.parameters.describe();
  return json;
}

Json structureOf(const Case& source, const Structure& structure) {
  const Reconstruction& made = *structure.reconstruction;
  Json json;
  json["id"] = structure.id;
  json["kind"] = kindId(structure.kind);
  json["colour"] = Json::array({structure.colour.r, structure.colour.g, structure.colour.b});
  json["opacity"] = structure.opacity;
  json["parameters"] = parametersOf(made);
  json["triangles"] = made.mesh.triangles.size();
  json["meshVolumeMl"] = numberOrNull(made.meshVolumeMl);
  json["voxelVolumeMl"] = numberOrNull(made.voxelVolumeMl);
  json["volumeDeviationPercent"] = numberOrNull(made.voxelVolumeMl > 0 ? 100 * made.volumeDeviation() : NAN);
  json["maskComponents"] = made.maskComponents;
  json["meshComponents"] = made.meshComponents;
  json["centrelineInside"] = made.centrelineInside ? Json(*made.centrelineInside) : Json();
  json["defects"] = made.defects.names();
  json["notes"] = made.notes;
  json["deviations"] = made.deviations;
  // A reviewer who bears the patient's name would name the patient.
  const auto& accepted = structure.acceptance;
  json["acceptedBy"] = accepted ? Json(pseudonymous(accepted->by, "a person", source)) : Json();
  json["acceptedAt"] = accepted ? Json(accepted->at) : Json();
  return json;
}

Json resectionOf(const Case& source, const Resection& resection, std::size_t index, const std::vector<PackageMesh>& meshes) {
  Json json;
  json["name"] = pseudonymous(resection.name, "Resection " + std::to_string(index + 1), source);
  json["planes"] = Json::array();
  for (const ResectionPlane& plane : resection.planes) {
    json["planes"].push_back({{"originMm", vectorJson(plane.origin)}, {"normalToResectedSide", vectorJson(plane.normal)}});
    if (plane.bend) {
      // The surface is origin + U u + V v + h(U, V) normal, h the cubic Bezier surface of these heights.
      json["planes"].back()["bend"] = {{"u", vectorJson(plane.bend->u)},
                                       {"v", vectorJson(plane.normal.cross(plane.bend->u))},
                                       {"halfSizeMm", plane.bend->halfSizeMm},
                                       {"order", kBendOrder},
                                       {"heightsMm", plane.bend->heightsMm}};
    }
  }
  json["meshes"] = Json::array();
  for (const PackageMesh& mesh : meshes) {
    if (mesh.resection == static_cast<int>(index)) {
      json["meshes"].push_back(mesh.named.id);
    }
  }
  return json;
}

/// The assessment with ids in place of the source's free text.
Json assessmentOf(const Case& source, PlanAssessment assessment) {
  for (TumourAssessment& tumour : assessment.tumours) {
    tumour.name = tumour.id;
  }
  for (VesselCrossing& crossing : assessment.vesselsCrossed) {
    crossing.name = crossing.id;
  }
  for (std::size_t i = 0; i < assessment.resections.size(); ++i) {
    assessment.resections[i].name = pseudonymous(assessment.resections[i].name, "Resection " + std::to_string(i + 1), source);
  }
  return Json::parse(toJson(assessment));
}

Json measuresOf(const Case& source, const ResectionPlan& plan) {
  Json json = Json::array();
  for (std::size_t n = 0; n < plan.measures.size(); ++n) {
    const Measure& measure = plan.measures[n];
    json.push_back({{"name", pseudonymous(measure.name, "Distance " + std::to_string(n + 1), source)},
                    {"fromMm", vectorJson(measure.from)},
                    {"toMm", vectorJson(measure.to)},
                    {"distanceMm", measure.mm()}});
  }
  return json;
}

Json filesOf(const std::vector<FileEntry>& files) {
  Json json = Json::array();
  for (const FileEntry& entry : files) {
    json.push_back({{"file", entry.file}, {"sha256", entry.sha256}});
  }
  return json;
}

/// What was doubtful in the input and read all the same, without the names of files behind the colon.
Json consentsOf(const Case& source) {
  Json json = Json::array();
  for (const std::string& note : source.notes) {
    if (note.find("with consent") != std::string::npos) {
      json.push_back(pseudonymous(note.substr(0, note.find(':')), "consent", source));
    }
  }
  return json;
}

}  // namespace

std::string planText(const Case& source, const ResectionPlan& plan, const ExportOptions& options, const PlanAssessment& assessment,
                     const std::vector<PackageMesh>& meshes, const std::vector<FileEntry>& files) {
  Json json;
  json["format"] = "glisson-plan";
  json["formatVersion"] = hasBends(plan) ? 2 : 1;  // a reader of 1 must not take a bent plane for a flat one
  json["program"] = "Glisson";
  json["version"] = glissonVersion();
  json["notice"] = "Not for clinical use";
  json["case"] = source.code;
  if (options.patientId) {
    json["patientId"] = source.identity.patientId;
  }
  json["plan"] = pseudonymous(plan.name, "Plan", source);
  json["exported"] = options.timestamp;
  json["frameOfReferenceUid"] = frameOfReference(source);
  json["axes"] = "LPS";
  json["units"] = "mm";
  json["volumeUnits"] = "mL";
  json["safetyMarginMm"] = plan.safetyMarginMm;
  json["resections"] = Json::array();
  for (std::size_t i = 0; i < plan.resections.size(); ++i) {
    json["resections"].push_back(resectionOf(source, plan.resections[i], i, meshes));
  }
  json["remnant"] = Json::array();
  for (const PackageMesh& mesh : meshes) {
    if (mesh.role == "remnant") {
      json["remnant"].push_back(mesh.named.id);
    }
  }
  json["measures"] = measuresOf(source, plan);
  json["assessment"] = assessmentOf(source, assessment);
  json["structures"] = Json::array();
  for (const Structure& structure : source.model->structures) {
    json["structures"].push_back(structureOf(source, structure));
  }
  json["consents"] = consentsOf(source);
  json["notAccepted"] = notAccepted(*source.model);
  json["files"] = filesOf(files);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> planProblems(const std::string& text, const Manifest& manifest) {
  std::vector<std::string> problems;
  try {
    const Json json = Json::parse(text);
    if (json.at("axes").get<std::string>() != "LPS" || json.at("units").get<std::string>() != "mm") {
      problems.emplace_back("plan.json does not say axes LPS and units mm: export the plan again.");
    }
    for (const Json& entry : json.at("files")) {
      const auto name = entry.at("file").get<std::string>();
      const auto found =
          std::find_if(manifest.files.begin(), manifest.files.end(), [&](const FileEntry& file) { return file.file == name; });
      if (found == manifest.files.end() || found->sha256 != entry.at("sha256").get<std::string>()) {
        problems.push_back("plan.json and manifest.json do not agree on \"" + name + "\": export the plan again.");
      }
    }
  } catch (const Json::exception&) {
    problems.emplace_back("plan.json is damaged: export the plan again.");
  }
  return problems;
}

}  // namespace glisson
