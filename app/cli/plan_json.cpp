#include "app/cli/plan_json.h"

#include <Eigen/Geometry>

#include "planning/case/parameters_json.h"
#include "planning/storage/surface_hash.h"

namespace glisson::cli {

namespace {
/// Where plane `p` of the resection stands.
Json placeJson(const Resection& resection, std::size_t p) {
  const ResectionPlane& plane = resection.planes[p];
  return {{"resection", resection.name},
          {"plane", p + 1},
          {"originMm", {plane.origin[0], plane.origin[1], plane.origin[2]}},
          {"normal", {plane.normal[0], plane.normal[1], plane.normal[2]}}};
}
}  // namespace

Json planesJson(const ResectionPlan& plan) {
  Json json = Json::array();
  for (const Resection& resection : plan.resections) {
    for (std::size_t p = 0; p < resection.planes.size(); ++p) {
      json.push_back(placeJson(resection, p));
    }
  }
  return json;
}

Json bendsJson(const ResectionPlan& plan) {
  Json json = Json::array();
  for (const Resection& resection : plan.resections) {
    for (std::size_t p = 0; p < resection.planes.size(); ++p) {
      const ResectionPlane& plane = resection.planes[p];
      if (plane.bend) {
        const Vec3& u = plane.bend->u;
        const Vec3 v = plane.normal.cross(u);
        Json bend = placeJson(resection, p);
        bend["u"] = {u[0], u[1], u[2]};
        bend["v"] = {v[0], v[1], v[2]};
        bend["halfSizeMm"] = plane.bend->halfSizeMm;
        bend["order"] = kBendOrder;
        bend["heightsMm"] = plane.bend->heightsMm;
        json.push_back(std::move(bend));
      }
    }
  }
  return json;
}

Json measuresJson(const std::vector<Measure>& measures) {
  Json json = Json::array();
  for (const Measure& m : measures) {
    json.push_back({{"name", m.name},
                    {"fromMm", {m.from[0], m.from[1], m.from[2]}},
                    {"toMm", {m.to[0], m.to[1], m.to[2]}},
                    {"distanceMm", m.mm()}});
  }
  return json;
}

Json structuresJson(const LiverModel& model) {
  Json json = Json::array();
  for (const Structure& structure : model.structures) {
    const auto& made = structure.reconstruction;
    const auto& acceptance = structure.acceptance;
    json.push_back({{"id", structure.id},
                    {"name", structure.name},
                    {"madeBy", made ? Json(made->parameters.describe()) : Json()},
                    {"parameters", made ? usedParametersJson(made->parameters) : Json()},
                    {"triangles", made ? Json(made->mesh.triangles.size()) : Json()},
                    {"voxelVolumeMl", made ? Json(made->voxelVolumeMl) : Json()},
                    {"meshVolumeMl", made ? Json(made->meshVolumeMl) : Json()},
                    {"surfaceSha256", made ? Json(surfaceHash(made->mesh)) : Json()},
                    {"acceptedBy", acceptance ? Json(acceptance->by) : Json()},
                    {"acceptedAt", acceptance ? Json(acceptance->at) : Json()}});
  }
  return json;
}

}  // namespace glisson::cli
