#include "reconstruction/sample/anatomy.h"

#include <algorithm>
#include <cmath>

namespace glisson::sample {

namespace {

// Lobes and what is taken from them; shapes were tuned to a liver of about 1.5 L.
const Ellipsoid kRightLobe{{-62, -2, 4}, {62, 69, 71}};
const Ellipsoid kLeftLobe{{14, -42, 26}, {78, 37, 34}};
const Ellipsoid kVisceralHollow{{30, 24, -84}, {85, 76, 79}};
const Ellipsoid kFissure{{22, -62, -6}, {4.5, 26, 34}};
const Ellipsoid kHilum{{-10, 14, -16}, {24, 13, 10}};
const Capsule kGallbladder{{-31, 0, -46}, {-41, -38, -61}, 6.5, 14.5};
const Capsule kCava{{-9, 47, -12}, {-5, 38, 72}, 10.5, 11.5};
// Neighbours in the CT. The bowel and the stomach are one soft mass; lung lies above the diaphragm's dome.
const Ellipsoid kBowel{{48, -26, -58}, {66, 50, 70}};
const Ellipsoid kDiaphragm{{-14, -6, -46}, {140, 112, 136}};
const Ellipsoid kHeart{{22, -30, 112}, {48, 38, 34}};
const Ellipsoid kSpleen{{92, 36, 24}, {24, 38, 44}};
constexpr double kBedGapMm = 1.5;

double smoothUnion(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k * 0.25;
}

double smoothDifference(double a, double taken, double k) { return -smoothUnion(-a, taken, k); }

/// 1 inside, 0 outside, over a ramp of about one voxel.
double cover(double distance) { return std::clamp(0.5 - 0.6 * distance, 0.0, 1.0); }

/// The same for a body at least 20 mm thick, without a root where p is far from its surface.
double coverOfBody(const Ellipsoid& body, const Vec3& p) {
  const double x = (p[0] - body.centre[0]) / body.radii[0];
  const double y = (p[1] - body.centre[1]) / body.radii[1];
  const double z = (p[2] - body.centre[2]) / body.radii[2];
  const double squared = (x * x + y * y) + z * z;
  if (squared > 1.2) {
    return 0;
  }
  return squared < 0.8 ? 1 : cover(signedDistance(body, p));
}

/// An ellipse that runs through the whole length of the body.
struct Disc {
  double x = 0;
  double y = 0;
  double rx = 0;
  double ry = 0;
};

double coverOfDisc(double x, double y, const Disc& disc) {
  return cover(signedDistance(Ellipsoid{{disc.x, disc.y, 0}, {disc.rx, disc.ry, 1e4}}, Vec3(x, y, 0)));
}

double blend(double below, double above, double share) { return below + (above - below) * share; }

}  // namespace

double dot3(const Vec3& a, const Vec3& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

double length3(const Vec3& a) { return std::sqrt(dot3(a, a)); }

double signedDistance(const Ellipsoid& body, const Vec3& p) {
  const double x = (p[0] - body.centre[0]) / body.radii[0];
  const double y = (p[1] - body.centre[1]) / body.radii[1];
  const double z = (p[2] - body.centre[2]) / body.radii[2];
  const double scaled = std::sqrt((x * x + y * y) + z * z);
  const double gx = x / body.radii[0];
  const double gy = y / body.radii[1];
  const double gz = z / body.radii[2];
  const double gradient = std::sqrt((gx * gx + gy * gy) + gz * gz);
  if (gradient < 1e-12) {
    return -std::min({body.radii[0], body.radii[1], body.radii[2]});
  }
  return scaled * (scaled - 1) / gradient;
}

double signedDistance(const Capsule& body, const Vec3& p) {
  const double ax = body.to[0] - body.from[0];
  const double ay = body.to[1] - body.from[1];
  const double az = body.to[2] - body.from[2];
  const double px = p[0] - body.from[0];
  const double py = p[1] - body.from[1];
  const double pz = p[2] - body.from[2];
  const double along = std::clamp(((px * ax + py * ay) + pz * az) / ((ax * ax + ay * ay) + az * az), 0.0, 1.0);
  const double dx = px - along * ax;
  const double dy = py - along * ay;
  const double dz = pz - along * az;
  return std::sqrt((dx * dx + dy * dy) + dz * dz) - (body.fromRadius + along * (body.toRadius - body.fromRadius));
}

double liverDistance(const Vec3& p) {
  double d = smoothUnion(signedDistance(kRightLobe, p), signedDistance(kLeftLobe, p), 26);
  if (d > 12) {
    return d;  // what follows only takes away
  }
  d = smoothDifference(d, signedDistance(kVisceralHollow, p), 12);
  d = smoothDifference(d, signedDistance(kFissure, p), 4);
  d = smoothDifference(d, signedDistance(kHilum, p), 8);
  d = smoothDifference(d, signedDistance(kCava, p) - kBedGapMm, 3);
  return smoothDifference(d, signedDistance(kGallbladder, p) - kBedGapMm, 3);
}

double gallbladderDistance(const Vec3& p) { return signedDistance(kGallbladder, p); }

const std::array<Ellipsoid, 3>& tumours() {
  static const std::array<Ellipsoid, 3> kTumours{Ellipsoid{{-88, 8, 22}, {16.5, 15.5, 16}},
                                                 Ellipsoid{{-34, -40, 12}, {9, 8.5, 9.5}},
                                                 Ellipsoid{{48.2, -43.6, 33.25}, {5, 5, 5}}};
  return kTumours;
}

const Capsule& cavaStump() { return kCava; }

BackgroundColumn::BackgroundColumn(double x, double y) : x_(x), y_(y) {
  base_ = blend(-1000, -100, coverOfDisc(x, y, {0, 0, 144, 106}));  // fat under the skin
  base_ = blend(base_, 55, coverOfDisc(x, y, {0, 0, 136, 98}));     // wall of muscle
  cavity_ = coverOfDisc(x, y, {0, -4, 129, 90});
  base_ = blend(base_, -85, cavity_);  // fat between the organs
  const auto put = [&](double hu, const Disc& disc) {
    const double share = coverOfDisc(x, y, disc);
    keep_ *= 1 - share;
    over_ = blend(over_, hu, share);
  };
  put(30, {-6, 62, 42, 18});   // muscles beside the spine
  put(165, {15, 50, 10, 10});  // aorta
  put(220, {2, 74, 21, 17});   // vertebrae
  put(25, {2, 94, 9, 7});      // spinal canal
}

double BackgroundColumn::hounsfield(double z) const {
  const Vec3 p(x_, y_, z);
  double hu = base_;
  if (cavity_ > 0) {
    hu = blend(hu, 40, coverOfBody(kBowel, p));
    if (z > 0) {
      hu = blend(hu, -850, std::min(cavity_, 1 - coverOfBody(kDiaphragm, p)));
    }
    hu = blend(hu, 120, coverOfBody(kHeart, p));
    hu = blend(hu, 115, coverOfBody(kSpleen, p));
  }
  return keep_ * hu + over_;
}

}  // namespace glisson::sample
