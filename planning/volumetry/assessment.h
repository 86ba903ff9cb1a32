#pragma once
// Purpose: the numbers of a plan, fast enough to follow the mouse. Volumes come from voxels with exact box fractions (method.md 5).

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planning/case/case.h"

namespace glisson {

enum class TumourState : std::uint8_t { Removed, Cut, Left };
/// "removed", "cut", "left".
std::string_view textOf(TumourState state);

/// "resected", "remnant".
std::string_view textOf(PlanSide side);

/// What stands beside margins wherever they are shown (method.md 5).
inline constexpr std::string_view kMarginNotice =
    "Margins know the voxel size only; segmentation, breathing, registration and transection are not included.";

struct TumourAssessment {
  std::string id;
  std::string name;
  bool isCyst = false;  ///< told of like a tumour, but it decides nothing: it may be cut or stay
  TumourState state = TumourState::Left;
  std::optional<double> marginMm;         ///< removed: >= 0; cut: minus the greatest depth on the remnant side; left: nothing
  std::optional<double> marginAtLeastMm;  ///< marginMm - r, r = 1/2 sum |n_i| spacing_i along the margin line
  std::optional<double> distanceMm;       ///< left: distance to the cut
  /// Removed or left: the shortest way, from the tumour to the cut, mm LPS; in the view, not in the JSON.
  std::optional<std::pair<Vec3, Vec3>> way{};
};

struct VesselCrossing {
  std::string id;
  std::string name;
  Vec3 positionMm = Vec3::Zero();
  /// Of the circle with the crossing's area, corrected for obliquity where known; not below the vessel's own calibre there.
  double diameterMm = 0;
  bool runsAlong = false;  ///< along the cut rather than through it (kAlongCosine), or grazed by it
};

/// |cos| of the angle between the vessel's direction and the cut's normal below which the vessel runs along the cut: 20 degrees.
inline constexpr double kAlongCosine = 0.35;

struct ResectionVolume {
  std::string name;
  double volumeMl = 0;
  double cutAreaMm2 = 0;
  bool dividesByItself = true;  ///< takes some of L and leaves some; it has nothing then where others of the plan already take it
};

/// A separated piece that is not the main one of its side (side_pieces.h), of more than kListedIslandMl or given to the other side.
struct IslandAssessment {
  PlanSide side = PlanSide::Remnant;  ///< as the planes leave it
  bool assigned = false;              ///< given to the other side, where its volumes count
  double volumeMl = 0;
  double functionalMl = 0;
  Vec3 point = Vec3::Zero();               ///< mm LPS, a voxel's centre inside it: names it in IslandAssignment
  std::vector<std::size_t> assignments{};  ///< of the plan's islands, by place, those that give it away
};
inline constexpr double kListedIslandMl = 1.0;

struct PlanAssessment {
  /// False where the plan has resections but takes nothing or all of L: resected, remnant and FLR are then no plan's numbers.
  bool divides = true;
  double totalMl = 0;       ///< |L|
  double tumourMl = 0;      ///< |T|
  double functionalMl = 0;  ///< |F|
  double resectedMl = 0;
  double remnantMl = 0;            ///< resected + remnant = total exactly
  double volumeUncertaintyMl = 0;  ///< half the slice-direction box width x cut area
  double functionalRemnantMl = 0;
  double flrPercent = 0;                    ///< functional remnant / functional
  std::vector<ResectionVolume> resections;  ///< as the planes leave them, without islands that are given to a side
  std::vector<IslandAssessment> islands;    ///< largest first; only in assess()
  std::vector<TumourAssessment> tumours;
  std::vector<VesselCrossing> vesselsCrossed;
  /// Why resections or the whole plan do not divide the liver, e.g. "Resection 1 does not divide the liver: nothing is resected.",
  /// and islands that are none. Not empty where the plan does not divide.
  std::string warning;
  std::uint64_t modelRevision = 0;  ///< what it came from
};

/// Precomputes run-length rows of L, T, F and the vessels once per case; const and thread-safe afterwards.
class PlanAssessor {
 public:
  /// Polls cancel per structure, and within a vessel per axis.
  explicit PlanAssessor(const Case& source, const ExecutionContext& context = {});
  ~PlanAssessor();
  PlanAssessor(PlanAssessor&&) noexcept;
  PlanAssessor& operator=(PlanAssessor&&) noexcept;

  /// Only the volumes.
  [[nodiscard]] PlanAssessment volumes(const ResectionPlan& plan) const;
  /// Volumes, tumours, vessels: for every mouse move. No islands are looked for that the plan does not name.
  [[nodiscard]] PlanAssessment assessMoving(const ResectionPlan& plan) const;
  /// Everything: volumes, tumours, vessels. A plan without resection leaves everything in the remnant.
  [[nodiscard]] PlanAssessment assess(const ResectionPlan& plan) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The `plan --json` object of design.md section 4, as text.
std::string toJson(const PlanAssessment& assessment);

}  // namespace glisson
