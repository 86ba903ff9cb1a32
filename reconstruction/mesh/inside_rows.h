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

  /// How many voxels of a run lie inside. Runs beyond the grid have none.
  [[nodiscard]] int insideOf(const VoxelRun& run) const;
  [[nodiscard]] bool isInside(int i, int j, int k) const { return insideOf({i, i + 1, j, k, 0}) == 1; }

 private:
  struct Crossing {
    double i;
    std::uint32_t row;  ///< j + rowsJ_ * k
    int enters;         ///< +1 where the ray enters, -1 where it leaves
  };
  void addTriangle(const std::array<Vec3, 3>& at, const Triangle& corners, std::vector<Crossing>& crossings) const;
  /// By row, then i.
  void sortByRow(const std::vector<Crossing>& crossings);

  int rowsJ_;
  int rowsK_;
  std::vector<Crossing> crossings_;   ///< by row, then i
  std::vector<std::uint32_t> first_;  ///< of each row, and the end of the last
};

}  // namespace glisson
