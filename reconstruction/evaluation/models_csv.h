#pragma once
// Purpose: models.csv, one row for each model of an experiment. Column names are a contract (README, "The command line"): units in
// the names, '.' as the decimal sign, numbers exact, a cell left empty where there is no such number. What may differ from run to
// run, times and memory, stands in the last columns.

#include <string>
#include <vector>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson {

std::string modelsCsv(const Evaluation& evaluation, double voxelVolumeMl);
/// Of modelsCsv(), in order.
std::vector<std::string> modelsCsvColumns();
/// The first of the columns that may differ from run to run.
inline constexpr const char* kFirstTimedColumn = "seconds";

}  // namespace glisson
