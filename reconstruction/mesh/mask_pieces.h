#pragma once
// Purpose: the topology of a mask: its pieces, its cavities and its Euler number, by runs of voxels along i, so that a liver takes
// a few milliseconds. Index frame of the whole grid.

#include <cstdint>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/mask.h"

namespace glisson {

/// Voxels [begin, end) of row (j, k).
struct VoxelRun {
  int begin = 0;
  int end = 0;
  int j = 0;
  int k = 0;
  std::uint32_t piece = 0;
  [[nodiscard]] int length() const { return end - begin; }
};

/// A mask's runs by k, then j, then i, each with the piece it belongs to, and the number of voxels of every piece.
struct Pieces {
  std::vector<VoxelRun> runs;
  std::vector<std::size_t> voxels;
  [[nodiscard]] std::size_t count() const { return voxels.size(); }
};

/// Joined by faces (6 neighbours), or by faces, edges and corners (26).
enum class Neighbours : std::uint8_t { Six, TwentySix };

/// The pieces of the mask, by first voxel. Polls cancel, as those below, with every slice.
Pieces piecesOf(const Mask& mask, Neighbours neighbours, const ExecutionContext& context = {});

/// The pieces of the background that the mask encloses. Six neighbours go with a mask joined by 26, and the other way round.
Pieces cavitiesOf(const Mask& mask, Neighbours neighbours, const ExecutionContext& context = {});

/// Pieces - tunnels + cavities of the mask's voxels as a solid, by what voxels are taken to be joined by.
struct EulerNumbers {
  long long facesEdgesCorners = 0;  ///< 26 neighbours; the background by 6
  long long facesEdges = 0;         ///< 18; the background by 6
  long long faces = 0;              ///< 6; the background by 26
  long long facesAsCubes = 0;       ///< 6; the background by 18: what vtkMarchingCubes makes
};
EulerNumbers eulerNumbers(const Mask& mask, const ExecutionContext& context = {});

}  // namespace glisson
