#include "planning/territories/vessel_graph.h"

#include <algorithm>
#include <limits>

#include "planning/territories/branch_roles.h"
#include "planning/territories/centreline_tree.h"
#include "planning/territories/place.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr int kSmoothings = 8;

/// Orders the sites of a forest in preorder and cuts them into branches.
class GraphMaker {
 public:
  GraphMaker(const CentrelineTree& tree, VesselGraph& graph) : tree_(tree), graph_(graph), children_(tree.sites.size()) {}

  void run() {
    std::vector<std::int32_t> roots;
    for (std::size_t s = 0; s < tree_.sites.size(); ++s) {
      const std::int32_t parent = tree_.sites[s].parent;
      (parent < 0 ? roots : children_[at(parent)]).push_back(static_cast<std::int32_t>(s));
    }
    for (auto& children : children_) {
      std::sort(children.begin(), children.end(), [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
    }
    std::stable_sort(roots.begin(), roots.end(),
                     [&](std::int32_t a, std::int32_t b) { return tree_.piece[at(a)] < tree_.piece[at(b)]; });
    for (const std::int32_t root : roots) {
      ++graph_.pieces;
      // The last put in is the first taken out: the branches behind a branch follow it at once.
      std::vector<Start> waiting{{root, -1, -1}};
      while (!waiting.empty()) {
        const Start start = waiting.back();
        waiting.pop_back();
        follow(start, waiting);
      }
    }
    for (VesselBranch& branch : graph_.branches) {
      measure(branch);
    }
  }

 private:
  struct Start {
    std::int32_t site;    ///< in the tree
    std::int32_t parent;  ///< site in the graph
    std::int32_t branch;  ///< that the parent ends
  };

  [[nodiscard]] std::array<int, 3> key(std::int32_t s) const {
    const Index3& v = tree_.sites[at(s)].voxel;
    return {v[2], v[1], v[0]};
  }

  void follow(const Start& start, std::vector<Start>& waiting) {
    const auto number = static_cast<std::int32_t>(graph_.branches.size());
    VesselBranch branch;
    branch.parent = start.branch;
    branch.piece = tree_.piece[at(start.site)];
    branch.firstSite = static_cast<std::int32_t>(graph_.sites.size());
    if (start.branch < 0) {
      branch.fromNode = addNode(NodeKind::Root, branch.firstSite);
    } else {
      branch.fromNode = graph_.branches[at(start.branch)].toNode;
    }
    std::int32_t here = start.site;
    std::int32_t parent = start.parent;
    while (true) {
      graph_.sites.push_back(tree_.sites[at(here)]);
      graph_.sites.back().parent = parent;
      graph_.sites.back().branch = number;
      parent = static_cast<std::int32_t>(graph_.sites.size()) - 1;
      ++branch.siteCount;
      if (children_[at(here)].size() != 1) {
        break;
      }
      here = children_[at(here)].front();
    }
    branch.toNode = addNode(children_[at(here)].empty() ? NodeKind::End : NodeKind::Junction, parent);
    for (auto child = children_[at(here)].rbegin(); child != children_[at(here)].rend(); ++child) {
      waiting.push_back({*child, parent, number});
    }
    graph_.branches.push_back(std::move(branch));
  }

  std::int32_t addNode(NodeKind kind, std::int32_t site) {
    graph_.nodes.push_back({kind, site});
    return static_cast<std::int32_t>(graph_.nodes.size()) - 1;
  }

  void measure(VesselBranch& branch) const {
    branch.minRadiusMm = std::numeric_limits<double>::infinity();
    if (branch.parent >= 0) {
      branch.lineMm.push_back(graph_.sites[at(graph_.nodes[at(branch.fromNode)].site)].positionMm);
    }
    for (std::int32_t s = branch.firstSite; s < branch.firstSite + branch.siteCount; ++s) {
      const VesselSite& site = graph_.sites[at(s)];
      branch.lineMm.push_back(site.positionMm);
      branch.meanRadiusMm += site.radiusMm / branch.siteCount;
      branch.minRadiusMm = std::min(branch.minRadiusMm, site.radiusMm);
    }
    // Steps from voxel to voxel are up to a tenth too long; the nodes stay where they are.
    std::vector<Vec3>& line = branch.lineMm;
    for (int n = 0; n < kSmoothings && line.size() > 2; ++n) {
      const std::vector<Vec3> before = line;
      for (std::size_t p = 1; p + 1 < line.size(); ++p) {
        line[p] = 0.25 * before[p - 1] + 0.5 * before[p] + 0.25 * before[p + 1];
      }
    }
    for (std::size_t p = 1; p < line.size(); ++p) {
      branch.lengthMm += (line[p] - line[p - 1]).norm();
    }
  }

  const CentrelineTree& tree_;
  VesselGraph& graph_;
  std::vector<std::vector<std::int32_t>> children_;
};
}  // namespace

bool VesselGraph::isDownstream(std::int32_t branch, std::int32_t ancestor) const {
  while (branch > ancestor) {
    branch = branches[at(branch)].parent;
  }
  return branch == ancestor;
}

std::vector<std::int32_t> VesselGraph::sidesOf(std::int32_t branch, double inLiverMm) const {
  std::vector<std::int32_t> sides;
  for (std::size_t b = at(branch) + 1; b < branches.size(); ++b) {
    if (branches[b].parent == branch && branches[b].inLiverMm >= inLiverMm) {
      sides.push_back(static_cast<std::int32_t>(b));
    }
  }
  return sides;
}

VesselGraph vesselGraphOf(VesselSystem system, const Mask& vessel, const ImageGeometry& geometry, const Mask& liver,
                          const Mask* cava, const ExecutionContext& context) {
  VesselGraph graph;
  graph.system = system;
  const std::string name = system == VesselSystem::Portal ? "Portal vein" : "Hepatic veins";
  const IndexBox& box = vessel.box();
  for (std::size_t a = 0; a < 3 && !vessel.empty(); ++a) {
    if (box.first[a] < 0 || box.first[a] + box.size[a] > geometry.size[a]) {
      throw PlanningError(name + ": the mask does not lie on the grid of the liver; read the segmentation again.");
    }
  }
  CentrelineTree tree = centrelineTreeOf(name, vessel, geometry, liver, context);
  GraphMaker(tree, graph).run();
  assignRoles(graph, tree.isLoose, cava);
  graph.notes = std::move(tree.notes);
  return graph;
}

}  // namespace glisson
