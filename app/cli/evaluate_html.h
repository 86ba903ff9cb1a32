#pragma once
// Purpose: report.html of `evaluate`: the tables and figures of Palomar et al. 2016, section 4, for one label. One file that needs
// nothing else; every text from outside is escaped.

#include <string>

#include "app/cli/evaluated_label.h"

namespace glisson::cli {

/// The evaluation has bounds. What may differ from run to run stands between the lines "<!-- times -->" and "<!-- end of times
/// -->".
std::string evaluationHtml(const EvaluatedLabel& label, const Evaluation& evaluation);

}  // namespace glisson::cli
