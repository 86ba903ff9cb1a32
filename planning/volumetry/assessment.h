#pragma once
// Purpose: the numbers of a plan, fast enough to follow the mouse. Volumes come from voxels with exact box fractions (method.md 5).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planning/case/case.h"

namespace glisson {

enum class TumourState : std::uint8_t { Removed, Cut, Left };
/// "removed", "cut", "left".
std::string_view textOf(TumourState state);

struct TumourAssessment {
  std::string id;
  std::string name;
  TumourState state = TumourState::Left;
  std::optional<double> marginMm;         ///< removed: >= 0; cut: minus the greatest depth on the remnant side; left: nothing
  std::optional<double> marginAtLeastMm;  ///< marginMm - r, r = 1/2 sum |n_i| spacing_i along the margin line
  std::optional<double> distanceMm;       ///< left: distance to the cut
};

struct VesselCrossing {
  std::string id;
  std::string name;
  Vec3 positionMm = Vec3::Zero();
  double diameterMm = 0;  ///< equivalent: of the circle with the crossing's area, corrected for obliquity where known
};

struct ResectionVolume {
  std::string name;
  double volumeMl = 0;
  double cutAreaMm2 = 0;
};

struct PlanAssessment {
  double totalMl = 0;       ///< |L|
  double tumourMl = 0;      ///< |T|
  double functionalMl = 0;  ///< |F|
  double resectedMl = 0;
  double remnantMl = 0;            ///< resected + remnant = total exactly
  double volumeUncertaintyMl = 0;  ///< half the slice-direction box width x cut area
  double functionalRemnantMl = 0;
  double flrPercent = 0;  ///< functional remnant / functional
  std::vector<ResectionVolume> resections;
  std::vector<TumourAssessment> tumours;
  std::vector<VesselCrossing> vesselsCrossed;
  std::string warning;              ///< e.g. "the plane does not divide the liver": volumes then stand as all or nothing
  std::uint64_t modelRevision = 0;  ///< what it came from
};

/// Precomputes run-length rows of L, T, F and the vessels once per case; const and thread-safe afterwards.
class PlanAssessor {
 public:
  explicit PlanAssessor(const Case& source);
  ~PlanAssessor();
  PlanAssessor(PlanAssessor&&) noexcept;
  PlanAssessor& operator=(PlanAssessor&&) noexcept;

  /// Only the volumes: for every mouse move.
  [[nodiscard]] PlanAssessment volumes(const ResectionPlan& plan) const;
  /// Everything: volumes, tumours, vessels. A plan without resection leaves everything in the remnant.
  [[nodiscard]] PlanAssessment assess(const ResectionPlan& plan) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The `plan --json` object of design.md section 4, as text.
std::string toJson(const PlanAssessment& assessment);

}  // namespace glisson
