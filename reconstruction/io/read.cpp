#include "reconstruction/io/read.h"

#include "reconstruction/errors.h"
#include "reconstruction/image/label_tables.h"
#include "reconstruction/io/child_process.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
namespace fs = std::filesystem;

void requireExisting(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InputError(path.string() + " does not exist; check the path.");
  }
}

template <typename T>
T importAs(ImportTask task, const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  requireExisting(path);
  if (!options.labelTable.empty() && labelTableNames(options.labelTable).empty()) {
    throw UsageError("There is no label table named " + options.labelTable +
                     "; the tables are totalsegmentator, totalsegmentator-v1 and totalsegmentator-mr.");
  }
  ImportAnswer answer = runImporter({task, path, options}, context);
  if (auto* result = std::get_if<T>(&answer)) {
    return std::move(*result);
  }
  throw InputError(path.string() + " cannot be read because glisson-import gave another answer than asked; install Glisson again.");
}
}  // namespace

CtVolume readCt(const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  return importAs<CtVolume>(ImportTask::Ct, path, options, context);
}

Segmentation readSegmentation(const fs::path& path, const ReadOptions& options, const ExecutionContext& context) {
  return importAs<Segmentation>(ImportTask::Segmentation, path, options, context);
}

InputKind guessInput(const fs::path& path, const ExecutionContext& context) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return InputKind::Unknown;
  }
  if (toLower(path.extension().string()) == ".glisson") {
    return InputKind::Case;
  }
  try {
    return importAs<InputKind>(ImportTask::Guess, path, {}, context);
  } catch (const Error&) {
    return InputKind::Unknown;
  }
}

}  // namespace glisson
