#include "planning/case/case.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>

#include "planning/case/structure_mask.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson {

namespace {
constexpr double kParenchymaOpacity = 0.35;

std::string newCode() {
  std::random_device random;
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string code = "G-";
  for (int n = 0; n < 6; ++n) {
    code += kDigits[random() & 15U];
  }
  return code;
}

/// Refuses what the user has to decide first: a structure of unknown kind.
void requireKinds(const Segmentation& segmentation) {
  for (const LabelledMask& structure : segmentation.structures) {
    if (!structure.kind) {
      const std::string key = labelsKey(structure);
      const std::string shown = key == structure.name ? key : "label " + key;
      throw InputError(segmentation.source + ": it is not known what \"" + shown + "\" is; say it with --labels \"" + key +
                       "=KIND\" (a structure kind, or other to leave it out).");
    }
  }
}

/// Ids by kind in file order: lesions are always numbered, the others from the second on.
class IdGiver {
 public:
  std::string next(StructureKind kind) {
    const int number = ++given_[kind];
    std::string id(kindId(kind));
    if (number > 1 || isLesion(kind)) {
      id += number < 10 ? "_0" : "_";
      id += std::to_string(number);
    }
    return id;
  }

 private:
  std::map<StructureKind, int> given_;
};

Structure structureFor(const LabelledMask& source, int index, std::string id) {
  Structure structure;
  structure.id = std::move(id);
  structure.name = source.name;
  structure.kind = *source.kind;
  structure.colour = source.colour.value_or(defaultColour(structure.kind));
  structure.opacity = structure.kind == StructureKind::Liver ? kParenchymaOpacity : 1.0;
  structure.sourceIndex = index;
  return structure;
}

/// The parenchyma first, then the others in file order; what stays out of the model is said in `notes`.
std::vector<Structure> listStructures(const Segmentation& segmentation, std::vector<std::string>& notes) {
  std::vector<Structure> structures;
  std::vector<Structure> others;
  std::string leftOut;
  IdGiver ids;
  for (std::size_t n = 0; n < segmentation.structures.size(); ++n) {
    const LabelledMask& source = segmentation.structures[n];
    const StructureKind kind = *source.kind;
    if (kind == StructureKind::Other || !source.mask) {
      leftOut += (leftOut.empty() ? "" : ", ") + source.name;
    } else if (source.mask->empty()) {
      notes.push_back(source.name + " has no voxels and is not in the model.");
    } else if (kind != StructureKind::Liver) {
      others.push_back(structureFor(source, static_cast<int>(n), ids.next(kind)));
    } else if (structures.empty()) {
      structures.push_back(structureFor(source, static_cast<int>(n), ids.next(kind)));
    } else {
      notes.push_back(source.name + " is part of the parenchyma, as " + structures.front().name + " is.");
    }
  }
  if (structures.empty()) {
    throw InputError(segmentation.source +
                     " holds no liver, or an empty one; choose a segmentation with a liver, or name its label with " +
                     "--labels N=liver.");
  }
  if (!leftOut.empty()) {
    notes.push_back("Not part of a liver model: " + leftOut + ".");
  }
  structures.insert(structures.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
  return structures;
}

}  // namespace

const Mask& maskOf(const Case& source, const Structure& structure) {
  if (structure.kind == StructureKind::Liver) {
    return source.liver->liver;
  }
  const auto& all = source.segmentation->structures;
  if (structure.sourceIndex < 0 || static_cast<std::size_t>(structure.sourceIndex) >= all.size() ||
      !all[static_cast<std::size_t>(structure.sourceIndex)].mask) {
    throw PlanningError(structure.name + " has no mask in this case; read the segmentation again.");
  }
  return *all[static_cast<std::size_t>(structure.sourceIndex)].mask;
}

Structure withReconstruction(Structure structure, std::shared_ptr<const Reconstruction> reconstruction) {
  structure.reconstruction = std::move(reconstruction);
  structure.acceptance.reset();
  return structure;
}

const Structure* LiverModel::find(const std::string& id) const {
  for (const Structure& structure : structures) {
    if (structure.id == id) {
      return &structure;
    }
  }
  return nullptr;
}

std::string labelsKey(const LabelledMask& structure) {
  const bool named = !structure.name.empty() && structure.name != "label " + std::to_string(structure.label);
  return named ? structure.name : std::to_string(structure.label);
}

Case newCase(std::shared_ptr<const CtVolume> ct, std::shared_ptr<const Segmentation> segmentation) {
  requireKinds(*segmentation);
  if (ct && segmentation->geometry.cornerDistance(ct->geometry) > kSameGridMm) {
    throw InputError(segmentation->source + " (" + segmentation->geometry.describe() + ") is not on the grid of " + ct->source +
                     " (" + ct->geometry.describe() + "); accept resample-labels, or choose the labels of this CT.");
  }
  Case made;
  made.code = newCode();
  const auto addNotes = [&](const std::vector<std::string>& notes) {
    made.notes.insert(made.notes.end(), notes.begin(), notes.end());
  };
  if (ct) {
    made.identity = ct->identity;
    // The case may be opened from another folder than the one the CT was named in.
    made.ctSource = ct->source == kSampleSource ? ct->source : std::filesystem::absolute(ct->source).lexically_normal().string();
    addNotes(ct->notes);
  }
  addNotes(segmentation->notes);
  auto model = std::make_shared<LiverModel>();
  model->revision = 1;
  model->structures = listStructures(*segmentation, made.notes);
  auto liver = std::make_shared<LiverVoxels>(liverVoxels(*segmentation));
  addNotes(liver->notes);
  made.ct = std::move(ct);
  made.segmentation = std::move(segmentation);
  made.liver = std::move(liver);
  made.model = std::move(model);
  made.plans.push_back({"Plan 1", {}, ResectionPlan().safetyMarginMm});
  return made;
}

Structure buildStructure(const Case& source, const Structure& structure, const ExecutionContext& context) {
  const Mask& mask = maskOf(source, structure);
  const ImageGeometry& geometry = source.segmentation->geometry;
  ReconstructionParameters parameters = ReconstructionParameters::defaultsFor(structure.kind);
  Reconstruction made = reconstruct(mask, geometry, structure.kind, parameters, context.range(0.0, 0.7));
  if (parameters.method == Method::Psr) {  // reconstruct() counts them for MCSD meshes only
    made.defects.selfIntersections = countSelfIntersections(made.mesh, context.range(0.7, 1.0));
  } else if (made.defects.any()) {
    // vtkDecimatePro does not look at the triangles around: without it the same surface is sound and can be exported.
    const std::string lost = made.defects.names().front();
    parameters.mcsd.decimation = 0;
    made = reconstruct(mask, geometry, structure.kind, parameters, context.range(0.7, 1.0));
    made.notes.push_back("decimation left out: at the default it broke the mesh (" + lost + ")");
  }
  context.report(1.0, structure.name);
  return withReconstruction(structure, std::make_shared<const Reconstruction>(std::move(made)));
}

std::shared_ptr<const LiverModel> withStructure(const LiverModel& model, Structure structure) {
  auto next = std::make_shared<LiverModel>(model);
  ++next->revision;
  for (Structure& place : next->structures) {
    if (place.id == structure.id) {
      place = std::move(structure);
      return next;
    }
  }
  throw PlanningError("The model has no structure " + structure.id + "; build it from the segmentation of this case.");
}

Case buildModel(Case source, const ExecutionContext& context) {
  const std::vector<Structure> wanted = source.model->structures;
  double total = 0;
  for (const Structure& structure : wanted) {
    total += static_cast<double>(maskOf(source, structure).box().voxelCount());
  }
  double done = 0;
  for (const Structure& structure : wanted) {
    const double share = static_cast<double>(maskOf(source, structure).box().voxelCount()) / total;
    const ExecutionContext part = context.range(done, std::min(1.0, done + share));
    part.report(0.0, structure.name);
    source.model = withStructure(*source.model, buildStructure(source, structure, part));
    done += share;
  }
  context.report(1.0, "model");
  return source;
}

}  // namespace glisson
