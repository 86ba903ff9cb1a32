#pragma once
// Purpose: plan.json and manifest.json: what the package's files say about themselves. Private to planning/exchange.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "planning/exchange/package_check.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

struct FileEntry {
  std::string file;
  std::string sha256;
  std::uintmax_t bytes = 0;
};
struct MeshEntry {
  std::string id;
  std::string role;
  MeshFigures figures;
};
struct Manifest {
  std::vector<FileEntry> files;  ///< all but manifest.json itself
  std::vector<MeshEntry> meshes;
  bool stl = true;
  bool glb = true;
};

inline constexpr std::string_view kManifestFile = "manifest.json";
inline constexpr std::string_view kPlanFile = "plan.json";
inline constexpr std::string_view kGlbFile = "model.glb";

/// The manifest holds the SHA-256 of its own text, computed with that field as 64 zeros: a change anywhere in it is found.
std::string manifestText(const Manifest& manifest);
/// `intact` is false where the text is not what was written. Throws InputError where it is no manifest at all.
Manifest parseManifest(const std::string& text, const std::string& file, bool& intact);

/// plan.json: frame of reference, axes, units, planes, parameters, volumes, margins, deviations, who accepted what, colours,
/// version, SHA-256 of the mesh files. No free text of the source and no identity but the id where `options` asks for it.
std::string planText(const Case& source, const ResectionPlan& plan, const ExportOptions& options, const PlanAssessment& assessment,
                     const std::vector<PackageMesh>& meshes, const std::vector<FileEntry>& files);
/// One sentence per problem of a package's plan.json against its manifest.
std::vector<std::string> planProblems(const std::string& text, const Manifest& manifest);

}  // namespace glisson
