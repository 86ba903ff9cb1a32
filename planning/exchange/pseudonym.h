#pragma once
// Purpose: free text as it may be handed on: without what names the patient (hazard H8).

#include <string>

namespace glisson {

struct Case;

/// `text`, or `fallback` where it holds a part of the patient's name, the id, the birth date, the study's date or the series'
/// description. Words such as "patient", which anonymised names are made of, are no name.
std::string pseudonymous(const std::string& text, const std::string& fallback, const Case& source);

}  // namespace glisson
