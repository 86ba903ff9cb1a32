#pragma once
// Purpose: the sample patient's organs as analytic bodies: what the masks, the CT and the truth are made from.
// Frame: LPS mm about the middle of the body (x to the left, y to posterior, z to superior); kPatientShift moves it into the world.
// Only + - * / and sqrt are used, in a fixed order, so that every machine gets the same voxels.
// Signed distances of ellipsoids, smooth unions and differences: I. Quilez, "Distance functions" (2008..2020).

#include <array>
#include <vector>

#include "reconstruction/image/image_geometry.h"

namespace glisson::sample {

/// World (mm LPS) = local + kPatientShift.
inline const Vec3 kPatientShift{7.35, -31.6, -1184.2};

struct Ellipsoid {
  Vec3 centre;
  Vec3 radii;  ///< mm
};

/// A tapering capsule: the points whose distance to the axis is below the radius there.
struct Capsule {
  Vec3 from;
  Vec3 to;
  double fromRadius = 0;
  double toRadius = 0;
};

/// a.b with a fixed order of summation.
double dot3(const Vec3& a, const Vec3& b);
double length3(const Vec3& a);

/// Below 0 inside; close to the distance in mm near the surface.
double signedDistance(const Ellipsoid& body, const Vec3& p);
double signedDistance(const Capsule& body, const Vec3& p);

/// The liver with everything in it (tumours, vessels): two lobes, visceral hollow, fissure, hilum, beds of gallbladder and cava.
double liverDistance(const Vec3& p);
double gallbladderDistance(const Vec3& p);
/// Three tumours of about 32, 18 and 10 mm, in the liver.
const std::array<Ellipsoid, 3>& tumours();
/// The stump of the vena cava, outside the liver, a part of the hepatic veins.
const Capsule& cavaStump();

/// Hounsfield units of everything but the structures above (air, fat, muscle, spine, aorta, spleen, lung), along one line x, y.
class BackgroundColumn {
 public:
  BackgroundColumn(double x, double y);
  [[nodiscard]] double hounsfield(double z) const;

 private:
  double x_ = 0;
  double y_ = 0;
  double cavity_ = 0;  ///< share of the line inside the trunk's cavity
  double base_ = 0;    ///< what lies below the bodies that end in z
  double keep_ = 1;    ///< hounsfield = keep_ * (base and bodies) + over_
  double over_ = 0;
};

}  // namespace glisson::sample
