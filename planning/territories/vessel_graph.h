#pragma once
// Purpose: a vessel mask as rooted trees of branches: what territories and cut vessels are computed from.
// Units and frame: mm; positions LPS, voxels in the index frame of the whole grid.
// Method: the mask's middle lines (vessel_paths.h). Each piece is rooted at the end that is widest and reaches farthest out of the
// liver; the ways from there give every voxel its parent. Rings are opened. Ends that stay inside the wall of the vessel they leave
// are pruned. A small piece whose own wide end lies within kBridgeMm of a tree is taken for its continuation.
// Everything is an estimate: it is only as complete as the label.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"

namespace glisson {

enum class VesselSystem : std::uint8_t { Portal, Hepatic };

enum class BranchRole : std::uint8_t {
  Trunk,      ///< between the root and the main bifurcation; the vena cava: owns nothing
  Outside,    ///< three quarters outside the liver, with all behind it (splenic, mesenteric veins), or a loose small piece: owns
              ///< nothing
  Supplying,  ///< owns what is nearest to it
};

/// One voxel of a centreline.
struct VesselSite {
  Index3 voxel{0, 0, 0};
  Vec3 positionMm = Vec3::Zero();
  double radiusMm = 0;       ///< from its centre to the surface of the nearest voxel outside: up to half a voxel's diagonal small
  std::int32_t parent = -1;  ///< the next site towards the root; -1 at a root
  std::int32_t branch = -1;
  bool inLiver = false;  ///< in L
};

enum class NodeKind : std::uint8_t { Root, Junction, End };
struct VesselNode {
  NodeKind kind = NodeKind::End;
  std::int32_t site = -1;
};

/// A vessel between two nodes. Its sites are consecutive, from behind the upstream node to the downstream node.
struct VesselBranch {
  std::int32_t parent = -1;  ///< branch towards the root; -1 where this one begins at a root
  std::int32_t fromNode = -1;
  std::int32_t toNode = -1;
  std::int32_t firstSite = 0;
  std::int32_t siteCount = 0;
  std::int32_t piece = 0;    ///< number of its tree
  std::vector<Vec3> lineMm;  ///< smoothed, from node to node, LPS
  double lengthMm = 0;       ///< of lineMm
  double meanRadiusMm = 0;
  double minRadiusMm = 0;
  double inLiverMm = 0;          ///< length of it and of all behind it inside L
  double downstreamMm = 0;       ///< length of it and of all behind it
  Vec3 centreMm = Vec3::Zero();  ///< middle of what it and all behind it are inside L; of everything where nothing is
  BranchRole role = BranchRole::Outside;
};

struct VesselGraph {
  VesselSystem system = VesselSystem::Portal;
  std::vector<VesselSite> sites;  ///< parents before children; with all behind a site following it (preorder)
  std::vector<VesselNode> nodes;
  std::vector<VesselBranch> branches;           ///< parents before children
  std::int32_t pieces = 0;                      ///< trees
  std::optional<std::int32_t> mainBifurcation;  ///< portal: the node where the trunk ends
  std::vector<std::string> notes;               ///< pieces joined, pieces left out

  [[nodiscard]] bool empty() const { return branches.empty(); }
  /// Is `branch` the branch `ancestor`, or behind it?
  [[nodiscard]] bool isDownstream(std::int32_t branch, std::int32_t ancestor) const;
  /// The branches that begin where `branch` ends and have at least `inLiverMm` inside L.
  [[nodiscard]] std::vector<std::int32_t> sidesOf(std::int32_t branch, double inLiverMm) const;
};

/// Share of a tree's length inside L that makes a branch, with all behind it, a side of the main bifurcation.
inline constexpr double kSubstantialSide = 0.1;
inline constexpr double kBridgeMm = 10;  ///< gaps of a label up to this are taken for one vessel

/// `vessel`: the whole label, also outside the liver; `liver`: L. With `cava`, its voxels (they belong to `vessel`) are trunk.
/// An empty mask gives an empty graph. The same for any number of threads and any direction of the grid. Throws PlanningError where
/// the mask lies outside the grid; Cancelled (polled in every step).
VesselGraph vesselGraphOf(VesselSystem system, const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                          const Mask* cava = nullptr, const ExecutionContext& context = {});

}  // namespace glisson
