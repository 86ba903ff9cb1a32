#pragma once
// Purpose: how much of a set of voxels a plan takes, and the surface it is cut along.
// Volumes are counted in units of 2^-32 voxel, in integers, so that resected + remnant = total exactly, whatever the planes are.
// One plane: closed form per run of voxels. Several planes: runs that only one plane cuts are taken as one box, the others are
// halved down to single voxels, whose parts are convex bodies. Where resections overlap, the first one has the voxel's part.
// Bent planes: flat_stretches.h.

#include <cstdint>
#include <vector>

#include "planning/volumetry/convex.h"
#include "planning/volumetry/row_blocks.h"

namespace glisson {

inline constexpr double kUnitsPerVoxel = 4294967296.0;

struct ImageResection {
  std::vector<ImagePlane> planes;
  std::vector<BentSurface> bends{};  ///< in the image frame

  [[nodiscard]] bool takesNothing() const { return planes.empty() && bends.empty(); }
};
/// The plan in the image frame. Resections without planes take nothing. Throws PlanningError where a plane is not finite.
std::vector<ImageResection> toImage(const ResectionPlan& plan, const ImageGeometry& geometry);

/// Nothing of the box, or of a point, surely remains: one resection has it as a whole.
bool isResected(const Box& box, const std::vector<ImageResection>& plan);

struct Resected {
  std::vector<std::int64_t> units;  ///< per resection, without what an earlier one has
  std::vector<double> cutAreaMm2;   ///< per resection: its planes' sections of the voxels, where they bound the resected region

  [[nodiscard]] std::int64_t totalUnits() const;
};
Resected resect(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan);
/// The same; faster where planes are bent, and to the unit what the blocks' rows give where all are.
Resected resect(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan);
/// resect().totalUnits(), without the surface that the areas of several planes need.
std::int64_t resectedUnits(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan);
std::int64_t resectedUnits(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan);

/// A piece of the resection surface inside one run of voxels.
struct CutPiece {
  Polygon polygon;  ///< image frame, mm
  std::size_t run = 0;
  std::size_t resection = 0;
  Vec3 normal = Vec3::UnitZ();  ///< unit, to the resected side
  double flatteningMm = 0;      ///< how far the surface can be from it, where the plane is bent
};
/// The resection surface inside the voxels: the boundary of the plan's region, piece by piece. A bent plane's pieces are flat in
/// each voxel, within flatteningMm of the surface.
std::vector<CutPiece> cutSurface(const VoxelRows& rows, const Vec3& spacing, const std::vector<ImageResection>& plan);
/// The same, in the same order; a piece's run is one of the whole's. Faster where planes are bent.
std::vector<CutPiece> cutSurface(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan);
/// The blocks that may have pieces of the surface, in order.
std::vector<std::size_t> cutBlocks(const RowBlocks& blocks, const Vec3& spacing, const std::vector<ImageResection>& plan);

}  // namespace glisson
