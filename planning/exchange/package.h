#pragma once
// Purpose: the navigation package: STL per structure, remnant, resected parts, resection surface, one GLB, plan.json, manifest.json
// with SHA-256. Written to a temporary folder, read back by other code than wrote it, compared (bounds, volume and its sign,
// distances <= 1e-4 mm), fsynced, then renamed. Nothing of the patient's identity is in it unless asked.

#include <filesystem>
#include <string>
#include <vector>

#include "planning/case/case.h"

namespace glisson {

struct ExportOptions {
  std::string planName;  ///< empty: the first plan
  bool stl = true;
  bool glb = true;
  bool patientId = false;         ///< put the patient's id into plan.json
  bool acceptDeviations = false;  ///< export although a structure deviates (method.md 3): the user was asked
  std::string timestamp;          ///< YYYYMMDD-HHMM; empty: now
};

struct ExportResult {
  std::filesystem::path folder;  ///< <code>_<plan>_<timestamp> inside the directory given
  std::vector<std::string> files;
};

/// Throws PlanningError (deviations not accepted, a part not built), CheckFailed (defects, verification failed), UsageError (no
/// such plan), InputError (cannot write), Cancelled. On any throw nothing new is left and an older package is intact.
ExportResult exportPackage(const Case& source, const std::filesystem::path& directory, const ExportOptions& options,
                           const ExecutionContext& context = {});

/// Re-checks a package: manifest, hashes, missing or extra files, STL geometry against the manifest, GLB axes and units. Returns
/// one sentence per problem; empty: sound. Throws InputError where there is no manifest.
std::vector<std::string> verifyPackage(const std::filesystem::path& folder);

}  // namespace glisson
