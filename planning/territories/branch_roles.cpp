#include "planning/territories/branch_roles.h"

#include <algorithm>

#include "planning/territories/place.h"

namespace glisson {

namespace {
constexpr double kOwnTree = 0.2;        ///< share of the greatest tree that makes another tree its equal
constexpr double kEnoughInside = 0.25;  ///< share of the length in the liver: splenic and mesenteric branches have none
constexpr std::int32_t kFewInside = 4;  ///< less than one of this many voxels of the cava's centreline lie in the liver
constexpr double kCavaWidth = 0.6;      ///< of the radius before: the cava goes on there

class Roles {
 public:
  Roles(VesselGraph& graph, const std::vector<std::uint8_t>& isLoose) : graph_(graph), isLoose_(isLoose) {}

  void run(const Mask* cava) {
    measure();
    if (graph_.system == VesselSystem::Portal) {
      const std::int32_t last = markTrunk();
      graph_.mainBifurcation = last < 0 ? std::nullopt : std::optional(graph_.branches[at(last)].toNode);
    } else if (cava != nullptr && !cava->empty()) {
      markLabelledCava(*cava);
    } else {
      markWideCava();
    }
    for (VesselBranch& branch : graph_.branches) {
      const bool inside = branch.inLiverMm > 0 && branch.inLiverMm >= kEnoughInside * branch.downstreamMm;
      if (branch.role != BranchRole::Trunk) {
        branch.role = inside && isLoose_[at(branch.piece)] == 0 ? BranchRole::Supplying : BranchRole::Outside;
      }
    }
  }

 private:
  /// Lengths from voxel to voxel, without what runs inside the vessel a branch leaves.
  void measure() {
    std::vector<Vec3> moments(graph_.branches.size(), Vec3::Zero());
    std::vector<Vec3> allMoments(graph_.branches.size(), Vec3::Zero());
    std::vector<double> all(graph_.branches.size(), 0);
    for (std::size_t b = graph_.branches.size(); b-- > 0;) {
      VesselBranch& branch = graph_.branches[b];
      const VesselSite& from = graph_.sites[at(graph_.nodes[at(branch.fromNode)].site)];
      for (std::int32_t s = branch.firstSite; s < branch.firstSite + branch.siteCount; ++s) {
        const VesselSite& site = graph_.sites[at(s)];
        const double mm = site.parent < 0 ? 0.0 : (site.positionMm - graph_.sites[at(site.parent)].positionMm).norm();
        all[b] += 1;
        allMoments[b] += site.positionMm;
        if (branch.parent >= 0 && (site.positionMm - from.positionMm).norm() < from.radiusMm) {
          continue;
        }
        branch.downstreamMm += mm;
        branch.inLiverMm += site.inLiver ? mm : 0.0;
        moments[b] += site.inLiver ? Vec3(mm * site.positionMm) : Vec3(Vec3::Zero());
      }
      branch.centreMm = branch.inLiverMm > 0 ? Vec3(moments[b] / branch.inLiverMm) : Vec3(allMoments[b] / all[b]);
      if (branch.parent >= 0) {
        const std::size_t up = at(branch.parent);
        graph_.branches[up].downstreamMm += branch.downstreamMm;
        graph_.branches[up].inLiverMm += branch.inLiverMm;
        moments[up] += moments[b];
        allMoments[up] += allMoments[b];
        all[up] += all[b];
      }
    }
  }

  [[nodiscard]] std::vector<std::int32_t> roots() const {
    std::vector<std::int32_t> found;
    for (std::size_t b = 0; b < graph_.branches.size(); ++b) {
      if (graph_.branches[b].parent < 0) {
        found.push_back(static_cast<std::int32_t>(b));
      }
    }
    return found;
  }

  /// From the root of the greatest tree down to the first node with two sides that matter: marks the way as trunk and returns the
  /// branch that ends there; -1 where there is no such node, or another tree is as large.
  std::int32_t markTrunk() {
    std::int32_t here = -1;
    const std::vector<std::int32_t> starts = roots();
    std::vector<double> trees;
    trees.reserve(starts.size());
    for (const std::int32_t root : starts) {
      trees.push_back(graph_.branches[at(root)].inLiverMm);
      here = graph_.branches[at(root)].piece == 0 ? root : here;
    }
    std::sort(trees.begin(), trees.end(), std::greater<>());
    if (here < 0 || !(trees[0] > 0) || (trees.size() > 1 && trees[1] > kOwnTree * trees[0])) {
      return -1;
    }
    std::vector<std::int32_t> trunk;
    while (here >= 0) {
      trunk.push_back(here);
      const std::vector<std::int32_t> sides = graph_.sidesOf(here, kSubstantialSide * trees[0]);
      if (sides.size() >= 2) {
        for (const std::int32_t branch : trunk) {
          graph_.branches[at(branch)].role = BranchRole::Trunk;
        }
        return here;
      }
      here = sides.empty() ? -1 : sides.front();
    }
    return -1;
  }

  void markLabelledCava(const Mask& cava) {
    for (VesselBranch& branch : graph_.branches) {
      std::int32_t inside = 0;
      for (std::int32_t s = branch.firstSite; s < branch.firstSite + branch.siteCount; ++s) {
        const Index3& v = graph_.sites[at(s)].voxel;
        inside += cava.at(v[0], v[1], v[2]) ? 1 : 0;
      }
      branch.role = 2 * inside > branch.siteCount ? BranchRole::Trunk : branch.role;
    }
  }

  [[nodiscard]] double medianRadius(const VesselBranch& branch) const {
    std::vector<double> radii;
    radii.reserve(at(branch.siteCount));
    for (std::int32_t s = branch.firstSite; s < branch.firstSite + branch.siteCount; ++s) {
      radii.push_back(graph_.sites[at(s)].radiusMm);
    }
    std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
    return radii[radii.size() / 2];
  }

  /// The cava: the trunk up to the first mouths, and the wide way outside the liver from there to the next ones.
  void markWideCava() {
    for (std::int32_t here = markTrunk(); here >= 0;) {
      graph_.branches[at(here)].role = BranchRole::Trunk;
      double widest = kCavaWidth * medianRadius(graph_.branches[at(here)]);
      std::int32_t next = -1;
      for (const std::int32_t child : graph_.sidesOf(here, 0)) {
        const VesselBranch& branch = graph_.branches[at(child)];
        if (kFewInside * sitesInLiver(branch) < branch.siteCount && medianRadius(branch) >= widest) {
          widest = medianRadius(branch);
          next = child;
        }
      }
      here = next;
    }
  }

  [[nodiscard]] std::int32_t sitesInLiver(const VesselBranch& branch) const {
    std::int32_t count = 0;
    for (std::int32_t s = branch.firstSite; s < branch.firstSite + branch.siteCount; ++s) {
      count += graph_.sites[at(s)].inLiver ? 1 : 0;
    }
    return count;
  }

  VesselGraph& graph_;
  const std::vector<std::uint8_t>& isLoose_;
};
}  // namespace

void assignRoles(VesselGraph& graph, const std::vector<std::uint8_t>& isLoose, const Mask* cava) {
  Roles(graph, isLoose).run(cava);
}

}  // namespace glisson
