#include "planning/exchange/version.h"

namespace glisson {

std::string_view glissonVersion() { return GLISSON_VERSION; }

}  // namespace glisson
