#pragma once
// Purpose: the numbers of well-known label maps, as published: TotalSegmentator's `total` task v2 (117 classes), v1 (104 classes)
// and `total_mr` (50 classes). Used only when the user names the table: bare numbers are never guessed.

#include <map>
#include <string>
#include <string_view>

namespace glisson {

/// Class names by label value for "totalsegmentator", "totalsegmentator-v1" or "totalsegmentator-mr"; empty for any other name.
std::map<int, std::string> labelTableNames(std::string_view table);

}  // namespace glisson
