#pragma once
// Purpose: what summary.json and report.html say an experiment was done on and with.

#include <string>

#include "app/cli/choose.h"
#include "reconstruction/evaluation/evaluation.h"

namespace glisson::cli {

struct EvaluatedLabel {
  std::string file;  ///< without its folder, so that a run elsewhere writes the same bytes
  ChosenMask chosen;
  ImageGeometry geometry;
  std::size_t points = 0;  ///< the paper error is measured from
  double voxelVolumeMl = 0;
  ExperimentOptions options;
};

}  // namespace glisson::cli
