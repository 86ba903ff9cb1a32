#include "app/cli/choose.h"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {

std::string listOf(const Segmentation& segmentation) {
  std::string list;
  for (const LabelledMask& structure : segmentation.structures) {
    list += (list.empty() ? "" : ", ") + structure.name + " (label " + std::to_string(structure.label) + ")";
  }
  return list;
}

bool holdsLiver(const Segmentation& segmentation) {
  return std::any_of(segmentation.structures.begin(), segmentation.structures.end(),
                     [](const LabelledMask& structure) { return structure.kind == StructureKind::Liver; });
}

ChosenMask parenchyma(const Segmentation& segmentation) {
  return {"parenchyma", StructureKind::Liver, std::make_shared<const Mask>(liverVoxels(segmentation).liver)};
}

template <typename Predicate>
std::vector<const LabelledMask*> matching(const Segmentation& segmentation, const Predicate& predicate) {
  std::vector<const LabelledMask*> found;
  for (const LabelledMask& structure : segmentation.structures) {
    if (predicate(structure)) {
      found.push_back(&structure);
    }
  }
  return found;
}

ChosenMask theOne(const std::vector<const LabelledMask*>& found, const std::string& flag, const Segmentation& segmentation) {
  if (found.size() == 1) {
    const LabelledMask& structure = *found.front();
    if (!structure.mask) {
      throw UsageError(structure.name + " in " + segmentation.source +
                       " is no part of a liver model and was not read; give it a kind with --labels NAME=KIND");
    }
    return {structure.name, structure.kind.value_or(StructureKind::Other), structure.mask};
  }
  throw UsageError(flag + " names " + (found.empty() ? "no structure" : std::to_string(found.size()) + " structures") + " of " +
                   segmentation.source + "; choose one of: " + listOf(segmentation));
}

}  // namespace

void addMaskChoice(CLI::App& command, MaskChoice& choice) {
  auto* label = command.add_option_function<std::string>(
      "--label",
      [&choice](const std::string& text) {
        const auto number = parseInteger(text);
        if (!number || *number != static_cast<int>(*number)) {
          throw CLI::ValidationError("--label", "takes a whole number, not \"" + text + "\"");
        }
        choice.label = static_cast<int>(*number);
      },
      "The structure by its label value");
  command
      .add_option("--structure", choice.structure,
                  "The structure by its name in the file or its kind; \"parenchyma\" is the liver with tumours and enclosed veins")
      ->excludes(label);
}

ChosenMask chooseMask(const Segmentation& segmentation, const MaskChoice& choice) {
  if (choice.label) {
    return theOne(matching(segmentation, [&](const LabelledMask& s) { return s.label == *choice.label; }),
                  "--label " + std::to_string(*choice.label), segmentation);
  }
  if (choice.structure.empty()) {
    if (segmentation.structures.size() != 1 && holdsLiver(segmentation)) {
      return parenchyma(segmentation);
    }
    return theOne(matching(segmentation, [](const LabelledMask&) { return true; }), "without --label or --structure the choice",
                  segmentation);
  }
  const std::string wanted = toLower(choice.structure);
  auto found = matching(segmentation, [&](const LabelledMask& s) { return toLower(s.name) == wanted; });
  if (found.empty() && wanted == kindId(StructureKind::Liver)) {
    return parenchyma(segmentation);
  }
  if (found.empty()) {
    found = matching(segmentation, [&](const LabelledMask& s) { return s.kind && s.kind == kindFromId(wanted); });
  }
  return theOne(found, "--structure " + choice.structure, segmentation);
}

}  // namespace glisson::cli
