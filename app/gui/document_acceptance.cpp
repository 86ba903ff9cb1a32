// The part of the document that says who accepts which structure.

#include "app/gui/document.h"
#include "app/gui/edit_commands.h"

namespace glisson {

namespace {

QString nameOf(const Structure& structure) {
  return QString::fromStdString(structure.name.empty() ? structure.id : structure.name);
}

}  // namespace

void Document::accept(const std::vector<std::string>& structureIds, const std::string& by) {
  const Acceptance acceptance = acceptedNow(by);
  std::vector<const Structure*> accepted;
  for (const std::string& id : structureIds) {
    const Structure* structure = case_.model ? case_.model->find(id) : nullptr;
    if (structure != nullptr && structure->reconstruction) {
      accepted.push_back(structure);
    }
  }
  if (!accepted.empty()) {
    const QString one = QStringLiteral("accept %1").arg(nameOf(*accepted.front()));
    pushAcceptance(accepted.size() == 1 ? one : QString::fromLatin1(QT_TR_NOOP("accept structures")), accepted, acceptance);
  }
}

void Document::withdrawAcceptance(const std::string& structureId) {
  const Structure* structure = case_.model ? case_.model->find(structureId) : nullptr;
  if (structure != nullptr && structure->acceptance) {
    pushAcceptance(QStringLiteral("withdraw the acceptance of %1").arg(nameOf(*structure)), {structure}, {});
  }
}

void Document::pushAcceptance(const QString& name, const std::vector<const Structure*>& structures,
                              const std::optional<Acceptance>& after) {
  std::vector<AcceptanceChange> changes;
  changes.reserve(structures.size());
  for (const Structure* structure : structures) {
    changes.push_back({structure->id, structure->reconstruction, structure->acceptance, after});
  }
  undo_.push(new AcceptanceCommand(*this, name, std::move(changes)));
}

void Document::setAcceptances(const std::vector<AcceptanceChange>& changes, std::optional<Acceptance> AcceptanceChange::*side) {
  std::shared_ptr<const LiverModel> model = case_.model;
  for (const AcceptanceChange& change : changes) {
    const Structure* structure = model ? model->find(change.structureId) : nullptr;
    if (structure != nullptr && structure->reconstruction == change.of) {
      model = withAcceptance(*model, {change.structureId}, change.*side);
    }
  }
  if (model != case_.model) {
    replaceModel(std::move(model));
  }
}

}  // namespace glisson
