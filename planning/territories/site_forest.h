#pragma once
// Purpose: shortest-way trees over the voxels of a centreline, and the pruning of spurs. A part of centrelineTreeOf(). Lengths in
// mm. Source: E. W. Dijkstra, A note on two problems in connexion with graphs, 1959.

#include "planning/territories/centreline_links.h"

namespace glisson {

using Sites = std::vector<std::int32_t>;

/// State per site; every call works on one connected piece, so that the work is proportional to the pieces.
class SiteForest {
 public:
  /// `voxelMm`: the longest edge of a voxel.
  SiteForest(const CentrelineLinks& links, double voxelMm);

  /// The sites of each connected piece, in order of their first sites.
  [[nodiscard]] std::vector<Sites> pieces() const;

  /// Shortest ways from `sources` to what is left of `piece`; equal ways go to the lower number. Returns the farthest site.
  std::int32_t grow(const Sites& piece, const Sites& sources);
  /// Removes ends that do not leave the wall of the vessel they come from, the shortest first; the root's own end as well, whose
  /// new root is returned.
  std::int32_t prune(const Sites& piece, std::int32_t root);
  /// Sites without children; the root too where it has one child at most.
  [[nodiscard]] Sites endsOf(const Sites& piece, std::int32_t root) const;
  /// The sites from an end inwards, up to the first junction or `mm`.
  [[nodiscard]] Sites fromEnd(std::int32_t end, double mm) const;

  [[nodiscard]] double wayMm(std::int32_t site) const { return wayMm_[static_cast<std::size_t>(site)]; }
  [[nodiscard]] std::int32_t parent(std::int32_t site) const { return parent_[static_cast<std::size_t>(site)]; }
  [[nodiscard]] bool removed(std::int32_t site) const { return removed_[static_cast<std::size_t>(site)] != 0; }

 private:
  [[nodiscard]] std::int32_t junctionAbove(std::int32_t end) const;
  [[nodiscard]] double lengthBetween(std::int32_t end, std::int32_t above) const { return wayMm(end) - wayMm(above); }
  [[nodiscard]] double spurLimit(std::int32_t junction) const;
  [[nodiscard]] std::int32_t onlyChild(std::int32_t site) const;
  void pruneEnds(const Sites& piece);

  const CentrelineLinks& links_;
  double voxelMm_;
  std::vector<double> wayMm_;
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> children_;  ///< number of
  std::vector<std::uint8_t> removed_;
};

}  // namespace glisson
