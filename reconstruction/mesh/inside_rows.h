#pragma once
// Purpose: which voxel centres of a grid lie inside a mesh, for all of them at once: rays along the grid's rows, crossings with
// their sense (so overlapping parts of a mesh count as inside). A voxel is looked at a thousandth of its size beside its centre,
// where no vertex of a marching-cubes surface lies.

#include <span>
#include <vector>

#include "reconstruction/mesh/mask_pieces.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson {

class InsideRows {
 public:
  /// The mesh in mm LPS, closed; `geometry` places the grid. Linear in triangles + rows crossed.
  /// Polls cancel.
  InsideRows(const SurfaceMesh& mesh, const ImageGeometry& geometry, const ExecutionContext& context = {});

  /// How many voxels of a run lie inside.
  [[nodiscard]] int insideOf(const VoxelRun& run) const;
  [[nodiscard]] bool isInside(int i, int j, int k) const { return insideOf({i, i + 1, j, k, 0}) == 1; }

 private:
  struct Crossing {
    std::uint64_t row;
    double i;
    int enters;  ///< +1 where the ray enters, -1 where it leaves
  };
  void addTriangle(const std::array<Vec3, 3>& at, const Triangle& corners);
  [[nodiscard]] static std::uint64_t rowKey(int j, int k);

  std::vector<Crossing> crossings_;  ///< by row, then i
};

}  // namespace glisson
