#pragma once
// Purpose: the open case: its content, its undo stack, its file and its numbers. The content changes only through the commands
// here; every edit is stored at once (recovery folder until the case is saved); clean = saved. Frame: mm LPS. UI thread only.

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/case_store.h"
#include "app/jobs/job_runner.h"
#include "planning/case/case.h"
#include "planning/resection/plan_edit.h"
#include "planning/volumetry/assessment.h"
#include "planning/volumetry/tumour_distance.h"

namespace glisson {

/// How much of assessment() belongs to the plan as it stands.
enum class Freshness : std::uint8_t {
  None,     ///< not computed yet
  Volumes,  ///< volumes are right, margins and vessels are of an older plan
  All
};

/// The plane that is worked on, by its places in the lists. What it names may be missing: an empty plan has no plane.
struct ChosenPlane {
  std::size_t plan = 0;
  std::size_t resection = 0;
  std::size_t plane = 0;
  bool operator==(const ChosenPlane&) const = default;
};

class Document : public QObject {
  Q_OBJECT
 public:
  /// Unsaved cases live in `recoveryFolder`.
  Document(JobRunner& jobs, std::filesystem::path recoveryFolder, QObject* parent = nullptr);
  ~Document() override;

  /// Shows a new case (stored in the recovery folder at once) or one from a file.
  void open(Case content, std::shared_ptr<CaseFile> file = nullptr);
  void close();
  [[nodiscard]] bool isOpen() const { return open_; }
  [[nodiscard]] const Case& content() const { return case_; }
  /// Where the case is stored now; isRecovery() while it has no name of its own.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool isRecovery() const { return recovery_; }
  /// Another program writes its file, or it is write-protected; until the first edit.
  [[nodiscard]] bool isReadOnly() const { return readOnly_; }
  /// Its texts are the names of the steps in English; show them through stepName().
  [[nodiscard]] QUndoStack& undoStack() { return undo_; }
  [[nodiscard]] static QString stepName(const QString& text);
  /// Saved under a name of its own and not changed since.
  [[nodiscard]] bool isClean() const;

  [[nodiscard]] const ChosenPlane& chosen() const { return chosen_; }
  /// What is worked on and shown; no undo step. Places that do not exist become the nearest that do.
  void choose(const ChosenPlane& chosen);
  /// The plane being worked on; nothing while the plan is empty.
  [[nodiscard]] std::optional<ResectionPlane> plane() const;
  /// The plan being worked on.
  [[nodiscard]] const ResectionPlan& plan() const;
  [[nodiscard]] const PlanAssessment& assessment() const { return assessment_; }
  [[nodiscard]] Freshness freshness() const { return freshness_; }
  /// Computes the numbers of all plans; plansAssessed() brings them, unless the plans change meanwhile.
  void assessPlans();
  /// For colouring the resection surface; null until computed.
  [[nodiscard]] const std::shared_ptr<const TumourDistance>& tumourDistance() const { return tumourDistance_; }
  /// Centre of L's voxels, mm; nothing until computed.
  [[nodiscard]] std::optional<Vec3> liverCentre() const { return liverCentre_; }
  /// Starts what the numbers are counted by, where it was cancelled; it starts by itself with the case.
  void prepareVolumes();
  [[nodiscard]] bool isPreparingVolumes() const { return preparing_.has_value(); }

  /// Each is one undo step with its name. A plane is placed where none is, else moved there; placed anew it is flat, moved it keeps
  /// its bend.
  void placePlane(const HalfSpace& plane);
  void movePlane(const HalfSpace& plane);
  void removePlane();
  /// Bends the plane worked on, from heights of 0 over its cut through the liver.
  void startBend();
  /// Bends the bent plane worked on in another way.
  void bendPlane(const Bend& bend);
  void flattenPlane();
  /// Any edit of the plan worked on; a plane it adds is the one worked on then. Throws PlanningError and changes nothing where the
  /// plan does not take it.
  void edit(const PlanEdit& edit);
  /// The list of plans. Throw as the functions of plan_list.h; a plan that comes is the one worked on then.
  void addPlan();
  void duplicatePlan();
  void renamePlan(const std::string& name);
  void removePlan();
  void setPatient(const PatientFacts& facts);
  /// `step`: what was done, as it stands behind Undo.
  void setTerritories(const TerritoryMarks& marks, const QString& step);
  void setColour(const std::string& structureId, Rgb colour);
  void setOpacity(const std::string& structureId, double opacity);
  void setVisible(const std::string& structureId, bool visible);
  /// These structures are accepted by a person, now; those that are not made yet are left out. One step.
  void accept(const std::vector<std::string>& structureIds, const std::string& by);
  void withdrawAcceptance(const std::string& structureId);

  /// From begin to end is one undo step. Between them all numbers but the islands follow in the same frame where the last ones took
  /// no longer than that, else the volumes alone. Another edit, undo or choice meanwhile cancels it first: the plane is back where
  /// it was, and dragCancelled() tells.
  void beginDrag();
  void dragTo(const ResectionPlane& plane);
  void endDrag(const ResectionPlane& plane);
  void cancelDrag();
  [[nodiscard]] bool isDragging() const { return beforeDrag_.has_value(); }
  /// How long all numbers may take for an edit to bring them at once; with 0 a job always brings what is no volume.
  void setFrameBudgetMs(double ms) { frameBudgetMs_ = ms; }

  /// A finished reconstruction; colour, opacity and visibility stay as the user has set them meanwhile. Nobody has accepted it.
  void setReconstruction(const std::string& structureId, std::shared_ptr<const Reconstruction> reconstruction);
  /// The CT of a case that was opened from its file. Ignored where its grid is not the labels'.
  void setCt(std::shared_ptr<const CtVolume> ct);
  /// An English sentence, as the libraries' notes beside it.
  void addNote(const QString& sentence);
  /// Why there is no CT to show: an English sentence that becomes a note, too.
  void setNoCt(const QString& sentence);
  /// Empty while one is shown, is being read, or where the case names none.
  [[nodiscard]] const QString& noCt() const { return noCt_; }

  /// A case in the recovery folder has no name yet: use saveAs().
  void save();
  void saveAs(const std::filesystem::path& path);
  /// Writes a copy that holds the CT too, in a job; the case stays where it is. copySaved() tells.
  void saveCopyWithCt(const std::filesystem::path& path);
  /// Blocks until every edit is on disk.
  void flush() { store_.flush(); }
  /// Every edit is on disk; asked after flush().
  [[nodiscard]] bool keepsAll() const { return store_.keepsAll(); }

 signals:
  void caseChanged();         ///< another case, or none
  void modelChanged();        ///< a structure was made or looks different
  void ctChanged();           ///< the CT has come, or is known not to come
  void notesChanged();        ///< the problem list
  void planChanged();         ///< a plane stands elsewhere, another one is worked on, or the list of plans is another
  void patientChanged();      ///< what the user said about the patient
  void territoriesChanged();  ///< what the user said about the territories
  void dragCancelled();       ///< whoever drags lets go
  void tumourDistanceChanged();
  /// What assessPlans() asked for, by plan.
  void plansAssessed(const std::vector<glisson::PlanAssessment>& assessments);
  void assessmentChanged();  ///< new numbers, or old ones out of date
  void cleanChanged();
  void saved(const QString& path);
  void copySaved(const QString& path);
  void storeFailed(const QString& sentence);  ///< in English

 private:
  friend class PlansCommand;
  friend class PatientCommand;
  friend class TerritoriesCommand;
  friend class StructuresCommand;
  void leave();
  /// Whoever drags lets go; the plans stay as they are.
  void forgetDrag();
  /// A case whose file must not be written goes on in the recovery folder from its first edit on: no edit is in memory alone.
  void leaveReadOnlyFile();
  [[nodiscard]] std::vector<ResectionPlan> plansWithPlane(const ResectionPlane& plane) const;
  void pushPlans(const QString& name, std::vector<ResectionPlan> plans, const ChosenPlane& chosen);
  void setPlans(std::vector<ResectionPlan> plans, const ChosenPlane& chosen, const QString& name);
  /// The edits of earlier sessions onto the undo stack; what was undone then is not there.
  void restoreHistory(const CaseFile& file);
  /// `name`: of the edit, for the history; empty where it takes one back.
  void storePatient(const PatientFacts& facts, const QString& name);
  void storeTerritories(const TerritoryMarks& marks, const QString& name);
  /// What an edit changes of a structure: that in which the states differ.
  struct StructureChange {
    StructureState before;
    StructureState after;
    std::shared_ptr<const Reconstruction> of;  ///< whose acceptance is changed; a structure with another one keeps what it has
  };
  enum class Direction : std::uint8_t { Forth, Back };
  /// All of them are one new model. `name` and `goesOn` as in CaseStore.
  void setStructures(const std::vector<StructureChange>& changes, Direction direction, const QString& name, bool goesOn = false);
  /// Nothing where the structure is missing or `change` leaves it as it is.
  void pushStructure(const QString& name, const std::string& structureId, const std::function<void(StructureState&)>& change);
  void pushAcceptance(const QString& name, const std::vector<const Structure*>& structures, const std::optional<Acceptance>& after);
  /// An edit of an earlier session, on the structures as they are now.
  [[nodiscard]] std::vector<StructureChange> changesOf(const Change<std::vector<StructureState>>& edit) const;
  void replaceModel(std::shared_ptr<const LiverModel> model);
  void prepareAssessor();
  void assessVolumes();
  /// All numbers where they are expected to fit into a frame, else the volumes.
  void assessInFrame();
  /// By a job, unless they are there.
  void assessAll();

  JobRunner& jobs_;
  std::filesystem::path recoveryFolder_;
  bool open_ = false;
  bool recovery_ = false;
  bool fresh_ = false;  ///< made in this session, not opened from a file
  bool readOnly_ = false;
  std::filesystem::path path_;
  Case case_;
  QString noCt_;
  ChosenPlane chosen_;
  QUndoStack undo_;
  CaseStore store_;
  std::shared_ptr<const PlanAssessor> assessor_;
  std::optional<JobId> preparing_;  ///< the job that makes it
  std::shared_ptr<const TumourDistance> tumourDistance_;
  std::optional<Vec3> liverCentre_;
  PlanAssessment assessment_;
  Freshness freshness_ = Freshness::None;
  double frameBudgetMs_ = 16;
  double wholeMs_ = 0;  ///< what all numbers are expected to take
  std::optional<std::vector<ResectionPlan>> beforeDrag_;
  int savingIndex_ = -1;  ///< the undo index a save under way will make clean
};

/// Centre of the mask's voxels, mm LPS. The mask must not be empty.
Vec3 voxelCentre(const Mask& mask, const ImageGeometry& geometry);

}  // namespace glisson
