// The part of the document that edits structures: how they look, and who accepts them.

#include "app/gui/document.h"
#include "app/gui/edit_commands.h"
#include "planning/storage/surface_hash.h"

namespace glisson {

namespace {

QString shownNameOf(const Structure& structure) {
  return QString::fromStdString(structure.name.empty() ? structure.id : structure.name);
}

}  // namespace

void Document::setColour(const std::string& structureId, Rgb colour) {
  pushStructure(QString::fromLatin1(QT_TR_NOOP("change colour")), structureId,
                [&](StructureState& state) { state.colour = colour; });
}

void Document::setOpacity(const std::string& structureId, double opacity) {
  pushStructure(QString::fromLatin1(QT_TR_NOOP("change opacity")), structureId,
                [&](StructureState& state) { state.opacity = opacity; });
}

void Document::setVisible(const std::string& structureId, bool visible) {
  const Structure* structure = case_.model ? case_.model->find(structureId) : nullptr;
  if (structure != nullptr) {
    const QString name = visible ? QStringLiteral("show %1") : QStringLiteral("hide %1");
    pushStructure(name.arg(shownNameOf(*structure)), structureId, [&](StructureState& state) { state.visible = visible; });
  }
}

void Document::pushStructure(const QString& name, const std::string& structureId,
                             const std::function<void(StructureState&)>& change) {
  const Structure* structure = case_.model ? case_.model->find(structureId) : nullptr;
  if (structure == nullptr) {
    return;
  }
  const StructureState before = stateOf(*structure);
  StructureState after = before;
  change(after);
  if (after == before) {
    return;
  }
  const auto* last = dynamic_cast<const StructuresCommand*>(undo_.command(undo_.index() - 1));
  const bool slides = before.opacity != after.opacity && last != nullptr && last->isOpacityOf(structureId);
  undo_.push(new StructuresCommand(*this, name, {{before, after, nullptr}}, slides && !undo_.isClean()));
}

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
    const QString one = QStringLiteral("accept %1").arg(shownNameOf(*accepted.front()));
    pushAcceptance(accepted.size() == 1 ? one : QString::fromLatin1(QT_TR_NOOP("accept structures")), accepted, acceptance);
  }
}

void Document::withdrawAcceptance(const std::string& structureId) {
  const Structure* structure = case_.model ? case_.model->find(structureId) : nullptr;
  if (structure != nullptr && structure->acceptance) {
    pushAcceptance(QStringLiteral("withdraw the acceptance of %1").arg(shownNameOf(*structure)), {structure}, {});
  }
}

void Document::pushAcceptance(const QString& name, const std::vector<const Structure*>& structures,
                              const std::optional<Acceptance>& after) {
  std::vector<StructureChange> changes;
  changes.reserve(structures.size());
  for (const Structure* structure : structures) {
    changes.push_back({stateOf(*structure), stateOf(*structure), structure->reconstruction});
    changes.back().after.acceptance = after;
  }
  undo_.push(new StructuresCommand(*this, name, std::move(changes)));
}

void Document::setStructures(const std::vector<StructureChange>& changes, Direction direction, const QString& name, bool goesOn) {
  std::shared_ptr<const LiverModel> model = case_.model;
  for (const StructureChange& change : changes) {
    const Structure* structure = model ? model->find(change.before.id) : nullptr;
    if (structure == nullptr) {
      continue;
    }
    StructureState from = direction == Direction::Forth ? change.before : change.after;
    const StructureState& to = direction == Direction::Forth ? change.after : change.before;
    if (change.of == nullptr || structure->reconstruction != change.of) {
      from.acceptance = to.acceptance;
    }
    if (!(from == to)) {
      model = withState(*model, from, to);
    }
  }
  if (model == case_.model) {
    return;
  }
  leaveReadOnlyFile();
  case_.model = std::move(model);
  store_.editModel(case_.model, name, goesOn);
  emit modelChanged();
}

std::vector<Document::StructureChange> Document::changesOf(const Change<std::vector<StructureState>>& edit) const {
  std::vector<StructureChange> changes;
  for (std::size_t n = 0; n < edit.before.size(); ++n) {
    const StructureState& before = edit.before[n];
    const Structure* structure = case_.model ? case_.model->find(before.id) : nullptr;
    const std::shared_ptr<const Reconstruction> now = structure != nullptr ? structure->reconstruction : nullptr;
    const bool same = now != nullptr && !before.surface.empty() && surfaceHash(now->mesh) == before.surface;
    changes.push_back({before, edit.after[n], same ? now : nullptr});
  }
  return changes;
}

}  // namespace glisson
