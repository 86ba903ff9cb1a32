#include "app/gui/model_builder.h"

#include <QElapsedTimer>
#include <algorithm>
#include <memory>

#include "app/gui/label_dialog.h"
#include "app/gui/sentences.h"

namespace glisson {

ModelBuilder::ModelBuilder(JobRunner& jobs, Document& document, QObject* parent)
    : QObject(parent), jobs_(jobs), document_(document) {
  connect(&document_, &Document::caseChanged, this, &ModelBuilder::cancelAll);
  connect(&jobs_, &JobRunner::jobEnded, this, &ModelBuilder::ended);
}

int ModelBuilder::buildMissing() {
  int started = 0;
  if (!document_.isOpen() || !document_.content().model) {
    return started;
  }
  const Case content = document_.content();
  for (const Structure& structure : content.model->structures) {
    if (structure.reconstruction || !isModelled(structure) || running_.contains(structure.id)) {
      continue;
    }
    const QString name = structureName(structure);
    JobRequest request{.key = QString::fromStdString("build/" + structure.id), .title = name, .heavy = true};
    request.fail =
        [this, own = QString::fromStdString(structure.name.empty() ? structure.id : structure.name)](const std::exception& error) {
          emit structureFailed(QStringLiteral("%1 could not be reconstructed: %2").arg(own, messageOf(error)));
        };
    auto clock = std::make_shared<QElapsedTimer>();
    const JobId id = submitFor<Structure>(
        jobs_, std::move(request),
        [content, structure, clock](const ExecutionContext& context) {
          clock->start();
          return buildStructure(content, structure, context);
        },
        [this, clock, name](const Structure& built) {
          document_.setReconstruction(built.id, built.reconstruction);
          emit structureReady(name, static_cast<double>(clock->elapsed()) / 1000.0);
        });
    running_[structure.id] = id;
    ++started;
  }
  emit changed();
  return started;
}

int ModelBuilder::missing() const {
  if (!document_.isOpen() || !document_.content().model) {
    return 0;
  }
  return static_cast<int>(std::ranges::count_if(document_.content().model->structures, [](const Structure& structure) {
    return isModelled(structure) && !structure.reconstruction;
  }));
}

int ModelBuilder::total() const {
  if (!document_.isOpen() || !document_.content().model) {
    return 0;
  }
  return static_cast<int>(std::ranges::count_if(document_.content().model->structures, isModelled));
}

void ModelBuilder::cancelAll() {
  const std::map<std::string, JobId> stale = std::exchange(running_, {});
  for (auto job = stale.rbegin(); job != stale.rend(); ++job) {
    jobs_.cancel(job->second);
  }
}

void ModelBuilder::ended(JobId id) {
  if (std::erase_if(running_, [id](const auto& item) { return item.second == id; }) > 0) {
    emit changed();
  }
}

QString structureName(const Structure& structure) {
  return structure.name.empty() ? kindName(structure.kind) : shownName(structure.name);
}

bool isModelled(const Structure& structure) { return structure.kind != StructureKind::Other; }

}  // namespace glisson
