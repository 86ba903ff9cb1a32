#include "planning/exchange/package.h"

#include <algorithm>
#include <ctime>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/manifest.h"
#include "planning/exchange/mesh_formats.h"
#include "planning/exchange/pseudonym.h"
#include "planning/exchange/staging.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/self_intersection.h"

namespace glisson {

namespace {

/// ASCII letters, digits and '-'; everything else becomes one '-'.
std::string fileSafe(const std::string& text, const std::string& fallback) {
  std::string safe;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) {
      safe += c;
    } else if (!safe.empty() && safe.back() != '-') {
      safe += '-';
    }
  }
  constexpr std::size_t kLongest = 60;
  safe.resize(std::min(safe.size(), kLongest));
  while (safe.ends_with('-')) {
    safe.pop_back();
  }
  return safe.empty() ? fallback : safe;
}

std::string timestampNow() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  const auto padded = [](int value, std::size_t width) {
    const std::string digits = std::to_string(value);
    return std::string(width - std::min(width, digits.size()), '0') + digits;
  };
  return padded(local.tm_year + 1900, 4) + padded(local.tm_mon + 1, 2) + padded(local.tm_mday, 2) + "-" + padded(local.tm_hour, 2) +
         padded(local.tm_min, 2);
}

void requireTimestamp(const std::string& text) {
  bool good = text.size() == 13;
  for (std::size_t i = 0; good && i < text.size(); ++i) {
    good = i == 8 ? text[i] == '-' : text[i] >= '0' && text[i] <= '9';
  }
  if (!good) {
    throw UsageError("The export's time \"" + text + "\" is not YYYYMMDD-HHMM.");
  }
}

const ResectionPlan& chosenPlan(const Case& source, const std::string& name) {
  if (source.plans.empty()) {
    throw PlanningError("The case has no plan: make one before exporting.");
  }
  if (name.empty()) {
    return source.plans.front();
  }
  const auto found =
      std::find_if(source.plans.begin(), source.plans.end(), [&](const ResectionPlan& plan) { return plan.name == name; });
  if (found == source.plans.end()) {
    throw UsageError("The case has no plan named \"" + name + "\": choose one of its plans with --plan.");
  }
  return *found;
}

[[noreturn]] void readBackFailed(const std::string& file, const std::string& fact) {
  throw CheckFailed("\"" + file + "\" was read back and " + fact +
                    ", so nothing was exported: simplify or reconstruct the structure and export again.");
}

FileEntry entryOf(const std::filesystem::path& folder, const std::string& file, const std::string& bytes) {
  FileEntry entry{file, sha256HexOfFile(folder / file), bytes.size()};
  if (entry.sha256 != sha256Hex(std::as_bytes(std::span(bytes)))) {
    readBackFailed(file, "is not what was written");
  }
  return entry;
}

FileEntry writeStl(const std::filesystem::path& folder, const PackageMesh& mesh, const FloatMesh& floats) {
  const std::string file = mesh.named.id + ".stl";
  const std::string bytes = stlBytes(mesh.named, floats);
  writeFileAtomically(folder / file, bytes);
  const std::string back = readWholeFile(folder / file);
  std::string problem = stlHeaderProblem(back);
  if (problem.empty()) {
    problem = differenceFrom(mesh, floats, parseStlSoup(back, file));
  }
  if (problem.empty() && mesh.closed) {
    const MeshDefects defects = readMesh(folder / file).defects();
    problem = defects.any() ? "has defects once rounded to the file's precision (" + defects.names().front() + ")" : "";
  }
  if (!problem.empty()) {
    readBackFailed(file, problem);
  }
  return entryOf(folder, file, bytes);
}

/// Of a closed part as the files hold it: rounding can turn slivers over that are sound in double precision.
void requireNoSelfIntersections(const PackageMesh& mesh, const ExecutionContext& context) {
  const std::size_t pairs = countSelfIntersections(roundedToFloat(mesh.named.mesh), context);
  if (pairs > 0) {
    throw CheckFailed(
        "\"" + mesh.named.id + "\" would cross itself once rounded to the files' precision (" + std::to_string(pairs) +
        (pairs == 1 ? " pair" : " pairs") + " of triangles), so nothing was exported: " +
        (mesh.role == "structure" ? "reconstruct it with other parameters." : "move the plane a little and export again."));
  }
}

FileEntry writeModel(const std::filesystem::path& folder, const std::vector<PackageMesh>& meshes,
                     const std::vector<FloatMesh>& floats) {
  const std::string file(kGlbFile);
  std::vector<NamedMesh> named;
  named.reserve(meshes.size());
  for (const PackageMesh& mesh : meshes) {
    named.push_back(mesh.named);
  }
  const std::string bytes = glbBytes(named, floats);
  writeFileAtomically(folder / file, bytes);
  const GlbContent content = parseGlb(readWholeFile(folder / file), file);
  std::string problem = rootMatrixProblem(content);
  if (problem.empty() && content.nodes.size() != meshes.size()) {
    problem = "does not hold every structure";
  }
  for (std::size_t i = 0; problem.empty() && i < meshes.size(); ++i) {
    problem = content.nodes[i].id != meshes[i].named.id ? "has its structures in disorder"
                                                        : differenceFrom(meshes[i], floats[i], content.nodes[i].mesh);
    if (problem.empty() && meshes[i].closed && content.nodes[i].mesh.defects().any()) {
      problem = "has defects in \"" + meshes[i].named.id + "\" once rounded to the file's precision";
    }
  }
  if (!problem.empty()) {
    readBackFailed(file, problem);
  }
  return entryOf(folder, file, bytes);
}

/// Writes and proves every file of the package; the manifest is the last.
std::vector<std::string> writeFiles(const std::filesystem::path& folder, const Case& source, const ResectionPlan& plan,
                                    const PlanAssessment& assessment, const ExportOptions& options,
                                    const std::vector<PackageMesh>& meshes, const ExecutionContext& context) {
  Manifest manifest;
  manifest.stl = options.stl;
  manifest.glb = options.glb;
  std::vector<FloatMesh> floats;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    context.report(0.8 * static_cast<double>(i) / static_cast<double>(meshes.size()), "Writing");
    floats.push_back(toFloatMesh(meshes[i].named.mesh));
    if (floats.back().triangles.empty()) {
      readBackFailed(meshes[i].named.id, "has no triangles");
    }
    if (meshes[i].closed) {
      requireNoSelfIntersections(meshes[i], context);
    }
    if (options.stl) {
      manifest.files.push_back(writeStl(folder, meshes[i], floats.back()));
    }
    manifest.meshes.push_back({meshes[i].named.id, meshes[i].role, figuresOf(meshes[i], floats.back())});
  }
  context.report(0.8, "Writing");
  if (options.glb) {
    manifest.files.push_back(writeModel(folder, meshes, floats));
  }
  context.report(0.9, "Checking");
  const std::string text = planText(source, plan, options, assessment, meshes, manifest.files);
  writeFileAtomically(folder / kPlanFile, text);
  manifest.files.push_back(entryOf(folder, std::string(kPlanFile), text));
  writeFileAtomically(folder / kManifestFile, manifestText(manifest));
  context.throwIfCancelled();

  const std::vector<std::string> problems = verifyPackage(folder);
  if (!problems.empty()) {
    throw CheckFailed("The package did not pass its own check, so nothing was exported: " + problems.front());
  }
  std::vector<std::string> files;
  for (const FileEntry& entry : manifest.files) {
    files.push_back(entry.file);
  }
  files.emplace_back(kManifestFile);
  context.throwIfCancelled();
  return files;
}

}  // namespace

ExportResult exportPackage(const Case& source, const std::filesystem::path& directory, const ExportOptions& options,
                           const ExecutionContext& context) {
  ExportOptions stamped = options;
  stamped.timestamp = options.timestamp.empty() ? timestampNow() : options.timestamp;
  requireTimestamp(stamped.timestamp);
  const ResectionPlan& plan = chosenPlan(source, options.planName);
  context.report(0.0, "Checking");
  const PlanAssessment assessment = PlanAssessor(source).assess(plan);
  const std::vector<PackageMesh> meshes = packageMeshes(source, plan, assessment.islands, stamped, context.range(0.0, 0.5));
  const std::string name =
      fileSafe(source.code, "case") + "_" + fileSafe(pseudonymous(plan.name, "Plan", source), "Plan") + "_" + stamped.timestamp;
  StagingFolder staging(directory, name);
  ExportResult result;
  result.files = writeFiles(staging.path(), source, plan, assessment, stamped, meshes, context.range(0.5, 1.0));
  result.folder = staging.publish();
  return result;
}

}  // namespace glisson
