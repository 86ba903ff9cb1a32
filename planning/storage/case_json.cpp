#include "planning/storage/case_json.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "planning/case/parameters_json.h"

namespace glisson::caseJson {

namespace {

Vec3 toVector(const Json& json) {
  if (!json.is_array() || json.size() != 3) {
    throw std::runtime_error("a vector has no three numbers");
  }
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Json fromColour(const Rgb& c) { return Json::array({c.r, c.g, c.b}); }

Rgb toColour(const Json& json) {
  return {json.at(0).get<std::uint8_t>(), json.at(1).get<std::uint8_t>(), json.at(2).get<std::uint8_t>()};
}

StructureKind toKind(const Json& json) {
  const auto kind = kindFromId(json.get<std::string>());
  if (!kind) {
    throw std::runtime_error("a structure has an unknown kind");
  }
  return *kind;
}

/// Files of before it existed have none, and a program that does not know it forgets it: not accepted.
void putAcceptance(Json& json, const std::optional<Acceptance>& acceptance) {
  if (acceptance) {
    validate(*acceptance);
    json["acceptance"] = {{"by", acceptance->by}, {"at", acceptance->at}};
  }
}

std::optional<Acceptance> toAcceptance(const Json& json) {
  if (!json.contains("acceptance")) {
    return std::nullopt;
  }
  const Json& accepted = json.at("acceptance");
  const Acceptance acceptance{accepted.at("by").get<std::string>(), accepted.at("at").get<std::string>()};
  validate(acceptance);
  return acceptance;
}

Json fromDefects(const MeshDefects& d) {
  return Json::array({d.openEdges, d.orientationEdges, d.inward ? 1 : 0, d.nonManifoldEdges, d.nonManifoldVertices,
                      d.degenerateTriangles, d.selfIntersections});
}

MeshDefects toDefects(const Json& json) {
  MeshDefects d;
  json.at(0).get_to(d.openEdges);
  json.at(1).get_to(d.orientationEdges);
  d.inward = json.at(2).get<int>() != 0;
  json.at(3).get_to(d.nonManifoldEdges);
  json.at(4).get_to(d.nonManifoldVertices);
  json.at(5).get_to(d.degenerateTriangles);
  json.at(6).get_to(d.selfIntersections);
  return d;
}

Json fromBend(const Bend& bend) {
  return {{"u", vectorJson(bend.u)}, {"halfSizeMm", bend.halfSizeMm}, {"heightsMm", bend.heightsMm}};
}

/// Checked; what fromBend() wrote comes back bit for bit.
Bend toBend(const Json& json, const HalfSpace& plane) {
  const Json& heights = json.at("heightsMm");
  if (!heights.is_array() || heights.size() != Bend().heightsMm.size()) {
    throw std::runtime_error("a plane's bend has not 16 heights");
  }
  return checkedBend(plane, {toVector(json.at("u")), json.at("halfSizeMm").get<double>(), heights.get<std::array<double, 16>>()});
}

Json fromReconstruction(const Reconstruction& r) {
  Json json;
  json["parameters"] = parametersJson(r.parameters);
  json["usedDepth"] = r.usedDepth;
  json["samples"] = r.samples;
  json["defects"] = fromDefects(r.defects);
  json["meshVolumeMl"] = std::isfinite(r.meshVolumeMl) ? Json(r.meshVolumeMl) : Json();
  json["voxelVolumeMl"] = r.voxelVolumeMl;
  json["maskComponents"] = r.maskComponents;
  json["meshComponents"] = r.meshComponents;
  json["centrelineInside"] = r.centrelineInside ? Json(*r.centrelineInside) : Json();
  json["notes"] = r.notes;
  json["deviations"] = r.deviations;
  const Seconds& s = r.seconds;
  json["seconds"] = Json::array({s.sample, s.solve, s.extract, s.smooth, s.decimate, s.check});
  json["vertices"] = r.mesh.vertices.size();
  json["triangles"] = r.mesh.triangles.size();
  return json;
}

std::shared_ptr<Reconstruction> toReconstruction(const Json& json) {
  auto r = std::make_shared<Reconstruction>();
  r->parameters = parametersFromJson(json.at("parameters"));
  json.at("usedDepth").get_to(r->usedDepth);
  json.at("samples").get_to(r->samples);
  r->defects = toDefects(json.at("defects"));
  const Json& volume = json.at("meshVolumeMl");
  r->meshVolumeMl = volume.is_null() ? std::numeric_limits<double>::quiet_NaN() : volume.get<double>();
  json.at("voxelVolumeMl").get_to(r->voxelVolumeMl);
  json.at("maskComponents").get_to(r->maskComponents);
  json.at("meshComponents").get_to(r->meshComponents);
  if (!json.at("centrelineInside").is_null()) {
    r->centrelineInside = json.at("centrelineInside").get<double>();
  }
  r->notes = json.at("notes").get<std::vector<std::string>>();
  r->deviations = json.at("deviations").get<std::vector<std::string>>();
  const auto s = json.at("seconds").get<std::array<double, 6>>();
  r->seconds = {s[0], s[1], s[2], s[3], s[4], s[5]};
  return r;
}
}  // namespace

Json fromPlans(const std::vector<ResectionPlan>& plans) {
  Json json = Json::array();
  for (const ResectionPlan& plan : plans) {
    Json resections = Json::array();
    for (const Resection& resection : plan.resections) {
      Json planes = Json::array();
      for (const ResectionPlane& plane : resection.planes) {
        planes.push_back({{"originMm", vectorJson(plane.origin)}, {"normal", vectorJson(plane.normal)}});
        if (plane.bend) {
          planes.back()["bend"] = fromBend(*plane.bend);
        }
      }
      resections.push_back({{"name", resection.name}, {"planes", planes}});
    }
    json.push_back({{"name", plan.name}, {"safetyMarginMm", plan.safetyMarginMm}, {"resections", resections}});
    for (const IslandAssignment& island : plan.islands) {
      json.back()["islands"].push_back({{"pointMm", vectorJson(island.point)}, {"toResected", island.to == PlanSide::Resected}});
    }
    for (const Measure& measure : plan.measures) {
      json.back()["measures"].push_back(
          {{"name", measure.name}, {"fromMm", vectorJson(measure.from)}, {"toMm", vectorJson(measure.to)}});
    }
  }
  return json;
}

std::vector<ResectionPlan> toPlans(const Json& json) {
  std::vector<ResectionPlan> plans;
  for (const Json& item : json) {
    ResectionPlan plan;
    item.at("name").get_to(plan.name);
    item.at("safetyMarginMm").get_to(plan.safetyMarginMm);
    for (const Json& cut : item.at("resections")) {
      Resection resection;
      cut.at("name").get_to(resection.name);
      for (const Json& plane : cut.at("planes")) {
        resection.planes.emplace_back(toVector(plane.at("originMm")), toVector(plane.at("normal")));
        const double length = resection.planes.back().normal.norm();
        if (std::abs(length - 1) > 1e-6) {
          throw std::runtime_error("a plane's normal is not of unit length");
        }
        if (plane.contains("bend")) {
          resection.planes.back().bend = toBend(plane.at("bend"), resection.planes.back());
        }
      }
      plan.resections.push_back(std::move(resection));
    }
    if (item.contains("islands")) {
      for (const Json& island : item.at("islands")) {
        const bool toResected = island.at("toResected").get<bool>();
        plan.islands.push_back({toVector(island.at("pointMm")), toResected ? PlanSide::Resected : PlanSide::Remnant});
      }
    }
    if (item.contains("measures")) {
      for (const Json& measure : item.at("measures")) {
        plan.measures.push_back(
            {measure.at("name").get<std::string>(), toVector(measure.at("fromMm")), toVector(measure.at("toMm"))});
      }
    }
    plans.push_back(std::move(plan));
  }
  return plans;
}

Json fromFacts(const PatientFacts& facts) {
  Json json;
  json["heightCm"] = facts.heightCm ? Json(*facts.heightCm) : Json();
  json["weightKg"] = facts.weightKg ? Json(*facts.weightKg) : Json();
  json["condition"] = facts.condition ? Json(idOf(*facts.condition)) : Json();
  json["tumourType"] = facts.tumourType ? Json(idOf(*facts.tumourType)) : Json();
  return json;
}

PatientFacts toFacts(const Json& json) {
  PatientFacts facts;
  const auto has = [&](const char* key) { return !json.at(key).is_null(); };
  if (has("heightCm")) {
    facts.heightCm = json.at("heightCm").get<double>();
  }
  if (has("weightKg")) {
    facts.weightKg = json.at("weightKg").get<double>();
  }
  if (has("condition")) {
    facts.condition = conditionFromId(json.at("condition").get<std::string>());
  }
  if (has("tumourType")) {
    facts.tumourType = tumourTypeFromId(json.at("tumourType").get<std::string>());
  }
  if (has("condition") != facts.condition.has_value() || has("tumourType") != facts.tumourType.has_value()) {
    throw std::runtime_error("the patient has an unknown liver condition or tumour type");
  }
  validate(facts);
  return facts;
}

Json fromMarks(const TerritoryMarks& marks) {
  Json list = Json::array();
  for (const TerritoryMark& mark : marks.marks) {
    Json points = Json::array();
    for (const Vec3& point : mark.pointsMm) {
      points.push_back(vectorJson(point));
    }
    list.push_back({{"name", mark.name}, {"pointsMm", std::move(points)}});
  }
  Json json{{"proposed", marks.proposed}, {"marks", std::move(list)}};
  if (marks.segments) {
    json["segments"] = {{"path", marks.segments->path}, {"sha256", marks.segments->sha256}};
  }
  return json;
}

TerritoryMarks toMarks(const Json& json) {
  TerritoryMarks marks;
  json.at("proposed").get_to(marks.proposed);
  for (const Json& one : json.at("marks")) {
    TerritoryMark mark{one.at("name").get<std::string>(), {}};
    for (const Json& point : one.at("pointsMm")) {
      mark.pointsMm.push_back(toVector(point));
    }
    marks.marks.push_back(std::move(mark));
  }
  if (const auto map = json.find("segments"); map != json.end()) {
    marks.segments = SegmentMapFile{map->at("path").get<std::string>(), map->at("sha256").get<std::string>()};
  }
  validate(marks);
  return marks;
}

Json fromStates(const std::vector<StructureState>& states) {
  Json list = Json::array();
  for (const StructureState& state : states) {
    list.push_back(
        {{"id", state.id}, {"colour", fromColour(state.colour)}, {"opacity", state.opacity}, {"visible", state.visible}});
    putAcceptance(list.back(), state.acceptance);
    if (!state.surface.empty()) {
      list.back()["surface"] = state.surface;
    }
  }
  return list;
}

std::vector<StructureState> toStates(const Json& json) {
  std::vector<StructureState> states;
  for (const Json& one : json) {
    states.push_back({one.at("id").get<std::string>(), toColour(one.at("colour")), one.at("opacity").get<double>(),
                      one.at("visible").get<bool>(), toAcceptance(one), one.value("surface", std::string())});
  }
  return states;
}

Json fromIdentity(const PatientIdentity& p) {
  return {{"patientName", p.patientName}, {"patientId", p.patientId},      {"birthDate", p.birthDate},
          {"studyDate", p.studyDate},     {"series", p.seriesDescription}, {"frameOfReferenceUid", p.frameOfReferenceUid}};
}

PatientIdentity toIdentity(const Json& json) {
  const auto text = [&](const char* key) { return json.at(key).get<std::string>(); };
  return {text("patientName"), text("patientId"), text("birthDate"),
          text("studyDate"),   text("series"),    text("frameOfReferenceUid")};
}

Json fromGeometry(const ImageGeometry& g) {
  return {
      {"size", g.size},
      {"spacingMm", vectorJson(g.spacing)},
      {"originMm", vectorJson(g.origin)},
      {"direction", Json::array({vectorJson(g.direction.col(0)), vectorJson(g.direction.col(1)), vectorJson(g.direction.col(2))})}};
}

ImageGeometry toGeometry(const Json& json) {
  ImageGeometry g;
  g.size = json.at("size").get<Index3>();
  g.spacing = toVector(json.at("spacingMm"));
  g.origin = toVector(json.at("originMm"));
  for (int axis = 0; axis < 3; ++axis) {
    g.direction.col(axis) = toVector(json.at("direction").at(static_cast<std::size_t>(axis)));
  }
  g.validate("The case");
  return g;
}

Json fromBox(const IndexBox& box) { return {{"first", box.first}, {"size", box.size}}; }

IndexBox toBox(const Json& json, const Index3& size) {
  const IndexBox box{json.at("first").get<Index3>(), json.at("size").get<Index3>()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.first[axis] < 0 || box.size[axis] < 0 || box.size[axis] > size[axis] || box.first[axis] > size[axis] - box.size[axis]) {
      throw std::runtime_error("a mask lies outside its grid");
    }
  }
  return box;
}

Json fromLabelled(const LabelledMask& structure) {
  Json json;
  json["name"] = structure.name;
  json["label"] = structure.label;
  json["kind"] = structure.kind ? Json(kindId(*structure.kind)) : Json();
  json["colour"] = structure.colour ? fromColour(*structure.colour) : Json();
  json["box"] = structure.mask ? fromBox(structure.mask->box()) : Json();
  return json;
}

LabelledMask toLabelled(const Json& json) {
  LabelledMask structure;
  json.at("name").get_to(structure.name);
  json.at("label").get_to(structure.label);
  if (!json.at("kind").is_null()) {
    structure.kind = toKind(json.at("kind"));
  }
  if (!json.at("colour").is_null()) {
    structure.colour = toColour(json.at("colour"));
  }
  return structure;
}

Json fromStructure(const Structure& structure) {
  Json json;
  json["id"] = structure.id;
  json["name"] = structure.name;
  json["kind"] = kindId(structure.kind);
  json["colour"] = fromColour(structure.colour);
  json["opacity"] = structure.opacity;
  json["visible"] = structure.visible;
  json["sourceIndex"] = structure.sourceIndex;
  json["reconstruction"] = structure.reconstruction ? fromReconstruction(*structure.reconstruction) : Json();
  putAcceptance(json, structure.acceptance);
  return json;
}

StoredStructure toStructure(const Json& json) {
  StoredStructure stored;
  json.at("id").get_to(stored.structure.id);
  json.at("name").get_to(stored.structure.name);
  stored.structure.kind = toKind(json.at("kind"));
  stored.structure.colour = toColour(json.at("colour"));
  json.at("opacity").get_to(stored.structure.opacity);
  json.at("visible").get_to(stored.structure.visible);
  json.at("sourceIndex").get_to(stored.structure.sourceIndex);
  const Json& made = json.at("reconstruction");
  if (!made.is_null()) {
    stored.reconstruction = toReconstruction(made);
    made.at("vertices").get_to(stored.vertices);
    made.at("triangles").get_to(stored.triangles);
    stored.structure.acceptance = toAcceptance(json);
  }
  return stored;
}

}  // namespace glisson::caseJson
