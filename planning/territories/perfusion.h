#pragma once
// Purpose: what a plan takes from the remnant's blood: parts whose portal branch is cut (devascularised) and parts drained by a cut
// hepatic vein (congested). Estimates: collaterals, arteries and veins that the labels lack are not known.
// Units: mL of L, image frame in mm. Made once per case (centrelines and nearest branches of every voxel); const and thread-safe
// afterwards, and fast enough to follow a drag.
// Rules. A branch is cut where its centreline inside L runs through the resected region, also where it only passes through; what
// lies behind the cut (portal: downstream; hepatic: upstream, away from the cava) is lost, what lies before it is not. A voxel
// belongs to the nearest centreline voxel, in mm, of all supplying branches. The vena cava itself is never cut. Islands are
// resected or not as the plan gives them.

#include <optional>

#include "planning/case/case.h"
#include "planning/territories/vessel_graph.h"

namespace glisson {

struct VesselCut {
  std::int32_t branch = -1;
  Vec3 positionMm = Vec3::Zero();  ///< LPS: where the centreline enters the resected region
  double radiusMm = 0;
};

struct PerfusionEstimate {
  std::optional<double> devascularisedMl;  ///< of the remnant; nothing where no portal branch lies in the liver
  std::optional<double> congestedMl;       ///< of the remnant; nothing where no hepatic vein lies in the liver
  double devascularisedOrCongestedMl = 0;  ///< what is both counts once
  double functionalRemnantMl = 0;          ///< remnant of F
  double perfusedFlrMl = 0;                ///< remnant of F that is neither devascularised nor congested
  double perfusedFlrPercent = 0;           ///< of F
  /// False: no vessels are known, and devascularisedOrCongestedMl and perfusedFlr are no statement about perfusion. Show "not
  /// known".
  [[nodiscard]] bool isKnown() const { return devascularisedMl.has_value() || congestedMl.has_value(); }
  std::vector<VesselCut> portalCuts;  ///< the first cut of each way from the root; by branch
  std::vector<VesselCut> hepaticCuts;
  std::uint64_t modelRevision = 0;  ///< what it came from
};

class LiverPerfusion {
 public:
  /// The portal graph is made of all structures of kind PortalVein, the hepatic one of HepaticVein and VenaCava. Throws
  /// PlanningError, Cancelled.
  explicit LiverPerfusion(const Case& source, const ExecutionContext& context = {});
  ~LiverPerfusion();
  LiverPerfusion(LiverPerfusion&&) noexcept;
  LiverPerfusion& operator=(LiverPerfusion&&) noexcept;

  [[nodiscard]] const VesselGraph& portal() const;
  [[nodiscard]] const VesselGraph& hepatic() const;
  /// The graphs' notes, and what is missing.
  [[nodiscard]] std::vector<std::string> notes() const;

  /// Throws PlanningError where a plane is not finite.
  [[nodiscard]] PerfusionEstimate effectOf(const ResectionPlan& plan) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
