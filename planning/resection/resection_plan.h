#pragma once
// Purpose: what is to be resected. A resection is the intersection of its planes' half-spaces; a plan is the union of its
// resections. Frame: mm LPS. A plane's unit normal points to the RESECTED side. A plane may be bent: its half-space is then what
// lies above the bent surface.

#include <string>
#include <vector>

#include "planning/resection/bend.h"

namespace glisson {

struct Resection {
  std::string name;                    ///< "Resection 1"
  std::vector<ResectionPlane> planes;  ///< resected = inside all of them
  bool operator==(const Resection&) const = default;
};

enum class PlanSide : std::uint8_t { Resected, Remnant };

/// A separated piece of one side that is given to the other side (method.md 5): the piece that holds `point`. Where the planes have
/// moved and no separated piece of the other side is there any more, it has no effect, and the assessment says so.
struct IslandAssignment {
  Vec3 point = Vec3::Zero();  ///< mm LPS
  PlanSide to = PlanSide::Resected;
  bool operator==(const IslandAssignment&) const = default;
};

/// A distance the user has measured; kept with the plan.
struct Measure {
  std::string name;  ///< "Distance 1"
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();

  [[nodiscard]] double mm() const { return (to - from).norm(); }
  bool operator==(const Measure&) const = default;
};

struct ResectionPlan {
  std::string name;  ///< "Plan 1"
  std::vector<Resection> resections;
  double safetyMarginMm = 10.0;
  std::vector<IslandAssignment> islands{};
  std::vector<Measure> measures{};
  bool operator==(const ResectionPlan&) const = default;
};

/// With a unit normal. Throws PlanningError where origin or normal is not finite or the normal is zero.
HalfSpace checkedPlane(const HalfSpace& plane);
/// The same; its bend as checkedBend() has it.
ResectionPlane checkedPlane(const ResectionPlane& plane);
/// Whether any plane of the plan is bent.
bool hasBends(const ResectionPlan& plan);

/// Translates along the plane's own normal (mm), or within the plane.
HalfSpace movedAlongNormal(const HalfSpace& plane, double mm);
/// The other side resected.
HalfSpace flipped(const HalfSpace& plane);
/// Turned by `radians` about a world axis through the plane's origin.
HalfSpace turned(const HalfSpace& plane, const Vec3& axis, double radians);

}  // namespace glisson
