#include "app/cli/model_store.h"

#include <system_error>

#include "planning/exchange/atomic_file.h"
#include "planning/exchange/version.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/model_json.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

std::string indexText(const Index3& index) {
  return std::to_string(index[0]) + " " + std::to_string(index[1]) + " " + std::to_string(index[2]) + "\n";
}

std::string keyOf(const EvaluatedLabel& label) {
  const Mask& mask = *label.chosen.mask;
  std::string facts = "glisson " + std::string(glissonVersion()) + " models " + std::to_string(kModelsVersion) + "\n";
  facts += label.options.sampling == Sampling::Paper ? "paper " : "unbiased ";
  facts += formatExact(label.options.scale) + " " + std::to_string(label.options.timings) + "\n";
  facts += indexText(label.geometry.size) + indexText(mask.box().first) + indexText(mask.box().size);
  const Mat3 matrix = label.geometry.indexToWorldMatrix();
  for (Eigen::Index n = 0; n < matrix.size(); ++n) {
    facts += formatExact(matrix.data()[n]) + " ";
  }
  for (const double coordinate : label.geometry.origin) {
    facts += formatExact(coordinate) + " ";
  }
  Sha256 hash;
  hash.update(std::as_bytes(std::span(facts)));
  hash.update(std::as_bytes(mask.values()));
  return hash.hex();
}

}  // namespace

ModelStore::ModelStore(std::filesystem::path folder, const EvaluatedLabel& label)
    : folder_(std::move(folder)), key_(keyOf(label)) {}

std::filesystem::path ModelStore::fileOf(const ModelRecipe& recipe) const { return folder_ / (modelId(recipe) + ".json"); }

void ModelStore::prepare() {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw InputError(folder_.string() + " cannot be made (" + error.message() + "); choose another folder");
  }
  lock_ = FileLock(folder_);
  if (lock_.isTaken()) {
    throw InputError("another evaluate is at work in " + folder_.string() + "; wait for its end or choose another folder");
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name.ends_with(".tmp")) {
      std::filesystem::remove(entry.path(), error);
    }
  }
}

std::optional<EvaluatedModel> ModelStore::load(const ModelRecipe& recipe) const {
  std::error_code error;
  if (!std::filesystem::is_regular_file(fileOf(recipe), error)) {
    return std::nullopt;
  }
  try {
    return modelOfJson(readWholeFile(fileOf(recipe)), key_, recipe);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void ModelStore::save(const EvaluatedModel& model) const { writeFileAtomically(fileOf(model.recipe), jsonOf(model, key_)); }

}  // namespace glisson::cli
