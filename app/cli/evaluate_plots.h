#pragma once
// Purpose: the box plots in the report of `evaluate` as an SVG element: Fig. 5 of Palomar et al. 2016.

#include <string>
#include <vector>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson::cli {

/// Fig. 5: box plots of the paper error of some models, whiskers without outliers. Where none has measures, nothing.
std::string boxPlots(const Evaluation& evaluation, const std::vector<std::size_t>& places);

}  // namespace glisson::cli
