#include "planning/exchange/manifest.h"

#include <algorithm>
#include <cmath>

#include "planning/exchange/version.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {

const std::string kZeros(64, '0');

std::string hashOf(const std::string& text) { return sha256Hex(std::as_bytes(std::span(text))); }

Vec3 toVec(const Json& json) {
  const auto values = json.get<std::array<double, 3>>();
  return {values[0], values[1], values[2]};
}

}  // namespace

std::string manifestText(const Manifest& manifest) {
  Json json;
  json["format"] = "glisson-package";
  json["formatVersion"] = 1;
  json["version"] = glissonVersion();
  json["axes"] = "LPS";
  json["units"] = "mm";
  json["stl"] = manifest.stl;
  json["glb"] = manifest.glb;
  json["files"] = Json::array();
  for (const FileEntry& entry : manifest.files) {
    json["files"].push_back({{"file", entry.file}, {"bytes", entry.bytes}, {"sha256", entry.sha256}});
  }
  json["meshes"] = Json::array();
  for (const MeshEntry& entry : manifest.meshes) {
    const MeshFigures& f = entry.figures;
    Json mesh;
    mesh["id"] = entry.id;
    mesh["role"] = entry.role;
    mesh["triangles"] = f.triangles;
    mesh["closed"] = f.closed;
    mesh["boundsMm"] = {{"low", vectorJson(f.bounds.low)}, {"high", vectorJson(f.bounds.high)}};
    mesh["areaMm2"] = f.areaMm2;
    mesh["volumeMm3"] = f.closed ? Json(f.volumeMm3) : Json();
    json["meshes"].push_back(std::move(mesh));
  }
  json["manifestSha256"] = kZeros;
  std::string text = json.dump(1) + "\n";
  text.replace(text.rfind(kZeros), kZeros.size(), hashOf(text));
  return text;
}

Manifest parseManifest(const std::string& text, const std::string& file, bool& intact) {
  try {
    const Json json = Json::parse(text);
    if (json.at("format").get<std::string>() != "glisson-package" || json.at("formatVersion").get<int>() != 1) {
      throw InputError("\"" + file + "\" is no manifest of this version: verify the package with the program that wrote it.");
    }
    const auto self = json.at("manifestSha256").get<std::string>();
    std::string zeroed = text;
    const std::size_t at = self.size() == kZeros.size() ? zeroed.rfind(self) : std::string::npos;
    if (at != std::string::npos) {
      zeroed.replace(at, self.size(), kZeros);
    }
    intact = at != std::string::npos && hashOf(zeroed) == self;
    Manifest manifest;
    manifest.stl = json.at("stl").get<bool>();
    manifest.glb = json.at("glb").get<bool>();
    for (const Json& entry : json.at("files")) {
      manifest.files.push_back(
          {entry.at("file").get<std::string>(), entry.at("sha256").get<std::string>(), entry.at("bytes").get<std::uintmax_t>()});
    }
    for (const Json& entry : json.at("meshes")) {
      MeshEntry mesh;
      mesh.id = entry.at("id").get<std::string>();
      mesh.role = entry.at("role").get<std::string>();
      mesh.figures.triangles = entry.at("triangles").get<std::size_t>();
      mesh.figures.closed = entry.at("closed").get<bool>();
      mesh.figures.bounds = {toVec(entry.at("boundsMm").at("low")), toVec(entry.at("boundsMm").at("high"))};
      mesh.figures.areaMm2 = entry.at("areaMm2").get<double>();
      mesh.figures.volumeMm3 = mesh.figures.closed ? entry.at("volumeMm3").get<double>() : 0.0;
      manifest.meshes.push_back(std::move(mesh));
    }
    return manifest;
  } catch (const Json::exception&) {
    throw InputError("\"" + file + "\" is damaged: export the plan again.");
  }
}

}  // namespace glisson
