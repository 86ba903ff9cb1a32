#pragma once
// Purpose: what a mesh made of the mask it was made from: pieces and cavities lost, Euler number, border, volume, centreline. Fills
// the notes (shown everywhere) and deviations (export asks first) of a Reconstruction (method.md 3, reliability.md).
//
// A mask's pieces are joined by faces, edges and corners (26 neighbours). Marching cubes and PSR join voxels that touch in an edge
// or corner in some places and part them in others, so the number of a mesh's pieces and its Euler number count as the mask's
// wherever they lie between those of the ways in which voxels can be joined (EulerNumbers). A piece is lost where none of its voxel
// centres is inside the mesh, a cavity where all are.

#include "reconstruction/mesh/mask_pieces.h"
#include "reconstruction/reconstruct.h"

namespace glisson {

/// Lost pieces below this many voxels are noted only; from it on they are a deviation too.
inline constexpr std::size_t kPieceThatMatters = 8;
/// A centreline of which less than this lies inside the mesh is noted.
inline constexpr double kCentrelineShare = 0.98;

/// What is known of a mask alone: computed once for all meshes made of it.
struct MaskFacts {
  Pieces pieces;                  ///< joined by 26
  std::size_t joinedByFaces = 0;  ///< pieces joined by 6
  Pieces cavities;                ///< of a background joined by 6
  EulerNumbers euler;
  std::vector<Index3> centreline;  ///< vessels only
};
MaskFacts factsOf(const Mask& mask, StructureKind kind, const ExecutionContext& context = {});

/// Fills defects, volumes, components, centreline, notes and deviations of `made` from its mesh. `psrCellMm` is the side of a PSR
/// cell (0 for MCSD). `facts` are filled where they are empty. Polls cancel between checks.
void checkAgainstMask(const Mask& mask, const ImageGeometry& geometry, StructureKind kind, double psrCellMm,
                      std::optional<MaskFacts>& facts, Reconstruction& made, const ExecutionContext& context = {});

}  // namespace glisson
