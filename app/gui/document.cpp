#include "app/gui/document.h"

#include <QElapsedTimer>

#include "app/gui/edit_commands.h"
#include "app/gui/sentences.h"
#include "reconstruction/errors.h"

namespace glisson {

Document::Document(JobRunner& jobs, std::filesystem::path recoveryFolder, QObject* parent)
    : QObject(parent), jobs_(jobs), recoveryFolder_(std::move(recoveryFolder)) {
  connect(&undo_, &QUndoStack::cleanChanged, this, &Document::cleanChanged);
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId id) {
    if (preparing_ == id) {
      preparing_.reset();
      emit assessmentChanged();
    }
  });
  connect(&store_, &CaseStore::failed, this, &Document::storeFailed);
  connect(&store_, &CaseStore::saved, this, [this](const QString& path) {
    path_ = path.toStdString();
    recovery_ = false;
    readOnly_ = false;  // the store goes on in the file it has just written
    if (savingIndex_ == undo_.index()) {
      undo_.setClean();
    }
    emit saved(path);
    emit cleanChanged();
  });
}

Document::~Document() { leave(); }

void Document::leave() {
  forgetDrag();
  // a case that was only looked at leaves nothing behind; its data can be opened again
  const bool untouched = open_ && recovery_ && fresh_ && undo_.count() == 0;
  store_.close(untouched ? path_ : std::filesystem::path());
}

void Document::leaveReadOnlyFile() {
  if (!readOnly_) {
    return;
  }
  path_ = recoveryFolder_ / (case_.code + ".glisson");
  for (int n = 2; std::filesystem::exists(path_); ++n) {
    path_ = recoveryFolder_ / (case_.code + "-" + std::to_string(n) + ".glisson");
  }
  readOnly_ = false;
  recovery_ = true;
  store_.goOnIn(path_, case_);
  emit cleanChanged();
}

void Document::open(Case content, std::shared_ptr<CaseFile> file) {
  leave();
  open_ = true;
  fresh_ = file == nullptr;
  case_ = std::move(content);
  noCt_.clear();
  chosen_ = {};
  undo_.clear();
  assessor_.reset();
  tumourDistance_.reset();
  liverCentre_.reset();
  assessment_ = {};
  freshness_ = Freshness::None;
  recovery_ = file == nullptr;
  readOnly_ = file != nullptr && file->readOnly();
  if (file) {
    path_ = file->path();
    const std::filesystem::path parent = path_.parent_path();
    std::error_code ignored;
    recovery_ = std::filesystem::equivalent(parent, recoveryFolder_, ignored);
    restoreHistory(*file);
    store_.adopt(std::move(file));
  } else {
    path_ = recoveryFolder_ / (case_.code + ".glisson");
    store_.create(path_, case_);
  }
  emit caseChanged();
  emit planChanged();
  emit patientChanged();
  emit assessmentChanged();
  emit cleanChanged();
  prepareAssessor();
}

void Document::close() {
  leave();
  open_ = false;
  case_ = {};
  chosen_ = {};
  undo_.clear();
  assessor_.reset();
  tumourDistance_.reset();
  assessment_ = {};
  freshness_ = Freshness::None;
  emit caseChanged();
  emit planChanged();
  emit assessmentChanged();
}

QString Document::stepName(const QString& text) {
  const QString shown = shownSentence(text);  // the names of a plan's edits come from planning/
  return shown == text ? tr(text.toUtf8().constData()) : shown;
}

bool Document::isClean() const { return !open_ || (!recovery_ && undo_.isClean()); }

void Document::setReconstruction(const std::string& structureId, std::shared_ptr<const Reconstruction> reconstruction) {
  const Structure* structure = case_.model ? case_.model->find(structureId) : nullptr;
  if (structure != nullptr) {
    replaceModel(withStructure(*case_.model, withReconstruction(*structure, std::move(reconstruction))));
  }
}

void Document::replaceModel(std::shared_ptr<const LiverModel> model) {
  case_.model = std::move(model);
  if (!readOnly_) {
    store_.storeModel(case_.model);
  }
  emit modelChanged();
}

void Document::setCt(std::shared_ptr<const CtVolume> ct) {
  if (ct && case_.segmentation && ct->geometry.cornerDistance(case_.segmentation->geometry) > kSameGridMm) {
    setNoCt(QStringLiteral("The CT at %1 does not lie on the grid of the labels and is not shown.")
                .arg(QString::fromStdString(ct->source)));
    return;
  }
  noCt_.clear();
  case_.ct = std::move(ct);
  emit ctChanged();
}

void Document::setNoCt(const QString& sentence) {
  noCt_ = sentence;
  addNote(sentence);
  emit ctChanged();
}

void Document::addNote(const QString& sentence) {
  case_.ctNotes.push_back(sentence.toStdString());
  emit notesChanged();
}

void Document::save() {
  if (open_ && !recovery_) {
    savingIndex_ = undo_.index();
    store_.checkpoint();
  }
}

void Document::saveAs(const std::filesystem::path& path) {
  if (open_ && !readOnly_ && !recovery_ && path == path_) {
    save();  // the file is this case's own: every edit is in it already
  } else if (open_) {
    savingIndex_ = undo_.index();
    store_.saveAs(path, case_, recovery_ ? path_ : std::filesystem::path());
  }
}

void Document::saveCopyWithCt(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!open_ || path == path_ || std::filesystem::equivalent(path, path_, ignored)) {
    emit storeFailed(QStringLiteral("%1 is the file this case is kept in; save the copy under another name.")
                         .arg(QString::fromStdString(path.string())));
    return;
  }
  store_.withRecord([this, path, content = case_](const FileRecord& record) {
    JobRequest request{.key = "copy", .title = tr("Saving a copy with the CT")};
    request.fail = [this](const std::exception& error) { emit storeFailed(messageOf(error)); };
    submitFor<std::filesystem::path>(
        jobs_, std::move(request),
        [path, content, record](const ExecutionContext& context) {
          return CaseFile::create(path, content, record.history, {.embed = true, .known = record.ctFiles}, context).path();
        },
        [this](const std::filesystem::path& written) { emit copySaved(QString::fromStdString(written.string())); });
  });
}

namespace {

struct Assessor {
  std::shared_ptr<const PlanAssessor> assessor;
  std::shared_ptr<const TumourDistance> tumours;
  Vec3 centre;
};

}  // namespace

void Document::prepareVolumes() {
  if (open_ && !assessor_ && !preparing_) {
    prepareAssessor();
  }
}

void Document::prepareAssessor() {
  JobRequest request{.key = "assessor", .title = tr("Volumes")};
  request.fail = [this](const std::exception& error) { emit storeFailed(messageOf(error)); };
  preparing_ = submitFor<Assessor>(
      jobs_, std::move(request),
      [content = case_](const ExecutionContext& context) {
        return Assessor{std::make_shared<const PlanAssessor>(content, context), std::make_shared<const TumourDistance>(content),
                        voxelCentre(content.liver->liver, content.liver->geometry)};
      },
      [this](Assessor made) {
        assessor_ = std::move(made.assessor);
        tumourDistance_ = std::move(made.tumours);
        liverCentre_ = made.centre;
        emit tumourDistanceChanged();
        assessVolumes();
        assessAll();
      });
}

void Document::assessVolumes() {
  if (!assessor_) {
    return;
  }
  const PlanAssessment fresh = assessor_->volumes(plan());
  PlanAssessment shown = assessment_;  // margins and vessels stay, marked as out of date
  shown.totalMl = fresh.totalMl;
  shown.tumourMl = fresh.tumourMl;
  shown.functionalMl = fresh.functionalMl;
  shown.divides = fresh.divides;
  shown.resectedMl = fresh.resectedMl;
  shown.remnantMl = fresh.remnantMl;
  shown.volumeUncertaintyMl = fresh.volumeUncertaintyMl;
  shown.functionalRemnantMl = fresh.functionalRemnantMl;
  shown.flrPercent = fresh.flrPercent;
  shown.resections = fresh.resections;
  shown.warning = fresh.warning;
  shown.modelRevision = fresh.modelRevision;
  assessment_ = std::move(shown);
  freshness_ = Freshness::Volumes;
  emit assessmentChanged();
}

void Document::assessInFrame() {
  if (!assessor_) {
    return;
  }
  if (wholeMs_ >= frameBudgetMs_) {
    assessVolumes();
    return;
  }
  QElapsedTimer clock;
  clock.start();
  assessment_ = isDragging() ? assessor_->assessMoving(plan()) : assessor_->assess(plan());
  // one slow frame of many, while the machine does something else, counts little
  constexpr double kWeight = 0.3;
  wholeMs_ += kWeight * (static_cast<double>(clock.nsecsElapsed()) * 1e-6 - wholeMs_);
  freshness_ = Freshness::All;
  emit assessmentChanged();
}

void Document::assessAll() {
  if (!assessor_ || freshness_ == Freshness::All) {
    return;
  }
  JobRequest request{.key = "assess", .title = tr("Margins"), .quiet = true};
  request.fail = [this](const std::exception& error) { emit storeFailed(messageOf(error)); };
  submitFor<PlanAssessment>(
      jobs_, std::move(request),
      [assessor = assessor_, current = plan()](const ExecutionContext&) { return assessor->assess(current); },
      [this, asked = assessor_, of = plan()](PlanAssessment assessment) {
        if (beforeDrag_ || asked != assessor_ || !(of == plan())) {
          return;  // the plane has been moved again, or another case opened, meanwhile: that asks anew
        }
        assessment_ = std::move(assessment);
        freshness_ = Freshness::All;
        emit assessmentChanged();
      });
}

void Document::assessPlans() {
  if (!assessor_) {
    return;
  }
  JobRequest request{.key = "assessPlans", .title = tr("Numbers of all plans"), .quiet = true};
  request.fail = [this](const std::exception& error) { emit storeFailed(messageOf(error)); };
  submitFor<std::vector<PlanAssessment>>(
      jobs_, std::move(request),
      [assessor = assessor_, plans = case_.plans](const ExecutionContext& context) {
        std::vector<PlanAssessment> assessments;
        for (const ResectionPlan& plan : plans) {
          context.throwIfCancelled();
          assessments.push_back(assessor->assess(plan));
        }
        return assessments;
      },
      [this, asked = assessor_](const std::vector<PlanAssessment>& assessments) {
        if (asked == assessor_ && !beforeDrag_) {
          emit plansAssessed(assessments);
        }
      });
}

Vec3 voxelCentre(const Mask& mask, const ImageGeometry& geometry) {
  if (mask.empty()) {
    throw ReconstructionError("The liver's mask is empty; there is nothing to place a plane on.");
  }
  const IndexBox& box = mask.box();
  const std::span<const std::uint8_t> values = mask.values();
  Vec3 sum = Vec3::Zero();
  std::size_t at = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i, ++at) {
        if (values[at] != 0) {
          sum += Vec3(i, j, k);
        }
      }
    }
  }
  const Vec3 first(box.first[0], box.first[1], box.first[2]);
  return geometry.toWorld(first + sum / static_cast<double>(mask.count()));
}

}  // namespace glisson
