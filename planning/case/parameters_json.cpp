#include "planning/case/parameters_json.h"

namespace glisson {

namespace {
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

/// "psr", "mcsd", or a listed method's id.
std::string methodId(const ReconstructionParameters& p) {
  return p.method == Method::Psr ? "psr" : p.method == Method::Mcsd ? "mcsd" : p.listedMethod;
}
}  // namespace

Json parametersJson(const ReconstructionParameters& p) {
  Json json{{"method", methodId(p)},
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
  if (p.method == Method::Listed) {
    json["variant"] = p.listedVariant;
  }
  return json;
}

ReconstructionParameters parametersFromJson(const Json& json) {
  ReconstructionParameters p;
  const std::string method = json.at("method").get<std::string>();
  p.method = method == "psr" ? Method::Psr : method == "mcsd" ? Method::Mcsd : Method::Listed;
  if (p.method == Method::Listed) {
    p.listedMethod = method;
    json.at("variant").get_to(p.listedVariant);
  }
  p.autoDepth = json.at("depth") == "auto";
  if (!p.autoDepth) {
    json.at("depth").get_to(p.psr.depth);
  }
  p.psr.sampling = json.at("sampling") == "paper" ? Sampling::Paper : Sampling::Unbiased;
  json.at("pointWeight").get_to(p.psr.pointWeight);
  json.at("scale").get_to(p.psr.scale);
  json.at("smoothing").get_to(p.mcsd.smoothing);
  p.mcsd.filter = json.at("filter") == "sinc" ? SmoothingFilter::Sinc : SmoothingFilter::Laplacian;
  json.at("decimation").get_to(p.mcsd.decimation);
  p.mcsd.order = json.at("order") == "decimate-first" ? McsdOrder::DecimateFirst : McsdOrder::SmoothFirst;
  json.at("splitNormals").get_to(p.mcsd.splitNormals);
  p.simplify = simplifyFromJson(json.value("simplify", Json()));  // cases of before it existed have none
  p.validate();
  return p;
}

Json usedParametersJson(const ReconstructionParameters& parameters) {
  const Json all = parametersJson(parameters);
  if (parameters.method == Method::Listed) {
    return picked(all, {"method", "variant", "sampling", "scale", "simplify"});
  }
  return parameters.method == Method::Psr ? picked(all, {"method", "depth", "sampling", "pointWeight", "scale", "simplify"})
                                          : picked(all, {"method", "smoothing", "filter", "decimation", "order", "simplify"});
}

}  // namespace glisson
