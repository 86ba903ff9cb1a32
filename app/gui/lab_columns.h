#pragma once
// Purpose: what is shown of a model of the lab, for its table and for the numbers under the views: names, units, decimals and where
// each number comes from.

#include <QString>
#include <optional>
#include <span>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

struct LabRow {
  const EvaluatedModel* model = nullptr;
  const ModelScore* score = nullptr;  ///< null: it has none, or no final one
  double voxelVolumeMl = 0;
};

struct LabColumn {
  const char* name;  ///< English; show it through labText()
  const char* part;  ///< of an error, which stands in several columns of one name; else empty
  const char* unit;
  int decimals;
  std::optional<double> (*value)(const LabRow& row);
};
std::span<const LabColumn> labColumns();

/// `text` of a column in the window's language.
QString labText(const char* text);
/// The whole of it, "Paper error, mean (mm)", in the window's language.
QString labColumnName(const LabColumn& column);
/// A dash where there is no such number.
QString labValueText(const LabColumn& column, const LabRow& row);
/// "none", or all of them; why the model failed.
QString labDefectsText(const EvaluatedModel& model);
/// "PSR", "MCSD", "simplified PSR" in the window's language.
QString labFamilyName(ModelFamily family);

}  // namespace glisson
