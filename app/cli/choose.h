#pragma once
// Purpose: which mask of a segmentation --label N or --structure NAME means.

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "reconstruction/image/segmentation.h"

namespace glisson::cli {

struct MaskChoice {
  std::optional<int> label;
  std::string structure;
};
void addMaskChoice(CLI::App& command, MaskChoice& choice);

struct ChosenMask {
  std::string name;
  StructureKind kind = StructureKind::Other;
  std::shared_ptr<const Mask> mask;
};

/// By label value, by name as in the file (upper and lower case alike), or by the ASCII id of a kind. "parenchyma" is L: the liver
/// with its tumours, cysts and enclosed veins. Without a choice: the only mask there is, else L. Throws UsageError where the choice
/// names none or several.
ChosenMask chooseMask(const Segmentation& segmentation, const MaskChoice& choice);

}  // namespace glisson::cli
