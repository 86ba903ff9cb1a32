#include "planning/resection/bend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
using Four = std::array<double, 4>;

/// From Bernstein to power form: the sum over k of power[k] s^k.
Four powerOf(const Four& c) { return {c[0], 3 * (c[1] - c[0]), 3 * (c[0] - 2 * c[1] + c[2]), c[3] - c[0] + 3 * (c[1] - c[2])}; }

double value(const double* p, double s) { return p[0] + s * (p[1] + s * (p[2] + s * p[3])); }
double slope(const double* p, double s) { return p[1] + s * (2 * p[2] + s * 3 * p[3]); }
double curvature(const double* p, double s) { return 2 * p[2] + s * 6 * p[3]; }

void extend(Range& range, double value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

/// The net of the same cubic between the parameters `from` and `to`, by its polar form.
Four between(const Four& c, double from, double to) {
  const auto mixed = [&](std::array<double, 3> at) {
    Four left = c;
    for (std::size_t level = 0; level < 3; ++level) {
      for (std::size_t n = 0; n < 3 - level; ++n) {
        left[n] += at[level] * (left[n + 1] - left[n]);
      }
    }
    return left[0];
  };
  return {mixed({from, from, from}), mixed({from, from, to}), mixed({from, to, to}), mixed({to, to, to})};
}

constexpr double kBeyond = kBendEase / 4;  // how far the parameter goes beyond 0..1

/// The net over all parameters that are used.
std::array<double, 16> widened(const std::array<double, 16>& h) {
  std::array<double, 16> wide{};
  for (std::size_t j = 0; j < 4; ++j) {
    const Four row = between({h[4 * j], h[4 * j + 1], h[4 * j + 2], h[4 * j + 3]}, -kBeyond, 1 + kBeyond);
    std::copy(row.begin(), row.end(), wide.begin() + static_cast<std::ptrdiff_t>(4 * j));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Four column = between({wide[i], wide[4 + i], wide[8 + i], wide[12 + i]}, -kBeyond, 1 + kBeyond);
    for (std::size_t j = 0; j < 4; ++j) {
      wide[4 * j + i] = column[j];
    }
  }
  return wide;
}

/// What follows from a net of control points whose parameter is `perMm` of a millimetre; the ranges of slopes hold 0.
struct NetBounds {
  NetBounds(const std::array<double, 16>& h, double perMm)
      : heights{*std::min_element(h.begin(), h.end()), *std::max_element(h.begin(), h.end())} {
    double curved = 0;
    double twisted = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        extend(slopesU, 3 * (h[4 * a + b + 1] - h[4 * a + b]) * perMm);
        extend(slopesV, 3 * (h[4 * b + 4 + a] - h[4 * b + a]) * perMm);
        if (b < 2) {
          curved = std::max({curved, std::abs(h[4 * a + b + 2] - 2 * h[4 * a + b + 1] + h[4 * a + b]),
                             std::abs(h[4 * b + 8 + a] - 2 * h[4 * b + 4 + a] + h[4 * b + a])});
        }
        if (a < 3) {
          twisted = std::max(twisted, std::abs(h[4 * a + 4 + b + 1] - h[4 * a + 4 + b] - h[4 * a + b + 1] + h[4 * a + b]));
        }
      }
    }
    mostCurved = (6 * curved + 9 * twisted) * perMm * perMm;
  }

  Range heights;
  Range slopesU;
  Range slopesV;
  double mostCurved = 0;  ///< 1/mm
};

/// How fast the place at which the cubic is taken moves along u or v, and how that changes, 1/mm.
struct Pace {
  double rate = 1;
  double change = 0;
};

Pace paceAt(double mm, double halfSizeMm) {
  const double beyond = std::abs(mm) - halfSizeMm;
  if (!(beyond > 0)) {
    return {};
  }
  const double width = kBendEase * halfSizeMm;
  return beyond < width ? Pace{1 - beyond / width, -std::copysign(1 / width, mm)} : Pace{0, 0};
}

/// Turns `axis`, which is perpendicular to `from`, along with the smallest rotation from `from` to `to`.
Vec3 turnedAlong(const Vec3& axis, const Vec3& from, const Vec3& to) {
  if (from == to) {
    return axis;
  }
  const Vec3 turned = Eigen::Quaterniond::FromTwoVectors(from, to) * axis;
  return (turned - turned.dot(to) * to).normalized();
}
}  // namespace

BendShape::BendShape(const Bend& bend) : perMm_(0.5 / bend.halfSizeMm), halfSizeMm_(bend.halfSizeMm) {
  const std::array<double, 16>& h = bend.heightsMm;
  const NetBounds inside(h, perMm_);
  const NetBounds everywhere(widened(h), perMm_ / (1 + 2 * kBeyond));
  heights_ = inside.heights;
  slopesU_ = everywhere.slopesU;
  slopesV_ = everywhere.slopesV;
  mostCurvedInside_ = inside.mostCurved;
  mostCurved_ = everywhere.mostCurved + std::max(slopesU_.most(), slopesV_.most()) / (kBendEase * halfSizeMm_);
  std::array<Four, 4> rows{};
  for (std::size_t j = 0; j < 4; ++j) {
    rows[j] = powerOf({h[4 * j], h[4 * j + 1], h[4 * j + 2], h[4 * j + 3]});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Four column = powerOf({rows[0][k], rows[1][k], rows[2][k], rows[3][k]});
    for (std::size_t l = 0; l < 4; ++l) {
      power_[4 * l + k] = column[l];
    }
  }
}

BendShape::Local BendShape::at(double u, double v) const {
  const double s = parameter(u);
  const double t = parameter(v);
  Four in{};
  Four slopes{};
  Four curvatures{};
  for (std::size_t l = 0; l < 4; ++l) {
    in[l] = value(&power_[4 * l], s);
    slopes[l] = slope(&power_[4 * l], s);
    curvatures[l] = curvature(&power_[4 * l], s);
  }
  const Pace paceU = paceAt(u, halfSizeMm_);
  const Pace paceV = paceAt(v, halfSizeMm_);
  const double alongU = perMm_ * value(slopes.data(), t);
  const double alongV = perMm_ * slope(in.data(), t);
  Local local;
  local.height = height(u, v);
  local.du = paceU.rate * alongU;
  local.dv = paceV.rate * alongV;
  local.duu = paceU.rate * paceU.rate * perMm_ * perMm_ * value(curvatures.data(), t) + paceU.change * alongU;
  local.duv = paceU.rate * paceV.rate * perMm_ * perMm_ * slope(slopes.data(), t);
  local.dvv = paceV.rate * paceV.rate * perMm_ * perMm_ * curvature(in.data(), t) + paceV.change * alongV;
  return local;
}

BentSurface::BentSurface(const ResectionPlane& plane)
    : origin_(plane.origin), normal_(plane.normal.normalized()), shape_(plane.bend ? *plane.bend : Bend()) {
  if (!plane.bend) {
    throw PlanningError("The plane has no bend; bend it first.");
  }
  u_ = plane.bend->u;
  v_ = normal_.cross(u_);
}

BentSurface BentSurface::inFrame(const ImageGeometry& geometry) const {
  const Mat3 back = geometry.direction.transpose();
  BentSurface moved = *this;
  moved.origin_ = back * (origin_ - geometry.origin);
  moved.normal_ = back * normal_;
  moved.u_ = back * u_;
  moved.v_ = back * v_;
  return moved;
}

HalfSpace BentSurface::tangentAt(const Vec3& p) const {
  const BendShape::Local local = localAt(p);
  const Vec3 from = p - origin_;
  return {p - (normal_.dot(from) - local.height) * normal_, (normal_ - local.du * u_ - local.dv * v_).normalized()};
}

double BentSurface::reach(const Vec3& half) const {
  return normal_.cwiseAbs().dot(half) + shape_.slopesU().most() * u_.cwiseAbs().dot(half) +
         shape_.slopesV().most() * v_.cwiseAbs().dot(half);
}

double heightAbove(const ResectionPlane& plane, const Vec3& p) {
  return plane.bend ? BentSurface(plane).above(p) : plane.normal.dot(p - plane.origin);
}

Bend flatBend(const HalfSpace& plane, double halfSizeMm) {
  Eigen::Index axis = 0;
  plane.normal.cwiseAbs().minCoeff(&axis);
  Bend bend;
  bend.u = Vec3::Unit(axis);
  bend.halfSizeMm = halfSizeMm;
  return checkedBend(plane, bend);
}

Bend checkedBend(const HalfSpace& plane, const Bend& bend) {
  const Vec3 normal = plane.normal.normalized();
  const Vec3 u = bend.u - bend.u.dot(normal) * normal;
  constexpr double kLeastU = 1e-3;
  const bool finite = bend.u.allFinite() && normal.allFinite() && u.norm() > kLeastU;
  const bool size = bend.halfSizeMm >= kLeastBendHalfSizeMm && bend.halfSizeMm <= kMostBendMm;
  const bool heights =
      std::all_of(bend.heightsMm.begin(), bend.heightsMm.end(), [](double h) { return h >= -kMostBendMm && h <= kMostBendMm; });
  if (!finite || !size || !heights) {
    throw PlanningError(
        "A bend needs an axis within the plane, a half size of 10 to 1000 mm and 16 heights of at most 1000 mm; bend the plane "
        "again.");
  }
  Bend checked = bend;
  // What is right already keeps its bits.
  constexpr double kRight = 1e-12;
  if (std::abs(bend.u.dot(normal)) > kRight || std::abs(bend.u.norm() - 1) > kRight) {
    checked.u = u.normalized();
  }
  return checked;
}

Vec3 controlPoint(const ResectionPlane& plane, std::size_t index) {
  const Bend& bend = plane.bend.value();
  const auto place = [&](std::size_t n) { return bend.halfSizeMm * (2.0 * static_cast<double>(n) / 3 - 1); };
  return plane.origin + place(index % 4) * bend.u + place(index / 4) * plane.normal.cross(bend.u) +
         bend.heightsMm[index] * plane.normal;
}

ResectionPlane flipped(const ResectionPlane& plane) {
  ResectionPlane other(HalfSpace{plane.origin, -plane.normal}, plane.bend);
  if (plane.bend) {
    // v = normal x u turns over with the normal.
    for (std::size_t n = 0; n < 16; ++n) {
      other.bend->heightsMm[n] = -plane.bend->heightsMm[4 * (3 - n / 4) + n % 4];
    }
  }
  return other;
}

bool isOpposite(const Vec3& normal, const Vec3& other) {
  constexpr double kOpposite = -0.999;
  return normal.dot(other) < kOpposite;
}

ResectionPlane movedTo(const ResectionPlane& from, const HalfSpace& to) {
  if (!from.bend) {
    return to;
  }
  const ResectionPlane start = isOpposite(from.normal, to.normal) ? flipped(from) : from;
  ResectionPlane moved(to, start.bend);
  moved.bend->u = turnedAlong(start.bend->u, start.normal, to.normal);
  return moved;
}

ResectionPlane spun(const ResectionPlane& plane, const Vec3& pivot, double radians) {
  if (!plane.bend) {
    return plane;
  }
  const Eigen::AngleAxisd turn(radians, plane.normal);
  ResectionPlane turned = plane;
  turned.origin = pivot + turn * (plane.origin - pivot);
  turned.bend->u = turn * plane.bend->u;
  return turned;
}

std::array<bool, 16> groupOf(std::size_t index) {
  const auto borders = [](std::size_t n) { return (n % 4 % 3 == 0 ? 1 : 0) + (n / 4 % 3 == 0 ? 1 : 0); };
  std::array<bool, 16> members{};
  for (std::size_t n = 0; n < members.size(); ++n) {
    members[n] = borders(n) == borders(index);
  }
  return members;
}

}  // namespace glisson
