#pragma once
// Purpose: numbers as text and back, whatever the locale's decimal sign is. Every file format goes through here.

#include <optional>
#include <string>
#include <string_view>

namespace glisson {

/// Fixed notation with `decimals` digits after the point; always '.', never a group sign.
std::string formatNumber(double value, int decimals);
/// Shortest text that reads back to the same double.
std::string formatExact(double value);
/// The whole text as a number; nothing on any rest, an empty text, or a non-finite value. Leading and trailing blanks are allowed.
std::optional<double> parseNumber(std::string_view text);
std::optional<long long> parseInteger(std::string_view text);

/// ASCII lower case, other bytes unchanged.
std::string toLower(std::string_view text);

}  // namespace glisson
