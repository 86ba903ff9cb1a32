#pragma once
// Purpose: from the paths a user gave to a case: finds out what each path is, reads, matches labels to CT, makes the case. No
// widgets; runs in a job.

#include <QStringList>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "planning/case/case.h"
#include "planning/storage/case_file.h"
#include "reconstruction/io/read.h"

namespace glisson {

/// What was read so far: kept between the questions, so that an answer does not mean reading everything again.
struct ReadSoFar {
  std::shared_ptr<const CtVolume> ct;
  std::shared_ptr<Segmentation> segmentation;
};

struct OpenRequest {
  std::vector<std::filesystem::path> paths;
  bool sample = false;  ///< the built-in patient; paths are ignored
  ReadOptions options;
  /// The user's answers for OpenedCase::unknown, in its order: names may repeat.
  std::vector<StructureKind> answeredKinds{};
  std::shared_ptr<ReadSoFar> readSoFar = std::make_shared<ReadSoFar>();
};

struct OpenedCase {
  Case content;
  std::shared_ptr<CaseFile> file;     ///< where the case came from a .glisson file
  std::string noCt{};                 ///< why the CT that the case names is not to be shown; empty where it may be
  std::filesystem::path loneCt{};     ///< a CT whose segmentation the user must choose; content is empty then
  std::vector<LabelledMask> unknown;  ///< labels whose kind the user must choose; content is empty then
  [[nodiscard]] bool needsKinds() const { return !unknown.empty(); }
};

/// What lies behind the paths, each found once. A folder that holds one CT and one
/// segmentation counts as both.
struct SortedInputs {
  std::optional<std::filesystem::path> caseFile;
  std::optional<std::filesystem::path> ct;
  std::optional<std::filesystem::path> segmentation;
};
/// Throws InputError where a path is nothing known, or two paths are the same sort of thing, Cancelled.
SortedInputs sortInputs(const std::vector<std::filesystem::path>& paths, const ExecutionContext& context = {});

/// The content of a case has its CT only where one is embedded: the one it names, or the embedded one where that is missing,
/// another one or not to be read. Throws InputError (a sentence that names the consent's flag where one is missing), Cancelled.
OpenedCase openInputs(const OpenRequest& request, const ExecutionContext& context = {});

/// The CT of a case whose file names its path; null where it has none. Throws InputError, Cancelled.
std::shared_ptr<const CtVolume> readCtOf(const Case& content, const ExecutionContext& context = {});

}  // namespace glisson
