#pragma once
// Purpose: the finished models of `evaluate` in DIR/models, a small file each, so that an interrupted run goes on where it stopped.
// A file counts for its key alone: label, geometry, parameters and program version. Files stay behind a finished run, whose
// repetition then only writes the tables again; without the folder everything is made anew.

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/evaluated_label.h"
#include "reconstruction/file_lock.h"

namespace glisson::cli {

/// To be raised where a model's numbers change and the program's version does not: of models and of outcomes made of them.
inline constexpr int kModelsVersion = 2;

class ModelStore {
 public:
  /// Touches no file. `folder` is DIR/models.
  ModelStore(std::filesystem::path folder, const EvaluatedLabel& label);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Makes the folder where it is missing, and removes what a killed run left half written; no other run can prepare it until this
  /// store is gone. Throws InputError.
  void prepare();
  /// Nothing where the model is not there, of another key or unreadable.
  [[nodiscard]] std::optional<EvaluatedModel> load(const ModelRecipe& recipe) const;
  /// Thread-safe for different models. Throws InputError.
  void save(const EvaluatedModel& model) const;

 private:
  [[nodiscard]] std::filesystem::path fileOf(const ModelRecipe& recipe) const;

  std::filesystem::path folder_;
  std::string key_;
  FileLock lock_;
};

}  // namespace glisson::cli
