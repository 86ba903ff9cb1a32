#include "app/gui/edit_commands.h"

namespace glisson {

PlansCommand::PlansCommand(Document& document, const QString& text, State before, State after, bool done)
    : QUndoCommand(text), document_(document), before_(std::move(before)), after_(std::move(after)), done_(done) {}

void PlansCommand::undo() { document_.setPlans(before_.plans, before_.chosen, {}); }

void PlansCommand::redo() {
  if (!done_) {
    document_.setPlans(after_.plans, after_.chosen, text());
  }
  done_ = false;
}

PatientCommand::PatientCommand(Document& document, const QString& text, const PatientFacts& before, const PatientFacts& after,
                               bool done)
    : QUndoCommand(text), document_(document), before_(before), after_(after), done_(done) {}

void PatientCommand::undo() { document_.storePatient(before_, {}); }

void PatientCommand::redo() {
  if (!done_) {
    document_.storePatient(after_, text());
  }
  done_ = false;
}

TerritoriesCommand::TerritoriesCommand(Document& document, const QString& text, TerritoryMarks before, TerritoryMarks after)
    : QUndoCommand(text), document_(document), before_(std::move(before)), after_(std::move(after)) {}

void TerritoriesCommand::undo() { document_.storeTerritories(before_); }

void TerritoriesCommand::redo() { document_.storeTerritories(after_); }

AppearanceCommand::AppearanceCommand(Document& document, const QString& text, What what, std::string structureId,
                                     Document::Appearance before, Document::Appearance after)
    : QUndoCommand(text), document_(document), what_(what), structureId_(std::move(structureId)), before_(before), after_(after) {}

bool AppearanceCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const AppearanceCommand*>(other);
  if (next == nullptr || next->structureId_ != structureId_ || what_ == What::Colour) {
    return false;
  }
  after_ = next->after_;
  return true;
}

void AppearanceCommand::undo() { document_.setAppearance(structureId_, before_); }

void AppearanceCommand::redo() { document_.setAppearance(structureId_, after_); }

AcceptanceCommand::AcceptanceCommand(Document& document, const QString& text, std::vector<Document::AcceptanceChange> changes)
    : QUndoCommand(text), document_(document), changes_(std::move(changes)) {}

void AcceptanceCommand::undo() { document_.setAcceptances(changes_, &Document::AcceptanceChange::before); }

void AcceptanceCommand::redo() { document_.setAcceptances(changes_, &Document::AcceptanceChange::after); }

}  // namespace glisson
