#include "app/gui/open_inputs.h"

#include <algorithm>
#include <utility>

#include "reconstruction/errors.h"
#include "reconstruction/sample/sample_patient.h"
#include "reconstruction/text.h"

namespace glisson {

namespace fs = std::filesystem;

namespace {

void put(SortedInputs& sorted, InputKind kind, const fs::path& path) {
  const auto set = [&path](std::optional<fs::path>& slot, const std::string& what) {
    if (slot) {
      throw InputError(slot->string() + " and " + path.string() + " both hold " + what + "; open one of them at a time.");
    }
    slot = path;
  };
  switch (kind) {
    case InputKind::Case:
      set(sorted.caseFile, "a case");
      return;
    case InputKind::Ct:
      set(sorted.ct, "a CT");
      return;
    case InputKind::Segmentation:
      set(sorted.segmentation, "a segmentation");
      return;
    case InputKind::Unknown:
      return;
  }
}

/// 3D-IRCADb ships its labels once more as grey values in a copy of the CT's slices: headers of a CT, but no CT.
bool isPictureOfLabels(const fs::path& folder) { return toLower(folder.filename().string()) == "labelled_dicom"; }

/// What the folder's entries are, where exactly one of them is a CT and one a segmentation (a patient's folder as 3D-IRCADb ships
/// it) or one is a case, or one is a CT and the other files are masks of one organ each, which the folder is then; else nothing.
std::optional<SortedInputs> patientFolder(const fs::path& folder, const ExecutionContext& context) {
  constexpr std::size_t kMostEntries = 64;  // a folder of slices is no patient's folder
  std::vector<fs::path> children;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (children.size() == kMostEntries) {
      return std::nullopt;
    }
    if (!isPictureOfLabels(entry.path())) {
      children.push_back(entry.path());
    }
  }
  std::ranges::sort(children);
  SortedInputs inside;
  bool organs = false;
  for (const fs::path& child : children) {
    const InputKind kind = guessInput(child, context);
    std::optional<fs::path>& slot = kind == InputKind::Ct     ? inside.ct
                                    : kind == InputKind::Case ? inside.caseFile
                                                              : inside.segmentation;
    const std::optional<fs::path> other = kind == InputKind::Unknown ? std::nullopt : std::exchange(slot, child);
    const bool masks = kind == InputKind::Segmentation && fs::is_regular_file(child);
    if (other && !(masks && fs::is_regular_file(*other))) {
      return std::nullopt;
    }
    organs = organs || other.has_value();
  }
  if (organs) {
    inside.segmentation = folder;
  }
  const bool pair = inside.ct && inside.segmentation && !inside.caseFile;
  const bool lone = inside.caseFile && !inside.ct && !inside.segmentation;
  return pair || lone ? std::optional(inside) : std::nullopt;
}

std::shared_ptr<const CtVolume> readCtOnce(const fs::path& path, const OpenRequest& request, const ExecutionContext& context) {
  ReadSoFar& kept = *request.readSoFar;
  if (!kept.ct) {
    kept.ct = std::make_shared<const CtVolume>(readCt(path, request.options, context));
  }
  return kept.ct;
}

std::vector<LabelledMask> unknownLabels(const Segmentation& segmentation) {
  std::vector<LabelledMask> unknown;
  std::ranges::copy_if(segmentation.structures, std::back_inserter(unknown),
                       [](const LabelledMask& mask) { return !mask.kind.has_value(); });
  return unknown;
}

/// The kinds of the command line by name, then the answers of the label dialog, laid over what was read before.
void applyKinds(Segmentation& segmentation, const OpenRequest& request) {
  for (LabelledMask& mask : segmentation.structures) {
    const auto chosen = request.options.kindByName.find(mask.name);
    if (chosen != request.options.kindByName.end()) {
      mask.kind = chosen->second;
    }
  }
  auto answer = request.answeredKinds.begin();
  for (LabelledMask& mask : segmentation.structures) {
    if (!mask.kind && answer != request.answeredKinds.end()) {
      mask.kind = *answer++;
    }
  }
}

/// The CT in the file; where it is damaged a note says so.
std::shared_ptr<const CtVolume> embeddedCtOf(OpenedCase& opened, const ExecutionContext& context) {
  try {
    return opened.file->embeddedCt(context);
  } catch (const InputError& damage) {
    opened.content.ctNotes.emplace_back(damage.what());
    return nullptr;
  }
}

/// The CT where the case says; where it cannot be read or does not lie on the labels, the one in the file and a note.
std::shared_ptr<const CtVolume> namedCtOrEmbedded(OpenedCase& opened, const ExecutionContext& context) {
  try {
    std::shared_ptr<const CtVolume> ct = readCtOf(opened.content, context);
    if (ct->geometry.cornerDistance(opened.content.segmentation->geometry) <= kSameGridMm) {
      return ct;
    }
  } catch (const InputError&) {  // told below, or when it is read for the view
  }
  std::shared_ptr<const CtVolume> ct = embeddedCtOf(opened, context);
  if (ct) {
    opened.content.ctNotes.push_back("The CT at " + opened.content.ctSource +
                                     " cannot be read: the CT embedded in the case is shown.");
  }
  return ct;
}

OpenedCase openCaseFile(const fs::path& path, const ExecutionContext& context) {
  OpenedCase opened;
  opened.file = std::make_shared<CaseFile>(CaseFile::open(path));
  opened.content = opened.file->load();
  const std::string& ct = opened.content.ctSource;
  const bool builtIn = ct == kSampleSource;
  const bool there = !ct.empty() && !builtIn && fs::exists(ct);
  if (builtIn || (there && opened.file->ctUnchanged())) {
    if (!builtIn && opened.file->hasEmbeddedCt()) {
      opened.content.ct = namedCtOrEmbedded(opened, context);
    }  // else it is read when the case is shown
    return opened;
  }
  opened.content.ct = embeddedCtOf(opened, context);
  std::vector<std::string>& notes = opened.content.ctNotes;
  if (there && opened.content.ct) {
    notes.push_back("The CT at " + ct +
                    " is not the one this case was made from (its files have changed): the CT embedded in the case is shown.");
  } else if (there) {
    // another patient's CT on the same grid would look right [hazard H2]
    opened.noCt = "The CT at " + ct +
                  " is not the one this case was made from (its files have changed): its slices are not shown; put the files of "
                  "then back to see them.";
  } else if (opened.content.ct) {
    notes.push_back("The CT of this case is not at " + ct + ": the CT embedded in the case is shown.");
  }
  return opened;
}

}  // namespace

SortedInputs sortInputs(const std::vector<fs::path>& paths, const ExecutionContext& context) {
  SortedInputs sorted;
  for (const fs::path& path : paths) {
    if (!fs::exists(path)) {
      throw InputError(path.string() + " does not exist; check the path.");
    }
    if (const std::optional<SortedInputs> inside = fs::is_directory(path) ? patientFolder(path, context) : std::nullopt) {
      for (const auto& [found, kind] :
           {std::pair(inside->ct, InputKind::Ct), std::pair(inside->segmentation, InputKind::Segmentation),
            std::pair(inside->caseFile, InputKind::Case)}) {
        if (found) {
          put(sorted, kind, *found);
        }
      }
      continue;
    }
    const InputKind kind = guessInput(path, context);
    if (kind == InputKind::Unknown) {
      if (fs::is_regular_file(path)) {
        readSegmentation(path, {}, context);  // refuses it: the reader says best why it cannot be read
      }
      throw InputError(path.string() + " holds neither a CT, nor a segmentation, nor a case; choose a DICOM folder, NIfTI, NRRD, " +
                       "MetaImage or .glisson file.");
    }
    put(sorted, kind, path);
  }
  return sorted;
}

OpenedCase openInputs(const OpenRequest& request, const ExecutionContext& context) {
  if (request.sample) {
    SamplePatient patient = makeSamplePatient(false, context);
    OpenedCase opened;
    opened.content = newCase(std::make_shared<const CtVolume>(std::move(patient.ct)),
                             std::make_shared<const Segmentation>(std::move(patient.segmentation)));
    return opened;
  }
  const SortedInputs inputs = sortInputs(request.paths, context);
  if (inputs.caseFile) {
    return openCaseFile(*inputs.caseFile, context);
  }
  if (!inputs.segmentation) {
    OpenedCase opened;
    opened.loneCt = inputs.ct.value();  // one of the three is there
    return opened;
  }
  std::shared_ptr<const CtVolume> ct;
  if (inputs.ct) {
    ct = readCtOnce(*inputs.ct, request, context.range(0.0, 0.5));
  }
  ReadSoFar& kept = *request.readSoFar;
  if (!kept.segmentation) {
    kept.segmentation =
        std::make_shared<Segmentation>(readSegmentation(*inputs.segmentation, request.options, context.range(0.5, 0.9)));
  }
  Segmentation labels = *kept.segmentation;
  applyKinds(labels, request);
  OpenedCase opened;
  opened.unknown = unknownLabels(labels);
  if (opened.needsKinds()) {
    return opened;
  }
  if (ct) {
    labels = matchToCt(std::move(labels), *ct, request.options);
  }
  context.throwIfCancelled();
  opened.content = newCase(ct, std::make_shared<const Segmentation>(std::move(labels)));
  return opened;
}

std::shared_ptr<const CtVolume> readCtOf(const Case& content, const ExecutionContext& context) {
  if (content.ctSource.empty()) {
    return nullptr;
  }
  if (content.ctSource == kSampleSource) {
    return std::make_shared<const CtVolume>(makeSamplePatient(false, context).ct);  // the built-in patient has no file
  }
  if (!fs::exists(content.ctSource)) {
    throw InputError("The CT of this case is no longer at " + content.ctSource + "; put it back to see the slices.");
  }
  // These very files were accepted when the case was made: the same consents hold, and of two frames the one on the labels' grid.
  ReadOptions options;
  options.consents = {Consent::Tilt, Consent::UnevenSlices};
  try {
    return std::make_shared<const CtVolume>(readCt(content.ctSource, options, context));
  } catch (const InputError& refusal) {
    if (std::string(refusal.what()).find("--prefer") == std::string::npos) {
      throw;
    }
  }
  options.niftiFrame = NiftiFrame::SForm;
  auto ct = std::make_shared<const CtVolume>(readCt(content.ctSource, options, context));
  if (content.segmentation && content.segmentation->geometry.cornerDistance(ct->geometry) > kSameGridMm) {
    options.niftiFrame = NiftiFrame::QForm;
    ct = std::make_shared<const CtVolume>(readCt(content.ctSource, options, context));
  }
  return ct;
}

}  // namespace glisson
