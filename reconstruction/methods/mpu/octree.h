#pragma once
// Purpose: the octree of MPU implicits: cells are divided until a quadric fits each cell's points (Ohtake et al. 2003, section 3
// and Fig. 3).

#include <span>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/methods/mpu/quadric_fit.h"

namespace glisson::mpu {

/// A ball with the function that counts in it. The balls of all leaves cover the cube.
struct Patch {
  Ball ball;
  Quadric quadric;
};

struct Cube {
  Vec3 corner = Vec3::Zero();  ///< low corner, mm
  double side = 0;             ///< mm
};

struct Fitting {
  double toleranceMm = 1;  ///< eps0: a cell is divided while a point of its ball lies farther from its quadric
  double leastSideMm = 0;  ///< no cell is divided into smaller ones: the samples have no more to say
};

/// The patches of the leaves, level by level. `normals` are unit and outward, one for each position; there is one point at least.
/// The same for any number of threads. Polls cancel every few cells.
std::vector<Patch> fitPatches(std::span<const Vec3> positions, std::span<const Vec3> normals, const Cube& cube,
                              const Fitting& fitting, const ExecutionContext& context = {});

}  // namespace glisson::mpu
