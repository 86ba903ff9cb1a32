#pragma once
// Purpose: the structures of one patient as binary masks on one grid. Masks may overlap. Immutable once read.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reconstruction/image/image_geometry.h"
#include "reconstruction/image/mask.h"
#include "reconstruction/image/structure_kind.h"

namespace glisson {

struct LabelledMask {
  std::string name;                   ///< as in the file: segment name, folder name, or "label 5"
  int label = 0;                      ///< value in the file; 1 where the file is one mask
  std::optional<StructureKind> kind;  ///< nothing: the user must choose (--labels)
  std::optional<Rgb> colour;          ///< as in the file
  std::shared_ptr<const Mask> mask;   ///< never null; null only where kind is Other and the reader skipped the pixels
};

struct Segmentation {
  ImageGeometry geometry;
  std::vector<LabelledMask> structures;  ///< in the file's order
  std::string source;
  std::string patientId;  ///< empty where the source has none
  std::string frameOfReferenceUid;
  std::vector<std::string> notes;
};

}  // namespace glisson
