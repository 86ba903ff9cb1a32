#pragma once
// Purpose: how wide a vessel is, from the balls that fit into it. Frame: the image frame, p = spacing * index; radii in mm, from a
// voxel's centre to the surface of the nearest voxel outside: up to half a voxel's diagonal small.

#include <vector>

#include "planning/volumetry/row_table.h"
#include "reconstruction/execution_context.h"

namespace glisson {

/// The radius for each set voxel, i fastest. Polls cancel per axis.
std::vector<double> inscribedRadii(const Mask& mask, const Vec3& spacing, const ExecutionContext& context = {});

/// The balls of one mask, to be asked by voxel; const once built.
class InscribedBalls {
 public:
  /// Polls cancel per axis.
  InscribedBalls(const Mask& mask, const Vec3& spacing, const ExecutionContext& context = {});

  /// Of the ball around the voxel's centre; 0 outside the mask.
  [[nodiscard]] double radiusAt(const Index3& voxel) const;
  /// Of the widest ball around any voxel's centre that reaches into this voxel; 0 outside the mask.
  [[nodiscard]] double widestAround(const Index3& voxel) const { return ballAround(voxel).radius; }
  /// The vessel's diameter there, mm: of the disc that spreads across the vessel's direction as its voxels within twice the widest
  /// ball do; not below that ball's diameter, nor above it by more than a voxel's diagonal. 0 outside the mask.
  [[nodiscard]] double calibreAround(const Index3& voxel) const;

 private:
  struct Ball {
    Index3 centre{};
    double radius = 0;
  };
  [[nodiscard]] Ball ballAround(const Index3& voxel) const;
  /// visit(voxel, way to it from `voxel`, radius of its ball) for the mask's voxels within `mm` of it.
  template <typename Visit>
  void forNear(const Index3& voxel, double mm, const Visit& visit) const;

  Vec3 spacing_;
  VoxelRows voxels_;
  RowTable table_;                   ///< of the runs
  std::vector<std::size_t> begins_;  ///< by run, in radii_
  std::vector<double> radii_;
  double widest_ = 0;
};

}  // namespace glisson
