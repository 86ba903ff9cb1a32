#pragma once
// Purpose: the two colours of what is compared: told apart without colour vision, too, and always beside their letters.

#include <QColor>
#include <array>

namespace glisson {

inline const std::array<QColor, 2> kLabColours{QColor(255, 170, 51), QColor(86, 180, 255)};

}  // namespace glisson
