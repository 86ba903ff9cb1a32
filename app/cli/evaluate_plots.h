#pragma once
// Purpose: the pictures in the report of `evaluate`, as SVG elements: Figures 5 and 7 of Palomar et al. 2016.

#include <string>
#include <vector>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson::cli {

/// Fig. 7: mean paper error over the number of triangles (logarithmic) of all models, with both Pareto fronts as stairs and the
/// chosen models named. The evaluation has bounds.
std::string accuracyPlot(const Evaluation& evaluation);

/// Fig. 5: box plots of the paper error of some models, whiskers without outliers. Where none has measures, nothing.
std::string boxPlots(const Evaluation& evaluation, const std::vector<std::size_t>& places);

}  // namespace glisson::cli
