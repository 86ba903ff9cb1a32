#include "planning/case/parameters_json.h"

namespace glisson {

namespace {
using Json = nlohmann::ordered_json;

Json picked(const Json& all, std::initializer_list<const char*> keys) {
  Json json;
  for (const char* key : keys) {
    json[key] = all.at(key);
  }
  return json;
}

Json simplifyJson(const std::optional<SimplifyTarget>& target) {
  if (!target) {
    return nullptr;
  }
  return target->triangles ? Json{{"triangles", *target->triangles}} : Json{{"distanceMm", *target->distanceMm}};
}

std::optional<SimplifyTarget> simplifyFromJson(const Json& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  SimplifyTarget target;
  if (json.contains("triangles")) {
    target.triangles = json.at("triangles").get<std::size_t>();
  } else {
    target.distanceMm = json.at("distanceMm").get<double>();
  }
  return target;
}
}  // namespace

Json parametersJson(const ReconstructionParameters& p) {
  return {{"method", p.method == Method::Psr ? "psr" : "mcsd"},
          {"depth", p.autoDepth ? Json("auto") : Json(p.psr.depth)},
          {"sampling", p.psr.sampling == Sampling::Paper ? "paper" : "unbiased"},
          {"pointWeight", p.psr.pointWeight},
          {"scale", p.psr.scale},
          {"smoothing", p.mcsd.smoothing},
          {"filter", p.mcsd.filter == SmoothingFilter::Sinc ? "sinc" : "laplacian"},
          {"decimation", p.mcsd.decimation},
          {"order", p.mcsd.order == McsdOrder::DecimateFirst ? "decimate-first" : "smooth-first"},
          {"splitNormals", p.mcsd.splitNormals},
          {"simplify", simplifyJson(p.simplify)}};
}

ReconstructionParameters parametersFromJson(const Json& json) {
  ReconstructionParameters p;
  p.method = json.at("method") == "psr" ? Method::Psr : Method::Mcsd;
  p.autoDepth = json.at("depth") == "auto";
  if (!p.autoDepth) {
    p.psr.depth = json.at("depth");
  }
  p.psr.sampling = json.at("sampling") == "paper" ? Sampling::Paper : Sampling::Unbiased;
  p.psr.pointWeight = json.at("pointWeight");
  p.psr.scale = json.at("scale");
  p.mcsd.smoothing = json.at("smoothing");
  p.mcsd.filter = json.at("filter") == "sinc" ? SmoothingFilter::Sinc : SmoothingFilter::Laplacian;
  p.mcsd.decimation = json.at("decimation");
  p.mcsd.order = json.at("order") == "decimate-first" ? McsdOrder::DecimateFirst : McsdOrder::SmoothFirst;
  p.mcsd.splitNormals = json.at("splitNormals");
  p.simplify = simplifyFromJson(json.value("simplify", Json()));  // cases of before it existed have none
  p.validate();
  return p;
}

Json usedParametersJson(const ReconstructionParameters& parameters) {
  const Json all = parametersJson(parameters);
  return parameters.method == Method::Psr ? picked(all, {"method", "depth", "sampling", "pointWeight", "scale", "simplify"})
                                          : picked(all, {"method", "smoothing", "filter", "decimation", "order", "simplify"});
}

}  // namespace glisson
