#pragma once

namespace glisson {

/// What VTK colours an actor with: 0 to 1.
struct Colour {
  double r, g, b;
};

}  // namespace glisson
