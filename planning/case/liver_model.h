#pragma once
// Purpose: the structures of one patient as an immutable snapshot with a revision, shared between threads.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "planning/case/acceptance.h"
#include "reconstruction/reconstruct.h"

namespace glisson {

struct Structure {
  std::string id;    ///< ASCII, unique: parenchyma, portal_vein, hepatic_vein, artery, tumour_01, cyst_01, ...
  std::string name;  ///< as in the file, shown to the user
  StructureKind kind = StructureKind::Other;
  Rgb colour;
  double opacity = 1.0;  ///< 0..1; the parenchyma starts at 0.35
  bool visible = true;
  int sourceIndex = -1;                                  ///< index into Segmentation::structures; the parenchyma is made from L
  std::shared_ptr<const Reconstruction> reconstruction;  ///< mesh, how it was made, notes; null until built
  std::optional<Acceptance> acceptance;                  ///< of this reconstruction; nothing: nobody has accepted it
};

/// The structure with a surface made again: whoever accepted the one before has not seen this one.
Structure withReconstruction(Structure structure, std::shared_ptr<const Reconstruction> reconstruction);

struct LiverModel {
  std::uint64_t revision = 0;
  std::vector<Structure> structures;

  [[nodiscard]] const Structure* find(const std::string& id) const;
};

}  // namespace glisson
