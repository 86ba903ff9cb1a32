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
  TerritoriesCommand(Document& document, const QString& text, TerritoryMarks before, TerritoryMarks after);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  TerritoryMarks before_;
  TerritoryMarks after_;
};

/// Steps of the same slider on the same structure become one.
class AppearanceCommand : public QUndoCommand {
 public:
  enum class What { Colour = 1, Opacity = 2 };
  AppearanceCommand(Document& document, const QString& text, What what, std::string structureId, Document::Appearance before,
                    Document::Appearance after);
  [[nodiscard]] int id() const override { return static_cast<int>(what_); }
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  What what_;
  std::string structureId_;
  Document::Appearance before_;
  Document::Appearance after_;
};

/// Several structures at once are one step. It holds for the surfaces that were looked at: done again, it leaves new ones alone.
class AcceptanceCommand : public QUndoCommand {
 public:
  AcceptanceCommand(Document& document, const QString& text, std::vector<Document::AcceptanceChange> changes);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  std::vector<Document::AcceptanceChange> changes_;
};

}  // namespace glisson
