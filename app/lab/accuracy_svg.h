#pragma once
// Purpose: the accuracy figure as SVG, with the chosen models named.

#include <string>

#include "reconstruction/evaluation/evaluation.h"

namespace glisson::lab {

/// An element to stand in an HTML page that has plotSheet(); svgFile() makes a file of it. Without measured models the axes are
/// empty.
std::string accuracySvg(const Evaluation& evaluation);

}  // namespace glisson::lab
