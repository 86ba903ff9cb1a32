#pragma once
// Purpose: how much of a box lies on one side of a plane, exactly, and how large the section is.
// Method: with t the height of the plane above the box's lowest corner and w_i the box's extent along the normal per axis, the
// fraction is G(t) = volume{u in [0,1]^3 : w . u <= t}, the distribution of a sum of three uniform variables. The two larger
// widths are taken in closed form, the smallest by a Gauss rule that is exact on each polynomial piece, so nothing is divided by a
// small width: the error stays near 1e-15 for every direction, axis-parallel ones included.

#include <array>

#include "reconstruction/image/image_geometry.h"

namespace glisson {

struct BoxCut {
  double fraction = 0;  ///< of the box's volume with distance >= 0; 0..1
  double density = 0;   ///< d fraction / d distance, 1/mm: times the box's volume it is the area of the section
};

/// `distance` mm: signed distance of the box's centre to the plane; `widths` mm: |normal_a| x extent_a of the box per axis.
/// A plane that touches the box from outside (distance = -half) has fraction 0 and the section of the touched face; one that
/// touches it from inside has fraction 1 and density 0, so a face shared by two boxes counts once.
BoxCut cutBox(double distance, const std::array<double, 3>& widths);

}  // namespace glisson
