#pragma once
// Purpose: the undo steps of the document. Each keeps the state before and after; plans are small values.

#include <QUndoCommand>

#include "app/gui/document.h"

namespace glisson {

class PlansCommand : public QUndoCommand {
 public:
  /// The plans, and the plane worked on among them.
  struct State {
    std::vector<ResectionPlan> plans;
    ChosenPlane chosen;
  };
  /// `done`: an edit of an earlier session; it stands already, and its first redo() changes nothing.
  PlansCommand(Document& document, const QString& text, State before, State after, bool done = false);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  State before_;
  State after_;
  bool done_;
};

class PatientCommand : public QUndoCommand {
 public:
  /// `done` as in PlansCommand.
  PatientCommand(Document& document, const QString& text, const PatientFacts& before, const PatientFacts& after, bool done = false);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  PatientFacts before_;
  PatientFacts after_;
  bool done_;
};

class TerritoriesCommand : public QUndoCommand {
 public:
  /// `done` as in PlansCommand.
  TerritoriesCommand(Document& document, const QString& text, TerritoryMarks before, TerritoryMarks after, bool done = false);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  TerritoryMarks before_;
  TerritoryMarks after_;
  bool done_;
};

/// How structures look, and who accepts them; several at once are one step. An acceptance holds for the surface that was looked at:
/// done again, it leaves a new one alone.
class StructuresCommand : public QUndoCommand {
 public:
  /// `goesOn`: what a slider does to the same structure as in the step before becomes one with it. `done` as in PlansCommand.
  StructuresCommand(Document& document, const QString& text, std::vector<Document::StructureChange> changes, bool goesOn = false,
                    bool done = false);
  [[nodiscard]] int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override;
  void redo() override;
  /// It changes nothing but the opacity of this structure.
  [[nodiscard]] bool isOpacityOf(const std::string& structureId) const;

 private:
  Document& document_;
  std::vector<Document::StructureChange> changes_;
  bool goesOn_;
  bool done_;
};

}  // namespace glisson
