#pragma once
// Purpose: L, T and F of method.md section 0: what the parenchyma is made from and what every volume counts.
//   L = liver mask + tumours and cysts that touch it + vessel voxels enclosed by it
//   T = union of tumours and cysts, F = L without T
// A patient given nested (the liver mask holds lesions and vessels) and given exclusive (they are cut out) gives the same L, T, F:
// what a vessel voxel counts as is decided only by what both have in common, S = (liver mask without vessels) + touching lesions.
// It is liver where it is enclosed along at least two of the three image axes: going straight through vessel voxels, both ways end
// in S. So a vein inside the liver is liver, a trunk is cut off flush with the surface where it leaves, and a cava in its groove is
// not liver. The price: vessel voxels of a nested mask that are not enclosed (0.04 % of a real liver) are left out, with a note.
// Vessels are portal and hepatic veins, cava, arteries and bile ducts. Lesions touch by a face, edge or corner, piece by piece.
// Where a label map gives a voxel of both lesion and vessel to the vessel alone, T lacks that voxel: it cannot be known.

#include <memory>
#include <string>
#include <vector>

#include "reconstruction/image/segmentation.h"

namespace glisson {

struct LiverVoxels {
  ImageGeometry geometry;
  Mask liver;                      ///< L
  Mask tumour;                     ///< T, every lesion voxel counted once, also outside L
  Mask functional;                 ///< F = L without T
  std::vector<std::string> notes;  ///< lesion volume outside the original mask, overlaps, detached lesions: listed, never dropped

  [[nodiscard]] double totalMl() const;
  [[nodiscard]] double tumourMl() const;
  [[nodiscard]] double functionalMl() const;
};

/// Throws ReconstructionError where no structure of kind Liver is there or it is empty.
LiverVoxels liverVoxels(const Segmentation& segmentation);

/// mm^3 to mL stands here and nowhere else.
inline constexpr double kMlPerMm3 = 1e-3;
double volumeMl(const Mask& mask, const ImageGeometry& geometry);

}  // namespace glisson
