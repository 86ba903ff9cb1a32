#pragma once
// Purpose: one evaluated model as a JSON text and back: what an experiment keeps of a finished model, so that an interrupted run
// goes on where it stopped.

#include <string>
#include <string_view>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

/// Numbers come back as the same doubles. `key` says what the model was made of; see modelOfJson().
std::string jsonOf(const EvaluatedModel& model, std::string_view key);
/// The model, its recipe apart, which is `recipe`; nothing where the text is no such model, or is that of another key.
std::optional<EvaluatedModel> modelOfJson(std::string_view text, std::string_view key, const ModelRecipe& recipe);

}  // namespace glisson
