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

TerritoriesCommand::TerritoriesCommand(Document& document, const QString& text, TerritoryMarks before, TerritoryMarks after,
                                       bool done)
    : QUndoCommand(text), document_(document), before_(std::move(before)), after_(std::move(after)), done_(done) {}

void TerritoriesCommand::undo() { document_.storeTerritories(before_, {}); }

void TerritoriesCommand::redo() {
  if (!done_) {
    document_.storeTerritories(after_, text());
  }
  done_ = false;
}

StructuresCommand::StructuresCommand(Document& document, const QString& text, std::vector<Document::StructureChange> changes,
                                     bool goesOn, bool done)
    : QUndoCommand(text), document_(document), changes_(std::move(changes)), goesOn_(goesOn), done_(done) {}

int StructuresCommand::id() const { return 1; }  // any but -1, which is never merged

bool StructuresCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const StructuresCommand*>(other);
  if (next == nullptr || !next->goesOn_) {
    return false;
  }
  changes_.front().after = next->changes_.front().after;
  return true;
}

void StructuresCommand::undo() { document_.setStructures(changes_, Document::Direction::Back, {}); }

void StructuresCommand::redo() {
  if (!done_) {
    document_.setStructures(changes_, Document::Direction::Forth, text(), goesOn_);
  }
  done_ = false;
}

bool StructuresCommand::isOpacityOf(const std::string& structureId) const {
  if (changes_.size() != 1 || changes_.front().before.id != structureId) {
    return false;
  }
  StructureState before = changes_.front().before;
  before.opacity = changes_.front().after.opacity;
  return before == changes_.front().after;
}

}  // namespace glisson
