#pragma once
// Purpose: one patient: CT, segmentation, model, plans, identity. A value made of immutable snapshots; copying is cheap.

#include <memory>
#include <string>
#include <vector>

#include "planning/case/liver_model.h"
#include "planning/case/patient_facts.h"
#include "planning/case/territory_marks.h"
#include "planning/resection/resection_plan.h"
#include "reconstruction/image/ct_volume.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/image/segmentation.h"

namespace glisson {

struct Case {
  std::string code;  ///< short pseudonym, e.g. "G-4F7A2C", made once per case (never from identity)
  PatientIdentity identity;
  std::string ctSource;                ///< path of the CT, empty where there is none
  std::shared_ptr<const CtVolume> ct;  ///< may be null: a case without CT
  std::shared_ptr<const Segmentation> segmentation;
  std::shared_ptr<const LiverVoxels> liver;
  std::shared_ptr<const LiverModel> model;
  std::vector<ResectionPlan> plans;  ///< never empty after newCase()
  PatientFacts patient;              ///< what the user said for the FLR card
  TerritoryMarks territories{};      ///< what the user said about the territories
  std::vector<std::string>
      notes;  ///< what the readers and the model had to say, consents included; all in the report, the consents in the package
  /// What this session has to say of the CT's file, with its path: shown, neither stored nor handed on.
  std::vector<std::string> ctNotes{};
};

/// What --labels calls a structure: its name, or its number where the file has no name for it.
std::string labelsKey(const LabelledMask& structure);

/// Makes a case from read volumes: forms L, T, F, a code, an empty plan "Plan 1" and the list of structures (not yet built).
/// `ct` may be null. Throws InputError where a structure's kind is unknown (names it and the --labels flag) or there is no liver.
Case newCase(std::shared_ptr<const CtVolume> ct, std::shared_ptr<const Segmentation> segmentation);

/// The structure with its reconstruction done, default parameters of its kind, self-intersections counted. Where the default
/// decimation breaks an MCSD mesh the structure is made without it, and a note says so. Called by one job per structure; pure.
Structure buildStructure(const Case& source, const Structure& structure, const ExecutionContext& context = {});

/// A new snapshot with `structure` in place of the one with its id; revision + 1.
std::shared_ptr<const LiverModel> withStructure(const LiverModel& model, Structure structure);

/// Builds every structure in turn (the command line). Progress and cancel through the context.
Case buildModel(Case source, const ExecutionContext& context = {});

}  // namespace glisson
