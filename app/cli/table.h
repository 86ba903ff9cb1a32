#pragma once
// Purpose: a text table with aligned columns.

#include <string>
#include <vector>

namespace glisson::cli {

/// Rows of equal length, the first one the heading; the first two columns are left-aligned, the others right-aligned. UTF-8 counts
/// by character.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace glisson::cli
