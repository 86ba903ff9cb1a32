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
  const std::string method = json.at("method");
  p.method = method == "psr" ? Method::Psr : method == "mcsd" ? Method::Mcsd : Method::Listed;
  if (p.method == Method::Listed) {
    p.listedMethod = method;
    p.listedVariant = json.at("variant");
  }
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
  if (parameters.method == Method::Listed) {
    return picked(all, {"method", "variant", "sampling", "scale", "simplify"});
  }
  return parameters.method == Method::Psr ? picked(all, {"method", "depth", "sampling", "pointWeight", "scale", "simplify"})
                                          : picked(all, {"method", "smoothing", "filter", "decimation", "order", "simplify"});
}

}  // namespace glisson
